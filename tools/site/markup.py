"""Text for Doxygen: escapes, and links from names to their declarations, pages and headers."""
import re

WORD = re.compile(r"`(?P<code>[^`]+)`|(?P<page>(?<![\w/.-])[\w-]+(?:/[\w-]+)*\.md\b)|(?P<header>\b(?:agaa/)?\w+\.h\b)|"
                  r"(?P<bits>\bAGAA_[A-Z0-9]+(?:_[A-Z0-9]+)*_…)|(?P<name>\b[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*(?:\(\))?)")
SPECIAL = str.maketrans({"\\": "\\\\", "@": "\\@", "&": "&amp;", "<": "&lt;", ">": "&gt;", "#": "\\#", "%": "\\%",
                         "\"": "&quot;", "$": "\\$"})


def escape(text):
    text = text.translate(SPECIAL)
    text = re.sub(r"--+", lambda dashes: "\\" + dashes[0] if len(dashes[0]) < 4 else "&minus;" * len(dashes[0]), text)
    return text.replace("::", "\\::").replace("*/", "*&zwj;/")


def title(text):
    """The title of a group or a page, in which Doxygen reads entities everywhere but escapes in some places only."""
    return text.replace("`", "").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("*/", "*&zwj;/")


class Linker:
    def __init__(self):
        self.names = set()    # declarations, and members as Struct::member
        self.headers = {}     # file: group
        self.bits = {}        # prefix of flags: anchor
        self.pages = {}       # path in the repository: label
        self.anchored = set() # anchors of bits that are written
        self.unlinked = set() # names of which a page speaks in another sense

    def reference(self, label, text):
        return f"\\ref {label} \"{text}\""

    def word(self, found):
        text = found[0]
        name = text.removesuffix("()")
        if found["page"] and text in self.pages:
            return self.reference(self.pages[text], text)
        if found["header"] and text in self.headers:
            return self.reference(self.headers[text], text)
        if found["bits"] and text[:-1] in self.bits:
            return self.reference(self.bits[text[:-1]], text)
        if found["name"] and name in self.names and name not in self.unlinked:
            return self.reference(name, text)
        return escape(text)

    def render(self, text, isCode=False):
        """Text with escapes and links; `code` between backticks."""
        made, position = [], 0
        for found in WORD.finditer(text):
            made.append(escape(text[position:found.start()]))
            if found["code"] and not isCode:
                made.append(f"<code>{self.render(found['code'], True)}</code>")
            elif found["code"]:
                made.append(escape(found[0]))
            else:
                made.append(self.word(found))
            position = found.end()
        return "".join(made) + escape(text[position:])

    def render_words(self, text):
        """Text without marks, for guides."""
        return self.render(text, isCode=True)
