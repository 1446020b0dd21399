# SPDX-License-Identifier: MIT
"""The examples run, and their results are right."""

import importlib
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest

import freshet

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
sys.path.insert(0, str(EXAMPLES))


def example(name, needs=None):
    if needs:
        pytest.importorskip(needs, reason=f"{needs} is not installed")
    return importlib.import_module(name)


def test_dam_break_front():
    # The spread of the experiment's own runs, and validation's bound.
    assert example("dam_break_front").main() < 0.05


def test_custom_force():
    # The mean force points to the attractor's path, which rises from (0.8, 0.5).
    momentum = example("custom_force").main()
    assert momentum[0] > 20 and momentum[1] > 20


def test_fit_viscosity():
    viscosity, difference = example("fit_viscosity", "scipy").main()
    assert 1 < viscosity < 1000 and difference < 0.003


def test_steered_body():
    assert example("steered_body").main() == pytest.approx(0.7, abs=0.03)


def test_to_pyvista():
    cloud = example("to_pyvista", "vtkmodules").main()
    assert cloud.GetNumberOfPoints() > 1000
    assert cloud.GetPointData().HasArray("pressure")


def test_sweep_spacing():
    done = subprocess.run(
        [sys.executable, EXAMPLES / "sweep_spacing.py"], check=True, capture_output=True, text=True
    )
    assert done.stdout.count("front [m]") == 3


def test_the_examples_of_the_manual_run():
    """Python blocks of docs/python.md, one after the other in a folder of their own."""
    manual = Path(__file__).resolve().parents[2] / "docs" / "python.md"
    blocks = [b.partition("```")[0] for b in manual.read_text(encoding="utf-8").split("```python\n")[1:]]
    assert len(blocks) >= 8
    before, names = os.getcwd(), {"freshet": freshet, "np": np}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for block in blocks:
                if "matplotlib" in block or "plot(" in block:
                    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
                exec(compile(block, "docs/python.md", "exec"), names)
        finally:
            os.chdir(before)


@pytest.mark.parametrize("name", ["article.ipynb", "article.zh-CN.ipynb"])
def test_notebooks(name, tmp_path):
    for module in ("nbformat", "nbclient", "ipykernel", "matplotlib"):
        pytest.importorskip(module, reason=f"{module} is not installed")
    import nbclient
    import nbformat

    book = nbformat.read(EXAMPLES / name, as_version=4)
    nbclient.NotebookClient(book, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [o for cell in book.cells if cell.cell_type == "code" for o in cell.outputs]
    assert any("digest 209739a4641c59b9" in o.get("text", "") for o in outputs)  # ArticleGolden's
    assert not any(o.output_type == "error" for o in outputs)
    assert sum("image/png" in o.get("data", {}) for o in outputs) >= 3


def test_the_notebooks_hold_no_output_and_the_same_code():
    books = [json.loads((EXAMPLES / n).read_text()) for n in ("article.ipynb", "article.zh-CN.ipynb")]
    code = [["".join(c["source"]) for c in b["cells"] if c["cell_type"] == "code"] for b in books]
    assert code[0] == code[1]
    for book in books:
        assert not any(c.get("outputs") for c in book["cells"] if c["cell_type"] == "code")
