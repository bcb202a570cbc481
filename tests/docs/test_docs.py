"""Documents against the sources they speak of."""
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["AGAA_SOURCE"])
QUOTES = ROOT / "tools" / "quotes.py"
FORMAT = ROOT / "scripts" / "format"
HARD_CASES = ROOT / "tools" / "hard_cases.py"
HARD_SCENES = ROOT / "tools" / "hard_scenes.py"
PICTURE = ROOT / "tools" / "comparison_picture.py"
README = ROOT / "README.md"
ROOT_DOCUMENTS = [README, *(ROOT / name for name in ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"))]
INDEX = ROOT / "docs" / "README.md"
GUIDES = [*sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs" / "integration").glob("*.md"))]
GENERATED = [ROOT / "docs" / name for name in ("choosing.md", "effects.md", "memory.md", "paper_figures.md", "papers.md",
                                            "state.md")]
WRITTEN = [guide for guide in GUIDES if guide not in GENERATED]
MIGRATION = ROOT / "docs" / "abi.md"  # names of earlier versions, too

SOURCE = """static int used(int a);

/* Why. */
static int used(int a,
                int b) {
    return other(a + b);
}
/* Not C's notion of a paragraph. */
static int other(int a) {
    return a;
}

static const char text[] =
    "used(";
#define LIMIT 3

static const char code[] = "int used;\\n"
                           "int b;\\n";
"""
DOCUMENT = """Text.

<!-- quote host.c used -->
```c
/* Why. */
static int used(int a,
                int b) {
    return other(a + b);
}
/* Not C's notion of a paragraph. */
static int other(int a) {
    return a;
}
```

<!-- quote host.c LIMIT -->
```c
static const char text[] =
    "used(";
#define LIMIT 3
```

<!-- quote host.c code -->
```c
static const char code[] = "int used;\\n"
                           "int b;\\n";
```
"""


def quotes(*arguments):
    return subprocess.run([sys.executable, QUOTES, *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True)


def links(document):
    """Relative targets of Markdown links and images, outside code."""
    text = re.sub(r"^```.*?^```$", "", document.read_text(), flags=re.MULTILINE | re.DOTALL)
    return [target.split("#")[0] for target in re.findall(r"\]\(([^)\s]+)\)", text) if "://" not in target]


class Guides(unittest.TestCase):
    def test_quotes_are_current(self):
        quoting = [guide for guide in (README, *WRITTEN) if "<!-- quote " in guide.read_text()]
        self.assertGreater(len(quoting), 5)
        result = quotes(*quoting)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_names_exist(self):
        """Every name of the SDK's in the guides is declared in a header, in a shader or in the library."""
        declaring = [*(ROOT / "include").rglob("*.h"), *(ROOT / "src" / "shaders").rglob("*.*"),
                     ROOT / "src/core/glsl/host_glsl.cpp", ROOT / "CMakeLists.txt", ROOT / "benchmark/runs.py",
                     ROOT / "conformance/include/agaa_conformance.h", ROOT / "conformance/CMakeLists.txt"]
        declared = set(re.findall(r"\w+", "".join(path.read_text() for path in declaring)))
        for document in (*ROOT_DOCUMENTS, *WRITTEN):
            if document == MIGRATION:
                continue
            names = set(re.findall(r"\b(?:agaa|Agaa|AGAA_)\w+\b(?!\.h)(?![\w…])", document.read_text()))
            self.assertEqual(sorted(names - declared), [], document)

    def test_links_resolve(self):
        for document in (*ROOT_DOCUMENTS, *GUIDES):
            for target in links(document):
                self.assertTrue((document.parent / target).exists(), f"{document}: {target}")

    def test_guides_are_in_the_index(self):
        listed = {(INDEX.parent / target).resolve() for target in links(INDEX)}
        self.assertEqual(sorted(set(GUIDES) - listed - {INDEX}), [])
        entries = [line for line in INDEX.read_text().splitlines() if line.startswith("* ")]
        self.assertEqual(len(entries), len(GUIDES) - 1)

    def test_scripts_run_by_their_name(self):
        scripts = [path for folder in ("benchmark", "tools", "scripts") for path in (ROOT / folder).rglob("*")
                   if path.is_file() and path.read_bytes().startswith(b"#!")]
        self.assertTrue(scripts)
        for path in scripts:
            self.assertTrue(os.access(path, os.X_OK), path)

    def test_files_exist(self):
        """Paths of the source tree that the guides name."""
        folders = "benchmark|samples|docs|src|tools|tests|scripts"
        for document in (*ROOT_DOCUMENTS, *GUIDES):
            for path in re.findall(rf"`((?:{folders})/[\w./-]+)[ `]", document.read_text()):
                if "NAME" not in path:
                    self.assertTrue((ROOT / path).exists(), f"{document}: {path}")

    def test_sources_name_guides_that_exist(self):
        folders = ("include", "src", "samples", "benchmark", "tests", "bindings", "cmake", "tools")
        suffixes = (".h", ".c", ".cpp", ".glsl", ".comp", ".py", ".cmake", ".txt")
        for path in (path for folder in folders for path in (ROOT / folder).rglob("*")):
            if path.suffix in suffixes:
                for name in re.findall(r"\bdocs/(?:integration/)?[a-z-]+\.md\b", path.read_text()):
                    self.assertTrue((ROOT / name).exists(), f"{path}: {name}")

    def test_table_of_the_readme_is_current(self):
        command = re.search(r"^    tools/comparison_picture\.py (.*)$", README.read_text(), flags=re.MULTILINE)[1].split()
        printed = subprocess.run([sys.executable, PICTURE, *command], stdout=subprocess.PIPE, text=True, cwd=ROOT)
        self.assertEqual(printed.returncode, 0)
        self.assertIn(printed.stdout, README.read_text())

    def test_readme_is_short(self):
        self.assertLessEqual(len(README.read_text().splitlines()), 120)
        code = re.findall(r"^```c\n(.*?)^```", README.read_text(), flags=re.MULTILINE | re.DOTALL)
        lines = [line for line in "".join(code).splitlines() if not line.strip().startswith("/*")]
        self.assertLessEqual(len(lines), 15)


    def test_kept_pages_are_small(self):
        for page in (ROOT / "docs").rglob("*.html"):
            self.assertLessEqual(page.stat().st_size, 4_000_000, page)

    def test_glossary_is_alphabetical(self):
        text = (ROOT / "docs" / "glossary.md").read_text()
        words = re.findall(r"^\| ([^|]*) \|", text, flags=re.MULTILINE)[1:]
        self.assertGreater(len(words), 50)
        self.assertEqual(words, sorted(words, key=lambda word: word.lower().replace("-", " ")))


class HardScenes(unittest.TestCase):
    """The table of whole-frame scenes, by tools/hard_scenes.py."""

    def check(self, *arguments):
        return subprocess.run([sys.executable, HARD_SCENES, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True)

    @staticmethod
    def output(**changes):
        row = {"scene": "mirror", "backend": "vk", "technique": "agaa", "samples": 8, "aggregates": 2, "tier": "ids",
               "preset": "", "shades": "aggregates", "mseTm": 2e-4, "maxMseTm": 1e-3, "meanError": 0.01,
               "maxMeanError": 0.02, "frames": 2, "nonFinite": 0, "sanitised": 0, "lostFragments": 0, "exceeds": "",
               "check": {"value": 0.5, "bound": 1}}
        return {"devices": [{"backend": "vk", "device": "device", "driver": "driver"}], "refusals": [],
                "scenes": [{"scene": "mirror", "cases": "2", "check": "the plane"}], "results": [row | changes]}

    def summarised(self, *outputs):
        """The process and the document of a summary of these outputs."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "docs/results").mkdir(parents=True)
            document = root / "docs/numerics.md"
            document.write_text("Before.\n<!-- hard-scenes begin -->\n<!-- hard-scenes end -->\nBehind.\n")
            for i, output in enumerate(outputs):
                (root / f"{i}.json").write_text(json.dumps(output))
            run = self.check("--root", folder, "--summarise", *(str(root / f"{i}.json") for i in range(len(outputs))))
            again = self.check("--root", folder)
            text = document.read_text()
            document.write_text(text.replace("2.0e-4", "3.0e-4"))
            return run, again, self.check("--root", folder), text

    def test_kept_table_is_current(self):
        result = self.check()
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_kept_run_is_finite_in_every_technique(self):
        kept = json.loads((ROOT / "docs/results/hard-scenes.json").read_text())
        self.assertEqual(kept["nonFinite"], 0)
        self.assertGreater(kept["frames"], 900)
        self.assertEqual({device["backend"] for device in kept["devices"]}, {"vk", "gl"})

    def test_table_has_the_nearest_configurations(self):
        run, again, stale, text = self.summarised(self.output(), self.output(backend="gl", mseTm=1e-4))
        self.assertEqual((run.returncode, again.returncode), (0, 0), run.stderr + again.stderr)
        self.assertEqual(stale.returncode, 1)
        self.assertIn("is not current", stale.stderr)
        self.assertIn("| `mirror` | 2 | – | – | – | 2.0e-4 of 1.0e-3 | – | – | agaa n=8 c=2 ids vk | the plane: 0.5 of 1 |", text)
        self.assertIn("2 combinations of a scene, a configuration and an API took 4 frames", text)

    def test_outputs_are_added_to_the_kept_results(self):
        def output(bound, **changes):
            made = self.output(**changes)
            made["scenes"][0]["bounds"] = {"aggregates": {"maxMseTm": bound, "maxMeanError": 0.02},
                                           "one event": {"maxMseTm": 5e-3, "maxMeanError": 0.02}}
            return made

        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "docs/results").mkdir(parents=True)
            (root / "docs/numerics.md").write_text("<!-- hard-scenes begin -->\n<!-- hard-scenes end -->\n")
            for name, made in (("kept", output(1e-3)), ("added", output(3e-3, technique="visibility", aggregates=0, tier="auto",
                                                                        shades="one event", mseTm=4e-3, maxMseTm=5e-3))):
                (root / name).write_text(json.dumps(made))
            for option, name in (("--summarise", "kept"), ("--add", "added")):
                run = self.check("--root", folder, option, str(root / name))
                self.assertEqual(run.returncode, 0, run.stderr)
            text = (root / "docs/numerics.md").read_text()
        self.assertIn("| 2.0e-4 of 3.0e-3 | – | 4.0e-3 of 5.0e-3 | visibility n=8 vk | the plane: 0.5 of 1 |", text)
        self.assertIn("2 combinations of a scene, a configuration and an API took 4 frames", text)

    def test_bounds_are_twice_the_largest_errors(self):
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(self.output(mseTm=2.04e-4), file)
            file.flush()
            run = self.check("--bounds", file.name)
        self.assertIn("mirror: .maxMseTm = bounds(1e-06, 1e-06, 1e-06, 0.00041, 1e-06, 1e-06)", run.stdout, run.stderr)
        self.assertIn("mirror: .maxMeanError = bounds(0.001, 0.001, 0.001, 0.02, 0.001, 0.001)", run.stdout)

    def test_runs_beyond_a_bound_are_not_kept(self):
        run, *_ = self.summarised(self.output(exceeds="error"))
        self.assertEqual(run.returncode, 1)
        self.assertIn("mirror, agaa n=8 c=2 ids vk: error", run.stderr)


class HardCases(unittest.TestCase):
    FIGURES = '{"case": %d, "measure": "error", "naive": "not finite", "ours": 2e-7, "bound": 1e-6, "inputs": 100000}'
    CELLS = " | error | not finite | 2e-7 | 1e-6 | 100,000 | "

    def check(self, *arguments):
        return subprocess.run([sys.executable, HARD_CASES, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True)

    def folder(self, cases):
        """A source tree of a table of these cases, with figures, and the paths of its table, a test and a program."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        root = pathlib.Path(folder.name)
        for name in ("docs/results", "tests/math", "build/bin"):
            (root / name).mkdir(parents=True)
        rows = "".join(f"| {case} | failure | form | code |\n" for case in cases)
        (root / "docs/numerics.md").write_text(f"| case | failure |\n|---|---|\n{rows}")
        (root / "docs/results/hard-cases.json").write_text(f"[{', '.join(self.FIGURES % case for case in cases)}]")
        (root / "tests/math/a_test.cpp").write_text("".join(f"TEST(HardCase0{case}_A, B) {{}}\n" for case in cases))
        return root

    def program(self, root, *figures):
        """Programs of which the first one prints these figures."""
        for name, lines in (("test_math_numeric", figures), ("test_core_unit", ())):
            path = root / "build/bin" / name
            path.write_text("#!/bin/sh\n" + "".join(f"echo '[hard case] {line}'\n" for line in lines))
            path.chmod(0o755)

    def test_tables_are_current_and_complete(self):
        result = self.check()
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_stale_tables_and_unknown_cases_fail(self):
        root = self.folder([1, 2])
        self.assertRegex(self.check("--root", root).stderr, "not current.*: 1, 2")
        self.assertEqual(self.check("--root", root, "--update").returncode, 0)
        self.assertEqual(self.check("--root", root).returncode, 0)
        table = (root / "docs/numerics.md").read_text()
        self.assertIn(f"| 2 | failure | form | code{self.CELLS}math | `tests/math/a_test.cpp` |\n", table)
        self.assertIn("| case | failure | stable form | code | error | naive | ours | bound | inputs | APIs | tests |",
                      table)
        (root / "tests/stages_support").mkdir()
        (root / "tests/stages_support/b.h").write_text("// docs/numerics.md, cases 1 and 2\n")
        self.assertRegex(self.check("--root", root).stderr, "not current.*: 1, 2")
        self.assertEqual(self.check("--root", root, "--update").returncode, 0)
        self.assertIn("| math, Vulkan, OpenGL | `tests/math/a_test.cpp`, `tests/stages_support/b.h` |",
                      (root / "docs/numerics.md").read_text())
        (root / "tests/stages_support/b.h").write_text("// hard cases 1 to 3\n")
        self.assertRegex(self.check("--root", root).stderr, r"lacks cases.*: 3 \(tests/stages_support/b.h\)")

    def test_cases_without_test_or_figures_fail(self):
        root = self.folder([1, 2])
        (root / "tests/math/a_test.cpp").write_text("TEST(HardCase01_A, B) {} // hard case 2\n")
        self.assertRegex(self.check("--root", root, "--update").stderr, "without a test by number: 2")
        self.assertRegex(self.check("--root", root).stderr, "without a test by number: 2")
        root = self.folder([1, 2])
        (root / "docs/results/hard-cases.json").write_text(f"[{self.FIGURES % 1}]")
        self.assertRegex(self.check("--root", root, "--update").stderr, "without figures: 2")

    def test_measured_figures_are_kept_with_two_digits(self):
        root = self.folder([1])
        self.program(root, (self.FIGURES % 1).replace("2e-7", "3.456e-7"))
        self.assertEqual(self.check("--root", root, "--measure", root / "build").returncode, 0)
        self.assertEqual(json.loads((root / "docs/results/hard-cases.json").read_text())[0]["ours"], 3.5e-7)
        self.assertIn("| not finite | 3.5e-7 |", (root / "docs/numerics.md").read_text())
        self.program(root, self.FIGURES % 1, self.FIGURES % 1)
        self.assertRegex(self.check("--root", root, "--measure", root / "build").stderr, "1 has the figures of two")

    def test_figures_of_another_magnitude_differ(self):
        root = self.folder([1, 2])
        for printed, differs in (("2e-7", False), ("9e-7", False), ("4e-8", False), ("3e-9", True), ("4e-6", True)):
            self.program(root, self.FIGURES % 1, (self.FIGURES % 2).replace("2e-7", printed))
            result = self.check("--root", root, "--compare", root / "build")
            self.assertEqual(result.returncode, int(differs), printed)
            if differs:
                self.assertRegex(result.stderr, r"not what the tests print.*: 2\.")
        self.program(root, self.FIGURES % 1)
        self.assertRegex(self.check("--root", root, "--compare", root / "build").stderr, "print.*: 2")


class Format(unittest.TestCase):
    def test_check_names_files_that_differ(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / ".clang-format").write_text((ROOT / ".clang-format").read_text())
            good, bad = (pathlib.Path(folder) / name for name in ("good.cpp", "bad file.cpp"))
            good.write_text("int a;\n")
            bad.write_text("int  a;\n")
            result = subprocess.run([FORMAT, "--check", good, bad], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            if result.returncode == 77:
                self.skipTest(result.stderr)
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            self.assertEqual(result.stderr.splitlines()[1:], [str(bad)])
            self.assertEqual(subprocess.run([FORMAT, good, bad]).returncode, 0)
            self.assertEqual(bad.read_text(), "int a;\n")
            self.assertEqual(subprocess.run([FORMAT, "--check", good, bad]).returncode, 0)

    def test_unknown_options_fail(self):
        result = subprocess.run([FORMAT, "--help"], stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("--help", result.stderr)


class Tool(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.source = pathlib.Path(folder.name) / "host.c"
        self.document = pathlib.Path(folder.name) / "guide.md"
        self.source.write_text(SOURCE)
        self.document.write_text(DOCUMENT)

    def run_tool(self, *arguments):
        return quotes("--root", self.source.parent, *arguments, self.document)

    def assert_refused(self, sentence):
        result = self.run_tool()
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, sentence)

    def test_current_quotes_pass(self):
        result = self.run_tool()
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_stale_quotes_fail_and_are_rewritten(self):
        self.document.write_text(DOCUMENT.replace("return other", "return old").replace("LIMIT 3", "LIMIT 4"))
        self.assert_refused("\"used\" of host.c.*\"LIMIT\" of host.c")
        self.assertEqual(self.run_tool("--update").returncode, 0)
        self.assertEqual(self.document.read_text(), DOCUMENT)

    def test_missing_and_ambiguous_definitions_fail(self):
        self.document.write_text(DOCUMENT.replace("host.c used", "host.c gone"))
        self.assert_refused("defines \"gone\" 0 times")
        self.document.write_text(DOCUMENT.replace("host.c used", "other.c used"))
        self.assert_refused("other.c is not there")
        self.source.write_text(SOURCE + "\nint used(void) {\n}\n")
        self.document.write_text(DOCUMENT)
        self.assert_refused("defines \"used\" 2 times")

    def test_quotes_without_a_block_fail(self):
        self.document.write_text(DOCUMENT + "<!-- quote host.c used -->\nno block\n")
        self.assert_refused("without a fenced block")


class Prices(unittest.TestCase):
    """Constants of the planner, and words of the page, that docs/results/lavapipe has the figures of."""

    @classmethod
    def setUpClass(cls):
        results = json.loads((ROOT / "docs/results/lavapipe/sweep/results.json").read_text())
        cls.scenes = [scene for scene in results["backends"][0]["scenes"] if not scene["plain"]]

    def price(self, file, name):
        return float(re.search(rf"\b{name} = ([0-9.]+)f", (ROOT / "src/core" / file).read_text())[1])

    def frame(self, scene, tier):
        def is_wanted(row):
            way = row["tiers"].get("generation")
            key = (row["technique"], row["n"], row["c"], row["shadingCost"], row["preset"])
            return key == ("agaa", 8, 2, 1, "") and (way if way in ("gbuffer", "ids") else None) == tier

        return next(row["frameMs"]["median"] for row in scene["rows"] if is_wanted(row))

    def test_of_tiers(self):
        for name, tier in (("gbufferCost", "gbuffer"), ("idsCost", "ids")):
            measured = [self.frame(scene, tier) / self.frame(scene, None) for scene in self.scenes]
            self.assertAlmostEqual(statistics.median(measured), self.price("plan/techniques/generation_tiers.cpp", name), delta=0.05)

    def test_of_causes(self):
        """What the page of a sweep says of aggregates that err more than surfaces of SBAA."""
        scenes = json.loads((ROOT / "docs/results/lavapipe/causes.json").read_text())["scenes"].values()

        def err_more(without):
            merged = [next(row for row in rows if row["without"] == without)["toAllSamples"] for rows in scenes]
            return sum(errors["agaa n=8 c=2"] > errors["sbaa n=8 S=4"] for errors in merged)

        self.assertGreater(err_more("nothing"), 0)
        self.assertLess(err_more("specular"), err_more("nothing") / 2, "on most it is the specular light")
        self.assertGreater(err_more("shadows"), err_more("nothing") / 2, "and not the shadows")

    def test_of_lit_aggregates(self):
        effects = json.loads((ROOT / "docs/results/lavapipe/effects/times.json").read_text())["effects"]
        self.assertAlmostEqual(effects["lit-aggregates"]["ratio"], self.price("plan/plan_shading.cpp", "litCost"), delta=0.02)


if __name__ == "__main__":
    unittest.main()
