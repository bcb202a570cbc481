"""All headers together: their names, their flags, and texts for declarations without comments."""
import re

from declarations import Comment, Declaration

TYPES = "struct", "enum", "typedef"
GLUE = {"Gl": "OpenGL", "Vk": "Vulkan"}


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
    ends = [name.removesuffix("_MAX_ENUM") if name.endswith("_MAX_ENUM") else name.rpartition("_")[0] for name in names]
    parts = [end.split("_") for end in ends]
    shared = [same[0] for same in zip(*parts) if len(set(same)) == 1]
    return "_".join(shared) + "_" if shared else ""


def flag_prefix(name):
    return "_".join(name.split("_")[:2]) + "_"


def has_next_flag(items, position):
    """Whether a macro with the same prefix follows the macro at a position."""
    following = items[position + 1] if position + 1 < len(items) else None
    return isinstance(following, Declaration) and following.kind == "define" and \
        flag_prefix(following.name) == flag_prefix(items[position].name)


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


class Interface:
    """All headers together: the names and their uses, from which missing texts are made."""

    def __init__(self, headers):
        self.headers = headers  # {name: items}
        self.declared = [item for items in headers.values() for item in items if isinstance(item, Declaration)]
        self.structs = {item.name.upper(): item.name for item in self.declared if item.kind == "struct"}
        self.known = set(self.names())

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
        uses = [use for use in self.uses(name) if use != owner] if item.kind in TYPES else []
        return words(name) + (f" Used by {', '.join(uses)}." if uses else "")
