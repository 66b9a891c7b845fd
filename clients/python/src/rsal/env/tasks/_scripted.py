"""Short policies by hand, which have the same observations as learners: what a learned policy is compared with."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.env._worlds import Floats

Numbers = npt.NDArray[np.floating[Any]]

_VIEW = np.deg2rad(276.0)
_SECTORS = 12
_SAFE = 0.9  # m that a direction should be free
_HALF_WIDTH = 0.36  # m of the lane that the robot needs
_FORWARD, _TURN = 0.5, 1.5


def _wrapped(angle: Numbers) -> Numbers:
    wrapped: Numbers = (angle + np.pi) % (2 * np.pi) - np.pi
    return wrapped


def _middles(sectors: int) -> Numbers:
    """Return the directions of the sectors' middles, from right to left."""
    middles: Numbers = (np.arange(sectors) + 0.5) * _VIEW / sectors - _VIEW / 2
    return middles


_DIRECTIONS = np.deg2rad(np.arange(-130.0, 131.0, 10.0))


def _lanes(ranges: Numbers, directions: Numbers) -> Numbers:
    """Return how far straight lanes are free, by direction [m]."""
    apart = _middles(ranges.shape[-1])[None, :] - directions[:, None]
    along, aside = np.cos(apart) * ranges[..., None, :], np.abs(np.sin(apart)) * ranges[..., None, :]
    free: Numbers = np.where((along > 0) & (aside < _HALF_WIDTH), along, 5.0).min(-1)
    return free


def _drive(
    observations: Floats,
    x: Numbers,
    y: Numbers,
    *,
    near: float = 0.0,
    sectors: int = _SECTORS,
    top: float = _FORWARD,
) -> Numbers:
    """Drive towards a place in the base frame, in the direction of it that is free.

    :param near: distance from the place at which to be slower [m]
    """
    ranges = observations[..., :sectors].astype(float)
    clear = _lanes(ranges, _DIRECTIONS)
    goal, distance = np.arctan2(y, x)[..., None], np.hypot(x, y)
    needed = np.minimum(2.0, np.maximum(distance, 0.3))[..., None]
    cost = np.abs(_wrapped(_DIRECTIONS - goal)) + 0.2 * np.abs(_DIRECTIONS)
    cost = cost + 3.0 * np.maximum(0.0, needed - clear) / needed
    aim = _DIRECTIONS[cost.argmin(-1)]
    ahead = _lanes(ranges, np.zeros(1))[..., 0]
    speed = top * np.clip((ahead - 0.25) / 0.6, 0.0, 1.0) * np.clip(np.cos(1.5 * aim), 0.0, 1.0)
    if near:
        speed = speed * np.clip(distance / near, 0.0, 1.0)
    return np.stack([speed, np.clip(2.0 * aim, -_TURN, _TURN)], -1)


def navigation(observations: Floats) -> Numbers:
    """Drive to the goal through the freest gap that is in its direction."""
    return _drive(observations, observations[..., -2], observations[..., -1], sectors=24)


def _searching(observations: Floats) -> tuple[Numbers, Numbers]:
    """Return a place to the front left: along what is to the right."""
    return np.full(observations.shape[:-1], 2.0), np.full(observations.shape[:-1], 0.6)


def pursuit(observations: Floats) -> Numbers:
    """Drive to the prey while it is seen, and along the walls while it is not."""
    x, y, seen = (observations[..., 15 + i].astype(float) for i in range(3))
    ahead, left = _searching(observations)
    hidden = seen < 1
    x, y = np.where(hidden, ahead, x), np.where(hidden, left, y)
    act = _drive(observations, x, y)
    # The prey itself is an obstacle in the way: near it, drive straight on.
    close = (~hidden) & (np.hypot(x, y) < 1.6)  # noqa: PLR2004 - m
    angle = np.arctan2(y, x)
    straight = np.stack([_FORWARD * np.clip(np.cos(angle), 0, 1), np.clip(2 * angle, -_TURN, _TURN)], -1)
    return np.where(close[..., None], straight, act)


def coverage(observations: Floats) -> Numbers:
    """Drive where it is free and where the robot has not been, rather straight on."""
    ranges = observations[..., :_SECTORS].astype(float)
    visited = observations[..., 15:23].astype(float)
    eight = np.arange(8) * np.pi / 4
    nearest = np.abs(_wrapped(_DIRECTIONS[:, None] - eight[None, :])).argmin(-1)
    clear = _lanes(ranges, _DIRECTIONS)
    cost = 0.5 * np.abs(_DIRECTIONS) + 2.0 * visited[..., nearest] + 3.0 * np.maximum(0.0, _SAFE - clear) / _SAFE
    aim = _DIRECTIONS[cost.argmin(-1)]
    return _drive(observations, 2.0 * np.cos(aim), 2.0 * np.sin(aim))


def formation(observations: Floats) -> Numbers:
    """Drive to the own slot, slower near it, and turn as the leader does once there."""
    x, y = observations[..., 15].astype(float), observations[..., 16].astype(float)
    act = _drive(observations, x, y, near=0.8, top=0.7)
    there = np.hypot(x, y) < 0.15  # noqa: PLR2004 - m
    behind = (x < 0) & (np.hypot(x, y) < 0.8)  # noqa: PLR2004 - m; it comes by itself, as the leader drives
    heading = np.arctan2(observations[..., 18], observations[..., 17]).astype(float)
    wait = np.stack([np.zeros_like(heading), np.clip(2.0 * heading, -_TURN, _TURN)], -1)
    return np.where((there | behind)[..., None], wait, act)


def foraging(observations: Floats) -> Numbers:
    """Drive to the nearest can that is seen, then home, and let go there; search along the walls while none is seen."""
    can_x, can_y, seen = (observations[..., 15 + i].astype(float) for i in range(3))
    home_x, home_y, holds = (observations[..., 18 + i].astype(float) for i in range(3))
    ahead, left = _searching(observations)
    search = (holds < 1) & (seen < 1)
    x = np.where(holds > 0, home_x, np.where(search, ahead, can_x))
    y = np.where(holds > 0, home_y, np.where(search, left, can_y))
    act = _drive(observations, x, y)
    close = (holds < 1) & ~search & (np.hypot(can_x, can_y) < 0.8)  # noqa: PLR2004 - m
    angle = np.arctan2(can_y, can_x)
    slow = np.stack([0.2 * (np.abs(angle) < 0.15), np.clip(2.0 * angle, -_TURN, _TURN)], -1)  # noqa: PLR2004 - rad
    act = np.where(close[..., None], slow, act)
    release = (holds > 0) & (np.hypot(home_x, home_y) < 0.6)  # noqa: PLR2004 - m
    return np.concatenate([act, release[..., None].astype(float)], -1)


def patrol(observations: Floats) -> Numbers:
    """Choose the place with the most steps without a visit for each meter of the way there."""
    places = observations[..., :24].reshape(*observations.shape[:-1], 8, 3).astype(float)
    value = (places[..., 2] + 1.0) / (np.hypot(places[..., 0], places[..., 1]) + 3.0)
    chosen: Numbers = value.argmax(-1)[..., None].astype(float)
    return chosen
