#!/usr/bin/env python3
"""Finds comments and names that the rules for writing in CONTRIBUTING.md reject.

    tools/prose.py             prints the number of findings by folder
    tools/prose.py FOLDER …    prints the findings below these folders

Rules:
  fragment   A comment begins with a word that begins no sentence, or with a phrase that no main clause follows.
             Comments behind code are labels, and may be phrases.
  retired    A name has been replaced by a term of the field.
  columns    A line is longer than 120 columns.
  reference  A comment names a file that the repository does not have, or that is not a part of it.
"""
import argparse
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDERS = "src", "include", "conformance", "samples", "benchmark", "cmake"
C_SUFFIXES = ".c", ".h", ".cpp", ".hpp", ".inc", ".glsl", ".comp", ".vert", ".frag", ".geom"
HASH_NAMES = ".py", ".cmake", ".txt"
COLUMNS = 120

# ---- reading -------------------------------------------------------------------------------------

TOKEN = re.compile(r"""
    //(?:\\\n|[^\n])* | /\*.*?\*/ |                              # comments
    R"(?P<d>[^(\s]*)\(.*?\)(?P=d)" |                             # raw strings
    "(?:\\.|[^"\\\n])*" | (?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])*'    # strings, but no separators of digits
    """, re.VERBOSE | re.DOTALL)

Comment = collections.namedtuple("Comment", "line isLabel text")  # line from 1; text without marks, one line a line
Finding = collections.namedtuple("Finding", "path line rule text")


def blank(text):
    """Spaces in place of all characters but line ends."""
    return re.sub(r"[^\n]", " ", text)


def without_marks(comment):
    if comment.startswith("/*"):
        return "\n".join(re.sub(r"^\s*\*? ?", "", line).rstrip() for line in comment[2:-2].split("\n"))
    return re.sub(r"^(?://+[!/<]*|#+!?) ?", "", comment).rstrip()


def join(pieces):
    """Comments of (line, column, is behind code, raw text): lines below each other in one column are one comment."""
    comments, last = [], None
    for line, column, is_label, raw in pieces:
        text = without_marks(raw)
        is_line = not raw.startswith("/*")
        if last and is_line and last == (line - 1, column, True) and not is_label:
            comments[-1] = comments[-1]._replace(text=comments[-1].text + "\n" + text)
        else:
            comments.append(Comment(line, is_label, text))
        last = line + raw.count("\n"), column, is_line
    return comments


def read_c(text):
    """Comments, and the text without comments and strings."""
    pieces = []

    def replaced(match):
        token = match[0]
        if token.startswith(("//", "/*")):
            start = text.rfind("\n", 0, match.start()) + 1
            before = text[start:match.start()]
            pieces.append((text.count("\n", 0, match.start()) + 1, len(before), bool(before.strip()), token))
        return blank(token)

    code = TOKEN.sub(replaced, text)
    return join(pieces), code


def read_hash(text):
    pieces, code = [], []
    for number, line in enumerate(text.split("\n"), 1):
        match = re.match(r"""((?:"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|[^"'#])*)(#.*)?$""", line)
        before, comment = (match[1], match[2]) if match else (line, None)
        if comment:
            pieces.append((number, len(before), bool(before.strip()), comment))
        code.append(before)
    return join(pieces), "\n".join(code)


# ---- rules ---------------------------------------------------------------------------------------

NEVER = "of", "that", "what", "those", "whether", "and", "but", "or", "nor", "than", "whose", "which"
INTRODUCES = "with", "without", "for", "by", "as", "where", "like", "in"
NO_CLAUSE = ("and", "but", "or", "nor", "with", "without", "where", "which", "that", "whose", "who", "except", "for",
             "of", "in", "by", "as", "to", "from", "not", "so", "than", "each", "both", "one", "beside")
VERB = re.compile(r"\b(?:is|are|has|have|does|do|must|may|can|cannot|needs?|comes?|appl(?:y|ies)|ties)\b")


def first_sentence(text):
    paragraph = re.split(r"\n\s*\n", text.strip())[0]
    flat = re.sub(r"\s+", " ", paragraph)
    return re.split(r"(?<=[.:;?])\s", re.sub(r"\([^()]*\)", "", flat))[0].strip()


def is_fragment(text):
    sentence = first_sentence(text)
    words = re.findall(r"[A-Za-z_][\w']*", sentence)
    if not words or sentence.endswith("?") or not re.match(r"[A-Za-z]", sentence) or re.match(r"\w+:", sentence):
        return False
    first, rest = words[0], words[1:]
    if not (first.islower() or first.istitle()):
        return False
    first = first.lower()
    if first == "whether" and rest[:2] == ["or", "not"]:
        return False
    if first in NEVER:
        return True
    if first == "the" and rest[:1] == ["same"]:
        return bool(re.match(r"the same(?:[.,:;]|$| (?:with|where|as|for|of|in|by|without|on|at|from|but|and|if)\b)",
                             sentence, re.IGNORECASE))
    if first == "less":
        return rest[:1] == ["than"] or rest[:1] == ["where"]
    if first in INTRODUCES:
        if first.startswith("with") and VERB.search(re.split(r"\b(?:that|which|what|whose)\b", sentence)[0]):
            return False
        clauses = re.findall(r", +(\w+)", sentence)
        return not any(word.lower() not in NO_CLAUSE for word in clauses)
    return False


# Names, and the part of the tree in which they are retired.
RETIRED = {
    "goesOn": "", "goesOnOffset": "", "outlivesFrame": "", "clearLasting": "", "writeLasting": "", "isHosts": "",
    "ownWords": "", "poolRecords": "", "SizedView": "", "remade": "src", "takeDeferred": "", "agaa_takeDeferred": "",
    "agaa_takePixel": "", "dropUncalledFor": "", "leaveOutEffects": "", "mostFetchedTargets": "", "mostDebugGroups": "",
    "agaa_unknown": "", r"agaa_count_\w*": "", r"below\.glsl": "", "isToldOfFacts": "", "failedHalfway": "", "WAYS": "",
    r"way(?=\()": "benchmark", "several": "src", "places": "src/core src/vk src/gl", "holds": "src", "gains": "src",
}
PATHS = re.compile(r"(?<![\w./-])(?:src|include|tests|docs|samples|tools|benchmark|scripts|conformance|cmake|abi|"
                   r"bindings|packaging)/[\w./-]*\w")
BASENAMES = re.compile(r"(?<![\w./<-])(?:[\w-]+/)*[\w-]{2,}\.(?:glsl|comp|inc|cpp|hpp|h|md|py|json)\b(?!\()")
PLACEHOLDER = re.compile(r"NAME|FOLDER")
OUTSIDE = re.compile(r"(?<![\w.])(?:\.\./|/(?:work|tmp|home|root)/|shared/)|hard-cases\.md|\bSDK design\b|"
                     r"\bissues? #?\d+", re.IGNORECASE)
SYSTEM = {"vulkan.h", "vulkan_core.h", "gl.h", "glad.h", "egl.h", "glcorearb.h", "glext.h", "stb_image.h",
          "stb_image_write.h", "stdint.h", "stddef.h"}


class Tree:
    def __init__(self, root):
        self.root = root
        folders = [path for path in root.iterdir() if path.is_dir() and not path.name.startswith((".", "build"))]
        self.names = {path.name for folder in folders for path in folder.rglob("*")}
        self.names |= {path.name for path in root.iterdir()} | SYSTEM

    def is_missing(self, path):
        return not PLACEHOLDER.search(path) and not (self.root / path).exists()

    def check(self, path):
        name = path.relative_to(self.root).as_posix()
        text = path.read_text()
        is_c = path.suffix in C_SUFFIXES
        comments, code = read_c(text) if is_c else read_hash(text)
        if is_c or path.suffix == ".cmake" or path.name == "CMakeLists.txt":
            for number, line in enumerate(text.split("\n"), 1):
                if len(line) > COLUMNS:
                    yield Finding(name, number, "columns", f"{len(line)} columns")
        for comment in comments:
            one_line = re.sub(r"\s+", " ", comment.text).strip()
            if not comment.isLabel and is_fragment(comment.text):
                yield Finding(name, comment.line, "fragment", one_line[:150])
            missing = [found for found in PATHS.findall(comment.text) if self.is_missing(found)]
            # A name without its folder, or with a part of it.
            missing += [found for found in BASENAMES.findall(comment.text)
                        if found not in missing and not PLACEHOLDER.search(found)
                        and pathlib.PurePath(found).name not in self.names]
            missing += OUTSIDE.findall(comment.text)
            for found in missing:
                yield Finding(name, comment.line, "reference", found)
        for word, folders in RETIRED.items():
            if folders and not name.startswith(tuple(folder + "/" for folder in folders.split())):
                continue
            pattern = re.compile(rf"\b{word}" + ("" if word.endswith(")") else r"\b"))
            # Words of English are retired as names only.
            for line, searched in [(1, code), *(() if folders else ((c.line, c.text) for c in comments))]:
                for match in pattern.finditer(searched):
                    yield Finding(name, line + searched.count("\n", 0, match.start()), "retired", match[0])


def files(root, folders):
    for folder in folders:
        base = root / folder
        for path in ([base] if base.is_file() else sorted(base.rglob("*"))):
            if path.is_file() and (path.suffix in C_SUFFIXES or path.suffix in HASH_NAMES):
                yield path


def findings(root, folders):
    tree = Tree(root)
    return [finding for path in files(root, folders) for finding in tree.check(path)]


def folder_of(name):
    """src/core/view/facts.h: src/core/view."""
    parts = pathlib.PurePosixPath(name).parts[:-1]
    return "/".join(parts[:3])


def counts(found):
    """Lines of a table: folder, rule, number."""
    numbers = collections.Counter((folder_of(finding.path), finding.rule) for finding in found)
    return [f"{number:5} {rule:10} {folder}" for (folder, rule), number in sorted(numbers.items())]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*")
    arguments = parser.parse_args()
    found = findings(ROOT, arguments.folders or FOLDERS)
    if arguments.folders:
        for finding in found:
            print(f"{finding.path}:{finding.line}: {finding.rule}: {finding.text}")
    else:
        print("\n".join(counts(found)))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
