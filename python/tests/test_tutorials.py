"""The tutorials of the documentation, at small size; where the variable CAPWALK_THOROUGH is set, at full size
as well, and then they print what is stored.

``python python/tests/test_tutorials.py [NAME...]`` runs them at full size and stores what they show.
"""

from __future__ import annotations

import os
import re
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
    "shape_of_a_lens": (),
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


def skip_without_packages(name: str) -> None:
    for module in ("matplotlib", *NEEDS[name]):
        pytest.importorskip(module)
    if name == "beside_mitsuba" and not has_llvm():
        pytest.skip("Mitsuba cannot render with LLVM here")


@pytest.mark.parametrize("name", NEEDS)
def test_tutorial(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    skip_without_packages(name)
    monkeypatch.setenv("CAPWALK_SMALL", "1")
    executed(FOLDER / f"{name}.ipynb")


@pytest.mark.skipif("CAPWALK_THOROUGH" not in os.environ, reason="takes minutes (CAPWALK_THOROUGH)")
@pytest.mark.parametrize("name", NEEDS)
def test_stored_outputs_are_those_of_a_run(name: str) -> None:
    skip_without_packages(name)
    path = FOLDER / f"{name}.ipynb"
    nbformat: Any = pytest.importorskip("nbformat")
    stored, found = printed(nbformat.read(path, as_version=4)), printed(executed(path))
    stale = [
        f"cell {number} stores\n{old}\nbut prints\n{new}"
        for number, (old, new) in enumerate(zip(stored, found, strict=True))
        if not is_same(old, new)
    ]
    assert not stale, "\n\n".join([*stale, f"to store them: python python/tests/test_tutorials.py {name}"])


def printed(notebook: Any) -> list[str]:
    """What each cell prints, images as what stands for them in a terminal."""
    texts = []
    for cell in notebook.cells:
        outputs = _joined(cell.get("outputs", []))
        texts.append("\n".join(output.get("text") or output.data["text/plain"] for output in outputs))
    return texts


def is_same(stored: str, found: str) -> bool:
    """True if two texts have the same words, and numbers that differ by at most one in the last digit."""
    number = r"-?\d[\d,]*(?:\.\d+)?(?:e-?\d+)?"
    pairs = zip(re.findall(number, stored), re.findall(number, found), strict=False)
    close = all(abs(float(a) - float(b)) <= 1.01 * max(_last(a), _last(b)) for a, b in map(_plain, pairs))
    return close and re.split(number, stored) == re.split(number, found)


def _plain(pair: tuple[str, str]) -> tuple[str, str]:
    a, b = (text.replace(",", "") for text in pair)
    return a, b


def _last(number: str) -> float:
    """One in the last digit of a number."""
    digits, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))


def test_stale_numbers_are_found() -> None:
    assert is_same("standard error 0.113 a number", "standard error 0.114 a number")
    assert not is_same("standard error 0.113 a number", "standard error 0.115 a number")
    assert not is_same("method edges", "method walk")
    assert not is_same("mean 2.3e-05", "mean 2.6e-05")


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
