"""Every function of the C ABI is in a C++ header, by the names that agaa.hpp promises."""
import json
import os
import pathlib
import re
import unittest

ROOT = pathlib.Path(os.environ["AGAA_SOURCE"])
INCLUDE = ROOT / "include"
# Functions without a function of their name, and the reason.
OTHERWISE = {
    "agaaDestroyContext": "agaa::Context destroys the handle",
    "agaaDestroyView": "agaa::View destroys the handle",
}


def without_comments(text):
    return re.sub(r"//.*", "", text)


def lower_first(name):
    return name[0].lower() + name[1:]


def missing(functions, sources):
    """Findings; sources are texts by file name. agaaInitX is agaa::init<AgaaX>()."""
    texts = {name: without_comments(text) for name, text in sources.items()}
    everything = "\n".join(texts.values())
    for function in functions:
        kind, api, name = re.fullmatch(r"(agaa)(Vk(?=[A-Z])|Gl(?=[A-Z])|)(\w+)", function).groups()
        if function.startswith("agaaInit"):
            struct = "A" + function.replace("Init", "", 1)[1:]
            if not re.search(rf"^template <> constexpr {struct} init\(\) noexcept", everything, re.MULTILINE):
                yield f"agaa::init<{struct}>() is missing"
            continue
        home = f"agaa_{api.lower()}.hpp" if api else None
        searched = texts.get(home, "") if home else "\n".join(t for n, t in texts.items() if not n.startswith("agaa_"))
        if not re.search(rf"\b{function}\b", searched):
            yield f"{function} is not called"
        if function not in OTHERWISE and not re.search(rf"^(?:\[\[nodiscard\]\] )?inline [^;{{}}]*\b{lower_first(name)}\(",
                                                       searched, re.MULTILINE):
            yield f"agaa::{api.lower() + '::' if api else ''}{lower_first(name)} is missing"


class Functions(unittest.TestCase):
    def setUp(self):
        description = json.loads((ROOT / "abi" / "agaa.json").read_text())
        self.functions = [function["name"] for function in description["functions"]]
        self.sources = {path.name: path.read_text() for path in INCLUDE.rglob("*.hpp")}

    def test_none_is_missing(self):
        self.assertGreater(len(self.functions), 80)
        self.assertEqual(list(missing(self.functions, self.sources)), [])

    def test_exceptions_exist(self):
        self.assertEqual(sorted(set(OTHERWISE) - set(self.functions)), [])

    def test_each_missing_one_is_found(self):
        for function in self.functions:
            changed = {name: text.replace(function, "other") for name, text in self.sources.items()}
            if function.startswith("agaaInit"):
                struct = "A" + function.replace("Init", "", 1)[1:]
                changed = {name: text.replace(f"constexpr {struct} init()", "") for name, text in self.sources.items()}
            self.assertNotEqual(list(missing([function], changed)), [], function)

    def test_a_new_one_is_found(self):
        for function in ("agaaNew", "agaaVkNew", "agaaGlNew", "agaaInitNew"):
            self.assertNotEqual(list(missing([function], self.sources)), [], function)

    def test_functions_keep_their_promises_on_exceptions(self):
        """Functions that return a vector or a string may throw std::bad_alloc. All others are noexcept."""
        found = 0
        for name, text in self.sources.items():
            if name in ("init.hpp", "result.hpp", "lists.hpp", "array_view.hpp"):
                continue
            for declaration in re.findall(r"^(?:\[\[nodiscard\]\] )?inline (?!constexpr)[^;{}]*", without_comments(text),
                                          re.MULTILINE):
                allocates = "std::vector<" in declaration or "std::string>" in declaration
                self.assertEqual("noexcept" in declaration, not allocates, declaration)
                found += 1
        self.assertGreater(found, 40)


if __name__ == "__main__":
    unittest.main()
