"""Sweeps: many runs, and the report of their results."""

from __future__ import annotations

import contextlib
import csv
import json
import math
import operator
import sys
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rsal.launch import RsalError
from rsal.studies._command import call, call_json, pandas, read_csv, scenario_word, settings, word

if TYPE_CHECKING:
    from pandas import DataFrame

_FIXED = ("run", "combination", "configuration", "seed", "outcome", "reason", "simulatedSeconds", "wallSeconds")
_FURTHER = ("eventHash", "outOfBounds", "failedAgents", "broken")


def sweep(
    scenario: str | Path,
    *,
    out: str | Path,
    vary: Mapping[str, Iterable[object] | object] | None = None,
    configuration: str | Sequence[str] | None = None,
    seeds: int | Iterable[int] = 10,
    seconds: float | None = None,
    jobs: int | None = None,
    record: bool = False,
    progress: bool = True,
    arguments: Mapping[str, object] | None = None,
    **more_arguments: object,
) -> DataFrame:
    """Run a scenario with every combination of configurations and values, and return a table with a row for each run.

    An interrupt ends the sweep; the same call resumes it. A call whose sweep is complete only reads its rows.

    Args:
        scenario: a scenario of RSAL, a scenario file or its folder.
        out: folder for the rows, which ``rsal report`` also reads. It is made if it does not exist.
        vary: values by argument: ``{"hunters": range(1, 5)}``; a single one counts as one. All combinations are run.
        configuration: one or several of the scenario; by default its first.
        seeds: how many (from 1), or consecutive numbers such as ``range(101, 121)``. All combinations have the same.
        seconds: each run ends after this number of simulated seconds.
        jobs: number of runs at once; by default the number of cores.
        record: whether each run is recorded to ``out/recordings/RUN.mcap``.
        progress: whether to print how many runs have ended.
        arguments: of the scenario, for all runs.
        more_arguments: the same, as keywords.

    Raises:
        CommandFailed: the scenario or a value is wrong, or the folder has another sweep.

    """
    first, last = _seeds(seeds)
    values = {name: [word(each) for each in _levels(levels)] for name, levels in (vary or {}).items()}
    for name, levels in values.items():
        if not levels or any("," in level for level in levels):
            raise RsalError(f"vary['{name}'] is {levels}. It needs at least one value, and none with a comma.")
    configurations = [configuration] if isinstance(configuration, str) else list(configuration or [])
    words = ["sweep", scenario_word(scenario, None), "--out", str(out), "--seeds", f"{first}:{last}"]
    for name, levels in values.items():
        words += ["--vary", f"{name}={','.join(levels)}"]
    if configurations:
        words += ["--configuration", ",".join(configurations)]
    if seconds is not None:
        words += ["--for", str(seconds)]
    if jobs is not None:
        words += ["--jobs", str(jobs)]
    if record:
        words.append("--record")
    if (Path(out) / "manifest.json").exists():
        words.append("--resume")
    words += settings({**(arguments or {}), **more_arguments})
    total = math.prod(map(len, values.values())) * max(1, len(configurations)) * (last - first + 1)
    shown = _Progress(Path(out), total) if progress else None
    try:
        call([*words, "--json"], while_waiting=shown.show if shown else bool)
    finally:
        if shown:
            shown.end()
    return rows(out)


def _levels(levels: Iterable[object] | object) -> Iterable[object]:
    """Return values of an argument; a word or a number is one."""
    return levels if isinstance(levels, Iterable) and not isinstance(levels, (str, bytes)) else [levels]


def _seeds(seeds: int | Iterable[int]) -> tuple[int, int]:
    numbers: list[int] = []
    with contextlib.suppress(TypeError):  # what is no whole number is refused below
        if isinstance(seeds, Iterable):
            numbers = [operator.index(each) for each in seeds]
        else:
            numbers = list(range(1, operator.index(seeds) + 1))
    if not numbers or numbers != list(range(numbers[0], numbers[0] + len(numbers))):
        raise RsalError(
            f"seeds is '{seeds}'. It must be a number of seeds (at least 1), or consecutive seeds in rising order, "
            "such as range(101, 121)."
        )
    return numbers[0], numbers[-1]


class _Progress:
    """Prints how many runs of a sweep have ended: on one line of a terminal or notebook."""

    def __init__(self, folder: Path, total: int) -> None:
        self._file = folder / "rows.jsonl"
        self._folder = folder
        self._total = total
        self._begun = time.monotonic()
        self._shown = ""

    def show(self) -> None:
        ended = 0
        with contextlib.suppress(OSError):
            ended = self._file.read_bytes().count(b"\n")
        text = f"{self._folder}: {ended} of {self._total} runs"
        if text != self._shown:
            self._shown = text
            print(f"\r{text}, {time.monotonic() - self._begun:.0f} s", end="", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._shown:
            print(file=sys.stderr, flush=True)


def rows(folder: str | Path) -> DataFrame:
    """Return the rows of a sweep, which may still run: one row for each run that has ended, by its number.

    Columns are those of ``rows.jsonl`` (docs/reference/sweeps.md). Arguments and metrics have their names; one whose
    name is there already has ``argument.`` or ``metric.`` before it.
    """
    file = Path(folder) / "rows.jsonl"
    try:
        lines = [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines() if line.endswith("}")]
    except OSError as error:
        raise RsalError(
            f"The rows of a sweep cannot be read from '{file}': {error.strerror}. "
            "Give the folder of 'rsal sweep --out FOLDER'."
        ) from error
    except ValueError as error:
        raise RsalError(f"'{file}' has a line that is no row of a sweep: {error}.") from error
    taken = set(_FIXED) | set(_FURTHER)
    arguments = _columns(lines, "arguments", "argument.", taken)
    metrics = _columns(lines, "metrics", "metric.", taken | set(arguments.values()))
    table: list[dict[str, Any]] = []
    for line in sorted(lines, key=lambda each: int(each["run"])):
        row = {name: line.get(name) for name in _FIXED[:3]}
        row |= {column: line["arguments"].get(name) for name, column in arguments.items()}
        row |= {name: line.get(name) for name in _FIXED[3:]}
        row |= {column: line["metrics"].get(name) for name, column in metrics.items()}
        table.append(row | {name: line.get(name) for name in _FURTHER})
    frame: DataFrame = pandas().DataFrame(table)
    frame.attrs["folder"] = str(folder)
    return frame


def _columns(lines: Sequence[Mapping[str, Any]], member: str, prefix: str, taken: set[str]) -> dict[str, str]:
    """Return the column of each name that a member of any row has, in the order of their appearance."""
    names = dict.fromkeys(name for line in lines for name in line[member])
    return {name: prefix + name if name in taken else name for name in names}


@dataclass(frozen=True)
class Report:
    """The report of a sweep.

    Attributes:
        page: the report as one HTML file.
        files: all files that were written: figures (SVG, PDF, PNG) and tables (CSV, LaTeX).

    """

    page: Path
    files: tuple[Path, ...]

    def tables(self) -> dict[str, DataFrame]:
        """Return the tables of the report: ``outcomes``, and of each metric ``NAME`` and ``NAME-effects``."""
        return {
            file.stem: read_csv(file)
            for file in self.files
            if file.suffix == ".csv" and file.parent.name.endswith("-tables") and _has_rows(file)
        }

    def figures(self) -> dict[str, Path]:
        """Return the figures as SVG files, by name."""
        return {file.stem: file for file in self.files if file.suffix == ".svg"}

    def _repr_html_(self) -> str:
        return "".join(f"<b>{escape(name)}</b>{table.to_html(index=False)}" for name, table in self.tables().items())


def _has_rows(file: Path) -> bool:
    with file.open(encoding="utf-8", newline="") as text:
        return len([row for row, _ in zip(csv.reader(text), range(2), strict=False)]) == 2  # noqa: PLR2004 - with its head


def report(folder: str | Path | DataFrame) -> Report:
    """Write the report of a sweep (``rsal report``): outcomes, metrics with confidence intervals, effects of changes.

    Args:
        folder: of the sweep, or the table that ``sweep`` or ``rows`` has returned.

    """
    place = getattr(folder, "attrs", {}).get("folder", folder)
    if not isinstance(place, (str, Path)):
        raise RsalError("This table is not of a sweep: its folder is unknown. Give the folder in its place.")
    said = call_json(["report", str(place)])
    files = tuple(Path(file) for file in said["files"])
    return Report(page=files[0], files=files)
