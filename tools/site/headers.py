"""Writes headers with comments for Doxygen, made from the comments in the headers' own grammar.

Titles of sections (/* ---- title ---- */) and headers become groups, comments before flags ("Bits of …") become the
heads of member groups. A declaration without a comment gets a text that follows from its name and its use.
"""
import re

import comments
import markup
from comments import Bullets, Code, Item, Paragraph
from declarations import SECTION, Comment, Declaration, joined
from interface import common_prefix, flag_prefix, has_next_flag, words


def group_of(header):
    """agaa/base.h: agaa_base."""
    return re.sub(r"\W", "_", header.removesuffix(".h"))


class Writer:
    def __init__(self, header, interface, linker):
        self.header, self.interface, self.linker = header, interface, linker
        self.lines = []
        self.prefix = ""      # of the flags in the open member group
        self.described = {}   # macro: text in the comment of its member group
        self.isOpen = False   # a group
        self.label = ""       # of that group
        self.notes = []       # comments that stand alone, for the next declaration

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
        return [f"\\par {', '.join(block.keys)}", *self.flow(block.blocks), ""]

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
        if self.notes:
            self.comment([f"\\addtogroup {self.label}", "", *self.document(joined(self.notes))])
        self.notes = []
        if self.isOpen:
            self.lines.append("/** @} */")
        self.isOpen = False

    def open(self, label, title, parent, text=""):
        self.close()
        self.label = label
        self.comment([f"\\defgroup {label} {markup.title(title)}", *([f"\\ingroup {parent}"] if parent else []),
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
        lines = [f"\\name {title.rstrip('.')}"]
        if anchor and anchor not in self.linker.anchored:
            self.linker.anchored.add(anchor)
            lines.append(f"\\anchor {anchor}")
        self.comment([*lines, *self.flow(rest), "@{"])

    # ---- declarations --------------------------------------------------------------------------

    def described_by(self, block, text):
        """Lines of a comment whose first part is an item of another comment."""
        described = self.flow(block.blocks)
        return [f"\\brief {described[0]}", *described[1:], *(["", *self.document(text)] if text else [])]

    def enumerator_text(self, member, prefix):
        """The words behind the prefix that the enumerators share, unless more is known of one."""
        text = self.interface.text_of(member)
        return words(member.name.removeprefix(prefix)) if text == words(member.name) else text

    def members(self, item, described):
        prefix, label = common_prefix([member.name for member in item.members]), ""
        lines = []
        for member in item.members:
            isValue, leading = member.kind == "enumerator", member.leading
            # A label before several enumerators is a word for each of them.
            if isValue and leading and member.trailing and not leading.endswith((".", ":")):
                label, leading = leading, ""
            text = joined([leading, member.trailing])
            if label and not member.name.endswith("_MAX_ENUM"):
                text = f"{label}: {text}"
            if member.name in described:
                document = self.described_by(described[member.name], text)
            elif isValue:
                document = self.document(text or self.enumerator_text(member, prefix))
            else:
                document = self.document(text or self.interface.text_of(member, item.name))
            lines += ["    /**", *(f"     * {line}".rstrip() for part in document for line in part.split("\n")), "     */"]
            lines.append(f"    {member.code}{',' if isValue else ';'}")
        return lines

    def declaration(self, item, text):
        if item.name in self.described:
            self.comment(self.described_by(self.described[item.name], text))
        elif item.kind == "struct":
            names = {member.name for member in item.members}
            described = {key: block for block in comments.parse(text) if isinstance(block, Item) and names.issuperset(block.keys)
                         for key in block.keys}
            self.comment(self.document(text or self.interface.text_of(item), leftOut=set(described)))
            self.lines += [f"{item.code} {{", *self.members(item, described)]
        else:
            self.comment(self.document(text or self.interface.text_of(item), item.parameters))
            if item.kind == "enum":
                self.lines += [f"{item.code} {{", *self.members(item, {})]
        if item.kind in ("struct", "enum"):
            self.lines.append(f"}} {item.name};" if item.code.startswith("typedef") else "};")
        else:
            self.lines.append(item.code + (";" if item.kind != "define" else ""))
        self.lines.append("")

    # ---- a file --------------------------------------------------------------------------------

    def write(self, title, parent=""):
        items = list(self.interface.headers[self.header])
        label = group_of(self.header)
        about = items.pop(0).text if items and isinstance(items[0], Comment) else ""
        self.comment([f"\\file {self.header}", f"\\brief See \\ref {label} \"{title}\"."])
        self.open(label, title, parent, about)
        previous, previousText = None, ""
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
                    self.notes.append(item.text)
                continue
            leading = item.leading
            if item.kind != "define" or flag_prefix(item.name) != self.prefix:
                if not (item.kind == "define" and leading.startswith("Bits of ")):
                    self.close_flags()
            if item.kind == "define" and leading.startswith("Bits of ") and has_next_flag(items, position):
                self.open_flags(leading, item.name)
                leading = ""
            text = joined([*self.notes, leading, item.trailing])
            self.notes = []
            if not text and item.isAdjacent and previous and previous.kind == item.kind and item.kind in ("function", "typedef"):
                text = previousText
            self.declaration(item, text)
            previous, previousText = item, text
        self.close()
        return "\n".join(self.lines) + "\n"
