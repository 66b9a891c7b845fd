"""What poses, points and scans can compute. The generated values inherit from these."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from rsal.agents.values import LaserScan, Point2d, Pose2d


def wrap(angle: float) -> float:
    """Return the same angle in [-π, π) [rad]."""
    return (angle + math.pi) % (2 * math.pi) - math.pi


class PointMethods:
    """Of :class:`Point2d`."""

    __slots__ = ()

    def distance_to(self: Point2d, other: Point2d | Pose2d) -> float:  # type: ignore[misc]
        """Distance [m]."""
        return math.hypot(other.x - self.x, other.y - self.y)


class PoseMethods:
    """Of :class:`Pose2d`."""

    __slots__ = ()

    @property
    def position(self: Pose2d) -> Point2d:  # type: ignore[misc]
        """The position without the heading [m], in the parent frame."""
        from rsal.agents.values import Point2d  # noqa: PLC0415 - values inherit from this module

        return Point2d(self.x, self.y)

    def distance_to(self: Pose2d, other: Point2d | Pose2d) -> float:  # type: ignore[misc]
        """Distance between the positions [m]."""
        return math.hypot(other.x - self.x, other.y - self.y)

    def bearing_to(self: Pose2d, other: Point2d | Pose2d) -> float:  # type: ignore[misc]
        """Direction of a place as seen from this pose [rad]: 0 is ahead, positive to the left."""
        return wrap(math.atan2(other.y - self.y, other.x - self.x) - self.theta)

    def compose(self: Pose2d, following: Pose2d) -> Pose2d:  # type: ignore[misc]
        """``map_from_laser = map_from_base.compose(base_from_laser)``."""
        cos, sin = math.cos(self.theta), math.sin(self.theta)
        return type(self)(
            self.x + cos * following.x - sin * following.y,
            self.y + sin * following.x + cos * following.y,
            wrap(self.theta + following.theta),
        )

    def inverse(self: Pose2d) -> Pose2d:  # type: ignore[misc]
        """``base_from_map`` of ``map_from_base``."""
        cos, sin = math.cos(self.theta), math.sin(self.theta)
        return type(self)(-cos * self.x - sin * self.y, sin * self.x - cos * self.y, wrap(-self.theta))


class ScanMethods:
    """Of :class:`LaserScan`."""

    __slots__ = ()

    @property
    def angles(self: LaserScan) -> npt.NDArray[np.float64]:  # type: ignore[misc]
        """Direction of each beam in the laser's frame, counter-clockwise [rad]."""
        beams = np.arange(len(self.ranges), dtype=np.float64)
        return np.asarray(self.angle_min + self.angle_increment * beams, dtype=np.float64)

    def sector(self: LaserScan, right: float, left: float) -> npt.NDArray[np.float32]:  # type: ignore[misc]
        """Ranges of the beams between two directions in the robot's frame [rad], 0 ahead, positive to the left [m].

        Ranges are as REP 117 has them: ``inf`` where nothing is, ``-inf`` where something is too close to measure, NaN
        where the sensor is broken. So do not take their least by ``min``: :meth:`nearest` does that.
        """
        first = self.base_from_laser.theta + self.angle_min
        step = self.angle_increment
        count = len(self.ranges)
        if step > 0 and first >= -math.pi and first + step * (count - 1) <= math.pi:
            begin = max(0, math.ceil((right - first) / step))
            return self.ranges[begin : max(begin, math.floor((left - first) / step) + 1)]
        bearings = (self.angles + self.base_from_laser.theta + math.pi) % (2 * math.pi) - math.pi
        return self.ranges[(bearings >= right) & (bearings <= left)]

    def nearest(self: LaserScan, right: float = -math.pi, left: float = math.pi) -> float:  # type: ignore[misc]
        """Return the least range in a sector [m]; ``inf`` where nothing is, or nothing was measured.

        Beams without a reading (NaN, and 0 where that is not too close) are left out. What is too close to measure is
        at ``range_min``.
        """
        ranges = self.sector(right, left)
        if not len(ranges):
            return math.inf
        least = float(ranges.min())
        if least >= self.range_min and least > 0:  # nearly always; false with NaN
            return least
        if (ranges < self.range_min).any():
            return self.range_min
        measured = ranges[ranges > 0]
        return float(measured.min()) if len(measured) else math.inf
