from __future__ import annotations

import signal
import subprocess
import threading

import pytest

import rsal
from rsal.studies import CommandFailed, Result, RunFailed, _command


def test_a_run_has_the_hash_and_metrics_of_the_command_line(hunt: Result) -> None:
    assert hunt.event_hash.startswith("3135ee5f")
    assert (hunt.scenario, hunt.configuration, hunt.seed) == ("hunt-and-prey", "virtual", 7)
    assert hunt.ok
    assert hunt.outcome == "success"
    assert hunt.metrics["captureTime"] == 42.6
    assert hunt.arguments["hunters"] == 2
    assert list(hunt.end_poses) == ["prey-1", "hunter-1", "hunter-2"]
    assert hunt.end_poses["prey-1"].x == hunt.json["endPoses"]["prey-1"]["x"]


def test_a_run_shows_itself_in_notebooks(hunt: Result) -> None:
    html = hunt._repr_html_()
    assert "hunt-and-prey:virtual" in html
    assert "<td>captureTime</td><td>42.6</td>" in html


def test_a_run_is_printed_in_a_few_lines(hunt: Result) -> None:
    lines = repr(hunt).splitlines()
    assert lines[0] == "<Result hunt-and-prey:virtual, seed 7: success at 52.6 s, event hash 3135ee5f"
    assert "  captureTime: 42.6" in lines
    assert len(lines) == 1 + len(hunt.metrics)


def test_what_ends_too_early_is_a_result_and_with_check_an_exception() -> None:
    with pytest.raises(RunFailed, match=r"'hunt-and-prey:virtual' with seed 3 ended with '\w+' at 1.0 s") as failed:
        rsal.run("hunt-and-prey", seed=3, seconds=1, check=True, hunters=1)
    assert not failed.value.result.ok
    assert failed.value.result.arguments["hunters"] == 1


def test_a_wrong_argument_is_an_exception_with_the_words_of_the_command() -> None:
    with pytest.raises(CommandFailed, match="hunterz") as failed:
        rsal.run("hunt-and-prey", hunterz=3)
    assert failed.value.code == 3
    assert "--set" in failed.value.command


def test_an_interrupt_ends_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[subprocess.Popen[bytes]] = []
    start = _command.start

    def remember(*arguments: object, **options: object) -> subprocess.Popen[bytes]:
        started.append(start(*arguments, **options))  # type: ignore[arg-type]
        return started[-1]

    monkeypatch.setattr(_command, "start", remember)
    threading.Timer(1.0, signal.raise_signal, [signal.SIGINT]).start()
    with pytest.raises(KeyboardInterrupt):
        rsal.run("patrol", seconds=1e6)
    assert started[0].poll() is not None


def test_numbers_of_numpy_are_numbers_for_the_command() -> None:
    import numpy as np  # noqa: PLC0415

    assert _command.settings({"a": np.float64(0.5), "b": np.int64(3), "c": True}) == [
        *("--set", "a=0.5"),
        *("--set", "b=3"),
        *("--set", "c=true"),
    ]
