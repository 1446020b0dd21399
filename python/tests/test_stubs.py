# SPDX-License-Identifier: MIT
"""The type stubs name what the module has, and the package type-checks."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

import freshet
from freshet import _freshet

PACKAGE = Path(freshet.__file__).parent


def test_the_stub_has_every_name_of_the_module():
    tree = ast.parse((PACKAGE / "_freshet.pyi").read_text(encoding="utf-8"))
    stub = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            stub[node.name] = {n.name for n in node.body if isinstance(n, ast.FunctionDef)} | {
                n.target.id for n in node.body if isinstance(n, ast.AnnAssign)
            }
        elif isinstance(node, ast.FunctionDef):
            stub[node.name] = set()
        elif isinstance(node, ast.AnnAssign):
            stub[node.target.id] = set()
    module = {name for name in vars(_freshet) if not name.startswith("__")}
    assert module == set(stub)
    for name in module:
        if isinstance(vars(_freshet)[name], type):
            members = {m for m in vars(vars(_freshet)[name]) if not m.startswith("__")}
            own = {m for m in stub[name] if not m.startswith("__")}
            assert members - {"_pybind11_conduit_v1_"} == own, name


def test_every_public_name_has_a_docstring():
    for name, value in vars(freshet).items():
        if not name.startswith("_") and callable(value):
            assert value.__doc__, name


def test_mypy():
    pytest.importorskip("mypy", reason="mypy is not installed")
    check = [sys.executable, "-m", "mypy", "--strict-optional", "-p", "freshet", "--no-error-summary"]
    env = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
    done = subprocess.run(
        [*check, "--ignore-missing-imports", "--cache-dir", os.devnull],
        capture_output=True, text=True, env=env, cwd=PACKAGE.parent,
    )
    assert done.returncode == 0, done.stdout
