"""Converters of headers and guides for Doxygen (tools/site), with small inputs."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["AGAA_SOURCE"])
TOOLS = SOURCE / "tools" / "site"
sys.path.insert(0, str(TOOLS))

import comments  # noqa: E402
import declarations  # noqa: E402
import guides  # noqa: E402
import headers  # noqa: E402
import interface  # noqa: E402
import markup  # noqa: E402


def read(source):
    return declarations.read(source, "a.h")


def converted(source, name="a.h"):
    """A header as Doxygen reads it, with one space for the marks and ends of lines."""
    items = {name: declarations.read(source, name)}
    known = interface.Interface(items)
    linker = markup.Linker()
    linker.names, linker.bits = set(known.known), interface.flag_anchors(items)
    written = headers.Writer(name, known, linker).write("A header")
    return written, " ".join(word for word in written.split() if word not in ("*", "/**", "*/"))


class Declarations(unittest.TestCase):
    def test_comments_belong_to_what_they_stand_before_or_behind(self):
        first, second, third = read("/* Before. */\nint f(int a);\nint g(void); /* behind */\n\nint h;\n")
        self.assertEqual((first.kind, first.name, first.leading, first.parameters), ("function", "f", "Before.", ["a"]))
        self.assertEqual((second.trailing, second.leading, second.isAdjacent), ("behind", "", True))
        self.assertEqual((third.name, third.leading, third.isAdjacent), ("h", "", False))

    def test_members_have_their_comments(self):
        struct, = read("typedef struct S {\n  /* Before. */\n  int a;\n  float b, c[2]; /* behind\n      both */\n"
                       "  void (*run)(int x, int y); // line\n} S; /* of S */\n")
        found = [(member.name, member.code, member.leading, member.trailing) for member in struct.members]
        self.assertEqual(found, [("a", "int a", "Before.", ""), ("b", "float b", "", "behind\nboth"),
                                 ("c", "float c[2]", "", "behind\nboth"), ("run", "void (*run)(int x, int y)", "", "line")])
        self.assertEqual((struct.name, struct.trailing), ("S", "of S"))

    def test_enumerators_and_macros(self):
        enum, macro = read("typedef enum E { E_A = 0, /* a */ E_B = 1 /* last */ } E;\n"
                           "#define M \\\n    UINT64_C(1) /* first \\\n  second */\n")
        self.assertEqual([(value.code, value.trailing) for value in enum.members], [("E_A = 0", "a"), ("E_B = 1", "last")])
        self.assertEqual((macro.name, macro.trailing), ("M", "first\nsecond"))
        self.assertNotIn("first", macro.code)

    def test_guards_are_kept_out_and_conditions_skipped(self):
        items = read("#ifndef A_H\n#define A_H\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n#if X\n#if Y\nint no;\n#endif\n"
                     "#endif\nint yes;\n#endif /* A_H */\n")
        self.assertEqual([item.name for item in items], ["yes"])

    def test_marks_in_strings_and_lines_are_no_comments(self):
        items = read("#define S \"/* no */ // no\"\n/* It's \"one\" quote: \". */\nint a;\n// b */ c\nint d;\n")
        self.assertEqual([(item.name, item.leading) for item in items],
                         [("S", ""), ("a", "It's \"one\" quote: \"."), ("d", "b */ c")])
        self.assertIn("\"/* no */ // no\"", items[0].code)

    def test_damaged_headers_fail_with_a_sentence(self):
        for source, sentence in (("int a;\n/* no end", "a.h:2: a comment does not end"), ("int a", "a.h:1: a decl.* does not end"),
                                 ("struct S { int a;", "a.h:1: a decl.* does not end"), ("int a; }\n", "a bracket closes"),
                                 ("#if X\nint a;\n", "a.h:1: #if has no #endif"), ("enum { A };", "an? enum has no name"),
                                 ("struct S {\n#if X\nint a;\n#endif\n};", "a.h:2: a preprocessor line"), ("+;", "not a declaration")):
            with self.subTest(source), self.assertRaisesRegex(declarations.SourceError, sentence):
                read(source)


class Comments(unittest.TestCase):
    def test_items_hold_their_lines(self):
        blocks = comments.parse("Does.\n\nname, size   First\n             second.\nErrors   CODE_A   one\n"
                                "                  two\n         CODE_B   three\n         A sentence.\nThreads  Any.")
        self.assertEqual(blocks[0], comments.Paragraph("Does."))
        self.assertEqual(blocks[1], comments.Item(["name", "size"], [comments.Paragraph("First second.")]))
        self.assertEqual([each.keys for each in blocks[2].blocks[:2]], [["CODE_A"], ["CODE_B"]])
        self.assertEqual(blocks[2].blocks[0].blocks, [comments.Paragraph("one two")])
        self.assertEqual(blocks[2].blocks[2], comments.Paragraph("A sentence."))
        self.assertEqual(blocks[3].keys, ["Threads"])

    def test_code_and_bullets(self):
        blocks = comments.parse("The text defines\n    void f(int a)\n    void g()\nwhich runs:\n- one\n  more\n- two")
        self.assertEqual(blocks[1], comments.Code("void f(int a)\nvoid g()"))
        self.assertEqual(blocks[3].items, [[comments.Paragraph("one more")], [comments.Paragraph("two")]])

    def test_unusual_comments(self):
        for source in ("", "\n\n", "   deep", "- ", "a  b", "Errors   ", "x   y\nz", "- a\n\n- b"):
            with self.subTest(source):
                comments.parse(source)
        self.assertEqual(comments.parse("SPDX-License-Identifier: MIT\nText."), [comments.Paragraph("Text.")])

    def test_first_sentence(self):
        for source, first in (("One. Two.", "One."), ("In [0.5, 1]. 0 is off.", "In [0.5, 1]."), ("Only one", "Only one"),
                              ("By Olano et al. Twice.", "By Olano et al. Twice."), ("Is 1.0 or e.g. Two", "Is 1.0 or e.g. Two")):
            self.assertEqual(comments.first_sentence(source)[0], first)


class Headers(unittest.TestCase):
    def test_functions(self):
        _, text_of = converted("/* Copies. It is fast.\n *\n * from     Source.\n * to, n    Rest.\n *\n * Returns  AGAA_OK.\n"
                               " * Errors   Those of f, and\n *          AGAA_A, AGAA_B   no room\n * OpenGL   Current. */\n"
                               "AGAA_API int AGAA_CALL f(int from, int* to, int n);\n")
        self.assertIn("\\brief Copies. It is fast. \\param from Source. \\param to,n Rest. \\return AGAA_OK. \\par Errors Those of "
                      "\\ref f \"f\", and \\retval AGAA_A no room \\retval AGAA_B no room \\par OpenGL Current. "
                      "int f(int from, int* to, int n);", text_of)

    def test_sections_and_flags_become_groups(self):
        written, text_of = converted(
            "/* About. */\n/* ---- first part ---- */\n\n/* Bits of S::flags: effects. More.\n *\n * ONE   is one */\n"
            "#define AGAA_F_ONE 1\n/* Is two. */\n#define AGAA_F_TWO 2\n\n/* Chain it. */\ntypedef struct S {\n"
            "  int flags; /* AGAA_F_… */\n} S;\n/* ---- second ---- */\nint f(void);\n")
        self.assertIn("\\defgroup a_first_part First part \\ingroup a", text_of)
        self.assertIn("\\name Bits of S::flags: effects \\anchor bits_agaa_f More. @{ \\brief is one #define AGAA_F_ONE 1", text_of)
        self.assertIn("\\brief Is two. #define AGAA_F_TWO 2 @} \\brief Chain it. typedef struct S {", text_of)
        self.assertIn("\\ref bits_agaa_f \"AGAA_F_…\"", text_of)
        self.assertEqual(written.count("@{"), written.count("@}"))

    def test_declarations_without_comments_have_texts(self):
        _, text_of = converted("typedef struct AgaaLog {\n uint32_t sType;\n uint32_t lineCount;\n const char* lines;\n} AgaaLog;\n"
                               "#define AGAA_LOG_INIT {0}\nvoid agaaInitLog(AgaaLog* out);\ntypedef enum AgaaKind {\n"
                               " AGAA_KIND_NEAR_END = 0,\n AGAA_KIND_MAX_ENUM = 1\n} AgaaKind;\nint agaaUse(AgaaKind kind);\n")
        for expected in ("\\brief Log.", "Number of elements of lines.", "\\brief Near end.",
                         "Initialises a struct \\ref AgaaLog \"AgaaLog\" with its defaults.", "as \\ref AGAA_LOG_INIT",
                         "No value of the enumeration", "\\brief Kind. Used by \\ref agaaUse"):
            self.assertIn(expected, text_of)

    def test_labels_of_several_members(self):
        _, text_of = converted("typedef enum E {\n E_A = 0, /* zero */\n /* near */\n E_B = 1, /* one */\n E_C = 2, /* two */\n} E;\n"
                               "typedef struct S {\n /* Sizes: */\n int a; /* first */\n int b; /* second */\n} S;\n")
        self.assertIn("\\brief zero E_A = 0, \\brief near: one E_B = 1, \\brief near: two E_C = 2,", text_of)
        self.assertIn("\\brief Sizes: first int a; \\brief second int b;", text_of)

    def test_comments_without_a_declaration_are_kept(self):
        _, text_of = converted("/* About. */\n\n/* Note. */\n\nint agaaA(void);\n/* Last one. */\n/* ---- end ---- */\n/* Lost? */\n")
        self.assertIn("\\brief Note. int agaaA(void); \\addtogroup a \\brief Last one.", text_of)
        self.assertIn("\\addtogroup a_end \\brief Lost?", text_of)

    def test_two_declarations_share_a_comment(self):
        _, text_of = converted("/* Both. */\nint agaaA(void);\nint agaaB(void);\n\nint agaaC(void);\n")
        self.assertIn("\\brief Both. int agaaA(void); \\brief Both. int agaaB(void); \\brief C. int agaaC(void);", text_of)

    def test_no_text_is_a_command(self):
        written, text_of = converted("/* Uses <i> & \\file, @page 100% $x #define --long \"q\" ::z [0, 1](x) *y* `x<y`. */\nint agaaA;\n"
                                     "// Ends */ here \\\n// and here\nint agaaB;\n")
        self.assertIn("Uses &lt;i&gt; &amp; \\\\file, \\@page 100\\% \\$x \\#define \\--long &quot;q&quot; \\::z [0, 1](x) *y* "
                      "<code>x&lt;y</code>. int agaaA;", text_of)
        self.assertIn("Ends *&zwj;/ here", text_of)
        self.assertEqual(written.count("/**"), written.count("*/"))


class Guides(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "docs/images").mkdir(parents=True)
        (self.root / "docs/images/a.png").write_bytes(b"")
        (self.root / "LICENSE").write_text("")

    def page(self, body, path="docs/in/a.md", others=()):
        linker = markup.Linker()
        linker.names = {"AgaaFrame", "AgaaFrame::view", "agaaRun"}
        known = [guides.Guide(path, "# Title\n\n" + body), *(guides.Guide(*other) for other in others)]
        self.pages = guides.Pages(self.root, known, linker)
        return self.pages.write(known[0]).replace("///", "").replace("\n", " ").replace("  ", " ")

    def test_blocks(self):
        made = self.page("Text\nmore.\n\n## A `b` part\n\n* one\n  * deep\n* two\n\n1. first\n\n   again\n2. second\n\n"
                         "| a | b |\n|---|--:|\n| `x\\|y` | 1 |\n\n```c\nint a; /* b */\n```\n\n    echo --x\n")
        for expected in ("\\page docs_in_a Title", "\\section docs_in_a_a_b_part A b part", "<li> one <ul> <li> deep </li> </ul>",
                         "<ol> <li> first again </li> <li> second </li> </ol>", "<td align=\"right\">1</td>", "<code>x|y</code>",
                         "\\code{.c} int a; /* b */ \\endcode", "\\code{.unparsed} echo --x \\endcode"):
            self.assertIn(expected, " ".join(made.split()))

    def test_links(self):
        made = self.page("[up](../B.md) [`part`](../B.md#a-part) [here](#an-end) [web](https://a.org/x?a=b&c) [law](../../LICENSE) "
                         "![a \"b\"](../images/a.png) `AgaaFrame::view` agaaRun() AgaaFrames\n\n## An end\n",
                         others=[("docs/B.md", "# B\n\n## A part\n\n## A part\n")])
        for expected in ("\\ref docs_b \"up\"", "<code>\\ref docs_b_a_part \"part\"</code>", "\\ref docs_in_a_an_end \"here\"",
                         "<a href=\"https://a.org/x?a=b&amp;c\">web</a>", " law ", "<img src=\"images/a.png\" alt=\"a &quot;b&quot;\"/>",
                         "<code>\\ref AgaaFrame::view \"AgaaFrame::view\"</code> \\ref agaaRun \"agaaRun()\" AgaaFrames"):
            self.assertIn(expected, made)
        self.assertEqual(self.pages.dropped, [("docs/in/a.md", "LICENSE")])
        self.assertEqual(self.pages.images, {"docs/images/a.png": "images/a.png"})

    def test_repeated_headings_have_anchors_of_their_own(self):
        self.assertEqual([anchor for *_, anchor in guides.headings("# A\n## B\n```\n## no\n```\n## B\n### `B`, c_d\n")],
                         ["a", "b", "b-1", "b-c_d"])

    def test_no_text_is_a_command(self):
        made = self.page("a \\@b @page `\\file` #x 50% a_b_c 2 * 3 * 4 ** x \\*y\\* <x@y> -- `--z` *em* **bold**\n")
        self.assertIn("a \\@b \\@page <code>\\\\file</code> \\#x 50\\% a_b_c 2 * 3 * 4 ** x *y* &lt;x\\@y&gt; \\-- <code>\\--z</code> "
                      "<em>em</em> <b>bold</b>", made)

    def test_refusals(self):
        for body, sentence in (("[a](no.md)", "no.md, which does not exist"), ("[a](#no)", "has no heading #no"),
                               ("[a](../../../etc)", "does not exist"), ("![a](no.png)", "image no.png does not exist"),
                               ("```\na", "a block of code does not end"), ("```perl\na\n```", "language \"perl\""),
                               ("<div>a</div>", "does not read"), ("> a", "does not read"), ("a\n---", "does not read"),
                               ("###### a", "too deep"), ("| a |\n|---|---|\n", "a table has 1 columns")):
            with self.subTest(body), self.assertRaisesRegex(declarations.SourceError, f"docs/in/a.md: .*{sentence}"):
                self.page(body)
        with self.assertRaisesRegex(declarations.SourceError, "must begin with a heading"):
            guides.Guide("a.md", "Text.\n")

    def test_a_source_that_cannot_be_converted_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, TOOLS / "convert.py", "--root", folder, f"{folder}/out"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"^.*agaa_sdk.h.*\n$")


if __name__ == "__main__":
    unittest.main()
