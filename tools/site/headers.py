"""Writes headers with comments for Doxygen, made from the comments in the headers' own grammar.

Titles of sections (/* ---- title ---- */) and headers become groups, comments before flags ("Bits of …") become the
heads of member groups. A declaration without a comment gets a text that follows from its name and its use.
"""
import re

import comments
from comments import Bullets, Code, Item, Paragraph
from declarations import Comment, Declaration, joined

SECTION = re.compile(r"^-{3,} (.+?) -{3,}$")
TYPES = "struct", "enum", "typedef"
GLUE = {"Gl": "OpenGL", "Vk": "Vulkan"}


def group_of(header):
    """agaa/base.h: agaa_base."""
    return re.sub(r"\W", "_", header.removesuffix(".h"))


def words(name):
    """shadowTaps: Shadow taps. AGAA_LIGHT_POINT without its prefix: Point."""
    name = re.sub(r"^(?:Agaa|agaa|AGAA_)", "", name)
    if name.upper() == name:
        parts = [part if any(map(str.isdigit, part)) else part.lower() for part in name.split("_")]
    else:
        parts = [GLUE.get(part, part.lower()) for part in re.findall(r"[A-Z]?[a-z0-9]+|[A-Z]+(?![a-z])", name)]
    text = " ".join(part for part in parts if part) or name
    return text[0].upper() + text[1:] + "."


def common_prefix(names):
    parts = [name.split("_")[:-1] for name in names if not name.endswith("_MAX_ENUM")]
    shared = [same[0] for same in zip(*parts) if len(set(same)) == 1]
    return "_".join(shared) + "_" if shared else ""


def flag_prefix(name):
    return "_".join(name.split("_")[:2]) + "_"


def has_next_flag(items, position):
    """Whether a macro with the same prefix follows the macro at a position."""
    following = items[position + 1] if position + 1 < len(items) else None
    return isinstance(following, Declaration) and following.kind == "define" and \
        flag_prefix(following.name) == flag_prefix(items[position].name)


class Interface:
    """All headers together: the names and their uses, from which missing texts are made."""

    def __init__(self, headers):
        self.headers = headers  # {name: items}
        self.declared = [item for items in headers.values() for item in items if isinstance(item, Declaration)]
        self.structs = {item.name.upper(): item.name for item in self.declared if item.kind == "struct"}
        self.known = set(self.names())
        self.undescribed = []   # names whose text is made of the name alone

    def names(self):
        for item in self.declared:
            yield item.name
            for member in item.members:
                yield member.name if member.kind == "enumerator" else f"{item.name}::{member.name}"

    def struct_of(self, constant):
        """AGAA_VK_FRAME: AgaaVkFrame."""
        return self.structs.get(constant.replace("_", ""))

    def uses(self, name):
        pattern = re.compile(rf"\b{name}\b")
        for item in self.declared:
            if item.name == name or item.name.startswith("agaaInit") or item.kind == "define":
                continue
            if item.kind == "struct":
                for member in item.members:
                    if pattern.search(member.code) or pattern.match(member.trailing):
                        yield f"{item.name}::{member.name}"
            elif item.kind != "enum" and pattern.search(item.code):
                yield item.name

    def text_of(self, item, owner=None):
        """A text for a declaration without a comment."""
        name = item.name
        initialised = re.match(r"AGAA_(\w+)_INIT$", name)
        struct = initialised and self.struct_of("AGAA_" + initialised[1])
        if item.kind == "define" and struct:
            return f"Initialises a struct {struct} with its defaults."
        if item.kind == "function" and name.startswith("agaaInit") and f"Agaa{name[8:]}" in self.structs.values():
            macro = next(macro.name for macro in self.declared if macro.kind == "define" and macro.name.endswith("_INIT")
                         and self.struct_of(macro.name.removesuffix("_INIT")) == f"Agaa{name[8:]}")
            return f"Initialises a struct Agaa{name[8:]}, as {macro} does. Does nothing if the pointer is null."
        if name.endswith("_MAX_ENUM"):
            return "No value of the enumeration: it makes the type 32 bits wide."
        if item.kind == "enumerator" and name.startswith("AGAA_STRUCTURE_TYPE_"):
            struct = self.struct_of("AGAA_" + name.removeprefix("AGAA_STRUCTURE_TYPE_"))
            if struct:
                return f"The type of {struct}."
        if item.kind == "member" and name in ("sType", "structSize", "pNext") and owner != "AgaaStructHeader":
            return f"See AgaaStructHeader::{name}."
        counted = re.sub(r"Count$", "s", name)
        if item.kind == "member" and counted != name and f"{owner}::{counted}" in self.known:
            return f"Number of elements of {counted}."
        mentioned = re.search(r"\bAgaa\w+", item.code) if item.kind == "member" else None
        if mentioned:
            return f"See {mentioned[0]}."
        self.undescribed.append(f"{owner}::{name}" if item.kind == "member" else name)
        uses = [use for use in self.uses(name) if use != owner] if item.kind in TYPES else []
        return words(name) + (f" Used by {', '.join(uses)}." if uses else "")


class Writer:
    def __init__(self, header, interface, linker):
        self.header, self.interface, self.linker = header, interface, linker
        self.lines = []
        self.prefix = ""      # of the flags in the open member group
        self.described = {}   # macro: text in the comment of its member group
        self.isOpen = False   # a group

    # ---- comments ------------------------------------------------------------------------------

    def inline(self, text):
        return self.linker.render(text)

    def flow(self, blocks):
        """Lines without a blank one, for places that hold one paragraph."""
        lines = []
        for block in blocks:
            if isinstance(block, Paragraph):
                lines.append(self.inline(block.text))
            elif isinstance(block, Code):
                lines += ["\\code{.c}", *block.text.replace("*/", "* /").split("\n"), "\\endcode"]
            elif isinstance(block, Bullets):
                entries = [" ".join(self.flow(entry)) for entry in block.items]
                lines += ["<ul>", *(f"<li>{entry}</li>" for entry in entries), "</ul>"]
            else:
                keys = ", ".join(block.keys)
                entry = f"<li>{self.inline(keys)}: {' '.join(self.flow(block.blocks))}</li>"
                if lines and lines[-1] == "</ul>":
                    lines.insert(-1, entry)
                else:
                    lines += ["<ul>", entry, "</ul>"]
        return lines

    def errors(self, blocks):
        """Codes as return values; sentences beside them as a paragraph."""
        codes, rest = [], []
        for block in blocks:
            if isinstance(block, Item) and all(key.startswith("AGAA_") for key in block.keys):
                text = " ".join(self.flow(block.blocks))
                codes += [f"\\retval {key} {text}" for key in block.keys]
            else:
                rest.append(block)
        return [*(["\\par Errors", *self.flow(rest), ""] if rest else []), *codes, ""]

    def section(self, block, parameters):
        key = block.keys[0]
        if all(name in parameters for name in block.keys):
            return [f"\\param {','.join(block.keys)} " + "\n".join(self.flow(block.blocks)), ""]
        if key == "Errors":
            return self.errors(block.blocks)
        if key == "Returns":
            return ["\\return " + "\n".join(self.flow(block.blocks)), ""]
        return [f"\\par {self.linker.render(', '.join(block.keys), isPlain=True)}", *self.flow(block.blocks), ""]

    def document(self, text, parameters=(), leftOut=()):
        """Lines of a comment for Doxygen, without the items of these keys."""
        blocks = [block for block in comments.parse(text)
                  if not (leftOut and isinstance(block, Item) and leftOut.issuperset(block.keys))]
        brief, rest = "", blocks
        if blocks and isinstance(blocks[0], Paragraph):
            brief, more = comments.first_sentence(blocks[0].text)
            rest = ([Paragraph(more)] if more else []) + blocks[1:]
        lines = [f"\\brief {self.inline(brief)}", ""] if brief else []
        for block in rest:
            lines += self.section(block, parameters) if isinstance(block, Item) else [*self.flow([block]), ""]
        return "\n".join(lines).strip().split("\n")

    def comment(self, lines):
        self.lines.append("/**")
        self.lines += [(" * " + line).rstrip() for text in lines for line in text.split("\n")]
        self.lines.append(" */")

    # ---- groups --------------------------------------------------------------------------------

    def close_flags(self):
        if self.prefix:
            self.lines.append("/** @} */")
        self.prefix = ""
        self.described = {}

    def close(self):
        self.close_flags()
        if self.isOpen:
            self.lines.append("/** @} */")
        self.isOpen = False

    def open(self, label, title, parent, text=""):
        self.close()
        self.comment([f"\\defgroup {label} {self.linker.render(title, isPlain=True)}", *([f"\\ingroup {parent}"] if parent else []),
                      *self.document(text or f"Declared in {self.header}.")])
        self.comment([f"\\addtogroup {label}", "@{"])
        self.isOpen = True

    def open_flags(self, text, name):
        self.close_flags()
        self.prefix = flag_prefix(name)
        blocks = comments.parse(text)
        title, more = comments.first_sentence(blocks[0].text)
        rest = [Paragraph(more)] if more else []
        for block in blocks[1:]:
            macros = [self.prefix + key for key in block.keys] if isinstance(block, Item) else []
            if macros and all(macro in self.linker.names for macro in macros):
                self.described.update(dict.fromkeys(macros, block))
            else:
                rest.append(block)
        anchor = self.linker.bits.get(self.prefix)
        lines = [f"\\name {self.linker.render(title.rstrip('.'), isPlain=True)}"]
        if anchor and anchor not in self.linker.anchored:
            self.linker.anchored.add(anchor)
            lines.append(f"\\anchor {anchor}")
        self.comment([*lines, *self.flow(rest), "@{"])

    # ---- declarations --------------------------------------------------------------------------

    def item_comment(self, item, text, owner=None):
        self.comment(self.document(text or self.interface.text_of(item, owner), item.parameters))

    def macro(self, item, text):
        lines = self.document(text) if text else []
        block = self.described.get(item.name)
        if block:
            described = self.flow(block.blocks)
            lines = [f"\\brief {described[0]}", *described[1:], *(["", *lines] if lines else [])]
        self.comment(lines or self.document(self.interface.text_of(item)))

    def members(self, item, text):
        """Members, and the text of the comment without the items that describe members."""
        blocks, label = comments.parse(text), ""
        described = {}
        names = {member.name for member in item.members}
        for block in blocks:
            if isinstance(block, Item) and item.kind == "struct" and all(key in names for key in block.keys):
                described.update(dict.fromkeys(block.keys, block))
        prefix = common_prefix([member.name for member in item.members])
        lines = []
        for member in item.members:
            leading = member.leading
            # A label before several enumerators is a word for each of them.
            if member.kind == "enumerator" and leading and member.trailing and not leading.endswith((".", ":")):
                label, leading = leading, ""
            text = joined([leading, member.trailing])
            if label and not member.name.endswith("_MAX_ENUM"):
                text = f"{label}: {text}"
            if not text and member.kind == "enumerator":
                short = Declaration("enumerator", member.name, member.code, member.line)
                text = self.interface.text_of(short)
                if text == words(member.name):
                    text = words(member.name.removeprefix(prefix))
            elif not text and member.name not in described:
                text = self.interface.text_of(member, item.name)
            document = self.document(text) if text else []
            if member.name in described:
                extra = self.flow(described[member.name].blocks)
                document = [f"\\brief {extra[0]}", *extra[1:], *(["", *document] if document else [])]
            lines += ["    /**", *(f"     * {line}".rstrip() for part in document for line in part.split("\n")), "     */"]
            lines.append(f"    {member.code}{',' if member.kind == 'enumerator' else ';'}")
        return lines, {key for block in described.values() for key in block.keys}

    def declaration(self, item, text):
        if item.kind == "define":
            self.macro(item, text)
            self.lines.append(item.code)
        elif item.kind in ("struct", "enum"):
            members, taken = self.members(item, text)
            self.comment(self.document(text or self.interface.text_of(item), leftOut=taken))
            self.lines += [f"{item.code} {{", *members, f"}} {item.name};" if item.code.startswith("typedef") else "};"]
        else:
            self.item_comment(item, text)
            self.lines.append(item.code + ";")
        self.lines.append("")


    # ---- a file --------------------------------------------------------------------------------

    def write(self, title, parent=""):
        items = list(self.interface.headers[self.header])
        label = group_of(self.header)
        about = items.pop(0).text if items and isinstance(items[0], Comment) else ""
        self.comment([f"\\file {self.header}", f"\\brief {self.inline(comments.first_sentence(title)[0])}"])
        self.open(label, title, parent, about)
        notes, previous, previousText = [], None, ""
        for position, item in enumerate(items):
            if isinstance(item, Comment):
                section = SECTION.match(item.text)
                if section:
                    self.open(f"{label}_{re.sub(r'[^a-z]+', '_', section[1].lower()).strip('_')}",
                              section[1][0].upper() + section[1][1:], label)
                    continue
                following = items[position + 1] if position + 1 < len(items) else None
                isHead = isinstance(following, Declaration) and following.kind == "define" and not self.prefix
                if isHead or (item.text.startswith("Bits of ") and isinstance(following, Declaration)):
                    self.open_flags(item.text, following.name)
                else:
                    notes.append(item.text)
                continue
            leading = item.leading
            if item.kind != "define" or flag_prefix(item.name) != self.prefix:
                if not (item.kind == "define" and leading.startswith("Bits of ")):
                    self.close_flags()
            if item.kind == "define" and leading.startswith("Bits of ") and has_next_flag(items, position):
                self.open_flags(leading, item.name)
                leading = ""
            text = joined([*notes, leading, item.trailing])
            notes = []
            if not text and item.isAdjacent and previous and previous.kind == item.kind and item.kind in ("function", "typedef"):
                text = previousText
            self.declaration(item, text)
            previous, previousText = item, text
        self.close()
        return "\n".join(self.lines) + "\n"


def flag_anchors(headers):
    """Prefixes of flags that a comment "Bits of …" introduces, and their anchors: the flag itself if it is alone."""
    anchors, isHead = {}, False
    for items in headers.values():
        for position, item in enumerate(items):
            text = item.text if isinstance(item, Comment) else item.leading
            isHead = isHead or text.startswith("Bits of ")
            if isinstance(item, Declaration):
                if isHead and item.kind == "define":
                    prefix = flag_prefix(item.name)
                    isAlone = bool(item.leading.startswith("Bits of ")) and not has_next_flag(items, position)
                    anchors.setdefault(prefix, item.name if isAlone else f"bits_{prefix.rstrip('_').lower()}")
                isHead = False
    return anchors
