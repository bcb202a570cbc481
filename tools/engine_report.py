#!/usr/bin/env python3
"""Prints the result of a host in an engine, which scripts/engines has run: a line per technique and check."""

import argparse
import json
import sys


def report(engine, result):
    print(f"{engine}: {result['engine']} on {result['device']}, {result['frames']} frames; "
          f"error of the engine's own image {result['engineError']:.2e}")
    for each in result["techniques"]:
        validity = "valid" if each["isValid"] else "NOT VALID"
        print(f"{engine}: {each['name']:<16} error {each['error']:.2e}, {validity}, "
              f"{each['once']} of {each['visible']} samples accumulated once, {each['shadingEvents']} shading events")
    for check, is_passed in result.get("checks", {}).items():
        print(f"{engine}: {'passed' if is_passed else 'FAILED'}: {check}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("engine")
    parser.add_argument("path", help="the JSON that the host printed")
    arguments = parser.parse_args()
    try:
        with open(arguments.path, encoding="utf-8") as file:
            report(arguments.engine, json.load(file))
    except (OSError, ValueError, KeyError):
        sys.exit(f"The host of {arguments.engine} printed no result.")


if __name__ == "__main__":
    main()
