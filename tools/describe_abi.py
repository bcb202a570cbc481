#!/usr/bin/env python3
"""Writes the description of the C ABI, which bindings for other languages are generated from: abi/agaa.json.

    tools/describe_abi.py            prints the description of include/
    tools/describe_abi.py --update   writes abi/agaa.json

It has functions, structs with offsets, enumerations, flags and other constants, callbacks and handles, for 64-bit hosts.
Comments are in the headers.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from pycparser import c_ast, c_generator, c_parser

ROOT = pathlib.Path(__file__).resolve().parents[1]
HEADERS = ["agaa/base.h", "agaa/config.h", "agaa/adaptive.h", "agaa/frame.h", "agaa/functions.h", "agaa/query.h", "agaa/price.h",
           "agaa/statistics.h", "agaa/outputs.h", "agaa/goal.h", "agaa/temporal.h", "agaa_vk.h", "agaa_gl.h"]
SIZES = {"char": 1, "int": 4, "float": 4, "double": 8, "uint32_t": 4, "int32_t": 4, "uint64_t": 8, "int64_t": 8, "size_t": 8,
         "void": 0}
# The parser knows no attributes and no standard headers.
STUBS = "typedef unsigned uint32_t; typedef int int32_t; typedef unsigned long uint64_t; typedef long int64_t; typedef unsigned long size_t;\n"


def preprocessed(root):
    with tempfile.TemporaryDirectory() as folder:
        for name in ("stddef.h", "stdint.h"):
            (pathlib.Path(folder) / name).write_text("")
        return subprocess.run(
            ["cpp", "-P", "-nostdinc", f"-I{folder}", f"-I{root / 'include'}", "-D__attribute__(x)=", "-"],
            input="#include \"agaa_vk.h\"\n#include \"agaa_gl.h\"\n", check=True, capture_output=True, text=True).stdout


def integer(text):
    """Of a macro: a number, or flags joined by |."""
    text = re.sub(r"UINT(?:32|64)_C\((\w+)\)", r"\1", text).strip("() ")
    text = re.sub(r"\b(0[xX][0-9a-fA-F]+|\d+)[uUlL]*\b", r"\1", text)
    return int(text, 0) if re.fullmatch(r"0[xX][0-9a-fA-F]+|\d+", text) else None


def constants(root):
    """Flags and limits: macros with a value that is a whole number, by header."""
    found = {}
    for header in HEADERS:
        text = re.sub(r"\\\n", " ", (root / "include" / header).read_text())
        for name, value in re.findall(r"^#define (AGAA_\w+) (.+?)\s*(?:/\*.*)?$", text, re.MULTILINE):
            if integer(value) is not None:
                found[name] = integer(value)
            elif re.fullmatch(r"\((?:AGAA_\w+ \| )*AGAA_\w+\)", value):
                found[name] = sum({found[flag] for flag in re.findall(r"AGAA_\w+", value)})
    return found


def constant_types(root, names):
    """Types of the constants in C: uint64_t for those that are made of UINT64_C, else uint32_t."""
    text = "".join(re.sub(r"\\\n", " ", (root / "include" / header).read_text()) for header in HEADERS)
    wide = set(re.findall(r"^#define (AGAA_\w+) +UINT64_C\(", text, re.MULTILINE))
    for name, flags in re.findall(r"^#define (AGAA_\w+) \(((?:AGAA_\w+ \| )*AGAA_\w+)\)", text, re.MULTILINE):
        if wide & set(flags.split(" | ")):
            wide.add(name)
    return {name: "uint64_t" if name in wide else "uint32_t" for name in names}


class Description:
    def __init__(self, tree):
        self.enums, self.structs, self.callbacks, self.handles, self.functions = {}, {}, {}, [], []
        for node in tree.ext:
            if isinstance(node, c_ast.Typedef):
                self.add_type(node)
            elif isinstance(node.type, c_ast.FuncDecl):
                self.functions.append({"name": node.name, **self.signature(node.type)})

    def add_type(self, node):
        kind = node.type.type if isinstance(node.type, c_ast.TypeDecl) else node.type
        if isinstance(kind, c_ast.Enum):
            self.enums[node.name] = self.values(kind)
        elif isinstance(kind, c_ast.Struct) and kind.decls:
            self.structs[node.name] = self.struct(kind)
        elif isinstance(kind, c_ast.PtrDecl) and isinstance(kind.type, c_ast.FuncDecl):
            self.callbacks[node.name] = self.signature(kind.type)
        elif isinstance(kind, c_ast.PtrDecl):
            self.handles.append(node.name)

    @staticmethod
    def values(enum):
        return {item.name: int(c_generator.CGenerator().visit(item.value).strip("()"), 0) for item in enum.values.enumerators}

    def signature(self, function):
        parameters = [] if function.args is None else [
            {"name": parameter.name, "type": self.type_name(parameter.type)} for parameter in function.args.params
            if self.type_name(parameter.type) != "void"]
        return {"returns": self.type_name(function.type), "parameters": parameters}

    def type_name(self, node):
        if isinstance(node, c_ast.PtrDecl):
            return self.type_name(node.type) + "*" + (" const" if "const" in node.quals else "")
        if isinstance(node, c_ast.ArrayDecl):
            return f"{self.type_name(node.type)}[]"
        name = " ".join(node.type.names) if isinstance(node.type, c_ast.IdentifierType) else node.type.name
        return ("const " if "const" in node.quals else "") + name

    def layout(self, node):
        """Size and alignment."""
        if isinstance(node, c_ast.PtrDecl):
            return 8, 8
        if isinstance(node, c_ast.ArrayDecl):
            size, alignment = self.layout(node.type)
            return size * int(c_generator.CGenerator().visit(node.dim), 0), alignment
        name = self.type_name(node).removeprefix("const ")
        if name in self.structs:
            return self.structs[name]["size"], self.structs[name]["alignment"]
        size = SIZES.get(name, 8 if name in self.handles or name in self.callbacks else 4)
        return size, size

    def struct(self, node):
        members, offset, largest = [], 0, 1
        for member in node.decls:
            size, alignment = self.layout(member.type)
            if offset % alignment:
                sys.exit(f"{member.name} needs padding before it.")
            element, lengths = member.type, []
            while isinstance(element, c_ast.ArrayDecl):
                lengths.append(int(c_generator.CGenerator().visit(element.dim), 0))
                element = element.type
            members.append({"name": member.name, "type": self.type_name(element), "offset": offset, "size": size,
                            **({"lengths": lengths} if lengths else {})})
            offset, largest = offset + size, max(largest, alignment)
        return {"size": offset, "alignment": largest, "members": members}


def describe(root):
    tree = c_parser.CParser().parse(STUBS + preprocessed(root))
    found = Description(tree)
    known = constants(root)
    version = [known[f"AGAA_VERSION_{part}"] for part in ("MAJOR", "MINOR", "PATCH")]
    return {"version": ".".join(map(str, version)), "handles": found.handles, "constants": known,
            "constantTypes": constant_types(root, known), "enums": found.enums, "callbacks": found.callbacks,
            "structs": found.structs, "functions": found.functions}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="of the sources")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    text = json.dumps(describe(arguments.root), indent=1) + "\n"
    if arguments.update:
        (arguments.root / "abi").mkdir(exist_ok=True)
        (arguments.root / "abi" / "agaa.json").write_text(text)
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
