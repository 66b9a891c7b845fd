from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

_NOTEBOOK = Path(__file__).parents[1] / "examples" / "study.ipynb"


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    """What each cell of code shows, after the notebook has run from top to bottom."""
    folder = tmp_path_factory.mktemp("notebook")
    shutil.copy(_NOTEBOOK, folder)
    notebook = nbformat.read(folder / _NOTEBOOK.name, as_version=4)
    NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(folder)}}).execute()
    (folder / "executed.ipynb").write_text(nbformat.writes(notebook), encoding="utf-8")
    return [
        {kind: data for output in cell.outputs for kind, data in output.get("data", {}).items()}
        for cell in notebook.cells
        if cell.cell_type == "code"
    ]


@pytest.mark.skipif(os.environ.get("RSAL_TEST_ALL") != "true", reason="runs by ./rsal test --all")
def test_it_runs_from_top_to_bottom(outputs: list[dict[str, Any]]) -> None:
    assert "3135ee5f" in outputs[0]["text/html"]
    assert outputs[1]["image/svg+xml"].startswith("<svg")
    assert "hunter-2" in outputs[2]["text/html"]
    assert "526 scans of" in outputs[3]["text/plain"]
    assert outputs[4]["text/html"].count("success") >= 5
    assert outputs[5]["image/png"]
    assert "Open the page" in outputs[6]["text/html"]
    assert "status='succeeded'" in outputs[6]["text/plain"]


def test_it_is_stored_without_outputs() -> None:
    notebook = nbformat.read(_NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    assert all(not cell.get("outputs") for cell in notebook.cells)
