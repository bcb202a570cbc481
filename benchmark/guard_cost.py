#!/usr/bin/env python3
"""Measures what the guards against non-finite values cost, for docs/numerics.md.

The tool copies the source tree to OUT/source, in which agaa_isFinite() returns true, so that compilers drop every test of a
value, its replacement and its count; values are clamped as before. It builds the sample engine there, and compares it with
the one of --harness:

  * SPIR-V instructions of the fragment shaders and of the compute passes, after spirv-opt -O. The shaders are those that the
    OpenGL backend compiles, which Mesa writes to files.
  * Time of a frame: that of the processor, which software rasterisers run on. Frames of both programs alternate.

OUT/guard_cost.json and OUT/guard_cost.md have the results. cmake, a compiler, Mesa, glslangValidator and the SPIR-V tools
must be installed.
"""
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

from command_line import tool_parser
from markdown_table import table
from runs import ROOT, Runs, find_scenes, view_options, write_results

GUARD = "src/shaders/math/sanitise.glsl"
TEST = "    return !agaa_exponentIsAllOnes(x);"
SCENES = ["metal"]
AGAA = ["--technique", "agaa", "--samples", 8, "--aggregates", 2, "--tier"]
ROWS = {
    "msaa-4": ["--technique", "msaa", "--samples", 4],
    "ssaa-8": ["--technique", "ssaa", "--samples", 8],
    "agaa-8-2-per-sample": [*AGAA, "generation=per-sample"],
    "agaa-8-2-gbuffer": [*AGAA, "generation=gbuffer"],
    "agaa-8-2-ids": [*AGAA, "generation=ids"],
    "dcaa-64-4-material-lists": ["--technique", "dcaa", "--samples", 64, "--aggregates", 4, "--tier",
                                 "generation=material-lists"],
}
SECTION = re.compile(r"^\[(vertex|geometry|fragment|compute) shader\]\n", re.MULTILINE)
STAGES = {"fragment": "frag", "compute": "comp"}
# Instructions that a device does not execute: labels, variables, and what merges control flow.
NOT_EXECUTED = {"OpFunction", "OpFunctionParameter", "OpFunctionEnd", "OpLabel", "OpVariable", "OpSelectionMerge",
                "OpLoopMerge", "OpNoLine", "OpLine", "OpUndef"}


def unguarded_text(text):
    """The text of math/sanitise.glsl without its test."""
    if text.count(TEST) != 1:
        sys.exit(f"guard_cost: {GUARD} does not have the line \"{TEST.strip()}\" once.")
    return text.replace(TEST, "    return true;")


def left_out(out):
    """For shutil.copytree: leaves out build folders, the repository and the results."""
    def names(folder, entries):
        paths = [pathlib.Path(folder) / entry for entry in entries]
        return [path.name for path in paths
                if path.name == ".git" or (path / "CMakeCache.txt").exists() or path.resolve() == out.resolve()]
    return names


def build_unguarded(out):
    """Builds the sample engine without guards, and returns it. A finished copy is kept."""
    source, build = out / "source", out / "build"
    if not source.exists():
        part = out / "source.part"
        shutil.rmtree(part, ignore_errors=True)
        shutil.copytree(ROOT, part, symlinks=True, ignore=left_out(out))
        guard = part / GUARD
        guard.write_text(unguarded_text(guard.read_text()))
        part.rename(source)
    subprocess.run(["cmake", "-S", source, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DAGAA_TESTS=OFF"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--target", "agaa-harness", "--parallel", str(os.cpu_count())], check=True,
                   stdout=subprocess.DEVNULL)
    return build / "bin" / "agaa-harness"


def sections(text):
    """Pairs of stage and GLSL in a file that Mesa wrote."""
    parts = SECTION.split(text)
    return list(zip(parts[1::2], parts[2::2]))


def count_instructions(disassembly):
    """The number of instructions in the functions of a module, as spirv-dis prints it."""
    count, inside = 0, False
    for line in disassembly.splitlines():
        words = line.split()
        if not words or words[0].startswith(";"):
            continue
        operation = words[2] if len(words) > 2 and words[1] == "=" else words[0]
        inside = inside or operation == "OpFunction"
        count += inside and operation not in NOT_EXECUTED
    return count


def optimised_instructions(stage, glsl):
    with tempfile.TemporaryDirectory() as folder:
        text, spirv, small = (pathlib.Path(folder) / name for name in (f"shader.{STAGES[stage]}", "a.spv", "b.spv"))
        text.write_text(glsl.strip() + "\n")
        subprocess.run(["glslangValidator", "-G", "--aml", "--amb", text, "-o", spirv], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run(["spirv-opt", "-O", spirv, "-o", small], check=True)
        return count_instructions(subprocess.run(["spirv-dis", "--raw-id", small], check=True, capture_output=True,
                                                 text=True).stdout)


def view_instructions(harness, options):
    """Instructions of the different shaders of a view, by stage."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "MESA_SHADER_CAPTURE_PATH": folder, "MESA_SHADER_CACHE_DISABLE": "1"}
        subprocess.run([harness, "render", *map(str, options), "--backend", "gl", "--no-validation", "--no-counters",
                        "--json"], check=True, stdout=subprocess.DEVNULL, env=environment)
        shaders = {pair for file in pathlib.Path(folder).glob("*.shader_test") for pair in sections(file.read_text())}
    return {stage: sum(optimised_instructions(found, glsl) for found, glsl in shaders
                       if found == stage and "agaa_" in glsl) for stage in STAGES}


def processor_ms():
    """The processor time of all finished processes that this one started."""
    times = os.times()
    return 1000 * (times.children_user + times.children_system)


def frame_ms(runs, options, count):
    """The processor time per frame after the first, before which the scene is loaded and pipelines are compiled."""
    def run(frames):
        before = processor_ms()
        runs.call("render", *options, "--backend", "vk", "--no-validation", "--no-counters", "--warmup", 0, "--frames",
                  frames)
        return processor_ms() - before
    return (run(1 + count) - run(1)) / count


def measure(programs, name, options, turns, frames):
    times = {program: [] for program in programs}
    for turn in range(turns):  # the load of a machine changes
        for program, runs in programs.items():
            times[program].append(runs.kept(f"{name}-{turn}", lambda: frame_ms(runs, options, frames)))
    ratios = sorted(a / b for a, b in zip(times["guarded"], times["unguarded"]))
    return {"guardedMs": round(statistics.median(times["guarded"]), 1),
            "unguardedMs": round(statistics.median(times["unguarded"]), 1),
            "ratio": round(statistics.median(ratios), 3), "ratios": [round(ratio, 3) for ratio in ratios]}


def instruction_cell(row, stage):
    return f"{row['unguarded'][stage]} + {row['guarded'][stage] - row['unguarded'][stage]}"


def document(rows):
    return "\n".join(table(
        ["scene", "row", "instructions of fragment shaders", "of compute passes", "time with guards / without",
         "lowest, highest"],
        [[row["scene"], f"`{row['row']}`", instruction_cell(row, "fragment"), instruction_cell(row, "compute"),
          f"{row['ratio']:.3f}", f"{min(row['ratios']):.3f}, {max(row['ratios']):.3f}"] for row in rows], "llr")) + "\n"


def main():
    parser = tool_parser(__doc__, out="guard-cost", size="320x180", scenes=True, turns=3, frames=10)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    settings = {"size": arguments.size, "frames": arguments.frames}
    programs = {"guarded": Runs("guard_cost", arguments.harness, arguments.out / "guarded", settings)}
    unguarded = build_unguarded(arguments.out)
    programs["unguarded"] = Runs("guard_cost", unguarded, arguments.out / "unguarded", settings)
    found = []
    for scene, source, camera in find_scenes("guard_cost", arguments.scene or SCENES):
        for name, options in ROWS.items():
            view = [*view_options(source, camera, arguments.size), *options]
            row = {"scene": scene, "row": name}
            for program, runs in programs.items():
                row[program] = runs.kept(f"{scene}-{name}-instructions",
                                         lambda: view_instructions(runs.harness, view))
            row.update(measure(programs, f"{scene}-{name}", view, arguments.turns, arguments.frames))
            found.append(row)
            print(scene, name, row["ratio"], flush=True)
    write_results(arguments.out, "guard_cost", found, document(found))


if __name__ == "__main__":
    main()
