#!/usr/bin/env python3
"""Says whether a host that was compiled against one version of the headers runs with a library of another.

    tools/check_abi.py OLD.json NEW.json

Both are descriptions by tools/describe_abi.py. Exit status 1 where the rules of docs/abi.md are broken, which are named.
"""
import argparse
import json
import pathlib
import sys


def lost(kind, old, new):
    return [f"{kind} {name} is gone." for name in old if name not in new]


def check_functions(old, new):
    functions = [{function["name"]: function for function in description["functions"]} for description in (old, new)]
    found = lost("The function", *functions)
    for name, function in functions[0].items():
        if name in functions[1] and signature(function) != signature(functions[1][name]):
            found.append(f"The function {name} has another signature.")
    return found


def signature(function):
    """Names of parameters may change."""
    return function["returns"], [parameter["type"] for parameter in function["parameters"]]


def is_versioned(struct):
    return [member["name"] for member in struct["members"][:3]] == ["sType", "structSize", "pNext"]


def check_structs(old, new):
    found = lost("The struct", old["structs"], new["structs"])
    for name, struct in old["structs"].items():
        if name not in new["structs"]:
            continue
        later = {member["name"]: member for member in new["structs"][name]["members"]}
        for member in struct["members"]:
            if member["name"].startswith("reserved"):
                continue  # new members take its place
            if later.get(member["name"]) != member:
                found.append(f"The member {name}::{member['name']} is gone or has changed.")
        size, now = struct["size"], new["structs"][name]["size"]
        # Elements of AgaaFrame's arrays, whose size the host says.
        if now < size or (now > size and not is_versioned(struct) and name not in ("AgaaLight", "AgaaShadow")):
            found.append(f"The struct {name} has {now} bytes in place of {size}.")
    return found


def check_values(old, new):
    found = []
    for enum, values in old["enums"].items():
        later = new["enums"].get(enum, {})
        for name, value in values.items():
            if later.get(name) != value and not name.endswith("_COUNT"):
                found.append(f"The enumerator {name} is gone or has another value.")
    for name, value in old["constants"].items():
        if name.startswith("AGAA_VERSION_") or name == "AGAA_FACT_ALL_SHADED":
            continue  # a sum of what is known
        if new["constants"].get(name) != value:
            found.append(f"The constant {name} is gone or has another value.")
    return found


def check(old, new):
    found = check_functions(old, new) + check_structs(old, new) + check_values(old, new)
    found += lost("The handle", old["handles"], new["handles"])
    for name, callback in old["callbacks"].items():
        if name not in new["callbacks"] or signature(callback) != signature(new["callbacks"][name]):
            found.append(f"The callback {name} is gone or has another signature.")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    arguments = parser.parse_args()
    found = check(*(json.loads(path.read_text()) for path in (arguments.old, arguments.new)))
    for sentence in found:
        print(sentence, file=sys.stderr)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
