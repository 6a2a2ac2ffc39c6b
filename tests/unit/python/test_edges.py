# SPDX-License-Identifier: MIT
"""The Python package where arguments are empty, wrong or many, and where a signal or a class of one's own comes in."""
import os
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
import typing
import unittest

import numpy as np

import libphysics as lp

LEVEL = os.environ["LEVEL"]
FLOOR = [(-2, -2, -1), (2, 2, 0)]


class EmptyShapesTest(unittest.TestCase):
    """Where the batch is empty nothing is read: not even what lies behind an array without elements."""

    def test_all_broadcast_as_numpy_does(self):
        scene = lp.Scene(LEVEL)
        stepper = lp.Stepper("symplectic-euler", scene)
        shapes = ((), (0,), (1,), (3, 0), (0, 3), (0, 1), (1, 0), (0, 0))
        for ball in shapes:
            for sets in shapes:
                for pull in (None, *shapes):
                    wanted = [ball, sets] + ([] if pull is None else [pull])
                    try:
                        shape = np.broadcast_shapes(*wanted)
                    except ValueError:
                        continue
                    for steps in (1, 5):
                        gravity = None if pull is None else np.full(pull + (steps, 3), (0.5, 0, -9.75))
                        params = stepper.params(restitution_wall=np.full(sets, 0.5))
                        for threads in (1, 3):
                            run = stepper.run(scene.start(ball), params, 0.01, steps, gravity=gravity, every=1, tally=True,
                                              threads=threads).check()
                            self.assertEqual((run.states.shape, run.path.shape), (shape, shape + (steps,)), wanted)

    def test_a_mask_that_selects_no_ball(self):
        scene = lp.Scene(LEVEL)
        stepper = lp.Stepper("exact", scene)
        nobody = np.zeros(4, bool)
        params = stepper.params(restitution_wall=np.array([0.1, 0.2, 0.3, 0.4])[nobody])
        self.assertEqual(stepper.run(scene.start(4)[nobody], params, 0.01, 5).states.shape, (0,))


class EqualityTest(unittest.TestCase):
    """Params are compared by value."""

    def test_sets_of_the_same_names_shape_and_values_are_equal(self):
        stepper = lp.Stepper("rk4", lp.Scene(boxes=[FLOOR]))
        for values in ({}, {"gravity": (1, 0, -9)}, {"model": lp.RIGID}, {"orientation": True}, {"as_reported": 1},
                       {"restitution_wall": [0.25, 0.75]}, {"rolling_friction": np.zeros((2, 0))}):
            self.assertTrue(stepper.params(**values) == stepper.params(**values), values)
            self.assertEqual(stepper.params(**values) != stepper.params(), values != {}, values)
        self.assertNotEqual(stepper.params(restitution_wall=[0.25, 0.75]), stepper.params(restitution_wall=[0.25, 0.5]))
        self.assertNotEqual(lp.Params(), lp.Params(restitution_wall=[0.5]))  # the default, in another shape
        self.assertNotEqual(lp.Params(), stepper.params())  # of other names
        self.assertNotEqual(lp.Params(), "Params")

    def test_sets_can_change_and_have_no_hash(self):
        with self.assertRaisesRegex(TypeError, "unhashable"):
            hash(lp.Params())


class PiecesTest(unittest.TestCase):
    """A long run is made in pieces, which show in nothing but that signals are heeded."""

    def setUp(self):
        self.scene = lp.Scene(LEVEL)
        self.stepper = lp.Stepper("symplectic-euler", self.scene)

    def runs(self, sizes, **arguments):
        from libphysics import _pieces
        usual = _pieces._STEPS
        try:
            for size in sizes:
                _pieces._STEPS = size
                yield self.stepper.run(self.scene.start(), self.stepper.params(), 0.01, **arguments)
        finally:
            _pieces._STEPS = usual

    def test_pieces_of_any_size_have_the_same_bits(self):
        gravity = lp.gravity_from_tilt(*np.random.default_rng(5).uniform(-0.1, 0.1, (2, 21, 60)))
        gravity[::4, 33] = (0, 0, 1)  # pulled off their floor
        gravity[1::4, :] = lp.gravity_from_tilt(0.2, 0.1)  # out after a while
        for every in (0, 1, 7, 20, 60, 100):
            for stop in (0, lp.AT_REST | lp.OUT):
                arguments = {"steps": 60, "gravity": gravity, "every": every, "stop": stop, "tally": True}
                whole, *others = self.runs((10**9, 1, 8, 100, 250, 1000), **arguments)
                self.assertIn(-2, whole.statuses)
                for other in others:
                    for name, mine, its in zip(whole._fields, whole, other):
                        self.assertEqual(None if mine is None else mine.tobytes(), None if its is None else its.tobytes(), name)

    def test_balls_that_are_done_end_the_run(self):
        scene = lp.Scene(boxes=[FLOOR], radius=0.125)
        stepper = lp.Stepper("swept", scene)
        run = stepper.run(scene.start(2), stepper.params(), 0.01, 2**53, gravity=(2, 0, -9.75), stop=lp.OUT)
        self.assertTrue((run.states["flags"] & lp.OUT).all())

    def test_steps_of_resting_balls_take_few_pieces(self):
        from libphysics import _pieces
        pieces, usual = [], _pieces.run_piece
        self.addCleanup(setattr, _pieces, "run_piece", usual)

        def run_piece(*arguments):
            pieces.append(arguments)
            if len(pieces) > 10_000:  # of 2^37
                raise InterruptedError
            usual(*arguments)

        _pieces.run_piece = run_piece
        for threads, every in ((1, 0), (2, 0), (1, 2**51)):
            pieces.clear()
            run = self.stepper.run(self.scene.start(16), self.stepper.params(), 0.25, 2**53, threads=threads, every=every)
            self.assertEqual(run.states["time"].tolist(), [2.0**51] * 16)
            self.assertEqual((run.steps_done == 2**53).all(), True)
            if every:
                self.assertEqual(run.path["time"].tolist(), [[2.0**49, 2.0**50, 1.5 * 2.0**50, 2.0**51]] * 16)

    def test_a_signal_ends_a_run(self):
        # A shell lets what it starts in the background ignore this signal, which Python takes over.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        # A program that a script starts in the background ignores the signal.
        heeded = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, heeded)
        states, params = self.scene.start(2), self.stepper.params(rolling_friction=0.0, restitution_wall=1.0)
        states["velocity"] = 0.25, 0.125, 0.0  # for good
        for threads in (1, 2):
            timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                self.stepper.run(states, params, 0.01, 2**53, threads=threads)
            timer.join()
        self.stepper.run(self.scene.start(2), self.stepper.params(), 0.01, 5).check()


class ForkTest(unittest.TestCase):
    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork here")
    def test_a_child_steps_although_another_thread_was_at_it(self):
        scene = lp.Scene(LEVEL)
        stepper = lp.Stepper("rk4", scene)
        tilt = lp.gravity_from_tilt(0.1, 0.05)
        params, after = stepper.params(gravity=tilt), stepper.step(scene.start(), stepper.params(gravity=tilt), 0.01).state
        with stepper._turns:  # as a run on another thread has it
            child = os.fork()
            if child == 0:
                signal.alarm(20)
                os._exit(0 if stepper.step(scene.start(), params, 0.01).state.tobytes() == after.tobytes() else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        stepper.step(scene.start(), params, 0.01)


    def test_a_signal_s_handler_is_told_that_the_stepper_is_at_it(self):
        scene = lp.Scene(LEVEL)
        stepper = lp.Stepper("rk4", scene)
        tilt = lp.gravity_from_tilt(0.1, 0.05)
        params, heard = stepper.params(gravity=tilt, rolling_friction=0.0, restitution_wall=1.0), []  # no ball rests

        def step(*_):
            with self.assertRaisesRegex(RuntimeError, "in the middle of a run of this stepper"):
                stepper.step(scene.start(), params, 0.01)
            heard.append(lp.Stepper("rk4", scene).step(scene.start(), params, 0.01).state["step"])
            raise InterruptedError

        self.addCleanup(signal.signal, signal.SIGVTALRM, signal.signal(signal.SIGVTALRM, step))
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.05)  # s of the processor, which only the run uses
        with self.assertRaises(InterruptedError):
            stepper.run(scene.start(16), params, 0.001, 1_000_000)
        self.assertEqual(heard, [1])
        stepper.step(scene.start(), params, 0.01)


class MessagesTest(unittest.TestCase):
    def refused(self, use):
        with self.assertRaises((lp.PhysicsError, TypeError, ValueError)) as caught:
            use()
        return str(caught.exception)

    def test_a_run_says_what_a_step_says(self):
        scene = lp.Scene(LEVEL)
        stepper = lp.Stepper("rk4", scene)
        gravity = np.tile([0.0, 0.0, -9.75], (3, 10, 1))
        gravity[1, 4] = (np.inf, 0, -9.75)
        run = stepper.run(scene.start(), stepper.params(), 0.01, 10, gravity=gravity)
        expected = "ball 1 fails in step 4: gravity_x is inf m/s^2; allowed is -1000000 .. 1000000 m/s^2"
        for one in (run, pickle.loads(pickle.dumps(run))):
            self.assertEqual(self.refused(one.check), expected)
        params = stepper.params(restitution_wall=[0.5, 0.5, 0.5])
        params.restitution_wall[2] = 7
        run = stepper.run(scene.start(), params, 0.01, 10)
        self.assertEqual(self.refused(run.check), "ball 2 fails in step 0: restitution_wall is 7; allowed is 0 .. 1")

    def test_missing_library_is_explained(self):
        environment = {**os.environ, "PHYSICS_LIBRARY": "/nowhere/libphysics.so"}
        out = subprocess.run([sys.executable, "-c", "import libphysics"], env=environment, capture_output=True, text=True)
        self.assertNotEqual(out.returncode, 0)
        self.assertIn("PHYSICS_LIBRARY", out.stderr)

    def test_arguments_without_a_line_of_the_library(self):
        scene = lp.Scene(LEVEL)
        for use, expected in ((lambda: lp.gravity_from_tilt([0, 5], 0),
                               "tilt_x is 5 rad; expected a number between -pi/2 and pi/2"),
                              (lambda: lp.gravity_from_tilt(0, np.nan), "tilt_y is nan rad; expected a number between"),
                              (lambda: lp.gravity_from_tilt(0, 0, [[-1]]), "strength is -1 m/s^2; expected a number from 0 to"),
                              (lambda: scene.contacts((0, 0, 0), np.inf), "reach is inf m; expected a finite number, 0 or more"),
                              (lambda: scene.contacts((0, 0, 0), -1), "reach is -1 m; expected"),
                              (lambda: scene.contacts((0, 1e31, 0)), r"a coordinate of centre is 1e+31 m; expected"),
                              (lambda: lp.Stepper("rk4", scene).step(scene.start().item(), lp.Params(), 0.01),
                               "expected state_dtype"),
                              (lambda: lp.Params(gravity=[[0, 0, -9], [0]]), "expected numbers"),
                              (lambda: lp.Params(model="rigid"), "model is 'rigid'; expected 0 (Rolling) or 1 (Rigid)"),
                              (lambda: setattr(lp.Params(), "model", None), "expected 0 (Rolling) or 1 (Rigid)"),
                              (lambda: lp.Stepper("rk4", scene).step(scene.start(), lp.Params(), "5 ms"),
                               "dt is '5 ms'; expected a number"),
                              (lambda: lp.Stepper("rk4", scene).params(nope=1), "no parameter is called 'nope'; known are"),
                              (lambda: scene.start(None), "shape is None; expected an integer"),
                              (lambda: scene.start(2.5), "shape is 2.5; expected an integer"),
                              (lambda: scene.start((3, -1)), "shape is -1; expected 0 .. "),
                              (lambda: lp.Stepper("rk4", scene).step(scene.start(), np.zeros((), lp.params_dtype), 0.01),
                               "expected those of Stepper.params()"),
                              (lambda: lp.Stepper("rk4", scene).run(scene.start(), lp.Params(), 0.01, 1, gravity=np.zeros((2, 3))),
                               "expected (3,), (..., 1, 3)")):
            self.assertIn(expected, self.refused(use))

    def test_a_mask_is_refused(self):
        scene = lp.Scene(LEVEL)
        stepper, masked = lp.Stepper("rk4", scene), np.ma.masked_array
        states, boxes = masked(scene.start(2), mask=True), masked([FLOOR], mask=True)
        for name, use in (("tilt_x", lambda: lp.gravity_from_tilt(masked([0.1, 0.2], mask=[1, 0]), 0)),
                          ("states", lambda: stepper.run(states, lp.Params(), 0.01, 1)),
                          ("gravity", lambda: stepper.params(gravity=masked([0, 0, -9.0], mask=[1, 0, 0]))),
                          ("boxes", lambda: lp.Scene(boxes=boxes))):
            self.assertIn(name + " is a masked array; expected ", self.refused(use))

    def test_the_other_order_of_bytes_says_how_to_turn_it(self):
        scene = lp.Scene(LEVEL)
        states = scene.start(2)
        states = states.astype(states.dtype.newbyteorder())
        said = self.refused(lambda: lp.Stepper("rk4", scene).run(states, lp.Params(), 0.01, 1))
        self.assertIn("states has the other order of bytes; expected state_dtype", said)
        turned = eval(said.partition("use ")[2])
        self.assertEqual(turned.tobytes(), scene.start(2).tobytes())
        lp.Stepper("rk4", scene).run(turned, lp.Params(), 0.01, 1).check()

    def test_a_write_without_effect_is_refused(self):
        scene, params = lp.Scene(LEVEL), lp.Params(orientation=[True, False], all_stages=False)
        for array in (scene.boxes, lp.Scene(boxes=[]).boxes, scene.bounds, params.orientation, params.all_stages):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[...] = 0

    def test_no_plugin_has_a_row_with_the_name_of_an_attribute(self):
        header = pathlib.Path(os.environ["SYMBOLS"]).parents[1] / "include/physics/plugin.h"
        listed = header.read_text().partition("#define PHYS_RESERVED_ROW_IDS")[2].partition("\n\n")[0]
        reserved = set(re.findall('"([a-z_]+)"', listed)) | {row["id"] for row in lp.Params.rows()}
        attributes = {name for name in dir(lp.Params()) if not name.startswith("_")}
        self.assertLessEqual(attributes, reserved)
        for name in ("self", "own_rows"):  # may be those of rows
            self.assertIn(f"no parameter is called '{name}'",
                          self.refused(lambda: lp.Stepper("rk4", lp.Scene(LEVEL)).params(**{name: 1})))

    def test_names_are_all_that_can_be_read_and_set(self):
        params = lp.Params()
        self.assertLessEqual({"gravity", "gravity_x", "gravity_z", "restitution_wall", "orientation"}, set(params.names()))
        for name in params.names():
            setattr(params, name, getattr(params, name))
            self.assertIn(name, dir(params))


class ErrorTextTest(unittest.TestCase):
    def setUp(self):
        self.scene = lp.Scene(LEVEL)
        self.stepper = lp.Stepper("exact", self.scene)

    def test_energy_names_the_number_that_has_none(self):
        for name in ("position", "velocity", "spin"):
            for number in (float("nan"), -1e300):
                state = self.scene.start()
                state[name][1] = number
                with self.assertRaisesRegex(lp.PhysicsError, f"component of {name} is {number:g}".replace("+", r"\+")):
                    self.stepper.energy(state, self.stepper.params())
        params = self.stepper.params()
        params.gravity[2] = float("inf")
        with self.assertRaisesRegex(lp.PhysicsError, "component of gravity is inf"):
            self.stepper.energy(self.scene.start(), params)

    def test_params_of_another_size_are_named_by_energy_too(self):
        params = self.stepper.params()
        params.record["struct_size"] = 5
        with self.assertRaisesRegex(ValueError, "struct_size is another"):
            self.stepper.energy(self.scene.start(), params)

    def test_values_of_another_shape_are_named(self):
        params = self.stepper.params()
        with self.assertRaisesRegex(ValueError, r"restitution_wall has the shape \(2,\); expected \(\)"):
            params.restitution_wall = [0.1, 0.2]
        with self.assertRaisesRegex(ValueError, r"gravity has the shape \(2, 3\); expected \(3,\)"):
            params.gravity = np.zeros((2, 3))

    def test_annotations_can_be_evaluated(self):
        for thing in (lp.Stepper.run, lp.Stepper.step, lp.Run, lp.Step, lp.Params.copy, lp.Scene.start, lp.gravity_from_tilt):
            self.assertTrue(typing.get_type_hints(thing))

    def test_results_beyond_all_memory_are_a_memory_error(self):
        states, params = self.scene.start(), self.stepper.params()
        for steps in (2**40, 2**57, 2**63, 2**64 - 1):
            with self.assertRaises(MemoryError):
                self.stepper.run(states, params, 0.01, steps, every=1)
        for shape in (2**57, (2**32, 2**32)):
            with self.assertRaises(MemoryError):
                self.scene.start(shape)
        with self.assertRaises(MemoryError):
            lp.gravity_from_tilt(np.broadcast_to(0.0, 2**59), 0.0)


class Room(lp.Scene):
    def __init__(self, size):
        super().__init__(boxes=[np.multiply(FLOOR, size)], radius=0.125)
        self.size = size


class Mine(lp.Stepper):
    def __init__(self, scene):
        super().__init__("rk4", scene)


class Mishap(lp.PhysicsError):
    def __init__(self):
        super().__init__(-3, "mishap")


class SubclassTest(unittest.TestCase):
    def test_classes_with_an_init_of_their_own_are_pickled(self):
        mine = pickle.loads(pickle.dumps(Mine(Room(2))))
        self.assertEqual((type(mine), mine.info.id, type(mine.scene), mine.scene.size), (Mine, "rk4", Room, 2))
        np.testing.assert_array_equal(mine.scene.boxes, [np.multiply(FLOOR, 2)])
        mishap = pickle.loads(pickle.dumps(Mishap()))
        self.assertEqual((type(mishap), mishap.status, str(mishap)), (Mishap, -3, "mishap"))

    def test_pickled_stepper_finds_its_plugin_from_another_folder(self):
        plugin = os.environ["PLUGIN"]
        folder, name = os.path.split(plugin)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder)
        pickled = pickle.dumps(lp.Stepper("adaptive-drag", lp.Scene(LEVEL), plugin="./" + name))
        os.chdir("/")
        self.assertTrue(os.path.samefile(pickle.loads(pickled).info.file, plugin))


if __name__ == "__main__":
    unittest.main()
