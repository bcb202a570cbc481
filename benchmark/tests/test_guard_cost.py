#!/usr/bin/env python3
"""Tests of benchmark/guard_cost.py: the change of the shader, how instructions are counted, and the kept table."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))
import guard_cost

MODULE = """; SPIR-V
               OpCapability Shader
          %5 = OpTypeFloat 32
          %9 = OpFunction %2 None %3
         %10 = OpLabel
         %11 = OpVariable %6 Function
         %12 = OpLoad %5 %7
         %13 = OpFAdd %5 %12 %12
               OpSelectionMerge %15 None
               OpBranchConditional %14 %16 %15
         %16 = OpLabel
               OpStore %8 %13
               OpBranch %15
         %15 = OpLabel
               OpReturn
               OpFunctionEnd
"""


class Tool(unittest.TestCase):
    def test_leaves_out_the_guard_alone(self):
        text = (ROOT / guard_cost.GUARD).read_text()
        changed = guard_cost.unguarded_text(text)
        differing = [(a, b) for a, b in zip(text.splitlines(), changed.splitlines()) if a != b]
        self.assertEqual(differing, [("    return !agaa_exponentIsAllOnes(x);", "    return true;")])

    def test_refuses_a_shader_without_the_guard(self):
        with self.assertRaises(SystemExit):
            guard_cost.unguarded_text("bool agaa_isFinite(real x) { return x == x; }")

    def test_finds_the_shaders_of_a_file(self):
        self.assertEqual(guard_cost.sections("[require]\nGLSL >= 4.50\n\n[vertex shader]\nA\n[fragment shader]\nB\n"),
                         [("vertex", "A\n"), ("fragment", "B\n")])

    def test_counts_what_a_device_executes(self):
        self.assertEqual(guard_cost.count_instructions(MODULE), 6)

    def test_table_is_in_the_page(self):
        rows = json.loads((ROOT / "docs/results/lavapipe/guard_cost.json").read_text())
        self.assertIn(guard_cost.document(rows), (ROOT / "docs/numerics.md").read_text())


if __name__ == "__main__":
    unittest.main()
