"""Lists what the headers promise, one name per promise, as the tests of the conformance suite are named.

    tools/promises.py [INCLUDE]

For functions, by the sections of their comments:
    FUNCTION/AGAA_ERROR_…   an error that the section Errors lists; FUNCTION/no_errors for "None."
    FUNCTION/those_of.OTHER the errors of another function
    FUNCTION/PARAM.unchanged, FUNCTION/PARAM.null, FUNCTION/returns, FUNCTION/threads, FUNCTION/opengl_state
For structs and their members:
    STRUCT/header           sType, structSize and pNext of a versioned struct
    STRUCT/init             the macro and the function agaaInit… give the same
    STRUCT.MEMBER/range, /enum, /flags, /zero (a reserved member), /null
    OWNER/AGAA_ERROR_…      an error that another comment names; OWNER is the struct, member, enumerator or macro
For all functions that take a struct:
    conventions/AGAA_ERROR_…
"""
import pathlib
import re
import sys

HEADERS = ("agaa/base.h", "agaa/config.h", "agaa/adaptive.h", "agaa/frame.h", "agaa/functions.h", "agaa/query.h", "agaa/price.h",
           "agaa/statistics.h", "agaa/outputs.h", "agaa/goal.h", "agaa/temporal.h", "agaa_vk.h", "agaa_gl.h")
ERROR = re.compile(r"AGAA_ERROR_[A-Z_]+")
RANGE = re.compile(r"[\[(]-?[0-9][^\]()]*, ?[^\]()]*[\])]|>=? ?[0-9]|\b[0-9]+, [0-9]+,")


def plain(comment):
    """The text of a comment without its frame."""
    lines = re.sub(r"^/\*|\*/$", "", comment.strip()).splitlines()
    return "\n".join(re.sub(r"^\s*\* ?", "", line) if i else line.strip() for i, line in enumerate(lines))


def sections(comment):
    """The rows of a function's comment: {"desc": text, "Errors": text}."""
    rows, key = {}, None
    for line in plain(comment).splitlines():
        begin = re.match(r"([A-Za-z]\w*(?:, \w+)*) {2,}(\S.*)", line)
        if begin:
            key = begin[1]
            rows[key] = begin[2]
        elif key and line.startswith("  "):
            rows[key] += "\n" + line.strip()
        elif line.strip():
            key = None
    return rows


def function_promises(name, comment):
    for key, text in sections(comment).items():
        flat = " ".join(text.split())
        if key == "Errors":
            if flat.startswith("None"):
                yield f"{name}/no_errors"
            for other in re.findall(r"[Tt]hose of (agaa\w+)", flat):
                yield f"{name}/those_of.{other}"
            for error in ERROR.findall(flat):
                yield f"{name}/{error}"
        elif key == "Returns":
            yield f"{name}/returns"
        elif key == "Threads":
            if flat.startswith("Any"):
                yield f"{name}/threads"
        elif key == "OpenGL":
            if "state is restored" in flat:
                yield f"{name}/opengl_state"
        elif key not in ("Vulkan", "OpenGL"):
            for parameter in key.split(", "):
                if "unchanged on failure" in flat:
                    yield f"{name}/{parameter}.unchanged"
                if re.search(r"[Mm]ay be null|\bNull[:,]", flat):
                    yield f"{name}/{parameter}.null"


def member_promises(struct, member, comment):
    owner = f"{struct}.{member}"
    if member.startswith("reserved"):
        yield f"{owner}/zero"
        return
    flat = " ".join(comment.split())
    if RANGE.search(flat):
        yield f"{owner}/range"
    if re.match(r"(?:bits? of )?Agaa\w+\b(?!::)", flat) and not flat.startswith("AgaaVk") and not flat.startswith("AgaaGl"):
        yield f"{owner}/enum"
    elif re.match(r"Agaa(?:Vk|Gl)(?:Rendering|Recording|Storage|Outputs|StatePolicy|Constants)\b", flat):
        yield f"{owner}/enum"
    if re.match(r"AGAA_\w+_…", flat):
        yield f"{owner}/flags"
    if re.search(r"\b[Mm]ay be null|\b[Nn]ull:", flat):
        yield f"{owner}/null"
    for error in ERROR.findall(flat):
        yield f"{owner}/{error}"


def members(body):
    """(name, comment) of each member of a struct or an enumeration: comments stand before or after on the line."""
    for match in re.finditer(r"((?:\s*/\*.*?\*/)*)\s*([^;,/{}]+(?:\{[^}]*\})?[^;,/{}]*(?:, \w+)*)[;,]?[ \t]*((?:/\*.*?\*/)?)",
                             body, re.DOTALL):
        before, declaration, after = match.groups()
        text = plain(after) if after else plain(before)
        declaration = declaration.split("=")[0].strip()
        if not declaration:
            continue
        for part in declaration.split(","):
            name = re.search(r"(\w+)\s*(?:\[.*\])*\s*$", part.strip())
            if name:
                yield name[1], text


def promises(include):
    found = []
    for header in HEADERS:
        text = (include / header).read_text()
        for comment, declarations in re.findall(
                r"(/\*(?:(?!\*/).)*?\*/)\n((?:AGAA_API [^;]*;\n)+)", text, re.DOTALL):
            for name in re.findall(r"AGAA_CALL (agaa\w+)\(", declarations):
                if not name.startswith("agaaInit"):
                    found += function_promises(name, comment)
        for comment, kind, body, name in re.findall(
                r"(/\*(?:(?!\*/).)*?\*/\n)?typedef (struct|enum) \w+ \{(.*?)\n\} (\w+);", text, re.DOTALL):
            for error in ERROR.findall(comment):
                found.append(f"{name}/{error}")
            for member, note in members(body):
                if kind == "struct":
                    if member not in ("sType", "structSize", "pNext"):
                        found += member_promises(name, member, note)
                elif name != "AgaaResultCode":
                    found += [f"{member}/{error}" for error in ERROR.findall(note)]
            if kind == "struct" and re.match(r"\s*uint32_t sType;", body) and name != "AgaaStructHeader":
                found.append(f"{name}/header")
        for name in re.findall(r"AGAA_CALL agaaInit(\w+)\(", text):
            found.append(f"Agaa{name}/init")
        for name, note in re.findall(r"#define (AGAA_\w+) [^\n]*?/\*(.*?)\*/", text, re.DOTALL):
            found += [f"{name}/{error}" for error in ERROR.findall(note)]
        # Comments that begin a line: others belong to what stands before them.
        for note, name in re.findall(r"^/\*((?:(?!\*/).)*?)\*/\n#define (AGAA_\w+) ", text, re.DOTALL | re.MULTILINE):
            found += [f"{name}/{error}" for error in ERROR.findall(note)]
    conventions = (include / "agaa_sdk.h").read_text()
    found += [f"conventions/{error}" for error in ERROR.findall(conventions)]
    return list(dict.fromkeys(found))


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[1] / "include"
    print("\n".join(promises(root)))
