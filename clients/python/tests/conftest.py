"""Tests run against the program that RSAL_TEST_JARS names ('./rsal test' does), with a page that shows nothing."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import rsal
from rsal.studies import Recording, Result

_TEAM = """
rsal: 1
scenario: team
arguments: {{count: {{type: integer, default: 2}}}}
world: {{map: office}}
robots:
  learner: {{count: $count, model: pioneer2dx, pose: {{free: true}}, devices: {{laser: urg04lx}}}}
  other: {{model: pioneer2dx, pose: [-20, 4, 0], devices: {{laser: urg04lx, pilot: {{}}}}}}
agents:
  wander: {{type: wander, robot: other}}
run: {{stop: [{{when: {end}, outcome: {outcome}}}]}}
metrics: [{{name: way, from: distance(other)}}]
"""

CHECKOUT = Path(__file__).parents[3]
OPTIONS = CHECKOUT / "apps/release/src/main/resources/rsal/release/unpacked/java.options"


@pytest.fixture(scope="session", autouse=True)
def _interrupts() -> None:
    """Let interrupts arrive: a shell has processes in the background ignore them, and their children, too."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session", autouse=True)
def _program(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Let the package run the jars that were just built, on the JDK that built them."""
    jars = os.environ.get("RSAL_TEST_JARS")
    with pytest.MonkeyPatch.context() as patch:
        if jars:
            program = tmp_path_factory.mktemp("program with a space")
            (program / "lib").mkdir()
            for jar in Path(jars).glob("*.jar"):
                (program / "lib" / jar.name).symlink_to(jar)
            # What makes short runs faster: one compiler only, and an archive of classes, which the first run writes.
            faster = ["-XX:TieredStopAtLevel=1", "-XX:+AutoCreateSharedArchive"]
            faster.append(f'"-XX:SharedArchiveFile={program / "classes.jsa"}"')
            options = OPTIONS.read_text(encoding="utf-8") + "\n".join(faster) + "\n"
            (program / "lib" / OPTIONS.name).write_text(options, encoding="utf-8")
            (program / "page").mkdir()
            (program / "page" / "index.html").write_text("<!doctype html><title>blank</title>", encoding="utf-8")
            patch.setenv("RSAL_PROGRAM", str(program))
        patch.setenv("PYTHONPATH", str(Path(rsal.__file__).parents[1]))  # for child processes
        patch.setenv("RSAL_CACHE", "off")  # else the first test would make one in the background
        yield


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for what the runs of all tests write."""
    return tmp_path_factory.mktemp("runs")


@pytest.fixture(scope="session")
def hunt(folder: Path) -> Result:
    """A whole hunt, recorded."""
    return rsal.run("hunt-and-prey", seed=7, record=folder / "hunt.mcap")


@pytest.fixture(scope="session")
def recording(hunt: Result) -> Recording:
    """The recording of the hunt."""
    assert hunt.recording is not None
    return hunt.recording


@pytest.fixture
def team(tmp_path: Path) -> Callable[..., str]:
    """Makes the file of a scenario with learners and a robot that wanders, which ends as it is told."""

    def make(end: str = "time >= 100", outcome: str = "timeout") -> str:
        file = tmp_path / "team.yaml"
        file.write_text(_TEAM.format(end=end, outcome=outcome), encoding="utf-8")
        return str(file)

    return make


@pytest.fixture
def scenario(team: Callable[..., str]) -> str:
    """The same, which ends after 100 s."""
    return team()
