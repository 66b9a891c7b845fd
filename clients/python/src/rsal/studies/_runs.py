"""Single runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

from rsal.launch import RsalError
from rsal.studies._command import call_json, scenario_word, settings
from rsal.studies._recordings import Recording

_NO_SUCCESS = 4  # exit code of a run that has ended in failure


class Pose(NamedTuple):
    """A pose in the map frame: ``x`` and ``y`` in meters, ``theta`` in radians from the map's x axis."""

    x: float
    y: float
    theta: float


class RunFailed(RsalError):
    """A run that has ended without success; ``result`` has its result."""

    def __init__(self, result: Result) -> None:
        """Make it of the result."""
        self.result = result
        super().__init__(
            f"The run of '{result.scenario}:{result.configuration}' with seed {result.seed} ended with "
            f"'{result.outcome}' at {result.simulated_seconds} s"
            + "".join(f"; agent '{agent}' failed: {why}" for agent, why in result.failed.items())
            + ". Without check=True, its result is returned."
        )


@dataclass(frozen=True, repr=False)
class Result:
    """The result of a run, as ``rsal run --json`` reports it (docs/reference/results.md).

    Attributes:
        scenario: name of the scenario.
        configuration: name of its configuration.
        seed: seed of all random numbers.
        outcome: ``success``, ``failure``, ``timeout``, ``stopped``, …
        simulated_seconds: length of the run in the time of the run [s].
        wall_seconds: length in real time [s].
        event_hash: hash over all events; equal seeds have equal hashes.
        metrics: values by name; those of one robot have its id behind a point.
        arguments: values of the scenario's arguments.
        end_poses: poses of robots at the end.
        failed: errors of agents that have failed, by agent.
        recording: what was recorded, with ``record``.
        json: everything that the command has printed.

    """

    scenario: str
    configuration: str
    seed: int
    outcome: str
    simulated_seconds: float
    wall_seconds: float
    event_hash: str
    metrics: dict[str, float]
    arguments: dict[str, Any]
    end_poses: dict[str, Pose]
    failed: dict[str, str]
    recording: Recording | None
    json: dict[str, Any]

    @property
    def ok(self) -> bool:
        """Whether the run was a success and no agent has failed."""
        return self.outcome == "success" and not self.failed

    def __repr__(self) -> str:
        """Return it in a few lines; all of it is in the attributes."""
        about = (
            f"<Result {self.scenario}:{self.configuration}, seed {self.seed}: {self.outcome} "
            f"at {self.simulated_seconds} s, event hash {self.event_hash[:8]}"
        )
        lines = [f"  {name}: {value}" for name, value in self.metrics.items()]
        lines += [f"  failed: agent '{agent}': {why}" for agent, why in self.failed.items()]
        return "\n".join([about, *lines]) + ">"

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{escape(name)}</td><td>{value}</td></tr>" for name, value in self.metrics.items())
        return (
            f"<b>{escape(self.scenario)}:{escape(self.configuration)}</b>, seed {self.seed}: {escape(self.outcome)} "
            f"at {self.simulated_seconds} s, event hash <code>{self.event_hash[:8]}</code><table>{rows}</table>"
        )


def run(
    scenario: str | Path = "hunt-and-prey",
    *,
    configuration: str | None = None,
    seed: int | None = None,
    seconds: float | None = None,
    record: str | Path | None = None,
    overwrite: bool = False,
    check: bool = False,
    arguments: Mapping[str, object] | None = None,
    **more_arguments: object,
) -> Result:
    """Run a scenario as fast as possible, without a page, and return its result.

    An interrupt ends the run. Agents that fail, and runs without success, are no exceptions, unless ``check`` is set.

    Args:
        scenario: a scenario of RSAL, a scenario file or its folder, or a world.
        configuration: of the scenario; by default its first.
        seed: of all random numbers; by default the scenario's.
        seconds: the run ends after this number of simulated seconds.
        record: a file for the recording (``.mcap``).
        overwrite: whether an existing recording is replaced.
        check: whether a run without success is an exception, ``RunFailed``.
        arguments: of the scenario, by name.
        more_arguments: the same, as keywords: ``run("hunt-and-prey", hunters=3)``.

    Raises:
        CommandFailed: the scenario or an argument is wrong, or a file cannot be written.

    """
    words = ["run", scenario_word(scenario, configuration), "--headless", "--speed", "max", "--quiet"]
    if seed is not None:
        words += ["--seed", str(seed)]
    if seconds is not None:
        words += ["--for", str(seconds)]
    if record is not None:
        words += ["--record", str(record), *(["--force"] if overwrite else [])]
    said = call_json([*words, *settings({**(arguments or {}), **more_arguments})], accepted=(0, _NO_SUCCESS))
    result = Result(
        scenario=said["scenario"],
        configuration=said["configuration"],
        seed=int(said["seed"]),
        outcome=said["outcome"],
        simulated_seconds=said["simulatedSeconds"],
        wall_seconds=said["wallSeconds"],
        event_hash=said["eventHash"],
        metrics=said["metrics"],
        arguments=said["arguments"],
        end_poses={robot: Pose(pose["x"], pose["y"], pose["theta"]) for robot, pose in said["endPoses"].items()},
        failed=said["failed"],
        recording=Recording(Path(record)) if record is not None else None,
        json=said,
    )
    if check and not result.ok:
        raise RunFailed(result)
    return result
