#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mazes as a vectorised environment in the shape that reinforcement learners expect: reset and step over all balls.

An action is the tilt of each ball's board; an observation its place and velocity, scaled. A ball earns 1 when it leaves
the maze and pays for time. A ball that is done starts anew in the next step (autoreset).

Usage: maze_env.py LEVEL      lets a random policy play and prints what it earns
"""
import sys

import numpy as np

import libphysics as lp


class MazeEnv:
    """observations (n, 4), actions (n, 2) in -1 .. 1, rewards, terminated, truncated (n,)."""

    MOST_TILT = np.radians(5)
    DT = 0.01  # s
    STEPS_PER_ACTION = 10

    def __init__(self, level, count, *, seconds=30.0, stepper="symplectic-euler", threads=1):
        self.scene = lp.Scene(level)
        self.stepper = lp.Stepper(stepper, self.scene)
        self.params = self.stepper.params()
        self.count, self.seconds, self.threads = count, seconds, threads
        self.states = self.scene.start(count)
        self._is_done = np.zeros(count, bool)
        self._low, self._high = self.scene.bounds[:, :2]

    def reset(self, *, seed=None, mask=None):
        """Starts all balls anew, or those of a mask (n,); each a little off the start, by the seed."""
        if seed is not None or not hasattr(self, "_random"):
            self._random = np.random.default_rng(seed)
        mask = np.ones(self.count, bool) if mask is None else np.asarray(mask, bool)
        fresh = self.scene.start(int(mask.sum()))
        fresh["velocity"][:, :2] = self._random.normal(0.0, 1e-3, (fresh.size, 2))
        self.states[mask] = fresh
        self._is_done[mask] = False
        return self._observe(), {}

    def step(self, actions):
        self.reset(mask=self._is_done)
        tilts = self.MOST_TILT * np.clip(np.asarray(actions, float), -1, 1)
        gravity = lp.gravity_from_tilt(tilts[:, 0], tilts[:, 1])[:, None]
        run = self.stepper.run(self.states, self.params, self.DT, self.STEPS_PER_ACTION, gravity=gravity, stop=lp.OUT,
                               threads=self.threads, out=self.states)
        terminated = (self.states["flags"] & lp.OUT) != 0
        truncated = ~terminated & ((self.states["time"] >= self.seconds) | (run.statuses != 0))
        self._is_done = terminated | truncated
        rewards = terminated - 1e-3 * run.steps_done
        return self._observe(), rewards, terminated, truncated, {}

    def _observe(self):
        place = (self.states["position"][:, :2] - self._low) / (self._high - self._low)
        return np.concatenate([2 * place - 1, self.states["velocity"][:, :2]], axis=1)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    env = MazeEnv(arguments[0], 64)
    random = np.random.default_rng(1)
    env.reset(seed=1)
    earned, ended = np.zeros(64), 0
    for _ in range(500):
        _, rewards, terminated, truncated, _ = env.step(random.uniform(-1, 1, (64, 2)))
        earned += rewards
        ended += int((terminated | truncated).sum())
    print(f"64 balls, 50 s each: {ended} episodes ended, {earned.mean():.3f} earned a ball")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except lp.PhysicsError as error:
        sys.exit(f"maze_env.py: {error}")
