"""The tutorials of the documentation, at small size.

``python python/tests/test_tutorials.py [NAME...]`` runs them at full size and stores what they show.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
from llvm import has_llvm

FOLDER = Path(__file__).parents[2] / "docs" / "tutorials"

NEEDS = {
    "first_gradient": (),
    "pose_and_colour": ("torch",),
    "shape_from_shadow": (),
    "beside_mitsuba": ("mitsuba",),
    "on_a_cluster": ("ray",),
}


def executed(path: Path) -> Any:
    """The notebook with all that it shows, in the order of its cells."""
    nbformat: Any = pytest.importorskip("nbformat")
    nbclient: Any = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    notebook = nbformat.read(path, as_version=4)
    client = nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3")
    return client.execute(cwd=str(path.parent))


@pytest.mark.parametrize("name", NEEDS)
def test_tutorial(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("matplotlib", *NEEDS[name]):
        pytest.importorskip(module)
    if name == "beside_mitsuba" and not has_llvm():
        pytest.skip("Mitsuba cannot render with LLVM here")
    monkeypatch.setenv("CAPWALK_SMALL", "1")
    executed(FOLDER / f"{name}.ipynb")


def test_all_tutorials_are_run() -> None:
    assert {path.stem for path in FOLDER.glob("*.ipynb")} == set(NEEDS)


def store(path: Path) -> None:
    """Runs a tutorial and stores what it shows, without what differs from run to run."""
    nbformat: Any = pytest.importorskip("nbformat")
    notebook = executed(path)
    for cell in notebook.cells:
        cell.metadata = {}
        if cell.cell_type == "code":
            cell.execution_count = None
            cell.outputs = _joined(cell.outputs)
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    path.write_text(nbformat.writes(notebook) + "\n", encoding="utf-8")


def _joined(outputs: list[Any]) -> list[Any]:
    """Outputs of a cell in which a stream is one text, however often it was flushed. What
    libraries say of their work, on the stream of errors or as Ray's log, is left out."""
    kept: list[Any] = []
    for output in outputs:
        if "execution_count" in output:
            output.execution_count = None
        if output.get("name") == "stderr" or "(raylet)" in output.get("text", ""):
            continue
        if output.output_type == "stream" and kept and kept[-1].output_type == "stream":
            kept[-1].text += output.text
        else:
            kept.append(output)
    return kept


if __name__ == "__main__":
    for name in sys.argv[1:] or NEEDS:
        store(FOLDER / f"{name}.ipynb")
