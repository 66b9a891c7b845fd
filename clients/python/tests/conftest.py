"""Tests run against the program that RSAL_TEST_JARS names ('./rsal test' does), with a page that shows nothing."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

import rsal
from rsal.studies import Recording, Result

CHECKOUT = Path(__file__).parents[3]
OPTIONS = CHECKOUT / "apps/release/src/main/resources/rsal/release/unpacked/java.options"


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
