"""Values: what they compute, and how frames have them."""

from __future__ import annotations

import io
import math
import random
from dataclasses import dataclass

import numpy as np
import pytest

from rsal.agents.convert import decoder, encode, wire_name
from rsal.agents.messages import PoseReport
from rsal.agents.values import (
    LaserScan,
    NavigatorCancelled,
    NavigatorReached,
    Point2d,
    Pose2d,
    PoseEstimate,
    Quality,
    Twist2d,
)
from rsal.protocol import Frames, ProtocolError

NOTHING = memoryview(b"")


def scan(mount: float, first: float, step: float, ranges: list[float]) -> LaserScan:
    return LaserScan(Pose2d(0, 0, mount), first, step, 0.0, 10.0, np.array(ranges, np.float32))


def test_frames_come_back_as_they_were_written() -> None:
    pipe = io.BytesIO()
    words = {"text": "ä€", "number": 0.1, "none": None, "far": math.inf}
    Frames(pipe, pipe).write(words, b"abc")
    Frames(pipe, pipe).write({})
    pipe.seek(0)
    frames = Frames(pipe, pipe)
    first = frames.read()
    assert first is not None
    assert first[0] == words
    assert bytes(first[1]) == b"abc"
    assert frames.read() == ({}, NOTHING)
    assert frames.read() is None


def test_what_is_no_frame_is_refused() -> None:
    pipe = io.BytesIO(b"\xff\xff\xff\x7f\x01\x00\x00\x00more")
    with pytest.raises(ProtocolError, match="2147483647 bytes"):
        Frames(pipe, pipe).read()


def test_names_are_as_in_java_in_frames() -> None:
    assert wire_name("map_from_base") == "mapFromBase"
    report = PoseReport("r1", "role", Pose2d(1, 2, 3))
    words = encode(report)
    assert words == {"robot": "r1", "role": "role", "mapFromBase": {"x": 1, "y": 2, "theta": 3}}
    assert decoder(PoseReport)(words, NOTHING) == report


def test_arrays_are_views_that_nobody_writes_to() -> None:
    numbers = np.array([1.5, math.inf], "<f4")
    words = {
        "baseFromLaser": {"x": 0, "y": 0, "theta": 0},
        "angleMin": -1,
        "angleIncrement": 0.5,
        "rangeMin": 0,
        "rangeMax": 5,
        "ranges": {"array": "f4", "at": 4, "count": 2},
    }
    found = decoder(LaserScan)(words, memoryview(b"\0\0\0\0" + numbers.tobytes()))
    assert found.ranges.tolist() == [1.5, math.inf]
    assert isinstance(found.angle_min, float)
    with pytest.raises(ValueError, match="read-only"):
        found.ranges[0] = 1


def test_one_of_several_records_is_told_by_its_type() -> None:
    kinds = NavigatorReached | NavigatorCancelled
    reached = decoder(kinds)({"type": "Reached", "mapFromBase": {"x": 1, "y": 2, "theta": 0}, "doubt": ""}, NOTHING)
    assert reached == NavigatorReached(Pose2d(1, 2, 0), "")
    assert decoder(kinds)({"type": "Cancelled", "why": "so"}, NOTHING) == NavigatorCancelled("so")
    assert encode(NavigatorCancelled("so")) == {"why": "so", "type": "Cancelled"}


def test_optional_lists_and_enumerations() -> None:
    covariance = dict.fromkeys(("xx", "xy", "xTheta", "yy", "yTheta", "thetaTheta"), 0)
    pose = {"x": 1, "y": 2, "theta": 0}
    words = {
        "mapFromBase": pose,
        "covariance": covariance,
        "hypotheses": [{"weight": 1, "mapFromBase": pose, "covariance": covariance}],
        "confidence": 0.5,
        "quality": "LOST",
    }
    found = decoder(PoseEstimate | None)(words, NOTHING)
    assert found.quality is Quality.LOST
    assert found.hypotheses[0].map_from_base == Pose2d(1, 2, 0)
    assert decoder(PoseEstimate | None)(None, NOTHING) is None


def test_own_dataclasses_and_numpy_are_sent() -> None:
    @dataclass
    class Offer:
        price_per_item: float
        places: list[Point2d]

    offer = Offer(np.float64(1.5), [Point2d(1, 2)])
    assert encode(offer) == {"pricePerItem": 1.5, "places": [{"x": 1, "y": 2}]}
    assert encode({"a": np.arange(3), "b": (True, None)}) == {"a": [0, 1, 2], "b": [True, None]}
    with pytest.raises(TypeError, match="'object' cannot be sent"):
        encode(object())


def test_poses_compose_as_matrices_do() -> None:
    draw = random.Random(7)  # noqa: S311 - values of a test

    def matrix(pose: Pose2d) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
        cos, sin = math.cos(pose.theta), math.sin(pose.theta)
        return np.array([[cos, -sin, pose.x], [sin, cos, pose.y], [0, 0, 1]])

    for _ in range(200):
        one, other = (Pose2d(*(draw.uniform(-4, 4) for _ in range(3))) for _ in range(2))
        assert np.allclose(matrix(one.compose(other)), matrix(one) @ matrix(other))
        assert np.allclose(matrix(one.inverse()), np.linalg.inv(matrix(one)))
        assert -math.pi <= one.compose(other).theta < math.pi
        there = one.compose(Pose2d(1, 1, 0))
        assert one.bearing_to(there) == pytest.approx(math.pi / 4)
        assert one.distance_to(there) == pytest.approx(math.sqrt(2))


def test_a_sector_is_what_each_beam_tells() -> None:
    draw = random.Random(7)  # noqa: S311 - values of a test
    for _ in range(300):
        count = draw.randrange(1, 60)
        ranges = [draw.choice([math.inf, draw.uniform(0, 5)]) for _ in range(count)]
        seen = scan(draw.uniform(-3, 3), draw.uniform(-3, 0), draw.uniform(0.01, 0.1), ranges)
        right, left = sorted((draw.uniform(-3, 3), draw.uniform(-3, 3)))
        wanted = [
            beam
            for index, beam in enumerate(seen.ranges.tolist())
            if right
            <= (seen.base_from_laser.theta + seen.angle_min + index * seen.angle_increment + math.pi) % math.tau
            - math.pi
            <= left
        ]
        assert seen.sector(right, left).tolist() == wanted
        assert seen.nearest(right, left) == min(wanted, default=math.inf)


def test_values_cannot_be_changed() -> None:
    with pytest.raises(AttributeError):
        Twist2d(0.0, 0.0, 0.0).vx = 1.0  # type: ignore[misc]


def test_the_nearest_thing_is_found_among_beams_without_a_reading() -> None:
    ranges = [2.0, math.nan, 0.3, math.inf]
    assert scan(0.0, -1.0, 0.5, ranges).nearest() == pytest.approx(0.3)
    assert scan(0.0, -1.0, 0.5, [*ranges, 0.0]).nearest() == pytest.approx(0.3)  # 0 is no reading
    assert scan(0.0, -1.0, 0.5, [math.nan, 0.0]).nearest() == math.inf
    assert scan(0.0, -1.0, 0.5, [math.nan, math.inf]).nearest() == math.inf
    near = LaserScan(Pose2d(0, 0, 0), -1.0, 0.5, 0.1, 10.0, np.array([math.nan, 2.0, -math.inf], np.float32))
    assert near.nearest() == 0.1  # what is too close is as near as can be measured
    zero = LaserScan(Pose2d(0, 0, 0), -1.0, 0.5, 0.1, 10.0, np.array([2.0, 0.0, math.nan], np.float32))
    assert zero.nearest() == 0.1


def test_the_nearest_thing_is_that_of_a_slow_search() -> None:
    generator = random.Random(3)  # noqa: S311
    for _ in range(300):
        least = generator.choice([0.0, 0.1])
        shown = [generator.choice([math.nan, math.inf, -math.inf, 0.0, 0.05, 1.0, 2.0]) for _ in range(5)]
        found = LaserScan(Pose2d(0, 0, 0), -1.0, 0.5, least, 10.0, np.array(shown, np.float32)).nearest()
        far = [least if each < least else each for each in shown if each != 0 or least > 0]  # as Rep117.distance
        assert found == pytest.approx(min((each for each in far if not math.isnan(each)), default=math.inf))


class _Slow(io.RawIOBase):
    """Takes three bytes at a time, as a pipe may when a signal comes."""

    def __init__(self) -> None:
        self.taken = b""

    def writable(self) -> bool:
        return True

    def write(self, data: object) -> int:
        part = bytes(data)[:3]  # type: ignore[call-overload]
        self.taken += part
        return len(part)


def test_all_of_a_frame_is_written_when_a_sink_takes_parts() -> None:
    sink = _Slow()
    Frames(io.BytesIO(), sink).write({"a": "long"}, b"xyz")  # type: ignore[arg-type]
    frame = Frames(io.BytesIO(sink.taken), io.BytesIO()).read()
    assert frame is not None
    assert frame[0] == {"a": "long"}
    assert bytes(frame[1]) == b"xyz"


def test_a_frame_that_is_too_long_is_not_begun() -> None:
    sink = io.BytesIO()
    with pytest.raises(ProtocolError, match="at most 67108864"):
        Frames(io.BytesIO(), sink).write({}, bytes(64 * 1024 * 1024))
    assert sink.getvalue() == b""
