"""Scenarios and recordings from Python: with the bits of the program."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import sudar

PROGRAM = os.environ.get("SUDAR_PROGRAM")


class Scenarios(unittest.TestCase):
    def test_all_are_there(self):
        names = {p.stem for p in pathlib.Path(os.environ["SUDAR_SOURCE"]).glob("scenarios/*/*.cc")}
        self.assertEqual({s.name for s in sudar.scenarios()}, names)

    @unittest.skipUnless(PROGRAM, "there is no program to compare with")
    def test_the_bits_of_the_program(self):
        for name, parameters, config in (("dominoes", {}, {}), ("train", {"force": 690}, {}),
                                         ("cradle", {}, {"solver": "soft_step", "soft_step": {"lanes": 1}})):
            session = sudar.Session(name, config=config, seconds=2, **parameters)
            session.run()
            options = [f"--set={k}={v}" for k, v in parameters.items()]
            options += ["--solver=soft_step", "--config=soft_step.lanes=1"] if config else []
            out = subprocess.run([PROGRAM, "run", name, "--seconds", "2", "--json", *options], capture_output=True, text=True)
            report = json.loads(out.stdout)
            with self.subTest(name):
                self.assertEqual(f"{session.world.motion_hash():016x}", report["motion_hash"])
                self.assertEqual(f"{session.world.hash():016x}", report["hash"])
                self.assertEqual({c.name: c.passed for c in session.checks}, {c["name"]: c["pass"] for c in report["checks"]})

    def test_parameters_and_verdicts(self):
        session = sudar.Session("train", force=660)
        self.assertEqual({p.name: p.value for p in session.parameters}["force"], 660)
        checks = session.run()
        self.assertTrue(session.passed, checks)
        self.assertTrue(session.done)
        for parameters, field in (({"force": 1e9}, "force"), ({"speed": 1}, "speed"), ({"force": "much"}, "force")):
            with self.assertRaises(sudar.Error) as caught:
                sudar.Session("train", **parameters)
            self.assertEqual(caught.exception.field, field)
        with self.assertRaises(sudar.Error):
            sudar.Session("trian")

    def test_saved_and_loaded(self):
        session = sudar.Session("dominoes", seconds=1)
        session.step(20)
        twin = sudar.Session.load(session.save())
        session.step(20), twin.step(20)
        self.assertEqual(session.world.hash(), twin.world.hash())
        self.assertEqual(twin.name, "dominoes")

    def test_keys(self):
        session = sudar.Session("vehicle", seconds=1)
        session.hold(["up"])
        session.step(5)
        with self.assertRaises(sudar.Error):
            session.hold(["warp"])


class Recordings(unittest.TestCase):
    def test_what_was_recorded_is_replayed(self):
        world = sudar.World()
        world.add(sudar.Gravity())
        ball = world.add(shape=sudar.sphere(0.5), name="ball")
        world.step(3)
        with tempfile.TemporaryDirectory() as folder, sudar.Recording(world, "a push") as recording:
            for i in range(20):
                ball.push((i, 0, 0))
                world.step()
            recording.stop()
            world.step(10)
            recording.save(pathlib.Path(folder) / "push.sudar")
            replay = sudar.Replay(pathlib.Path(folder) / "push.sudar")
            if PROGRAM:
                subprocess.run([PROGRAM, "replay", "--check", f"{folder}/push.sudar"], check=True, capture_output=True)
        self.assertEqual((replay.title, len(replay)), ("a push", 20))
        self.assertEqual(list(replay), [None] * 20)
        self.assertTrue(replay.done)
        self.assertEqual(replay.world.steps, 23)
        with self.assertRaises(IndexError):
            replay.step()

    def test_a_session_is_recorded_to_its_last_step(self):
        session = sudar.Session("dominoes", seconds=0.37)
        with sudar.Recording(session.world) as recording:
            session.run()
        replay = sudar.Replay(bytes(recording))
        self.assertEqual(len(replay), session.world.steps)
        self.assertEqual(set(replay), {None})
        self.assertEqual(replay.world.hash(), session.world.hash())

    def test_a_difference_is_named(self):
        world = sudar.World()
        ball = world.add(shape=sudar.sphere(0.5))
        with sudar.Recording(world) as recording:
            world.step(5)
        replay = sudar.Replay(bytes(recording))
        replay.step()
        replay.world[ball].velocity = (1, 0, 0)
        divergence = replay.step()
        self.assertEqual((divergence.step, divergence.body), (2, ball))
        with self.assertRaises(sudar.Error):
            sudar.Replay(b"nonsense")
        with self.assertRaises(sudar.Error):
            sudar.Replay("no such file")

    def test_batches_are_recorded_too(self):
        world = sudar.World()
        world.add(shape=sudar.sphere(0.5))
        batch = sudar.WorldBatch(world, 2)
        with sudar.Recording(batch[1]) as recording:
            batch.step(7)
        self.assertEqual(len(sudar.Replay(bytes(recording))), 7)


if __name__ == "__main__":
    unittest.main()
