"""Writes guides in Markdown as pages for Doxygen.

It reads the part of Markdown that the guides use and refuses the rest: headings with #, paragraphs, lists, tables, code,
images, links, emphasis and comments. Doxygen's own reader of Markdown takes words for commands, and anchors and paths
otherwise than code hosts do. A link to a file that is not part of the site becomes its text.
"""
import posixpath
import re

import markup
from declarations import SourceError
from markup import escape

LANGUAGES = {"c": "c", "cpp": "cpp", "glsl": "c", "python": "py", "py": "py", "sh": "unparsed", "": "unparsed"}
MARKER = re.compile(r"^( *)([*+-]|\d+\.) +(?=\S)")
HEADING = re.compile(r"^(#{1,6}) +(.+?)(?: +#+)?$")
DELIMITER = re.compile(r"^ *\|?(?: *:?-+:? *\|)+(?: *:?-+:? *\|?)? *$")
INLINE = re.compile(r"(?P<ticks>`+)(?P<code>.+?)(?<!`)(?P=ticks)(?!`)|\\(?P<escaped>[!-/:-@\[-`{-~])|"
                    r"!\[(?P<alt>[^\]]*)\]\((?P<image>[^)\s]+)\)|\[(?P<text>(?:`[^`]*`|[^\]`])+)\]\((?P<link>[^)\s]+)\)|"
                    r"<(?P<url>https?://[^>\s]+)>|\*\*(?P<strong>\S(?:.*?\S)?)\*\*|"
                    r"(?<![\w*])(?P<mark>[*_])(?P<emphasis>[^\s*_](?:[^*_]*[^\s*_])?)(?P=mark)(?![\w*])", re.DOTALL)
LEVELS = {1: "section", 2: "section", 3: "subsection", 4: "subsubsection", 5: "paragraph"}
MAIN = "index"     # label of the first page of the site
CONTENTS_FROM = 3  # headings from which a page has a table of contents


def plain(text):
    """Text of a heading without marks."""
    text = re.sub(r"\[((?:`[^`]*`|[^\]`])+)\]\([^)\s]+\)", r"\1", text)
    return re.sub(r"\\([!-/:-@\[-`{-~])", r"\1", text).replace("`", "").replace("**", "")


def slug(title):
    """The anchor that code hosts give a heading."""
    return re.sub(r"[^\w\- ]", "", plain(title).lower()).replace(" ", "-")


def label_of(path):
    """docs/integration/views.md: docs_integration_views."""
    return re.sub(r"\W", "_", path.removesuffix(".md")).lower()


def outside_code(text):
    """Numbers and texts of the lines that are not in fences; comments are blank."""
    text = re.sub(r"^<!--.*?-->$", lambda comment: re.sub(r".", "", comment[0]), text, flags=re.MULTILINE | re.DOTALL)
    fence = ""
    for number, line in enumerate(text.split("\n"), 1):
        mark = re.match(r"^ *(`{3,}|~{3,})", line)
        if mark and not fence:
            fence = mark[1]
        elif mark and line.strip() == fence:
            fence = ""
        elif not fence:
            yield number, line


def headings(text):
    """(number of the line, level, title, anchor) of each heading; repeated anchors end with numbers."""
    seen = {}
    for number, line in outside_code(text):
        found = HEADING.match(line)
        if found:
            anchor = slug(found[2])
            count = seen[anchor] = seen.get(anchor, -1) + 1
            yield number, len(found[1]), found[2].strip(), f"{anchor}-{count}" if count else anchor


class Guide:
    """A document of the repository."""

    def __init__(self, path, text, label=""):
        self.path, self.text, self.label = path, text, label or label_of(path)
        found = list(headings(text))
        if not found or found[0][1] != 1:
            raise SourceError(f"{path}: a page must begin with a heading of the first level.")
        self.title = plain(found[0][2])
        self.anchors = {anchor: f"{self.label}_{re.sub(r'[^a-z0-9]', '_', anchor)}" for *_, anchor in found[1:]}
        if len(set(self.anchors.values())) != len(self.anchors):
            raise SourceError(f"{path}: two headings have anchors that differ in marks only.")
        self.anchors_of_lines = {number: anchor for number, *_, anchor in found[1:]}
        self.firstLine = found[0][0]


class Pages:
    """Converts guides that link each other."""

    def __init__(self, root, guides, linker):
        self.root, self.linker = root, linker
        self.guides = {guide.path: guide for guide in guides}
        self.images = {}   # path in the repository: path in the site
        self.dropped = []  # (guide, target) of links to files outside the site

    # ---- text ----------------------------------------------------------------------------------

    def fail(self, guide, sentence):
        raise SourceError(f"{guide.path}: {sentence}")

    def link(self, guide, source, target):
        text = escape(plain(source))
        made = self.target(guide, text, target)
        return f"<code>{made}</code>" if re.fullmatch(r"`[^`]*`", source) else made

    def target(self, guide, text, target):
        if re.match(r"[a-z]+:", target):
            return f"<a href=\"{escape(target)}\">{text}</a>"
        path, _, anchor = target.partition("#")
        path = posixpath.normpath(posixpath.join(posixpath.dirname(guide.path), path)) if path else guide.path
        other = self.guides.get(path)
        if not other:
            if path.startswith("..") or not (self.root / path).exists():
                self.fail(guide, f"a link goes to {target}, which does not exist.")
            self.dropped.append((guide.path, path))
            return text
        if anchor and anchor not in other.anchors:
            self.fail(guide, f"{path} has no heading #{anchor}.")
        label = other.anchors[anchor] if anchor else other.label
        return f"\\ref {label} \"{text}\""

    def image(self, guide, alt, target):
        path = posixpath.normpath(posixpath.join(posixpath.dirname(guide.path), target))
        if path.startswith("..") or not (self.root / path).is_file():
            self.fail(guide, f"the image {target} does not exist.")
        self.images[path] = "images/" + path.removeprefix("docs/").removeprefix("images/")
        return f"<img src=\"{escape(self.images[path])}\" alt=\"{escape(alt)}\"/>"

    def inline(self, guide, text):
        words = self.linker.render_words
        made, position = [], 0
        for found in INLINE.finditer(text):
            made.append(words(text[position:found.start()]))
            position = found.end()
            if found["code"] is not None:
                code = found["code"].strip() if len(found["ticks"]) > 1 else found["code"]
                made.append(f"<code>{words(code)}</code>")
            elif found["escaped"]:
                made.append(escape(found["escaped"]))
            elif found["image"]:
                made.append(self.image(guide, found["alt"], found["image"]))
            elif found["link"]:
                made.append(self.link(guide, found["text"], found["link"]))
            elif found["url"]:
                made.append(f"<a href=\"{escape(found['url'])}\">{escape(found['url'])}</a>")
            elif found["strong"]:
                made.append(f"<b>{self.inline(guide, found['strong'])}</b>")
            else:
                made.append(f"<em>{self.inline(guide, found['emphasis'])}</em>")
        return "".join(made) + words(text[position:])

    @staticmethod
    def heading(guide, level, anchor, text):
        """A section. Those of the first page are plain headings, because the tree of the site lists its sections."""
        label = guide.anchors[anchor]
        if guide.label == MAIN:
            return f"\\anchor {label}\n<h{level}>{escape(text)}</h{level}>"
        return f"\\{LEVELS[level]} {label} {markup.title(text)}"

    # ---- blocks --------------------------------------------------------------------------------

    @staticmethod
    def cells(line):
        line = line.strip()
        line = re.sub(r"(?<!\\)\|$", "", line.removeprefix("|"))
        parts = re.split(r"(?<!\\)\|", line)
        return [part.strip().replace("\\|", "|") for part in parts]

    def table(self, guide, lines):
        head, delimiter, *rows = [self.cells(line) for line in lines]
        align = [" align=\"right\"" if mark.endswith(":") and not mark.startswith(":") else
                 " align=\"center\"" if mark.startswith(":") and mark.endswith(":") and len(mark) > 1 else "" for mark in delimiter]
        if len(head) != len(delimiter):
            self.fail(guide, f"a table has {len(head)} columns and a line of {len(delimiter)} below them.")

        def row(cells, tag):
            cells = (cells + [""] * len(head))[:len(head)]
            return "<tr>" + "".join(f"<{tag}{how}>{self.inline(guide, cell)}</{tag}>" for cell, how in zip(cells, align)) + "</tr>"

        return ["<table class=\"markdownTable\">", row(head, "th"), *(row(cells, "td") for cells in rows), "</table>", ""]

    def code(self, language, lines):
        # Doxygen links names in code of C by itself.
        if self.linker.unlinked & set(re.findall(r"\w+", "\n".join(lines))):
            language = "unparsed"
        return [f"\\code{{.{language}}}", *lines, "\\endcode", ""]

    def list(self, guide, lines, position):
        """A list, its items with the blocks that are indented below them."""
        first = MARKER.match(lines[position])
        margin, isNumbered = len(first[1]), first[2][-1] == "."
        made = ["<ol>" if isNumbered else "<ul>"]
        while position < len(lines):
            marker = MARKER.match(lines[position])
            if not marker or len(marker[1]) != margin or (marker[2][-1] == ".") != isNumbered:
                break
            column = marker.end()
            body, position = [lines[position][column:]], position + 1
            while position < len(lines):
                line = lines[position]
                following = next((each for each in lines[position:] if each.strip()), "")
                inner = len(following) - len(following.lstrip())
                if not line.strip():
                    if inner < column:
                        break
                elif inner <= margin and (MARKER.match(line) or not lines[position - 1].strip() or HEADING.match(line)):
                    break
                body.append(line[min(len(line) - len(line.lstrip()), column):])
                position += 1
            following = position
            while following < len(lines) and not lines[following].strip():
                following += 1
            made += ["<li>", *self.blocks(guide, body), "</li>"]
            if following < len(lines) and MARKER.match(lines[following]) and len(MARKER.match(lines[following])[1]) == margin:
                position = following
        return [*made, "</ol>" if isNumbered else "</ul>", ""], position

    def blocks(self, guide, lines, anchors=None):
        made, position = [], 0
        while position < len(lines):
            line = lines[position]
            fence = re.match(r"^ *(`{3,}|~{3,}) *(\w*) *$", line)
            heading = HEADING.match(line)
            if not line.strip():
                made.append("")
                position += 1
            elif fence:
                end = next((at for at in range(position + 1, len(lines)) if lines[at].strip() == fence[1]), None)
                if end is None:
                    self.fail(guide, "a block of code does not end.")
                if fence[2] not in LANGUAGES:
                    self.fail(guide, f"the site does not know the language \"{fence[2]}\" of a block of code.")
                made += self.code(LANGUAGES[fence[2]], lines[position + 1:end])
                position = end + 1
            elif heading:
                if anchors is None or position + 1 != guide.firstLine:
                    if len(heading[1]) not in LEVELS or not anchors or position + 1 not in anchors:
                        self.fail(guide, f"the heading \"{heading[2]}\" is too deep or in a list.")
                    made += [self.heading(guide, len(heading[1]), anchors[position + 1], plain(heading[2])), ""]
                position += 1
            elif MARKER.match(line):
                items, position = self.list(guide, lines, position)
                made += items
            elif line.startswith("    "):
                end = position
                while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                    end += 1
                block = [each[4:] for each in lines[position:end]]
                while not block[-1].strip():
                    block.pop()
                made += self.code("unparsed", block)
                position = end
            elif "|" in line and position + 1 < len(lines) and DELIMITER.match(lines[position + 1]):
                end = position
                while end < len(lines) and "|" in lines[end]:
                    end += 1
                made += self.table(guide, lines[position:end])
                position = end
            elif line.lstrip().startswith(">") or re.match(r"^ *<(?!https?:)[A-Za-z!/]", line) or \
                    (position + 1 < len(lines) and re.match(r"^(?:=+|-+) *$", lines[position + 1])):
                self.fail(guide, f"the site does not read quotations, HTML and underlined headings: \"{line.strip()}\".")
            else:
                end = position + 1
                while end < len(lines) and lines[end].strip() and not HEADING.match(lines[end]) and \
                        not MARKER.match(lines[end]) and not re.match(r"^ *(`{3,}|~{3,})", lines[end]):
                    end += 1
                made += [*self.inline(guide, "\n".join(part.strip() for part in lines[position:end])).split("\n"), ""]
                position = end
        return made

    def write(self, guide):
        text = re.sub(r"^<!--.*?-->$", lambda comment: re.sub(r".", "", comment[0]), guide.text,
                      flags=re.MULTILINE | re.DOTALL)
        lines = self.blocks(guide, text.expandtabs(4).split("\n"), guide.anchors_of_lines)
        isMain = guide.label == MAIN
        command = f"\\mainpage {markup.title(guide.title)}" if isMain else f"\\page {guide.label} {markup.title(guide.title)}"
        contents = ["\\tableofcontents"] if len(guide.anchors) >= CONTENTS_FROM and not isMain else []
        lines = "\n".join([command, *contents, "", *lines]).split("\n")
        return "".join(f"/// {line}".rstrip() + "\n" for line in lines)
