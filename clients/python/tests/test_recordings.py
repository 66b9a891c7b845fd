from __future__ import annotations

import base64
import io
import math
import re
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from matplotlib.image import imread

import rsal
from rsal.studies import CommandFailed, Recording, Result, _drawing


def test_it_knows_its_run_and_result(recording: Recording, hunt: Result) -> None:
    assert recording.run["scenario"] == "hunt-and-prey"
    assert recording.event_hash == hunt.event_hash
    assert recording.metrics == hunt.metrics
    assert recording.duration == hunt.simulated_seconds
    assert recording.robots == ["prey-1", "hunter-1", "hunter-2"]
    assert "hunt.mcap" in repr(recording)


def test_poses_end_where_the_run_ended(recording: Recording, hunt: Result) -> None:
    poses = recording.poses()
    assert len(poses) == 3 * 527
    for robot, end in hunt.end_poses.items():
        last = recording.poses(robot).iloc[-1]
        assert (last["x"], last["y"], last["theta"]) == (end.x, end.y, end.theta)
        assert last["truth.x"] == end.x


def test_poses_have_estimates_near_the_truth(recording: Recording, hunt: Result) -> None:
    poses = recording.poses("hunter-1")
    errors = np.hypot(poses["estimate.x"] - poses["truth.x"], poses["estimate.y"] - poses["truth.y"])
    percentile = sorted(errors)[math.ceil(0.95 * len(errors)) - 1]  # as the scenario defines this metric
    assert percentile == pytest.approx(hunt.metrics["localizationError.hunter-1"], rel=1e-3)


def test_scans_are_arrays(recording: Recording) -> None:
    scans = recording.scans("hunter-1")
    assert scans.ranges.dtype == np.float32
    assert scans.ranges.shape == (len(scans.times), len(scans.angles))
    assert len(scans.times) == 526
    assert np.all(np.diff(scans.times) > 0)
    assert scans.angles[0] == -scans.angles[-1]
    assert np.nanmin(scans.ranges[np.isfinite(scans.ranges)]) > 0


def test_events_and_messages_are_tables(recording: Recording, hunt: Result) -> None:
    events = recording.events()
    assert events["sequence"].tolist() == list(range(1, len(events) + 1))
    caught = recording.messages("caught")
    assert caught["log_time_s"].tolist() == [hunt.metrics["captureTime"]]
    assert caught["content.hunter"].tolist() == ["hunter-2"]
    assert len(recording.messages()) > len(caught)


def test_minds_are_what_agents_believe(recording: Recording) -> None:
    minds = recording.minds()
    assert "prey=prey-1" in set(minds["beliefs"])


def test_the_map_is_an_array(recording: Recording) -> None:
    grid = recording.map
    assert grid.cells.shape == (312, 1259)
    assert set(np.unique(grid.cells)) <= {-1, 0, 100}
    for x, y in recording.poses()[["x", "y"]].to_numpy()[::50]:  # robots are where there is no wall
        row, column = int((y - grid.origin[1]) / grid.resolution), int((x - grid.origin[0]) / grid.resolution)
        assert grid.cells[row, column] == 0


def test_it_draws_the_ways_of_robots_on_the_map(recording: Recording) -> None:
    picture = ET.fromstring(recording._repr_svg_())
    name = "{http://www.w3.org/2000/svg}"
    ways = picture.findall(f"{name}polyline")
    assert [way.findtext(f"{name}title") for way in ways] == ["prey-1", "hunter-1", "hunter-2"]
    width, height = float(picture.attrib["width"]), float(picture.attrib["height"])
    for way in ways:
        for x, y in (point.split(",") for point in way.attrib["points"].split()):
            assert 0 <= float(x) <= width
            assert 0 <= float(y) <= height
    shorter = ET.fromstring(recording.svg(until=5, width=300))
    assert len(shorter.findall(f"{name}polyline")[0].attrib["points"]) < len(ways[0].attrib["points"])


def test_a_point_of_a_way_is_over_its_cell_of_the_picture() -> None:
    cells = np.zeros((10, 20), np.int8)
    cells[2, 5] = 100  # x 2.5 to 3, y 1 to 1.5
    way = np.array([[2.75, 1.25, 0.0], [2.75, 1.25, 0.0]])
    text = _drawing.drawn(cells, 0.5, (0.0, 0.0), {"a": ("#000", way)}, title="", width=200)
    found = re.search(r"base64,([^\"]+)", text)
    assert found
    pixels = imread(io.BytesIO(base64.b64decode(found.group(1))))
    assert pixels.shape[:2] == (10, 20)
    row, column = (int(each) for each in np.argwhere(pixels < 0.5)[0][:2])
    scale = 200 / 10
    point = re.search(r'points="([\d.]+),([\d.]+)', text)
    assert point
    assert math.floor(float(point.group(1)) / scale / 0.5) == column
    assert math.floor((float(point.group(2)) - 24) / scale / 0.5) == row


@pytest.mark.parametrize("shape", [(1, 1), (3, 7)])
def test_pictures_are_png(shape: tuple[int, int]) -> None:
    gray = np.arange(math.prod(shape), dtype=np.uint8).reshape(shape) * 5
    read = imread(io.BytesIO(_drawing.png(gray)))
    assert (np.rint(read * 255).astype(np.uint8) == gray).all()


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda recording: recording.table("/nothing"), "no topic '/nothing'.*/events"),
        (lambda recording: recording.poses("r9"), "no robot 'r9'.*hunter-1"),
        (lambda recording: recording.readings("prey-1", "gripper"), "'gripper' of 'prey-1'.*navigator"),
        (lambda recording: recording.scans("prey-1", "estimate"), "has no ranges"),
    ],
)
def test_what_is_not_there_is_an_error_that_lists_what_is(recording: Recording, ask: object, words: str) -> None:
    assert callable(ask)
    with pytest.raises(rsal.RsalError, match=words):
        ask(recording)


def test_a_file_that_is_no_recording_is_an_error(folder: Path) -> None:
    (folder / "other.mcap").write_bytes(b"not a recording")
    with pytest.raises(CommandFailed, match=r"other\.mcap"):
        rsal.load(folder / "other.mcap")
