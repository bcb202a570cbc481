"""abi/agaa.json is what the headers say, and a binding made of it works."""
import ctypes
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "python"))
import agaa  # noqa: E402


class Description(unittest.TestCase):
    def test_is_current(self):
        printed = subprocess.run([sys.executable, ROOT / "tools" / "describe_abi.py"], check=True, capture_output=True,
                                 text=True).stdout
        self.assertEqual((ROOT / "abi" / "agaa.json").read_text(), printed, "tools/describe_abi.py --update")

    def test_has_every_function_that_the_library_exports(self):
        description = json.loads((ROOT / "abi" / "agaa.json").read_text())
        exported = (ROOT / "tests" / "abi" / "exported_symbols.txt").read_text().split()
        self.assertEqual(sorted(function["name"] for function in description["functions"]), exported)

    def test_has_every_flag_of_the_headers(self):
        description = json.loads((ROOT / "abi" / "agaa.json").read_text())
        for header in (ROOT / "include").rglob("*.h"):
            text = header.read_text().replace("\\\n", " ")
            for name, bits in re.findall(r"^#define (AGAA_\w+) +UINT(32|64)_C\(", text, re.MULTILINE):
                self.assertIn(name, description["constants"], header)
                self.assertEqual(description["constantTypes"][name], f"uint{bits}_t", name)
        self.assertEqual(description["constantTypes"]["AGAA_FACT_ALL_SHADED"], "uint64_t")
        self.assertEqual(list(description["constantTypes"]), list(description["constants"]))


class Binding(unittest.TestCase):
    def setUp(self):
        self.sdk = agaa.Library(os.environ["AGAA_LIBRARY"])
        self.messages = []
        self.config = self.sdk.new("AgaaConfig")
        self.facts = self.sdk.new("AgaaSceneFacts")
        self.view = self.sdk.new("AgaaViewDesc")
        self.view.width, self.view.height = 640, 360
        self.view.config = ctypes.pointer(self.config)
        self.view.facts = ctypes.pointer(self.facts)
        self.log = self.sdk.new("AgaaLog")
        # Kept: the library calls it later.
        self.callback = self.sdk.AgaaLogCallback(lambda user, severity, code, text: self.messages.append((code, text.decode())))
        self.log.callback = self.callback

    def test_version(self):
        self.assertEqual(self.sdk.call("agaaGetVersion") >> 12, self.sdk.AGAA_VERSION_MINOR)

    def test_structs_are_initialised(self):
        self.assertEqual(self.config.technique, b"agaa")
        self.assertEqual((self.config.samples, self.config.aggregates), (8, 2))
        light = self.sdk.new("AgaaLight")
        self.assertEqual(light.shadowMap, self.sdk.AGAA_NO_SHADOW)

    def test_prices_may_be_negative(self):
        count = ctypes.c_uint32()
        self.sdk.call("agaaQueryPrices", self.view, None, self.log, count, None)
        prices = self.sdk.array("AgaaPrice", count.value)
        self.sdk.call("agaaQueryPrices", self.view, None, self.log, count, prices)
        tiers = {price.name: price.geometryPasses for price in prices if price.changesTier}
        self.assertEqual(tiers[b"lit-aggregates"], -1) # one geometry pass in place of two

    def test_memory(self):
        report = self.sdk.new("AgaaMemoryReport")
        count = ctypes.c_uint32()
        self.sdk.call("agaaQueryMemory", self.view, None, self.log, report, count, None)
        surfaces = self.sdk.array("AgaaSurface", count.value)
        self.sdk.call("agaaQueryMemory", self.view, None, self.log, report, count, surfaces)
        self.assertEqual(report.totalBytes, sum(s.bytes for s in surfaces if s.isPerPixel))
        self.assertEqual(report.bytesPerPixel, report.totalBytes / (640 * 360))
        self.assertIn(b"depth", [s.name for s in surfaces])

    def test_plan(self):
        size = ctypes.c_size_t()
        self.sdk.call("agaaPlanToJson", self.view, None, self.log, size, None)
        text = ctypes.create_string_buffer(size.value)
        self.sdk.call("agaaPlanToJson", self.view, None, self.log, size, text)
        plan = json.loads(text.value)
        self.assertEqual(plan["technique"], "agaa")
        self.assertTrue(plan["passes"])

    def test_errors(self):
        self.config.flags = 1 << 40
        with self.assertRaises(agaa.Error) as caught:
            self.sdk.call("agaaPlanToJson", self.view, None, self.log, ctypes.c_size_t(), None)
        self.assertEqual(caught.exception.name, "AGAA_ERROR_OUT_OF_RANGE")
        self.assertEqual(len(self.messages), 1)
        self.assertIn("0x10000000000", self.messages[0][1])

    def test_names(self):
        count = ctypes.c_uint32()
        for kind, known in ((self.sdk.AGAA_NAMES_TECHNIQUES, b"simple_complex"), (self.sdk.AGAA_NAMES_TIERS, b"gbuffer"),
                            (self.sdk.AGAA_NAMES_STAGES, b"prepass"), (self.sdk.AGAA_NAMES_LAYOUTS, b"paper16"),
                            (self.sdk.AGAA_NAMES_PRESETS, b"accurate")):
            self.sdk.call("agaaGetNames", kind, count, None)
            names = (ctypes.c_char_p * count.value)()
            self.sdk.call("agaaGetNames", kind, count, names)
            self.assertIn(known, list(names))
        with self.assertRaises(agaa.Error):
            self.sdk.call("agaaGetNames", 99, count, None)
        tier = ctypes.c_uint32()
        self.sdk.call("agaaTierFromName", b"post_depth_atomics", tier)
        self.assertEqual(tier.value, self.sdk.AGAA_TIER_POST_DEPTH_ATOMICS)


if __name__ == "__main__":
    unittest.main()
