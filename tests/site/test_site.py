"""The site that scripts/site makes: complete, without lost text, and with links that resolve."""
import collections
import functools
import html
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

SOURCE = pathlib.Path(os.environ["AGAA_SOURCE"])
SITE = pathlib.Path(os.environ["AGAA_BUILD"]) / "site-test" / "a site"
sys.path.insert(0, str(SOURCE / "tools" / "site"))

import convert  # noqa: E402
import declarations  # noqa: E402
import guides  # noqa: E402

ROW = re.compile(r'<tr class="memitem:(\w+)">(.*?)</tr>\s*(?:<tr class="memdesc:\1">(.*?)</tr>)?', re.DOTALL)
VALUE = re.compile(r'<td class="fieldname"><a id="(\w+)"[^>]*></a>(\w+)&#160;</td><td class="fielddoc">(.*?)</td>', re.DOTALL)
NAME = re.compile(r'<td class="memItemRight"[^>]*>(?:<b>|<a class="el" href="[^"]*">)(\w+)</')


def run_site(*arguments):
    return subprocess.run([SOURCE / "scripts/site", *arguments], capture_output=True, text=True)


def text_of(source):
    return html.unescape(re.sub(r"<[^>]*>", " ", source))


def words(source):
    """Words between spaces, without the marks of emphasis around them."""
    return " " + " ".join(word.strip("_") for word in re.findall(r"\w+", source) if word.strip("_")) + " "


class Page(html.parser.HTMLParser):
    """The anchors and the links of a page."""

    def __init__(self, source):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(source)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


class Site:
    def __init__(self):
        self.sources = {path.name: path.read_text() for path in SITE.glob("*.html")}
        self.pages = {name: Page(source) for name, source in self.sources.items()}
        self.interface = {name: source for name, source in self.sources.items() if name.startswith(("group__", "struct"))}

    def described(self):
        """Texts by (page, name), of members, functions, types, values and macros."""
        found = {}
        for page, source in self.interface.items():
            for _, item, text in ROW.findall(source):
                name = NAME.search(item)
                if name:
                    found[page, name[1]] = text_of(text or "").strip()
            for _, name, text in VALUE.findall(source):
                found[page, name] = text_of(text).strip()
        return found

    def scripts_links(self):
        """Targets in the scripts of the tree, which index.html loads."""
        for path in SITE.glob("*.js"):
            if path.name.startswith(("navtreedata", "group__", "struct", "modules", "annotated", "globals")):
                for target in re.findall(r'"([\w-]+\.html(?:#[\w-]+)?)"', path.read_text()):
                    yield path.name, target


def setUpModule():
    if not shutil.which("doxygen"):
        print("doxygen is not installed: scripts/install-deps doxygen installs it.")
        raise unittest.SkipTest("doxygen is not installed")


@functools.cache
def site():
    run = run_site(SITE)
    if run.returncode:
        raise AssertionError(run.stderr)
    return Site()


class Entities(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.described = site().described()
        cls.abi = json.loads((SOURCE / "abi/agaa.json").read_text())
        cls.texts = collections.defaultdict(list)
        for (_, name), text in cls.described.items():
            cls.texts[name].append(text)

    def test_all_of_the_abi_is_described(self):
        names = [*self.abi["handles"], *self.abi["constants"], *self.abi["enums"], *self.abi["callbacks"],
                 *(function["name"] for function in self.abi["functions"]),
                 *(value for values in self.abi["enums"].values() for value in values)]
        self.assertGreater(len(names), 400)
        self.assertEqual([name for name in names if not any(self.texts[name])], [])

    def test_structs_have_pages_and_their_members_have_texts(self):
        for name, struct in self.abi["structs"].items():
            page = f"struct{name}.html"
            self.assertIn(page, site().interface)
            details = site().sources[page].split('name="details"')[1].split("<h2 class")[1]
            self.assertGreater(len(words(text_of(details)).split()), 2, name)
            for member in struct["members"]:
                self.assertTrue(self.described.get((page, member["name"])), f"{name}::{member['name']}")

    def test_functions_of_the_conformance_suite_are_described(self):
        for name in ("agaaConformanceTestLibrary", "agaaConformanceCheckHost", "AgaaConformanceGetFunction"):
            self.assertTrue(any(self.texts[name]), name)


class Text(unittest.TestCase):
    def assert_contains(self, page, lines, where):
        """Each run of words stands on the page in its order."""
        for line in lines:
            self.assertTrue(not words(line).strip() or words(line) in page, f"{where}: \"{line}\" is lost.")

    def test_no_text_of_the_headers_is_lost(self):
        page = words(" ".join(text_of(source) for source in site().interface.values()))
        described, checked = site().described(), 0
        for name, items in convert.read_headers(SOURCE).items():
            for item in items:
                below = item.members if isinstance(item, declarations.Declaration) else []
                comments = [item.text] if isinstance(item, declarations.Comment) else [item.leading, item.trailing]
                for text in (*comments, *(each for member in below for each in (member.leading, member.trailing))):
                    lines = [part for line in re.sub(r"^SPDX.*", "", text, flags=re.MULTILINE).split("\n")
                             for part in re.split(r" {2,}|^- ", line) if part.strip(" -")]
                    lines = [part for line in lines for part in ([line] if not re.fullmatch(r"(\w+, )+\w+", line) else line.split(","))]
                    lines = ["Return values" if line in ("Returns", "Errors") else re.sub(r"^-+ (.*?) -+$", r"\1", line) for line in lines]
                    if re.match(r"-{3,} ", text):
                        lines = [line[0].upper() + line[1:] for line in lines]
                    # Keys that describe flags have the names of the flags on the site.
                    lines = [line for line in lines if not re.fullmatch(r"[A-Z][A-Z_]+", line)
                             or not any(found.endswith("_" + line) for _, found in described)]
                    self.assert_contains(page, lines, name)
                    checked += len(lines)
        self.assertGreater(checked, 1500)

    def test_no_text_of_the_guides_is_lost(self):
        for guide in convert.read_guides(SOURCE):
            page = words(text_of(site().sources[f"{guide.label}.html"]))
            text = re.sub(r"^<!--.*?-->$", "", guide.text, flags=re.MULTILINE | re.DOTALL)
            text = re.sub(r"^ *```\w*$", "", text, flags=re.MULTILINE)
            text = re.sub(r"!\[[^\]]*\]\([^)\s]*\)|(?<=\])\([^)\s]*\)", " ", text)
            for line in text.replace("\\_", "_").split("\n"):
                cells = re.split(r"(?<!\\)\|", line) if line.lstrip().startswith("|") else [line]
                cells = [re.sub(r"^\s*\d+\. ", " ", cell) if "    " not in line else cell for cell in cells]
                self.assert_contains(page, cells, f"{guide.path}: {line}")


class Links(unittest.TestCase):
    def test_links_resolve(self):
        checked = 0
        targets = [(name, link) for name, page in site().pages.items() for link in page.links]
        for name, link in [*targets, *site().scripts_links()]:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https", "mailto"):
                continue
            self.assertFalse(parts.scheme and parts.scheme != "javascript", f"{name}: {link}")
            if parts.scheme:
                continue
            path = urllib.parse.unquote(parts.path) or name
            self.assertTrue((SITE / path).is_file(), f"{name}: {link}")
            if parts.fragment and path in site().pages:
                self.assertIn(urllib.parse.unquote(parts.fragment), site().pages[path].anchors, f"{name}: {link}")
            checked += 1
        self.assertGreater(checked, 5000)

    def test_nothing_is_loaded_from_elsewhere(self):
        for name, source in site().sources.items():
            self.assertEqual(re.findall(r"<(?:script|link|img|iframe)[^>]*(?:src|href)=\"(?:https?:)?//[^>]*>", source), [], name)

    def test_guides_and_headers_are_reached_from_the_start(self):
        tree = collections.defaultdict(set)
        for name, page in site().pages.items():
            tree[name] |= {link.split("#")[0] for link in page.links}
        # The tree of the site is in scripts, which each page loads.
        tree["index.html"] |= {target.split("#")[0] for _, target in site().scripts_links()}
        reached, waiting = {"index.html"}, ["index.html"]
        while waiting:
            for target in tree[waiting.pop()] & site().pages.keys() - reached:
                reached.add(target)
                waiting.append(target)
        wanted = {f"{guide.label}.html" for guide in convert.read_guides(SOURCE)}
        self.assertGreater(len(wanted), 50)
        self.assertEqual(wanted - reached, set())
        self.assertEqual(site().interface.keys() - reached, set())

    def test_images_are_shown(self):
        shown = {link for page in site().pages.values() for link in page.links if link.startswith("images/")}
        self.assertGreater(len(shown), 10)

    def test_the_start_is_the_readme(self):
        title = guides.Guide("README.md", (SOURCE / "README.md").read_text()).title
        self.assertIn(f'<div class="title">{title}', site().sources["index.html"])


class Command(unittest.TestCase):
    def test_it_replaces_its_own_site_only(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "mine").write_text("")
            run = run_site(folder)
            self.assertEqual((run.returncode, sorted(os.listdir(folder))), (1, ["mine"]))
            self.assertRegex(run.stderr, r"^.* is not a site that scripts/site made\.\n$")
        site()
        (SITE / "old.html").write_text("")
        run = run_site(SITE)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn(f"{SITE}/index.html", run.stdout)
        self.assertFalse((SITE / "old.html").exists())
        self.assertEqual(os.listdir(SITE.parent), [SITE.name])

    def test_wrong_arguments(self):
        for arguments in (["--no"], ["a", "b"]):
            run = run_site(*arguments)
            self.assertEqual(run.returncode, 2)
            self.assertEqual(run.stderr.count("\n"), 1)

    def test_warnings_are_errors(self):
        """Doxygen fails with a function that has no text, and with a reference to nothing."""
        for comment in ("", "/** \\brief See \\ref nothing. */", "/** \\brief F. */"):
            with tempfile.TemporaryDirectory() as folder:
                options = (SOURCE / "tools/site/Doxyfile").read_text()
                options = re.sub(r"^(?:LAYOUT_FILE|HTML_EXTRA_STYLESHEET) .*$", "", options, flags=re.MULTILINE)
                (pathlib.Path(folder) / "Doxyfile").write_text(options + "INPUT = a.h\n")
                (pathlib.Path(folder) / "a.h").write_text(f"/** \\file a.h\n * \\brief A. */\n{comment}\nint f(void);\n")
                run = subprocess.run(["doxygen"], cwd=folder, capture_output=True, text=True)
                self.assertEqual(run.returncode != 0, comment != "/** \\brief F. */", run.stderr)


if __name__ == "__main__":
    unittest.main()
