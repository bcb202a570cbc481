"""Reads the declarations of a C header and the comments that belong to them.

A comment directly before a declaration, or behind it on its line, belongs to it. A comment that stands alone (a blank
line or another comment follows) is an item of its own. Blocks of #if are left out, except for the include guard.
"""
import dataclasses
import re

TOKEN = re.compile(r"""/\*.*?\*/ | //(?:\\\n|[^\n])* | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*' | .""",
                   re.VERBOSE | re.DOTALL)
MARKS = ("/*", "//")
SECTION = re.compile(r"^-{3,} (.+?) -{3,}$")  # the text of a comment that is the title of a section


class SourceError(Exception):
    """The sentence names the file and the line."""


@dataclasses.dataclass
class Comment:
    text: str  # without marks
    line: int


@dataclasses.dataclass
class Declaration:
    kind: str  # define, enum, struct, typedef, function; member, enumerator
    name: str
    code: str  # without comments and the marks of exports
    line: int
    leading: str = ""
    trailing: str = ""
    isAdjacent: bool = False  # no blank line and no comment between it and the declaration before
    members: list = dataclasses.field(default_factory=list)
    parameters: list = dataclasses.field(default_factory=list)  # names


def without_marks(raw):
    """Text of a comment: the column behind `/* ` and ` * ` is the first one."""
    if raw.startswith("//"):
        return re.sub(r"^///?[!<]? ?", "", raw.replace("\\\n", "\n")).rstrip()
    lines = [re.sub(r"\s*\\$", "", line).rstrip() for line in raw[2:-2].split("\n")]
    lines[0] = re.sub(r"^[*!]?<? ?", "", lines[0])
    if all(re.match(r"\s*(?:\*|$)", line) for line in lines[1:]):
        lines[1:] = [re.sub(r"^\s*\* ?", "", line) for line in lines[1:]]
    else:
        lines[1:] = [line.strip() for line in lines[1:]]
    return "\n".join(lines).rstrip()


def joined(texts):
    return "\n\n".join(text for text in texts if text)


def split(text, blank=lambda comment: " "):
    """The code without comments, and the texts of the comments."""
    code, found = [], []
    for token in TOKEN.findall(text):
        if token.startswith(MARKS):
            found.append(without_marks(token))
            token = blank(token)
        code.append(token)
    return "".join(code), joined(found)


class Scanner:
    """Splits a text at a separator outside of brackets, comments and strings."""

    def __init__(self, text, name, line, separator):
        self.text, self.name, self.separator = text, name, separator
        self.position, self.line = 0, line

    def fail(self, sentence, line=None):
        raise SourceError(f"{self.name}:{line or self.line}: {sentence}")

    def take(self, end):
        taken = self.text[self.position:end]
        self.position = end
        self.line += taken.count("\n")
        return taken

    def token(self):
        found = TOKEN.match(self.text, self.position)[0]
        if found == "/" and self.text.startswith("/*", self.position):
            self.fail("a comment does not end.")
        return self.take(self.position + len(found))

    def at_line_start(self):
        before = self.text[:self.position].rsplit("\n", 1)[-1]
        return not before.strip()

    def directive(self):
        """A preprocessor line with its continuations and the comments that begin in it."""
        taken = ""
        while self.position < len(self.text):
            if self.text.startswith("\\\n", self.position):
                taken += self.take(self.position + 2)
                continue
            if self.text[self.position] == "\n":
                break
            taken += self.token()
        return taken

    def skip_conditional(self):
        first, depth = self.line, 1
        while depth:
            if self.position >= len(self.text):
                self.fail("#if has no #endif.", first)
            line = self.take((self.text + "\n").find("\n", self.position) + 1).strip()
            depth += bool(re.match(r"#\s*if", line)) - bool(re.match(r"#\s*endif", line))

    def pieces(self):
        """Yields (kind, text, line, text between it and the piece before), where kind is comment, directive or code."""
        code, first, gap = "", 1, ""
        depth = 0
        while self.position < len(self.text):
            line, isStart = self.line, self.at_line_start()
            if not code and self.text[self.position] == "#" and isStart:
                yield "directive", self.directive(), line, gap
                gap = ""
                continue
            token = self.token()
            if not code and token.isspace():
                gap += token
            elif not code and token.startswith(MARKS):
                yield "comment", token, line, gap
                gap = ""
            elif token == self.separator and depth == 0:
                yield "code", code, first, gap
                code, gap = "", ""
            else:
                first = first if code else line
                code += token
                depth += (token in "{([" and len(token) == 1) - (token in "})]" and len(token) == 1)
                if depth < 0:
                    self.fail("a bracket closes that none opens.")
        if code.strip():
            if depth or self.separator == ";":
                self.fail("a declaration does not end.", first)
            yield "code", code, first, gap


def directive_of(text, line):
    """A macro with a value, or none."""
    code, trailing = split(text)
    found = re.match(r"#\s*define\s+(\w+)(\([^)]*\))?(.*)$", code, re.DOTALL)
    if not found or not found[3].strip(" \t\\\n"):
        return None
    value = "\n".join(part.rstrip() for part in re.split(r"\\\n", found[3])).rstrip()
    value = value.replace("\n", " \\\n")
    return Declaration("define", found[1], f"#define {found[1]}{found[2] or ''}{value}", line, trailing=trailing)


def one_space(text):
    return re.sub(r"\s+", " ", text).strip()


def declarators(code):
    """The declarations of `type a, *b[2];`, one each."""
    found = re.match(r"^(.*?[\w*]\s*?[ *])((?:\**\w+(?:\[[^]]*\])*\s*,\s*)+\**\w+(?:\[[^]]*\])*)$", code)
    if not found or "(" in code:
        return [code]
    return [f"{found[1].strip()} {part.strip()}" for part in found[2].split(",")]


def member_of(code, kind):
    if kind == "enumerator":
        return re.match(r"\w+", code)
    return re.search(r"\(\s*\*\s*(\w+)", code) or re.search(r"(\w+)\s*(?:\[[^]]*\]\s*)*(?::\s*\d+)?$", code)


def members_of(body, name, line, kind):
    """Members of the body of a struct, or enumerators of that of an enum."""
    scanner = Scanner(body, name, line, "," if kind == "enumerator" else ";")
    members, pending = [], []
    for what, text, at, gap in scanner.pieces():
        if what == "directive":
            scanner.fail("a preprocessor line is inside a declaration.", at)
        if what == "comment":
            if members and not pending and "\n" not in gap:
                for member in members[-len(declared):]:
                    member.trailing = joined([member.trailing, without_marks(text)])
            else:
                pending.append(without_marks(text))
            continue
        code, inner = split(text)
        declared = []
        for code in declarators(one_space(code)):
            found = member_of(code, kind)
            if not found:
                scanner.fail(f"\"{code}\" is not a member.", at)
            declared.append(Declaration(kind, found[found.lastindex or 0], code, at, leading=joined(pending), trailing=inner))
        members += declared
        pending = []
    if pending and members:
        members[-1].trailing = joined([members[-1].trailing, *pending])
    return members


def code_of(text, name, line):
    """A declaration that ends with a semicolon."""
    blank, inner = split(text, lambda comment: re.sub(r"[^\n]", " ", comment))
    body = re.match(r"\s*(typedef\s+)?(struct|enum)\b[^{;(]*\{", blank)
    if body:
        opening, closing, kind = body.end(), blank.rindex("}"), body[2]
        head, tail = one_space(blank[:opening - 1]), one_space(blank[closing + 1:])
        found = re.search(r"\w+$", tail or head)
        members = members_of(text[opening:closing], name, line + text[:opening].count("\n"),
                             "member" if kind == "struct" else "enumerator")
        if not found or found[0] in ("struct", "enum"):
            raise SourceError(f"{name}:{line}: a {kind} has no name.")
        beside = joined(split(part)[1] for part in (text[:opening], text[closing:]))
        return Declaration(kind, found[0], head, line, trailing=beside, members=members)
    code = one_space(re.sub(r"\bAGAA_(?:API|CALL)\b", "", blank))
    kind = "typedef" if code.startswith("typedef ") else "function"
    pointer = re.search(r"\(\s*\*\s*(\w+)\s*\)\s*\((.*)\)$", code)
    function = pointer or re.match(r"[^(]*?(\w+)\s*\((.*)\)$", code)
    found = function or re.search(r"(\w+)\s*(?:\[[^]]*\]\s*)*$", code)
    if not found:
        raise SourceError(f"{name}:{line}: \"{code[:60]}\" is not a declaration.")
    parameters = []
    if function:
        code = re.sub(r"(\w)\(\s*\*\s*", r"\1 (*", code)
        parameters = [part[1] for part in (re.search(r"(\w+)\s*(?:\[[^]]*\]\s*)*$", each) for each in function[2].split(","))
                      if part and part[1] != "void"]
    return Declaration(kind, found[1], code, line, trailing=inner, parameters=parameters)


def read(text, name):
    """Comments and declarations of a header in their order."""
    scanner = Scanner(text, name, 1, ";")
    items, pending, guard = [], None, False
    for what, raw, line, gap in scanner.pieces():
        isSeparate = gap.count("\n") > 1
        if what == "comment":
            last = items[-1] if items and isinstance(items[-1], Declaration) else None
            if last and not pending and "\n" not in gap:
                last.trailing = joined([last.trailing, without_marks(raw)])
                continue
            if pending:
                items.append(pending)
            pending = Comment(without_marks(raw), line)
            continue
        if what == "directive":
            word = re.match(r"#\s*(\w*)", raw)[1]
            if word == "ifndef" and not guard and raw.rstrip().endswith("_H"):
                guard = True
            elif word in ("if", "ifdef", "ifndef"):
                scanner.skip_conditional()
            declaration = directive_of(raw, line) if word == "define" else None
            if not declaration:
                if pending:
                    items.append(pending)
                    pending = None
                continue
        else:
            declaration = code_of(raw, name, line)
        if pending and (isSeparate or SECTION.match(pending.text)):
            items.append(pending)
        elif pending:
            declaration.leading = pending.text
        declaration.isAdjacent = not isSeparate and not pending
        pending = None
        items.append(declaration)
    if pending:
        items.append(pending)
    return items
