"""The rules for comments and names (tools/prose.py), in folders whose comments keep to them."""
import os
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["AGAA_SOURCE"])
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))
import prose  # noqa: E402

# Folders and files, from the root, that must have no finding. The test prints the number of findings of all others.
DONE = ("benchmark", "cmake", "conformance", "include", "samples", "src")


class Sources(unittest.TestCase):
    def test_done_folders_keep_the_rules(self):
        found = prose.findings(ROOT, prose.FOLDERS)
        def is_done(finding):
            return any(finding.path == done or finding.path.startswith(done + "/") for done in DONE)
        print("\n".join(["Findings outside the folders that are done:",
                         *prose.counts(finding for finding in found if not is_done(finding))]))
        bad = [f"{f.path}:{f.line}: {f.rule}: {f.text}" for f in found if is_done(f)]
        self.assertEqual(bad, [], "\n" + "\n".join(bad))

    def test_done_folders_exist(self):
        for done in DONE:
            self.assertTrue((ROOT / done).exists(), done)


class Fragments(unittest.TestCase):
    FRAGMENTS = """Of the targets that a draw clears.
What a technique is: a row of a table.
That of the frame.
Whether sample i lies on the plane.
Those of whole numbers become 0.
The same as JPEG.
The same where it has run.
The same, for sizes.
For thin things that shine narrowly.
With its variant.
Without what is not used.
As agaaChooseSettings. Throws Error.
By where they lie, and what they show.
And it interpolates inside.
Less than it was.
of the set that hosts bind
In memory, as before.
Where an aggregate has each channel."""
    OTHERS = """Returns the variant of this frame.
Plans and their passes.
bytes, a multiple of 4
The same buffer holds both.
If there is none, it throws.
For each pixel, the pass writes one word.
With one sample, a pass reads it.
Without a mask all samples are covered.
By default, views have no counters.
As in the paper, lanes take turns.
what: the call, as a reader of the failure would write it.
---- results ----
Whether or not a layer is used, the slot exists.
OF_ALL names a constant.
What is a tier?
Less memory is used.
(of the frame)"""

    def test_fragments(self):
        for text in self.FRAGMENTS.splitlines():
            self.assertTrue(prose.is_fragment(text), text)
            self.assertTrue(prose.is_fragment(text.replace(" ", "\n")), text)

    def test_sentences_titles_and_labels(self):
        for text in ("", *self.OTHERS.splitlines()):
            self.assertFalse(prose.is_fragment(text), text)


class Files(unittest.TestCase):
    def check(self, text, name="src/core/a.cpp"):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            path = root / name
            path.parent.mkdir(parents=True)
            path.write_text(text)
            return [(f.line, f.rule, f.text) for f in prose.findings(root, ["src"])]

    def test_comments_of_c(self):
        self.assertEqual(self.check("// Sentence begins.\n// Of these, the second line.\nint a; // of these\n"
                                    "       // of those, in the second line of a label\n"), [])
        self.assertEqual(self.check("/* Of these. */\nint a;\n\n    // That of b.\n"),
                         [(1, "fragment", "Of these."), (4, "fragment", "That of b.")])
        self.assertEqual(self.check('const char* a = "// Of these";\nauto b = R"(\n// Of these\n)";\n'), [])
        self.assertEqual(self.check("int c = 1'000;\n// That of c.\nint d = 2'000;\n"), [(2, "fragment", "That of c.")])

    def test_comments_of_scripts(self):
        self.assertEqual(self.check('set(A "# Of these") # of those\n# Of these.\n', "src/CMakeLists.txt"),
                         [(2, "fragment", "Of these.")])

    def test_retired_names(self):
        self.assertEqual(self.check("bool isHosts;\nint holds; // holds\n"),
                         [(1, "retired", "isHosts"), (2, "retired", "holds")])
        self.assertEqual(self.check("// Passes hold several rows. SizedView.\n"), [(1, "retired", "SizedView")])

    def test_columns(self):
        self.assertEqual(self.check("x" * 120 + "\n" + "x" * 121 + "\n"), [(2, "columns", "121 columns")])

    def test_references(self):
        self.assertEqual(self.check("// See src/core/a.cpp, core/a.cpp, a.cpp, src/NAME.comp and <stdio.h>.\n"), [])
        found = self.check("// See src/core/b.cpp, gone.glsl and docs/none/gone.md.\n"
                           "// And ../a.cpp, the SDK design.\n")
        self.assertEqual({text for _, rule, text in found if rule == "reference"},
                         {"src/core/b.cpp", "gone.glsl", "docs/none/gone.md", "../", "SDK design"})


if __name__ == "__main__":
    unittest.main()
