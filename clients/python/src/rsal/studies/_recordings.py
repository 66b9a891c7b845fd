"""Recordings as tables and arrays.

They are read by ``rsal show`` and ``rsal export``, not by a decoder of this package: so Python has the same names, and
reads files that are cut off or damaged, as the command line does. The
price is a start of Java for the state, events, messages and map together, and for each further topic.
"""

from __future__ import annotations

import json
import re
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rsal.launch import RsalError
from rsal.studies._command import call_json, pandas, read_csv
from rsal.studies._drawing import drawn

if TYPE_CHECKING:
    from pandas import DataFrame

_SMALL = re.compile(r"/(map|state|robots|events|agents|minds|messages(\..*)?)")
"""Topics that are read together, since most studies want them."""


@dataclass(frozen=True)
class OccupancyMap:
    """The map of a run.

    Attributes:
        cells: 0 free, 100 occupied, -1 unknown; ``cells[row, column]``, with row 0 at the lowest y.
        resolution: side of a cell [m].
        origin: x and y of the lower left corner [m].

    """

    cells: NDArray[np.int8]
    resolution: float
    origin: tuple[float, float]


@dataclass(frozen=True)
class Scans:
    """Readings of a laser or of sonars.

    Attributes:
        times: of the readings [s], one for each.
        ranges: ``ranges[i, beam]`` [m]; inf: no echo, -inf: too close, nan: invalid.
        angles: of the beams in the frame of the laser [rad]; empty for sonars.

    """

    times: NDArray[np.float64]
    ranges: NDArray[np.float32]
    angles: NDArray[np.float64]


def load(file: str | Path) -> Recording:
    """Read a recording, from ``rsal run --record`` or ``rsal.run(record=…)``.

    Raises:
        CommandFailed: there is no such file, or it is no recording of RSAL.

    """
    recording = Recording(Path(file))
    assert recording.run  # noqa: S101 - reads what it has, so that a wrong file is an error here
    return recording


class Recording:
    """A recorded run.

    Times are those of the run, in seconds. Times of readings are those of their measurement.

    """

    def __init__(self, file: Path) -> None:
        """Make it of a file, which is not read yet."""
        self.file = file
        self._folder = tempfile.TemporaryDirectory(prefix="rsal-recording-")
        self._tables: dict[str, DataFrame] = {}

    @cached_property
    def _shown(self) -> dict[str, Any]:
        shown: dict[str, Any] = call_json(["show", str(self.file)])
        return shown

    @property
    def run(self) -> dict[str, str]:
        """What was recorded at the start: ``scenario``, ``configuration``, ``seed``, ``argument.NAME`` and more."""
        return dict(self._shown["run"])

    @property
    def result(self) -> dict[str, str]:
        """What was recorded at the end: ``outcome``, ``eventHash``, ``metric.NAME``; empty if it is cut off."""
        return dict(self._shown.get("result") or {})

    @property
    def duration(self) -> float:
        """Length of the recording in the time of the run [s]."""
        return float(self._shown["seconds"])

    @property
    def event_hash(self) -> str:
        """The event hash of the run; empty if the recording was cut off."""
        return self.result.get("eventHash", "")

    @property
    def metrics(self) -> dict[str, float]:
        """Values of metrics by name."""
        start = "metric."
        return {name[len(start) :]: float(value) for name, value in self.result.items() if name.startswith(start)}

    @property
    def topics(self) -> list[str]:
        """Topics of the recording (docs/reference/recordings.md)."""
        return [each["topic"] for each in self._shown["topics"]]

    @property
    def robots(self) -> list[str]:
        """Ids of the robots, in the order in which they came."""
        return list(dict.fromkeys(self.table("/robots")["id"]))

    def table(self, topic: str) -> DataFrame:
        """Return the messages of a topic, with the columns of ``rsal export --csv`` (docs/reference/recordings.md)."""
        if topic not in self.topics:
            raise RsalError(
                f"'{self.file}' has no topic '{topic}'. It has {', '.join(self.topics)}. "
                "Topics are listed in docs/reference/recordings.md."
            )
        if topic not in self._tables:
            self._read([each for each in self.topics if _SMALL.fullmatch(each)] if _SMALL.fullmatch(topic) else [topic])
        return self._tables[topic]

    def _read(self, topics: Sequence[str]) -> None:
        options = [word for topic in topics for word in ("--topic", topic)]
        call_json(["export", str(self.file), "--csv", self._folder.name, "--force", *options])
        for topic in topics:
            file = Path(self._folder.name) / f"{_file_name(topic)}.csv"
            text = {"hash": str, "words": str, "text": str, "state": str, "beliefs": str, "robots.lacks": str}
            self._tables[topic] = read_csv(file, dtype=text)

    def poses(self, robot: str | None = None) -> DataFrame:
        """Return poses every 0.1 s: ``time``, ``robot``, and ``x``, ``y``, ``theta`` in the map frame.

        They are true poses if these are known, otherwise estimates of localizers. ``truth.*`` and ``estimate.*`` have
        both, with nan where one is unknown. Robots that are gone have no rows.
        """
        state = self.table("/state")
        columns: dict[str, Any] = {"time": state["log_time_s"], "robot": state["robots.id"]}
        for to, source in (("truth", "robots.truth"), ("estimate", "robots.estimate.pose")):
            for name, field in (("x", "x"), ("y", "y"), ("theta", "heading")):
                column = f"{source}.{field}"
                columns[f"{to}.{name}"] = state[column].astype(float) if column in state else float("nan")
        frame: DataFrame = pandas().DataFrame(columns)[~state["robots.gone"].astype(bool)]
        for name in ("theta", "y", "x"):
            best = frame[f"truth.{name}"].where(frame["truth.x"].notna(), frame[f"estimate.{name}"])
            frame.insert(2, name, best)
        if robot is not None:
            self._check_robot(robot)
            frame = frame[frame["robot"] == robot]
        whole: DataFrame = frame.reset_index(drop=True)
        return whole

    def _check_robot(self, robot: str) -> None:
        if robot not in self.robots:
            raise RsalError(f"'{self.file}' has no robot '{robot}'. It has {', '.join(self.robots)}.")

    def scans(self, robot: str, device: str = "scan") -> Scans:
        """Return the readings of a robot's laser (``scan``) or sonars (``ranges``), or of a further one by its name."""
        self._check_robot(robot)
        table = self.table(self._topic(robot, device))
        if "ranges" not in table:
            raise RsalError(f"Device '{device}' of '{robot}' has no ranges. Try readings('{robot}', '{device}').")
        lists = [np.array(str(cell).split(), dtype=np.float32) for cell in table["ranges"]]
        ranges = np.stack(lists) if lists else np.empty((0, 0), np.float32)
        angles = np.empty(0)
        if "start_angle" in table and len(table):
            angles = np.linspace(table["start_angle"][0], table["end_angle"][0], ranges.shape[1])
        return Scans(table["timestamp"].to_numpy(float), ranges, angles)

    def readings(self, robot: str, device: str) -> DataFrame:
        """Return the readings of a device: ``estimate``, ``particles``, ``path``, or the name of a device."""
        self._check_robot(robot)
        return self.table(self._topic(robot, device))

    def _topic(self, robot: str, device: str) -> str:
        for topic in (f"/{robot}/{device}", f"/{robot}/device/{device}"):
            if topic in self.topics:
                return topic
        known = [topic.split("/")[-1] for topic in self.topics if topic.startswith(f"/{robot}/")]
        raise RsalError(f"'{self.file}' has no readings of '{device}' of '{robot}'. It has {', '.join(known)}.")

    def messages(self, topic: str | None = None) -> DataFrame:
        """Return messages of agents in words, or those of one topic with their fields (``content.NAME``)."""
        return self.table("/messages" if topic is None else f"/messages.{topic}")

    def events(self) -> DataFrame:
        """Return all events: ``sequence`` from 1, ``kind``, ``subject``, ``text``, ``hash``."""
        return self.table("/events")

    def minds(self) -> DataFrame:
        """Return beliefs and goals of BDI agents at each change; of other agents their states and beliefs."""
        return self.table("/minds" if "/minds" in self.topics else "/agents")

    @cached_property
    def map(self) -> OccupancyMap:
        """The map of the run."""
        self.table("/map")
        image = (Path(self._folder.name) / "map.pgm").read_bytes()
        header, size, depth, pixels = image.split(b"\n", 3)
        width, height = map(int, size.split())
        if header != b"P5" or depth != b"255" or len(pixels) != width * height:
            raise RsalError(f"The map of '{self.file}' is no PGM of 8 bits.")
        gray = np.frombuffer(pixels, np.uint8).reshape(height, width)[::-1]  # a picture begins at its top
        cells = np.where(gray < 64, 100, np.where(gray > 250, 0, -1)).astype(np.int8)  # noqa: PLR2004 - ROS's 0, 205, 254
        grid = self.table("/map").iloc[-1]
        origin = (float(grid["pose.position.x"]), float(grid["pose.position.y"]))
        return OccupancyMap(cells, float(grid["cell_size.x"]), origin)

    def svg(self, *, until: float | None = None, width: int = 800) -> str:
        """Return a picture: the map, the way of each robot with its start and end, as SVG.

        Args:
            until: time at which the ways end [s].
            width: of the picture [px].

        """
        poses = self.poses()
        if until is not None:
            poses = poses[poses["time"] <= until]
        colors = dict(zip(self.table("/robots")["id"], self.table("/robots")["color"], strict=True))
        ways = {
            str(robot): (colors.get(robot, "#0072b2"), group[["x", "y", "theta"]].dropna().to_numpy(float))
            for robot, group in poses.groupby("robot", sort=False)
        }
        title = f"{self.run.get('scenario', '')}:{self.run.get('configuration', '')}, seed {self.run.get('seed', '')}"
        return drawn(self.map.cells, self.map.resolution, self.map.origin, ways, title=title, width=width)

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        """Return it in words."""
        return (
            f"Recording('{self.file}': {self.run.get('scenario')}:{self.run.get('configuration')}, "
            f"{self.duration} s, {json.dumps(self.result.get('outcome', 'cut off'))})"
        )


def _file_name(topic: str) -> str:
    return "".join(
        letter if letter.isascii() and (letter.isalnum() or letter in "_-") else "." for letter in topic.lstrip("/")
    )
