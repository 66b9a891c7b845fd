from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import rsal
from rsal.studies import CommandFailed, Result, _sweeps

_SWEEP: dict[str, Any] = {"vary": {"hunters": range(1, 3)}, "seeds": range(6, 8), "hunterSpeed": 0.6}


@pytest.fixture(scope="module")
def swept(folder: Path) -> pd.DataFrame:
    return rsal.sweep("hunt-and-prey", out=folder / "hunt", progress=False, **_SWEEP)


def test_each_run_is_a_row(swept: pd.DataFrame) -> None:
    assert list(swept["run"]) == [1, 2, 3, 4]
    assert sorted(zip(swept["hunters"], swept["seed"], strict=True)) == [(h, s) for h in (1, 2) for s in (6, 7)]
    assert set(swept["hunterSpeed"]) == {0.6}
    assert {"outcome", "captureTime", "distance.prey-1", "eventHash"} <= set(swept.columns)


def test_a_row_is_the_run_with_its_seed(swept: pd.DataFrame, hunt: Result) -> None:
    row = swept[(swept["hunters"] == 2) & (swept["seed"] == 7)].iloc[0]
    assert row["eventHash"] == hunt.event_hash
    for name, value in hunt.metrics.items():
        assert row[name] == value


def test_the_same_call_resumes_what_was_interrupted(
    swept: pd.DataFrame, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows = folder / "hunt" / "rows.jsonl"
    lines = rows.read_text(encoding="utf-8").splitlines(keepends=True)
    rows.write_text("".join(lines[:3]) + lines[3][:40], encoding="utf-8")  # the last run was cut off
    assert len(rsal.rows(folder / "hunt")) == 3
    again = rsal.sweep("hunt-and-prey", out=folder / "hunt", **_SWEEP)
    pd.testing.assert_frame_equal(again.drop(columns="wallSeconds"), swept.drop(columns="wallSeconds"))
    assert "4 of 4 runs" in capsys.readouterr().err


def test_the_report_and_the_table_agree_to_the_digit(swept: pd.DataFrame) -> None:
    report = rsal.report(swept)
    tables = report.tables()
    assert report.page.is_file()
    assert {"outcomes", "capturetime", "capturedistance", "collisions"} <= set(tables)
    compared = 0
    for metric in ("captureTime", "captureDistance", "wallCollisions", "collisions"):
        table = tables[metric.lower()].set_index("combination")
        for hunters, group in swept.groupby("hunters"):
            values = group[metric].dropna()
            shown = table.loc[f"hunters={hunters}"]
            assert shown["n"] == len(values)
            if len(values):
                assert float(shown["mean"]) == values.mean()
                compared += 1
    assert compared == 8
    outcomes = tables["outcomes"]
    assert outcomes["count"].tolist() == swept.groupby("hunters")["outcome"].value_counts().tolist()


def test_another_sweep_in_the_same_folder_is_refused(swept: pd.DataFrame) -> None:
    with pytest.raises(CommandFailed, match="hunt"):
        rsal.sweep("hunt-and-prey", out=swept.attrs["folder"], seeds=2, progress=False)


def test_a_single_value_counts_as_one(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    words: list[str] = []
    monkeypatch.setattr(_sweeps, "call", lambda given, **_: words.extend(given))
    monkeypatch.setattr(_sweeps, "rows", lambda _: None)
    vary = {"assignment": "fixed", "hunters": 3, "prey": np.int64(2), "speed": np.array([0.5, 1.0])}
    rsal.sweep("hunt-and-prey", out=tmp_path, vary=vary, seeds=np.int64(3), progress=False)
    assert [each for each in words if "=" in each] == ["assignment=fixed", "hunters=3", "prey=2", "speed=0.5,1.0"]
    assert words[words.index("--seeds") + 1] == "1:3"


@pytest.mark.parametrize("seeds", [0, [], [1, 3], [3, 2], 2.5, "ab", np.int64(0)])
def test_seeds_must_be_consecutive(seeds: Any, folder: Path) -> None:
    with pytest.raises(rsal.RsalError, match="seeds is"):
        rsal.sweep("hunt-and-prey", out=folder / "none", seeds=seeds)


def test_values_must_be_there(folder: Path) -> None:
    with pytest.raises(rsal.RsalError, match=r"vary\['hunters'\]"):
        rsal.sweep("hunt-and-prey", out=folder / "none", vary={"hunters": []})


def test_a_folder_without_rows_is_an_error(folder: Path) -> None:
    with pytest.raises(rsal.RsalError, match="rsal sweep --out"):
        rsal.rows(folder / "none")
