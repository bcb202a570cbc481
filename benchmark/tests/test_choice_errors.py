#!/usr/bin/env python3
"""Tests of benchmark/choice_errors.py: the prediction, the choices of a host that measures them, and the kept page."""
import math
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark"))

import choice_errors


def scenes_alike():
    """Errors of five settings in ten scenes: each is a scene's own number and a little of the setting's."""
    numbers = random.Random(3)
    own = [numbers.gauss(-2, 0.6) for _ in range(10)]
    return {name: [x + offset + numbers.gauss(0, 0.02) for x in own] for name, offset in zip("abcde", (0, -0.5, -1, -1.5, -2))}


class Prediction(unittest.TestCase):
    def test_one_given_variable_is_a_regression(self):
        variables = {"x": [1.0, 2.0, 4.0, 5.0], "y": [2.0, 2.5, 5.0, 6.5]}
        model = choice_errors.Conditional(variables, {"x": 3.5}, noise=0.3)
        mean, deviation = model.of("y")
        common, own = model.covariance("x", "y"), statistics.variance(variables["x"]) + 0.09
        self.assertAlmostEqual(mean, 4 + common / own * (3.5 - 3))
        self.assertAlmostEqual(deviation ** 2, statistics.variance(variables["y"]) + 0.09 - common ** 2 / own)
        self.assertEqual(model.of("x"), (3.5, 0.0))

    def test_one_error_predicts_the_others_of_a_scene_that_is_left_out(self):
        errors = scenes_alike()
        self.assertGreater(choice_errors.distances(errors, {}, [])[-1], 2)
        self.assertLess(choice_errors.distances(errors, {}, ["a"])[-1], 1.2)

    def test_the_noise_is_that_of_the_library(self):
        text = (ROOT / "src/core/tuning/error_model.cpp").read_text()
        self.assertEqual(float(re.search(r"double noise = ([0-9.]+);", text)[1]), choice_errors.NOISE)


class Choices(unittest.TestCase):
    def test_the_fastest_that_is_predicted_to_reach(self):
        predicted = {"a": (math.log(0.2), 0.1), "b": (math.log(0.05), 0.1), "c": (math.log(0.04), 0.1)}
        times = {"a": 1, "b": 3, "c": 2}
        self.assertEqual(choice_errors.choose(predicted, times, 0.3), "a")
        self.assertEqual(choice_errors.choose(predicted, times, 0.1), "c")
        self.assertEqual(choice_errors.choose(predicted, times, 0.01), "c")

    def test_measured_choices_reach_the_target(self):
        errors = scenes_alike()
        times = {"single-1": [1.0] * 10, **{name: [2.0 + i] * 10 for i, name in enumerate("abcde")}}
        for scene in range(10):
            target = 1.3 * math.exp(errors["c"][scene])
            judged = choice_errors.judge(errors, times, scene, target, 3)
            self.assertLessEqual(judged["reached"], 1)
            self.assertEqual(judged["choice"], "c")
            self.assertEqual(judged["time"], 1)
        self.assertIsNone(choice_errors.judge(errors, times, 0, 1e-9, 3)["time"])


class Kept(unittest.TestCase):
    def test_the_kept_page_is_of_the_kept_sweep(self):
        kept = ROOT / "docs/results/lavapipe"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "benchmark/choice_errors.py", "--out", folder], check=True)
            for name in ("choice_errors.json", "choice_errors.md"):
                self.assertEqual((pathlib.Path(folder) / name).read_text(), (kept / name).read_text(), name)


if __name__ == "__main__":
    unittest.main()
