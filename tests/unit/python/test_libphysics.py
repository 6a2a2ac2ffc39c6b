# SPDX-License-Identifier: MIT
"""The Python package against the library it calls: each fact by single steps, closed forms or the C function itself."""
import copy
import gc
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import unittest
from fractions import Fraction

import numpy as np

import libphysics as lp

LEVEL = os.environ["LEVEL"]
PLUGIN = os.environ["PLUGIN"]

FLOOR = [(-2, -2, -1), (2, 2, 0)]
WALL = [(1, -2, 0), (1.25, 2, 1)]
MAZE = "physics-maze 1\nunits m\nball 0.125\nstart 0 0 0.125\nbox -2 -2 -1 2 2 0\nbox 1 -2 0 1.25 2 1\n"


def room():
    return lp.Scene(boxes=[FLOOR, WALL], radius=0.125)


class SceneTest(unittest.TestCase):
    def test_path_text_and_boxes_give_the_same_scene(self):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
            file.write(MAZE)
            file.flush()
            scenes = [lp.Scene(file.name), lp.Scene(text=MAZE), lp.Scene(text=MAZE.encode()), room()]
        for scene in scenes:
            self.assertEqual(scene.radius, 0.125)
            np.testing.assert_array_equal(scene.boxes, [FLOOR, WALL])
            np.testing.assert_array_equal(scene.start()["position"], [0, 0, 0.125])
            np.testing.assert_array_equal(scene.bounds, [(-2, -2, -1), (2, 2, 1)])

    def test_just_one_source_is_taken(self):
        for arguments in ({}, {"text": MAZE, "boxes": [FLOOR]}, {"text": MAZE, "radius": 1.0}):
            with self.assertRaises(TypeError):
                lp.Scene(**arguments)

    def test_failure_has_status_name_and_the_library_s_line(self):
        with self.assertRaises(lp.PhysicsError) as caught:
            lp.Scene(text=MAZE.replace("ball 0.125", "ball big"))
        self.assertEqual((caught.exception.status, caught.exception.name), (-6, "PHYS_ERROR_SYNTAX"))
        self.assertEqual(str(caught.exception), "text:3: ball: expected a number in m, found 'big'")

    def test_boxes_of_another_shape_are_refused(self):
        with self.assertRaises(ValueError):
            lp.Scene(boxes=np.zeros((3, 6)))

    def test_scene_without_boxes(self):
        scene = lp.Scene(boxes=[])
        self.assertEqual(scene.boxes.shape, (0, 2, 3))
        self.assertEqual(scene.contacts((0, 0, 0), 10.0).size, 0)

    def test_contacts_by_box(self):
        contacts = room().contacts((0.75, 0, 0.125), 0.25)
        self.assertEqual(contacts["box"].tolist(), [0, 1])
        self.assertEqual(contacts["gap"].tolist(), [0.0, 0.125])
        np.testing.assert_array_equal(contacts["normal"], [(0, 0, 1), (-1, 0, 0)])

    def test_start_of_many(self):
        states = room().start((2, 3))
        self.assertEqual((states.shape, states.dtype), ((2, 3), lp.state_dtype))
        self.assertTrue((states["orientation"] == [0, 0, 0, 1]).all())

    def test_planarity_is_explained(self):
        self.assertEqual(room().why_not_planar(), "")
        kerb = lp.Scene(boxes=[FLOOR, [(1, -2, 0), (2, 2, 0.0625)]], radius=0.125)
        self.assertIn("box 1 ends", kerb.why_not_planar())

    def test_hash_is_that_of_the_bytes(self):
        state = room().start()
        expected = 0xCBF29CE484222325
        for byte in state.tobytes():
            expected = (expected ^ byte) * 0x100000001B3 % 2**64
        self.assertEqual(lp.state_hash(state), expected)


class ParamsTest(unittest.TestCase):
    def test_defaults_are_the_rows_initial_values(self):
        params = lp.Params()
        for row in lp.Params.rows():
            if not row["id"].startswith("gravity"):
                self.assertEqual(getattr(params, row["id"]), row["initial"], row["id"])
        np.testing.assert_array_equal(params.gravity, [0, 0, -9.81])

    def test_unknown_names_are_refused(self):
        params = lp.Params()
        for error, use in ((AttributeError, lambda: params.restitution),
                           (AttributeError, lambda: setattr(params, "restitution", 0.5)),
                           (TypeError, lambda: lp.Params(restitution=0.5))):
            with self.assertRaisesRegex(error, "restitution_wall"):
                use()

    def test_values_outside_their_range_are_refused_and_nothing_changes(self):
        params = lp.Params()
        for name, value in (("restitution_wall", 1.5), ("restitution_wall", float("nan")), ("model", 2),
                            ("model", 0.5), ("gravity", (0, 0, 2e6)), ("rolling_friction", [0.1, -0.1])):
            with self.assertRaises(lp.PhysicsError) as caught:
                setattr(params, name, value)
            self.assertEqual(caught.exception.name, "PHYS_ERROR_RANGE")
        self.assertEqual(params.record.tobytes(), lp.Params().record.tobytes())

    def test_arrays_broadcast_to_one_shape(self):
        params = lp.Params(restitution_wall=np.linspace(0, 1, 5)[:, None], rolling_friction=[0.0, 0.01, 0.02])
        self.assertEqual(params.shape, (5, 3))
        self.assertEqual(params.restitution_wall[4, 0], 1.0)
        self.assertEqual(params.rolling_friction[0].tolist(), [0.0, 0.01, 0.02])

    def test_sets_of_no_length_are_sets(self):
        for shape in ((0,), (2, 0)):
            params = lp.Params(restitution_wall=np.zeros(shape), gravity=np.zeros(shape + (3,)), orientation=True)
            self.assertEqual((params.shape, params.restitution_wall.shape, params.copy().shape), (shape,) * 3)

    def test_switches_are_bits_of_the_options(self):
        params = lp.Params(orientation=True)
        self.assertEqual((int(params.record["options"]), bool(params.orientation)), (1, True))
        params.all_stages, params.orientation = True, False
        self.assertEqual(int(params.record["options"]), 2)

    def test_own_rows_belong_to_their_stepper(self):
        params = lp.Stepper("rk4", room()).params(as_reported=1)
        self.assertEqual(params.record["stepper"][0], 1.0)
        with self.assertRaises(TypeError):
            lp.Params(as_reported=1)

    def test_copy_is_independent(self):
        params = lp.Params()
        params.copy().restitution_wall = 0.25
        self.assertEqual(params.restitution_wall, 0.5)

    def test_gravity_from_tilt_broadcasts(self):
        gravity = lp.gravity_from_tilt([0.1, 0.2], 0.0, 9.81)
        self.assertEqual(gravity.shape, (2, 3))
        np.testing.assert_allclose(gravity[1], 9.81 * np.array([np.sin(0.2), 0, -np.cos(0.2)]), rtol=1e-15)
        with self.assertRaises(lp.PhysicsError):
            lp.gravity_from_tilt(2.0, 0.0)


class StepTest(unittest.TestCase):
    def test_rolling_down_is_the_closed_form(self):
        stepper = lp.Stepper("exact", room())
        params = stepper.params(rolling_friction=0, gravity=(0.7, 0, -9.8))
        after = stepper.step(room().start(), params, 1.0).state
        self.assertAlmostEqual(after["position"][0], 0.25, 14)  # 5/7 g t^2/2
        self.assertAlmostEqual(after["velocity"][0], 0.5, 14)

    def test_report_and_events_of_an_impact(self):
        stepper = lp.Stepper("swept", room())
        state = room().start()
        state["velocity"], state["spin"] = (1, 0, 0), (0, 8, 0)
        step = stepper.step(state, stepper.params(rolling_friction=0), 1.0)
        self.assertEqual(step.events["kind"].tolist(), [lp.EVENT_IMPACT])
        self.assertEqual(step.events["box"].tolist(), [1])
        self.assertAlmostEqual(step.events["time"][0], 0.875, 12)
        self.assertAlmostEqual(step.events["speed_after"][0], 0.5, 12)
        self.assertGreater(step.report["lost_impact"], 0)
        self.assertEqual(state["time"], 0)  # the given state stays

    def test_events_without_room_are_counted(self):
        stepper = lp.Stepper("swept", room())
        state = room().start()
        state["velocity"], state["spin"] = (1, 0, 0), (0, 8, 0)
        step = stepper.step(state, stepper.params(rolling_friction=0), 1.0, events=0)
        self.assertEqual((step.events.size, step.report["events_lost"]), (0, 1))

    def test_failure_names_the_value(self):
        stepper = lp.Stepper("rk4", room())
        with self.assertRaisesRegex(lp.PhysicsError, "dt is -1 s"):
            stepper.step(room().start(), stepper.params(), -1.0)
        with self.assertRaisesRegex(lp.PhysicsError, "known are"):
            lp.Stepper("rk5", room())

    def test_wrong_types_are_refused(self):
        stepper = lp.Stepper("rk4", room())
        for state, params in ((np.zeros(16), stepper.params()), (room().start(2), stepper.params()),
                              (room().start(), {"restitution_wall": 1}), (room().start(), np.zeros(144, "u1"))):
            with self.assertRaises(TypeError):
                stepper.step(state, params, 0.01)

    def test_energy_and_requirements(self):
        stepper = lp.Stepper("rk4", room())
        self.assertAlmostEqual(stepper.energy(room().start(), stepper.params()), 9.81 * 0.125, 12)
        told = stepper.requirements(room().start(), stepper.params(), 0.01)
        self.assertFalse(told["vertical motion"][0])
        self.assertTrue(all(reason for _, reason in told.values()))

    def test_shapes_that_do_not_broadcast_are_named(self):
        scene = room()
        stepper = lp.Stepper("rk4", scene)
        with self.assertRaisesRegex(ValueError, r"states \(3,\), gravity \(2,\)$"):
            stepper.run(scene.start(3), stepper.params(), 0.01, 4, gravity=np.zeros((2, 1, 3)))
        with self.assertRaisesRegex(ValueError, r"tilt_x \(3,\), tilt_y \(2,\)$"):
            lp.gravity_from_tilt([0, 0, 0], [0, 0])
        with self.assertRaisesRegex(ValueError, r"restitution_wall \(3,\), gravity \(2,\)$"):
            stepper.params(restitution_wall=[0, 0, 0], gravity=np.zeros((2, 3)))

    def test_every_repr_is_one_line(self):
        scene = room()
        stepper = lp.Stepper("rk4", scene)
        step = stepper.step(scene.start(), stepper.params(), 0.01)
        run = stepper.run(scene.start(3), stepper.params(), 0.01, 9, every=3)
        for thing in (scene, stepper, stepper.params(), stepper.params(model=[0, 1]), lp.Registry(), step, run):
            self.assertNotIn("\n", repr(thing))


class RunTest(unittest.TestCase):
    def setUp(self):
        self.scene = lp.Scene(LEVEL)
        self.stepper = lp.Stepper("symplectic-euler", self.scene)

    def one_by_one(self, state, params, dt, gravities):
        path = []
        for gravity in gravities:
            params.gravity = gravity
            state = self.stepper.step(state, params, dt).state
            path.append(state)
        return np.array(path, lp.state_dtype)

    def test_same_bits_as_single_steps(self):
        random = np.random.default_rng(5)
        gravity = lp.gravity_from_tilt(*random.uniform(-0.1, 0.1, (2, 3, 40)))
        params = self.stepper.params(restitution_wall=[0.2, 0.5, 0.9])
        run = self.stepper.run(self.scene.start(), params, 0.01, 40, gravity=gravity, every=4).check()
        self.assertEqual((run.states.shape, run.path.shape), ((3,), (3, 10)))
        for ball in range(3):
            single = self.stepper.params(restitution_wall=params.restitution_wall[ball])
            expected = self.one_by_one(self.scene.start(), single, 0.01, gravity[ball])
            self.assertEqual(run.path[ball].tobytes(), expected[3::4].tobytes())
            self.assertEqual(run.states[ball].tobytes(), expected[-1].tobytes())

    def test_tally_is_what_the_reports_of_single_steps_say(self):
        gravity = lp.gravity_from_tilt(np.linspace(-0.1, 0.1, 5), 0.05)[:, None]
        run = self.stepper.run(self.scene.start(), self.stepper.params(), 0.01, 200, gravity=gravity, threads=2,
                               tally=True).check()
        self.assertEqual((run.impacts.dtype, run.energy_lost.dtype), ("u8", "f8"))
        for ball in range(5):
            state, params = self.scene.start(), self.stepper.params(gravity=gravity[ball, 0])
            impacts, lost = 0, 0.0
            for _ in range(200):
                state, report, events = self.stepper.step(state, params, 0.01)
                impacts += np.count_nonzero(events["kind"] == lp.EVENT_IMPACT)
                lost += report["lost_impact"] + report["lost_rolling"] + report["lost_slip"]
            self.assertEqual((run.impacts[ball], run.energy_lost[ball]), (impacts, lost))
        self.assertGreater(run.impacts.min(), 0)

    def test_landings_lose_energy_but_are_no_impacts(self):
        scene = lp.Scene(boxes=[FLOOR], radius=0.125, start=(0, 0, 0.5))
        stepper = lp.Stepper("swept", scene)
        run = stepper.run(scene.start(), stepper.params(restitution_floor=0.5), 0.01, 100, tally=True)
        self.assertEqual(run.impacts, 0)
        self.assertGreater(run.energy_lost, 1)

    def test_tally_has_the_shape_of_the_batch_and_is_made_when_asked_for(self):
        states, params = self.scene.start((2, 3)), self.stepper.params()
        run = self.stepper.run(states, params, 0.01, 5, tally=True)
        self.assertEqual((run.impacts.shape, run.energy_lost.shape), ((2, 3), (2, 3)))
        run = self.stepper.run(states, params, 0.01, 5)
        self.assertIsNone(run.impacts)
        self.assertIsNone(run.energy_lost)

    def test_batch_has_the_shape_that_numpy_would_give(self):
        params = self.stepper.params(restitution_wall=np.linspace(0, 1, 4)[:, None])
        gravity = lp.gravity_from_tilt(np.linspace(0, 0.1, 3), 0.0)[:, None]
        run = self.stepper.run(self.scene.start((2, 1, 1)), params, 0.01, 5, gravity=gravity)
        self.assertEqual(run.states.shape, (2, 4, 3))
        one = self.stepper.run(self.scene.start(), self.stepper.params(restitution_wall=params.restitution_wall[2, 0]),
                               0.01, 5, gravity=gravity[1, 0])
        self.assertEqual(run.states[1, 2, 1].tobytes(), one.states.tobytes())
        with self.assertRaises(ValueError):
            self.stepper.run(self.scene.start(5), params, 0.01, 5, gravity=gravity)

    def test_given_states_stay_unless_they_are_the_output(self):
        states = self.scene.start(4)
        before = states.tobytes()
        gravity = (1.0, 0.0, -9.75)
        run = self.stepper.run(states, self.stepper.params(), 0.01, 7, gravity=gravity)
        self.assertEqual(states.tobytes(), before)
        self.stepper.run(states, self.stepper.params(), 0.01, 7, gravity=gravity, out=states)
        self.assertEqual(states.tobytes(), run.states.tobytes())

    def test_threads_change_nothing(self):
        gravity = lp.gravity_from_tilt(np.linspace(-0.1, 0.1, 37), 0.05)[:, None]
        runs = [self.stepper.run(self.scene.start(), self.stepper.params(), 0.01, 200, gravity=gravity, threads=threads,
                                 every=50) for threads in (1, 2, 5, 100)]
        for run in runs[1:]:
            self.assertEqual(run.states.tobytes(), runs[0].states.tobytes())
            self.assertEqual(run.path.tobytes(), runs[0].path.tobytes())

    def test_other_python_threads_run_meanwhile(self):
        ticks, over = [0], threading.Event()

        def count():
            while not over.is_set():
                ticks[0] += 1

        counter = threading.Thread(target=count)
        counter.start()
        before = ticks[0]
        params = self.stepper.params(restitution_wall=1.0, rolling_friction=0.0)  # no ball rests
        self.stepper.run(self.scene.start(200), params, 0.01, 2000, gravity=(1, 0.5, -9.75), tally=True)
        after = ticks[0]
        over.set()
        counter.join()
        self.assertGreater(after, before)

    def test_stop_flags_end_a_ball(self):
        scene = lp.Scene(boxes=[FLOOR], radius=0.125)
        stepper = lp.Stepper("swept", scene)
        run = stepper.run(scene.start(2), stepper.params(), 0.01, 1000, gravity=[[(2, 0, -9.75)], [(0, 0, -9.75)]],
                          stop=lp.OUT, every=100)
        self.assertLess(run.steps_done[0], 1000)
        self.assertEqual(run.steps_done[1], 1000)
        self.assertTrue(run.states["flags"][0] & lp.OUT)
        self.assertEqual(run.path[0, -1].tobytes(), run.states[0].tobytes())

    def test_failing_ball_has_its_status_and_the_others_go_on(self):
        gravity = np.tile([0.0, 0.0, -9.75], (3, 10, 1))
        gravity[1, 4] = (0, 0, 1)  # pulled off its floor
        run = self.stepper.run(self.scene.start(), self.stepper.params(), 0.01, 10, gravity=gravity)
        self.assertEqual(run.statuses.tolist(), [0, -2, 0])
        self.assertEqual(run.steps_done.tolist(), [10, 4, 10])
        with self.assertRaisesRegex(lp.PhysicsError, "ball 1 fails in step 4"):
            run.check()

    def test_wrong_arguments_raise(self):
        states, params = self.scene.start(2), self.stepper.params()
        wrong = [(ValueError, {"steps": -1}), (ValueError, {"gravity": np.zeros((2, 4, 3))}), (ValueError, {"every": -1}),
                 (lp.PhysicsError, {"dt": -1.0}), (lp.PhysicsError, {"stop": 64}),
                 (ValueError, {"out": np.zeros(3, lp.state_dtype)}), (ValueError, {"threads": -1})]
        for error, change in wrong:
            arguments = {"dt": 0.01, "steps": 5, **change}
            with self.assertRaises(error):
                self.stepper.run(states, params, **arguments)
        with self.assertRaises(TypeError):
            self.stepper.run(np.zeros(2), params, 0.01, 5)

    def test_no_balls_and_no_steps(self):
        self.assertEqual(self.stepper.run(self.scene.start(0), self.stepper.params(), 0.01, 5).states.shape, (0,))
        run = self.stepper.run(self.scene.start(2), self.stepper.params(), 0.01, 0, gravity=np.zeros((2, 0, 3)))
        self.assertEqual(run.steps_done.tolist(), [0, 0])


class RegistryTest(unittest.TestCase):
    def test_built_in_steppers_from_crude_to_exact(self):
        ids = [info.id for info in lp.steppers()]
        self.assertEqual((ids[0], ids[-1]), ("explicit-euler", "exact"))

    def test_plugin_runs_with_its_own_rows(self):
        scene = lp.Scene(LEVEL)
        stepper = lp.Stepper("adaptive-drag", scene, plugin=PLUGIN)
        self.assertEqual(stepper.info.file, PLUGIN)
        params = stepper.params(air_drag=0.25)
        single = stepper.step(scene.start(), params, 0.01).state
        self.assertEqual(stepper.run(scene.start(), params, 0.01, 1).states.tobytes(), single.tobytes())

    def test_scan_tells_what_it_refuses(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "no.so"), "w", encoding="utf-8") as file:
                file.write("no shared object")
            script = "import libphysics as lp; print(lp.Registry(scan=True).refused)"
            environment = {**os.environ, "PHYS_PLUGIN_PATH": folder}
            out = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
        self.assertIn("no.so", out.stdout)


class CopyTest(unittest.TestCase):
    """Copies outlive what they were made from: the library's objects are freed once, after the last of them."""

    def copies(self, thing):
        return copy.copy(thing), copy.deepcopy(thing)

    def test_copies_of_a_scene_outlive_it(self):
        scene = lp.Scene(boxes=[FLOOR, WALL], radius=0.125, start=(0.5, 0.25, 0.125))
        others = [*self.copies(scene), pickle.loads(pickle.dumps(scene))]
        del scene
        for other in others:
            self.assertEqual(other.radius, 0.125)
            np.testing.assert_array_equal(other.boxes, [FLOOR, WALL])
            np.testing.assert_array_equal(other.start()["position"], [0.5, 0.25, 0.125])

    def test_copies_of_a_stepper_make_its_steps(self):
        stepper = lp.Stepper("adaptive-drag", room(), plugin=PLUGIN)
        params = stepper.params(air_drag=0.25, gravity=(1, 0, -9))
        expected = stepper.step(room().start(), params, 0.25).state.tobytes()
        others = [*self.copies(stepper), pickle.loads(pickle.dumps(stepper))]
        del stepper
        for other in others:
            self.assertEqual(other.step(room().start(), params, 0.25).state.tobytes(), expected)

    def test_registry_is_shared_but_stays_in_its_process(self):
        registry = lp.Registry(PLUGIN)
        others = self.copies(registry)
        del registry
        for other in others:
            self.assertEqual(lp.Stepper("adaptive-drag", room(), plugin=other).info.file, PLUGIN)
        with self.assertRaisesRegex(TypeError, "Registry can't be pickled"):
            pickle.dumps(others[0])

    def test_copies_of_params_are_independent_and_know_their_names(self):
        params = lp.Stepper("rk4", room()).params(as_reported=1, restitution_wall=[0.25, 0.75])
        for other in (*self.copies(params), pickle.loads(pickle.dumps(params))):
            self.assertEqual(other, params)
            other.as_reported = other.restitution_wall = 0
            self.assertEqual(params.as_reported.tolist(), [1, 1])
            with self.assertRaisesRegex(lp.PhysicsError, "as_reported is 2"):
                other.as_reported = 2

    def test_an_error_reaches_another_process(self):
        with self.assertRaises(lp.PhysicsError) as caught:
            lp.gravity_from_tilt(2, 0)
        for other in (*self.copies(caught.exception), pickle.loads(pickle.dumps(caught.exception))):
            self.assertEqual((other.status, other.name, str(other)), (-1, "PHYS_ERROR_ARGUMENT", str(caught.exception)))

    def test_a_stepper_outlives_what_its_scene_was(self):
        scene = room()
        stepper = lp.Stepper("exact", scene)
        expected = stepper.step(scene.start(), stepper.params(), 0.25).state.tobytes()
        scene.__init__(boxes=[FLOOR], radius=0.5)
        self.assertEqual(stepper.step(room().start(), stepper.params(), 0.25).state.tobytes(), expected)

    def test_steppers_are_freed_before_scenes_even_in_a_cycle(self):
        from libphysics import _library
        freed = []

        class Circle:
            pass

        def create(*arguments):
            arguments[-2]._obj.value = len(arguments)  # a pointer that is never followed
            return 0

        circle = Circle()
        circle.scene = _library.Handle(create, lambda pointer: freed.append("scene"))
        circle.stepper = _library.Handle(create, lambda pointer: freed.append("stepper"), circle.scene)
        circle.itself = circle
        del circle
        gc.collect()
        self.assertEqual(freed, ["stepper", "scene"])


class ArgumentTest(unittest.TestCase):
    """What crosses into C: each wrong one is refused by what was expected and found, and nothing is written."""

    def setUp(self):
        self.scene = room()
        self.stepper = lp.Stepper("swept", self.scene)
        self.params = self.stepper.params()

    def run_with(self, **change):
        arguments = {"states": self.scene.start(2), "params": self.params, "dt": 0.25, "steps": 3, **change}
        return self.stepper.run(**arguments)

    def test_integers_stay_within_those_of_c(self):
        uses = {"steps": (lambda n: self.run_with(steps=n), 2**64), "every": (lambda n: self.run_with(every=n), 2**64),
                "stop": (lambda n: self.run_with(stop=n), 2**32), "threads": (lambda n: self.run_with(threads=n), 1025),
                "events": (lambda n: self.stepper.step(self.scene.start(), self.params, 0.25, events=n), 2**32)}
        for name, (use, beyond) in uses.items():
            for value in (-1, beyond, beyond + 3, 2**64 + 3, 2**70):
                with self.assertRaisesRegex(ValueError, f"^{name} is {value}; expected . .. ", msg=f"{name}={value}"):
                    use(value)
            for value in (2.0, "2", None, np.float64(2), [1, 2]):
                with self.assertRaisesRegex(TypeError, f"^{name} is .*; expected an integer", msg=f"{name}={value!r}"):
                    use(value)
            for value in (1, np.int64(1), np.uint8(1), np.array(1)):
                use(value)

    def test_numbers_are_numbers(self):
        state = self.scene.start()
        uses = {"dt": lambda x: self.stepper.step(state, self.params, x),
                "dt of run": lambda x: self.run_with(dt=x),
                "dt of requirements": lambda x: self.stepper.requirements(state, self.params, x),
                "reach": lambda x: self.scene.contacts((0, 0, 0), x),
                "radius": lambda x: lp.Scene(boxes=[FLOOR], radius=x, start=(0, 0, 1)),
                "tilt_x": lambda x: lp.gravity_from_tilt(x, 0.0),
                "restitution_wall": lambda x: self.stepper.params(restitution_wall=x)}
        for name, use in uses.items():
            for value in ("0.25", b"1", 1j, np.array(1j), object(), 10**400, np.zeros((), lp.state_dtype)):
                with self.assertRaisesRegex(TypeError, "; expected (a number|numbers)$", msg=f"{name}={value!r}"):
                    use(value)
            for value in (0.25, 1, True, np.float32(0.25), np.array(0.25), Fraction(1, 4), np.array([0.25], ">f8")[0]):
                use(value)
        for name in ("dt", "dt of run", "reach", "radius"):
            with self.assertRaises(TypeError, msg=name):
                uses[name]([0.25, 0.25])
        for name in ("dt", "dt of run", "dt of requirements", "reach", "tilt_x", "restitution_wall"):
            with self.assertRaises(TypeError, msg=name):
                uses[name](None)

    def test_vectors_have_their_shape(self):
        for wrong in ((0, 0), (0, 0, 1, 2), [[0, 0, 1]], 1.0):
            for use in (lambda: self.scene.contacts(wrong), lambda: lp.Scene(boxes=[FLOOR], start=wrong)):
                with self.assertRaisesRegex(ValueError, r"has the shape .*; expected \(3,\)"):
                    use()
        for wrong in (1.0, (1, 2), (1, 2, 3, 4), [[1]]):
            with self.assertRaisesRegex(ValueError, "gravity has the shape"):
                self.params.gravity = wrong
        for wrong in (np.zeros((2, 3)), np.zeros((0, 5)), np.zeros((5, 0)), 1.0):
            with self.assertRaisesRegex(ValueError, "boxes has the shape"):
                lp.Scene(boxes=wrong)

    def test_texts_are_texts_to_their_end(self):
        for use in (lambda: lp.Stepper("rk4\0", self.scene), lambda: lp.Scene(LEVEL + "\0.txt"), lambda: lp.Registry("a\0b"),
                    lambda: lp.Scene(os.fsencode(LEVEL) + b"\0")):
            with self.assertRaisesRegex(ValueError, "without NUL"):
                use()
        for use in (lambda: lp.Stepper(b"rk4", self.scene), lambda: lp.Stepper(None, self.scene), lambda: lp.Scene(5),
                    lambda: lp.Scene(text=5), lambda: lp.Registry(None), lambda: lp.Stepper("rk4", "01.txt"),
                    lambda: lp.Stepper("rk4", self.scene, plugin=5)):
            with self.assertRaisesRegex(TypeError, "; expected"):
                use()

    def test_switches_are_true_or_false(self):
        for value in (2, float("nan"), -1):
            with self.assertRaises(ValueError):
                self.params.orientation = value
        with self.assertRaises(TypeError):
            self.params.orientation = "no"
        self.assertFalse(self.params.orientation)

    def test_records_of_any_layout_are_read(self):
        states = self.scene.start(3)
        states["velocity"][:, 0] = (0.25, 0.5, 0.75)
        expected = self.run_with(states=states).states.tobytes()
        memory = np.zeros(3 * 128 + 1, "u1")
        odd = memory[1:].view(lp.state_dtype)
        odd[...] = states
        fixed = states.copy()
        fixed.flags.writeable = False
        for given in (odd, fixed, np.repeat(states, 2)[::2], states[::-1].copy()[::-1]):
            self.assertEqual(self.run_with(states=given).states.tobytes(), expected)
            self.assertEqual(self.stepper.step(given[1], self.params, 0.25).state.tobytes(),
                             self.stepper.step(states[1], self.params, 0.25).state.tobytes())
            self.assertEqual(lp.state_hash(given[1:2]), lp.state_hash(states[1]))
        boxes = np.frombuffer(b" " + np.array([FLOOR, WALL], "f8").tobytes(), "f8", offset=1).reshape(2, 2, 3)
        np.testing.assert_array_equal(lp.Scene(boxes=boxes).boxes, [FLOOR, WALL])

    def test_what_isn_t_a_state_is_refused(self):
        swapped = self.scene.start().astype(lp.state_dtype.newbyteorder())
        for wrong in (np.zeros(16), None, 1.0, swapped, self.params.record):
            for use in (lambda: self.run_with(states=wrong), lambda: lp.state_hash(wrong),
                        lambda: self.stepper.step(wrong, self.params, 0.25), lambda: self.stepper.energy(wrong, self.params)):
                with self.assertRaisesRegex(TypeError, "expected state_dtype"):
                    use()
        for wrong in ({"restitution_wall": 1}, None, self.scene.start()):
            with self.assertRaisesRegex(TypeError, "expected params_dtype"):
                self.run_with(params=wrong)

    def test_outputs_stay_as_they_were_if_an_argument_is_wrong(self):
        out = np.full(2, 7, lp.state_dtype)
        before = out.tobytes()
        shared = self.params.copy()
        shared.record["restitution_wall"] = 7
        for wrong in ({"dt": -1.0}, {"dt": float("nan")}, {"stop": 64}, {"params": shared}, {"steps": 2**64}, {"threads": 0},
                      {"every": -1}, {"gravity": np.zeros((2, 2, 3))}):
            with self.assertRaises((ValueError, lp.PhysicsError), msg=str(wrong)):
                self.run_with(out=out, **wrong)
            self.assertEqual(out.tobytes(), before, str(wrong))

    def test_outputs_that_c_cannot_write_are_refused(self):
        fixed = self.scene.start(2)
        fixed.flags.writeable = False
        odd = np.zeros(2 * 128 + 1, "u1")[1:].view(lp.state_dtype)
        for out in (fixed, odd, self.scene.start(4)[::2], self.scene.start(3)):
            with self.assertRaisesRegex(ValueError, "^out "):
                self.run_with(out=out)
        for out in ([1, 2], np.zeros((2, 16))):
            with self.assertRaisesRegex(TypeError, "^out "):
                self.run_with(out=out)

    def test_arguments_are_checked_without_balls_too(self):
        with self.assertRaises(lp.PhysicsError):
            self.run_with(states=self.scene.start(0), dt=-1.0)


class PackageTest(unittest.TestCase):
    def test_every_function_of_the_library_is_declared(self):
        from libphysics import _library
        with open(os.environ["SYMBOLS"], encoding="utf-8") as file:
            self.assertEqual(set(file.read().split()), set(_library._FUNCTIONS))

    def test_all_that_is_public_has_a_docstring(self):
        for name in lp.__all__:
            thing = getattr(lp, name)
            if callable(thing):
                self.assertTrue(thing.__doc__, name)


if __name__ == "__main__":
    unittest.main()
