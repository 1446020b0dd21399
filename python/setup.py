# SPDX-License-Identifier: MIT
"""Makes the wheel: CMake builds the package, and this copies it. python/build_wheel calls it.

FRESHET_BUILD names a build folder to take the module from. Without it, build/wheel is configured for
every instruction set.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent.parent


def version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"project\(freshet VERSION ([0-9.]+)", text)
    assert found
    return found[1]


def built() -> Path:
    """The package in a build folder, after CMake has built it."""
    folder = Path(os.environ.get("FRESHET_BUILD", ROOT / "build" / "wheel" / "cmake")).resolve()
    if not (folder / "CMakeCache.txt").exists():
        flags = ["-DFRESHET_TESTS=OFF", "-DFRESHET_BENCH=OFF", "-DFRESHET_VIEW=OFF"]
        python = f"-DPython_EXECUTABLE={sys.executable}"
        preset = ["--preset", "package", "-S", ROOT, "-B", folder]
        subprocess.run(["cmake", *preset, *flags, python], check=True, cwd=ROOT)
    targets = ["--target", "freshet_python", "freshet_python_files"]
    subprocess.run(["cmake", "--build", folder, *targets], check=True)
    return folder / "python" / "freshet"


class CMakeBuild(build_ext):
    """Puts the module, the Python files and the bundled scenes in place."""

    def run(self) -> None:
        package = Path(self.build_lib) / "freshet"
        shutil.rmtree(package, ignore_errors=True)
        shutil.copytree(built(), package, ignore=shutil.ignore_patterns("__pycache__"))
        for name in ("scenes", "validation"):
            shutil.copytree(ROOT / name, package / "share" / name)
        shutil.copy(ROOT / "LICENSE", package / "share" / "LICENSE")
        pybind11 = Path("/usr/share/doc/pybind11-dev/copyright")  # in the module, as headers
        if pybind11.exists():
            shutil.copy(pybind11, package / "share" / "LICENSE.pybind11")


setup(
    name="freshet",
    version=version(),
    description="Fluid simulator: smoothed particle hydrodynamics",
    license="MIT",
    python_requires=">=3.10",
    install_requires=["numpy"],
    extras_require={"plots": ["matplotlib"], "tables": ["pandas"], "progress": ["tqdm"]},
    ext_modules=[Extension("freshet._freshet", [])],
    cmdclass={"build_ext": CMakeBuild},
    zip_safe=False,
)
