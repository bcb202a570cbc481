"""tools/check_abi.py finds incompatible changes and accepts compatible ones, on altered copies of the description."""
import copy
import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_abi  # noqa: E402

NOW = json.loads((ROOT / "abi" / "agaa.json").read_text())


class CheckAbi(unittest.TestCase):
    def setUp(self):
        self.later = copy.deepcopy(NOW)

    def found(self):
        return " ".join(check_abi.check(NOW, self.later))

    def member(self, struct, name):
        return next(m for m in self.later["structs"][struct]["members"] if m["name"] == name)

    def grow(self, struct):
        size = self.later["structs"][struct]["size"]
        self.later["structs"][struct]["members"].append({"name": "more", "type": "uint64_t", "offset": size, "size": 8})
        self.later["structs"][struct]["size"] = size + 8

    def test_the_same(self):
        self.assertEqual(self.found(), "")

    def test_growth_is_compatible(self):
        for struct in ("AgaaConfig", "AgaaFrameStatistics", "AgaaVkFrame", "AgaaDrawTarget", "AgaaLight", "AgaaShadow"):
            self.grow(struct)
        self.later["functions"].append({"name": "agaaMore", "returns": "void", "parameters": []})
        self.later["enums"]["AgaaTier"]["AGAA_TIER_MORE"] = 21
        self.later["constants"]["AGAA_CONFIG_MORE"] = 64
        self.later["constants"]["AGAA_VERSION_PATCH"] += 1
        self.assertEqual(self.found(), "")

    def test_reserved_members_may_get_names(self):
        members = self.later["structs"]["AgaaCounters"]["members"]
        reserved = members.pop()
        members.append({"name": "more", "type": "uint64_t", "offset": reserved["offset"], "size": 8})
        members.append({**reserved, "offset": reserved["offset"] + 8, "size": reserved["size"] - 8, "lengths": [15]})
        self.assertEqual(self.found(), "")

    def test_structs_inside_structs_may_not_grow(self):
        for struct in ("AgaaDrawState", "AgaaCounters", "AgaaPassTime", "AgaaInvalidPixel", "AgaaLayoutAttribute"):
            self.later = copy.deepcopy(NOW)
            self.grow(struct)
            self.assertIn(f"The struct {struct} has", self.found())

    def test_changes_of_structs(self):
        self.member("AgaaConfig", "samples")["offset"] += 4
        self.assertIn("AgaaConfig::samples", self.found())
        self.member("AgaaFrame", "view")["type"] = "double"
        self.assertIn("AgaaFrame::view", self.found())
        del self.later["structs"]["AgaaTarget"]
        self.assertIn("AgaaTarget is gone", self.found())

    def test_changes_of_functions(self):
        self.later["functions"][0]["parameters"][0]["name"] = "other"
        self.assertEqual(self.found(), "")
        self.later["functions"][0]["returns"] = "void"
        self.assertIn("has another signature", self.found())
        name = self.later["functions"].pop()["name"]
        self.assertIn(f"The function {name} is gone", self.found())

    def test_changes_of_values(self):
        self.later["enums"]["AgaaNdf"]["AGAA_NDF_LEAN"] = 9
        self.assertIn("AGAA_NDF_LEAN", self.found())
        del self.later["constants"]["AGAA_VIEW_COMPOSITE"]
        self.assertIn("AGAA_VIEW_COMPOSITE", self.found())

    def test_changes_of_callbacks_and_handles(self):
        self.later["callbacks"]["AgaaDrawCallback"]["parameters"].pop()
        self.later["handles"].remove("AgaaView")
        self.assertIn("AgaaDrawCallback", self.found())
        self.assertIn("AgaaView is gone", self.found())


if __name__ == "__main__":
    unittest.main()
