"""The grammar of the headers' comments: paragraphs, items `key   text`, bullets and code.

An item has its key, two spaces or more, and its text, which may hold further blocks. Keys are parameters, members and
words such as Errors and Threads.
"""
import dataclasses
import re

KEY = re.compile(r"^( *)([A-Za-z_]\w*(?:, [A-Za-z_]\w*)*)( {2,})(?=\S)")
BULLET = re.compile(r"^( *)- (?=\S)")
TERM = re.compile(r"^[A-Z][A-Z_]+: ")
CODE_INDENT = 4


@dataclasses.dataclass
class Paragraph:
    text: str


@dataclasses.dataclass
class Item:
    keys: list
    blocks: list


@dataclasses.dataclass
class Bullets:
    items: list  # of blocks


@dataclasses.dataclass
class Code:
    text: str


def indent(line):
    return len(line) - len(line.lstrip(" "))


def hanging(lines, start, column, limit):
    """The lines of an item or a bullet: the rest of its first line, and the following ones that are indented more."""
    taken, end = [lines[start][column:]], start + 1
    while end < len(lines) and lines[end].strip() and indent(lines[end]) > limit:
        taken.append(lines[end][min(indent(lines[end]), column):])
        end += 1
    return taken, end


def parse(text):
    lines, blocks, paragraph = text.expandtabs().split("\n"), [], []

    def close():
        if paragraph:
            blocks.append(Paragraph(" ".join(paragraph)))
            paragraph.clear()

    position, wasText = 0, False
    while position < len(lines):
        line = lines[position]
        key, bullet = KEY.match(line), BULLET.match(line)
        if line.strip().startswith("SPDX-License-Identifier:"):
            position += 1
        elif not line.strip():
            close()
            position += 1
        elif wasText and indent(line) >= CODE_INDENT and not key:
            close()
            end = position
            while end < len(lines) and indent(lines[end]) >= CODE_INDENT:
                end += 1
            code = lines[position:end]
            blocks.append(Code("\n".join(part[min(map(indent, code)):] for part in code)))
            position = end
        elif key:
            close()
            body, position = hanging(lines, position, key.end(), len(key[1]))
            blocks.append(Item(key[2].split(", "), parse("\n".join(body))))
        elif bullet:
            close()
            body, position = hanging(lines, position, bullet.end(), len(bullet[1]))
            if not (blocks and isinstance(blocks[-1], Bullets)):
                blocks.append(Bullets([]))
            blocks[-1].items.append(parse("\n".join(body)))
        else:
            if TERM.match(line):
                close()
            paragraph.append(line.strip())
            position += 1
        wasText = bool(paragraph)
    close()
    return blocks


def first_sentence(text):
    """The first sentence and the rest."""
    found = re.search(r"(?<!\be\.g)(?<!\bet al)[.!?](?:\"|\))?\s+(?=[A-Z\"'(`0-9])", text)
    return (text[:found.end()].rstrip(), text[found.end():]) if found else (text, "")
