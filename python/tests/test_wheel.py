# SPDX-License-Identifier: MIT
"""The wheel in a fresh virtual environment, without network."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import freshet

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def wheel():
    for module in ("build", "setuptools", "wheel"):
        pytest.importorskip(module, reason=f"{module} is not installed")
    command = [ROOT / "python" / "build_wheel", os.environ["FRESHET_BUILD"]]
    env = {**os.environ, "PYTHON": sys.executable}
    made = subprocess.run(command, check=True, capture_output=True, text=True, env=env)
    return ROOT / made.stdout.strip().splitlines()[-1]


def test_the_wheel_holds_the_package(wheel):
    names = zipfile.ZipFile(wheel).namelist()
    for name in ("__init__.py", "py.typed", "_freshet.pyi", "scene_classes.py"):
        assert f"freshet/{name}" in names
    assert "freshet/share/scenes/dam_break_2d.toml" in names
    assert f"freshet-{freshet.__version__}-" in wheel.name and "linux" in wheel.name


def test_the_wheel_runs_in_a_fresh_environment(wheel, tmp_path):
    pytest.importorskip("ensurepip", reason="python3-venv is not installed")
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "v"], check=True)
    python = tmp_path / "v" / "bin" / "python"
    install = [python, "-m", "pip", "install", "--no-index", "--no-deps", "--quiet", wheel]
    subprocess.run(install, check=True)
    script = (
        "import freshet; assert 'site-packages' in freshet.__file__, freshet.__file__\n"
        "sim = freshet.Simulation('dam_break_2d', threads=1); sim.step(20); print(sim.state_sha256())"
    )
    env = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run(
        [python, "-c", script], check=True, capture_output=True, text=True, env=env, cwd=tmp_path
    )
    simulation = freshet.Simulation("dam_break_2d", threads=1)
    simulation.step(20)
    assert done.stdout.strip() == simulation.state_sha256()
