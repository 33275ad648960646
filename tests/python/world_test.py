"""Worlds, bodies, joints, forces, sensors and queries from Python."""

import copy
import math
import os
import pathlib
import pickle
import re
import signal
import threading
import time
import unittest

import numpy as np

import sudar


def falling_ball(**config):
    world = sudar.World(**config)
    world.add(sudar.Gravity())
    world.add(shape=sudar.half_space(), motion="fixed", name="ground")
    ball = world.add(shape=sudar.sphere(0.5), at=(0, 4, 0), material={"restitution": 0.5}, name="ball")
    return world, ball


class Definitions(unittest.TestCase):
    def test_take_their_fields_by_name(self):
        d = sudar.BodyDef(at=[1, 2, 3], motion="kinematic", center=(0, 1, 0))
        np.testing.assert_array_equal(d.at, [1, 2, 3])
        self.assertEqual(d.at.dtype, np.float64)
        self.assertEqual(d.motion, "kinematic")
        np.testing.assert_array_equal(d.center, [0, 1, 0])
        self.assertIsNone(d.inertia)
        np.testing.assert_array_equal(d.turn, [0, 0, 0, 1])

    def test_inner_fields_can_be_changed_where_they_are(self):
        d = sudar.BodyDef(material={"restitution": 0.25})
        d.material.restitution = 0.75
        self.assertEqual(d.material.restitution, 0.75)
        self.assertEqual(d.material.friction_static, sudar.Material().friction_static)

    def test_a_vector_that_was_read_cannot_be_changed_in_vain(self):
        with self.assertRaises(ValueError):
            sudar.BodyDef().at[1] = 5

    def test_compare_field_by_field(self):
        self.assertEqual(sudar.Config(dt=0.01), sudar.Config(dt=0.01))
        self.assertNotEqual(sudar.Config(), sudar.Config(soft_step={"lanes": 4}))
        self.assertEqual(sudar.Config().replace(workers=2).workers, 2)

    def test_show_what_is_not_usual(self):
        self.assertEqual(repr(sudar.Material(rolling=0.5)), "Material(rolling=0.5)")
        self.assertEqual(repr(sudar.Drive(mode="speed", target=2)), "Drive(mode='speed', target=2.0)")

    def test_name_the_field_that_is_wrong(self):
        for make, field in (
            (lambda: sudar.BodyDef(at="high"), "at"),
            (lambda: sudar.BodyDef(at=(1, 2)), "at"),
            (lambda: sudar.BodyDef(material={"restitution": "much"}), "material.restitution"),
            (lambda: sudar.BodyDef(motion="flying"), "motion"),
            (lambda: sudar.BodyDef(sleeps="no"), "sleeps"),
            (lambda: sudar.Hinge(a=3), "hinge.a"),
            (lambda: sudar.Config(substeps=1.5), "substeps"),
            (lambda: setattr(sudar.Config(), "dt", None), "dt"),
            (lambda: sudar.World(dt=-1), "dt"),
            (lambda: sudar.World(soft_step={"lanes": 99}), "soft_step.lanes"),
            (lambda: sudar.World().step(-1), "steps"),
            (lambda: sudar.World().add(shape=None), "shape"),
            (lambda: setattr(sudar.World(), "config", {"soft_step": {"lanes": "many"}}), "soft_step.lanes"),
            (lambda: sudar.sphere(-1), "radius"),
            (lambda: sudar.World().add(shape=sudar.sphere(1), material={"restitution": 2}), "material.restitution"),
            (lambda: sudar.World().add(at=(0, 0, 0)), "shape"),
        ):
            with self.subTest(field=field), self.assertRaises(sudar.Error) as caught:
                make()
            self.assertEqual(caught.exception.field, field)
            self.assertIsInstance(caught.exception, ValueError)

    def test_name_a_field_that_does_not_exist(self):
        with self.assertRaisesRegex(TypeError, "material.colour: is no field of Material, which has .*restitution"):
            sudar.BodyDef(material={"colour": "red"})

    def test_every_field_of_the_header_is_here(self):
        """What the header declares between the braces of each definition, read by eyes other than describe()."""
        header = pathlib.Path(os.environ["SUDAR_SOURCE"], "include/sudar/definitions.h").read_text()
        for name in ("BodyDef", "Material", "Config", "Hinge", "SoftStep", "Sensor"):
            body = re.search(rf"struct {name} {{.*?\n(.*?)\n}};", header, re.S)[1]
            body = re.sub(r"//.*", "", body)
            declared = set(re.findall(r"(\w+)(?:\{[^}]*\}|\s*=[^,;]*)?(?=[,;])", re.sub(r"<[^>]*>|\([^)]*\)", "", body)))
            self.assertEqual(declared, {f[0] for f in getattr(sudar, name)._fields}, name)
        self.assertIn("kg/m³", sudar.BodyDef.density.__doc__)


class Worlds(unittest.TestCase):
    def test_a_ball_falls_as_galileo_says(self):
        world = sudar.World(dt=1 / 256, substeps=1)
        world.add(sudar.Gravity())
        ball = world.add(shape=sudar.sphere(0.5), at=(0, 100, 0))
        world.step(256)
        self.assertEqual(world.time, 1)
        self.assertAlmostEqual(ball.velocity[1], -9.81, places=4)
        self.assertAlmostEqual(ball.position[1], 100 - 9.81 / 2 * (1 + 1 / 256), places=4)

    def test_handles(self):
        world, ball = falling_ball()
        self.assertEqual([b.name for b in world.bodies], ["ground", "ball"])
        self.assertEqual(world["ball"], ball)
        self.assertEqual(len({ball, world["ball"], world["ground"]}), 2)
        with self.assertRaises(KeyError):
            world["nobody"]
        ball.remove()
        self.assertFalse(ball.alive)
        with self.assertRaisesRegex(sudar.Error, "dead"):
            ball.position
        with self.assertRaisesRegex(sudar.Error, "another world"):
            sudar.World()[world["ground"]]

    def test_a_handle_keeps_its_world_alive(self):
        ball = falling_ball()[1]
        np.testing.assert_array_equal(ball.position, [0, 4, 0])

    def test_what_may_be_set(self):
        world, ball = falling_ball()
        ball.position = np.array([1, 5, 2])
        ball.orientation = (0, math.sqrt(0.5), 0, math.sqrt(0.5))
        ball.velocity, ball.spin = [1, 0, 0], [0, 2, 0]
        np.testing.assert_allclose(ball.position, [1, 5, 2])
        np.testing.assert_allclose(ball.orientation, [0, 0.70710678, 0, 0.70710678], rtol=1e-6)
        np.testing.assert_array_equal(ball.velocity, [1, 0, 0])
        np.testing.assert_array_equal(ball.spin, [0, 2, 0])
        ball.push((ball.mass * 60, 0, 0))
        world.step()
        self.assertAlmostEqual(ball.velocity[0], 2, places=4)

    def test_a_body_of_several_shapes(self):
        world = sudar.World()
        parts = [{"shape": sudar.sphere(0.5), "at": (1, 0, 0)}, sudar.ShapeDef(shape=sudar.box((1, 1, 1)), at=(-1, 0, 0), density=500)]
        dumbbell = world.add(shapes=parts, at=(0, 2, 0))
        ball, cube = dumbbell.shapes
        self.assertEqual((ball.shape.kind, cube.shape, cube.density), ("sphere", sudar.box((1, 1, 1)), 500))
        self.assertAlmostEqual(dumbbell.mass, 1000 * math.pi / 6 + 500, delta=0.1)
        np.testing.assert_allclose(cube.position, [-1, 2, 0], atol=1e-6)
        np.testing.assert_allclose(cube.at, [-1, 0, 0], atol=1e-6)
        self.assertEqual(ball.body, dumbbell)
        self.assertEqual(world.ray_cast((1, 10, 0), (0, -1, 0)).shape, ball)
        third = dumbbell.add_shape(shape=sudar.sphere(0.25), at=(0, 1, 0), material={"restitution": 0.5})
        self.assertEqual((third.material.restitution, dumbbell.shapes), (0.5, [ball, cube, third]))
        third.remove()
        self.assertFalse(third.alive)
        with self.assertRaises(sudar.Error) as caught:
            world.add(shapes=[{"shape": sudar.sphere(1), "material": {"restitution": "much"}}])
        self.assertEqual(caught.exception.field, "shapes[0].material.restitution")

    def test_joints(self):
        world = sudar.World()
        world.add(sudar.Gravity())
        bob = world.add(shape=sudar.sphere(0.1), at=(1, 0, 0))
        hinge = world.join(sudar.Hinge(b=bob, at=(0, 0, 0), drive={"mode": "servo", "target": 0.5, "force": 1e4}))
        self.assertIsNone(hinge.a)
        self.assertEqual(hinge.b, bob)
        self.assertEqual(hinge.definition.b, bob)
        world.step(300)
        self.assertAlmostEqual(hinge.coordinate, 0.5, places=3)
        self.assertAlmostEqual(hinge.load.force[1], 9.81 * bob.mass, delta=0.01 * bob.mass)
        drive = hinge.drive
        drive.target = 0.25
        hinge.drive = drive
        world.step(300)
        self.assertAlmostEqual(hinge.coordinate, 0.25, places=3)
        hinge.drive = {"mode": "servo", "target": -0.5, "force": 1e4}
        world.step(300)
        self.assertAlmostEqual(hinge.coordinate, -0.5, places=3)
        with self.assertRaises(sudar.Error) as caught:
            world.join(sudar.Hinge(a=bob, b=bob))
        self.assertEqual(caught.exception.field, "hinge.b")

    def test_forces_and_sensors(self):
        world, ball = falling_ball()
        sensor = world.add(sudar.Sensor(kind="distance", a=ball, b=world["ground"], name="height"))
        gravity = world.forces[0]
        self.assertAlmostEqual(gravity.definition.acceleration[1], -9.81, places=5)
        world.step()
        self.assertAlmostEqual(sensor.value, ball.position[1], places=5)
        gravity.remove()
        self.assertEqual(world.forces, [])
        with self.assertRaises(TypeError):
            world.add(3)
        with self.assertRaises(TypeError):
            world.add(sudar.Gravity(), at=(0, 0, 0))

    def test_events_and_contacts(self):
        world, ball = falling_ball()
        begun, hits = [], []
        while world.time < 1:
            world.step()
            begun += world.events.begun
            hits += world.events.hits
        self.assertEqual({begun[0].a, begun[0].b}, {ball, world["ground"]})
        self.assertAlmostEqual(hits[0].speed, math.sqrt(2 * 9.81 * 3.5), delta=0.2)
        world.step(600)
        contact, = world.contacts
        self.assertTrue(ball.touches(world["ground"]))
        self.assertAlmostEqual(abs(contact.normal[1]), 1)
        self.assertLess(contact.points[0].separation, 0.01)
        self.assertEqual(world.pair_material(ball, world["ground"]).restitution, 0.5)

    def test_queries(self):
        world, ball = falling_ball()
        hit = world.ray_cast((0, 10, 0), (0, -1, 0))
        self.assertEqual(hit.body, ball)
        self.assertAlmostEqual(hit.distance, 5.5, places=5)
        self.assertIsNone(world.ray_cast((3, 10, 0), (0, -1, 0), length=2))
        self.assertEqual([h.body.name for h in world.ray_cast_all((0, 10, 0), (0, -1, 0))], ["ball", "ground"])
        self.assertAlmostEqual(ball.distance(world["ground"]).value, 3.5, places=5)
        self.assertAlmostEqual(world.energy.total, ball.mass * 9.81 * 4, delta=1)
        np.testing.assert_array_equal(world.momentum.linear, [0, 0, 0])
        with self.assertRaises(sudar.Error):
            world.ray_cast((0, 0, 0), (0, 2, 0))


class States(unittest.TestCase):
    def test_arrays(self):
        world, ball = falling_ball()
        arrays = world.arrays()
        world.step(30)
        for name, width in (("positions", 3), ("orientations", 4), ("velocities", 3), ("spins", 3)):
            now = getattr(world, name)
            self.assertEqual((now.shape, now.dtype), ((2, width), np.dtype(np.float64)))
            kept = getattr(arrays, name)
            if name == "positions":
                self.assertEqual(kept[1, 1], 4)
            arrays.update()
            self.assertIs(getattr(arrays, name), kept)
            np.testing.assert_array_equal(kept, now)
        np.testing.assert_array_equal(world.positions[1], ball.position)
        np.testing.assert_array_equal(world.velocities[1], ball.velocity)

    def test_a_copy_goes_on_with_the_same_bits(self):
        world, ball = falling_ball()
        world.step(20)
        twin, loaded = copy.deepcopy(world), sudar.World()
        loaded.load(world.save())
        pickled = pickle.loads(pickle.dumps(world))
        for w in (world, twin, loaded, pickled):
            w.step(50)
        self.assertEqual({w.hash() for w in (world, twin, loaded, pickled)}, {world.hash()})
        np.testing.assert_array_equal(twin[ball].position, ball.position)
        twin[ball].push((0, 0, 1))
        twin.step()
        world.step()
        difference = sudar.difference(world, twin)
        self.assertEqual(difference.body, ball)
        with self.assertRaises(sudar.Error):
            world.load(b"nonsense")

    def test_configure(self):
        world = sudar.World()
        world.configure(dt=0.25, soft_step={"lanes": 1})
        self.assertEqual((world.config.dt, world.config.soft_step.lanes), (0.25, 1))
        world.step()
        self.assertEqual(world.time, 0.25)

    def test_other_threads_run_during_a_step_and_are_kept_out(self):
        world = sudar.World()
        world.add(sudar.Gravity())
        world.add(shape=sudar.half_space(), motion="fixed")
        for i in range(300):
            world.add(shape=sudar.box((1, 1, 1)), at=(i % 10 * 1.01, 0.5 + i // 100 * 1.01, i // 10 % 10 * 1.01))
        refused, ran = [], []
        thread = threading.Thread(target=lambda: world.step(20))
        thread.start()
        while thread.is_alive():
            ran.append(time.perf_counter())
            try:
                world.positions
            except RuntimeError as e:
                refused.append(str(e))
        thread.join()
        self.assertGreater(len(ran), 10)
        self.assertIn("the world is being stepped by another thread", refused)
        self.assertEqual(world.steps, 20)


    def test_a_fork_leaves_no_one_waiting(self):
        world = falling_ball(workers=2)[0]
        batch = sudar.WorldBatch(falling_ball()[0], 4, threads=2)
        world.step(), batch.step()
        child = os.fork()
        if child == 0:
            refused = 0
            for step in (world.step, batch.step):
                try:
                    step()
                except RuntimeError as e:
                    refused += "forked" in str(e)
            copy.copy(world).step()
            os._exit(refused)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 2)

    def test_long_work_can_be_interrupted(self):
        def ring(*_):
            raise KeyboardInterrupt
        before = signal.signal(signal.SIGALRM, ring)
        try:
            world = falling_ball()[0]
            batch = sudar.WorldBatch(world, 2)
            for step in (world.step, batch.step):
                signal.setitimer(signal.ITIMER_REAL, 0.1)
                with self.assertRaises(KeyboardInterrupt):
                    step(10**12)
        finally:
            signal.signal(signal.SIGALRM, before)
        world.step()  # it is whole


class Batches(unittest.TestCase):
    def test_every_world_has_the_bits_that_it_has_alone(self):
        world, ball = falling_ball()
        batch = sudar.WorldBatch(world, 5, threads=3)
        forces = np.zeros((5, 3))
        forces[:, 0] = np.arange(5) * 1000
        batch.push(ball, forces)
        batch.step(40)
        self.assertEqual(batch.positions.shape, (5, 2, 3))
        for i, alone in enumerate(copy.copy(world) for _ in range(5)):
            alone[ball].push(forces[i])
            alone.step(40)
            self.assertEqual(alone.hash(), batch[i].hash())
            np.testing.assert_array_equal(alone.positions, batch.positions[i])
        self.assertEqual(len({w.hash() for w in batch}), 5)
        batch.reset([0, 2])
        self.assertEqual([w.steps for w in batch], [0, 40, 0, 40, 40])
        batch.reset()
        self.assertEqual({w.hash() for w in batch}, {world.hash()})

    def test_sets_and_tells(self):
        world = sudar.World()
        arm = world.add(shape=sudar.box((1, 0.1, 0.1)), at=(0.5, 0, 0))
        hinge = world.join(sudar.Hinge(b=arm, drive={"mode": "servo", "force": 1e6}))
        batch = sudar.WorldBatch(world, 3)
        batch.set_targets(hinge, [0.1, 0.2, 0.3])
        batch.step(200)
        np.testing.assert_allclose(batch.coordinates([hinge])[:, 0], [0.1, 0.2, 0.3], atol=1e-3)
        batch.set_spins(arm, (0, 0, 1))
        np.testing.assert_array_equal(batch.spins[:, 0, 2], [1, 1, 1])
        for values in (np.zeros((2, 3)), np.zeros(2), "fast"):
            with self.subTest(values=values), self.assertRaises((sudar.Error, TypeError, ValueError)):
                batch.push(arm, values)
        with self.assertRaises(sudar.Error):
            sudar.WorldBatch(world, 0)


if __name__ == "__main__":
    unittest.main()
