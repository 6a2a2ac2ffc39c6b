# SPDX-License-Identifier: MIT
"""The example that fits a measured ball: it finds what made a track, also one that it reads from a file."""
import contextlib
import io
import os
import sys
import tempfile
import unittest

import numpy as np

import libphysics as lp

sys.path.insert(0, os.path.join(os.path.dirname(lp.__file__), "..", "examples"))
import fit  # noqa: E402

LEVEL = os.environ["LEVEL"]


PROJECT = os.path.join(os.path.dirname(lp.__file__), "..", "..", "..")


class FitTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stepper = lp.Stepper("exact", lp.Scene(LEVEL))
        cls.dt, cls.seen, cls.tilts, cls.truth = fit.make_track(cls.stepper)

    def test_truth_lies_near_its_intervals(self):
        """Intervals of 95 %: four of their halves away, chance doesn't lead."""
        numbers, deviations, rms, count = fit.fit(self.stepper, self.dt, self.seen, self.tilts)
        self.assertEqual(count, len(self.seen))
        self.assertTrue(np.all(np.abs(numbers - self.truth) < 4 * 1.96 * deviations))
        self.assertLess(abs(rms - 1), 4 / np.sqrt(2 * self.seen.size))

    def test_example_track_is_what_it_prints(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            fit.main(["--make", os.path.join(PROJECT, "mazes", "levels", "03.txt")])
        with open(os.path.join(PROJECT, "inspector", "example_track.csv"), encoding="ascii") as file:
            self.assertEqual(said.getvalue(), file.read())

    def test_other_ball_is_followed_a_little_way_only(self):
        """A ball that is pushed aside by a centimetre after two seconds isn't the model's."""
        seen = self.seen.copy()
        seen[120:] += 0.01
        self.assertLessEqual(fit.fit(self.stepper, self.dt, seen, self.tilts)[3], 120)

    def test_slopes_of_a_batch_are_those_of_single_balls(self):
        apart, slopes = fit.residuals_and_slopes(self.stepper, self.truth, self.dt, self.seen, self.tilts)
        for i, notch in enumerate(fit.NOTCHES):
            beside = self.truth.copy()
            beside[i] += notch
            there = ((fit.roll(self.stepper, beside, self.dt, self.tilts) - self.seen) / fit.NOISE).ravel()
            np.testing.assert_array_equal(slopes[:, i], (there - apart) / notch)

    def test_track_is_read_from_a_table(self):
        times = np.arange(len(self.seen)) * self.dt
        rows = np.column_stack([times, self.seen, np.vstack([self.tilts, self.tilts[-1:]])])
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            np.savetxt(file, rows, delimiter=",", header="t,x,y,tilt_x,tilt_y", comments="", fmt="%.17g")
            file.flush()
            dt, seen, tilts, truth = fit.read_track(file.name)
        self.assertAlmostEqual(dt, self.dt, 12)
        np.testing.assert_array_equal(seen, self.seen)
        np.testing.assert_array_equal(tilts, self.tilts)
        self.assertIsNone(truth)


if __name__ == "__main__":
    unittest.main()
