# SPDX-License-Identifier: MIT
# Sets FRESHET_PYTHON_MODULE if the Python module can be built: Python's headers, pybind11 and NumPy.
option(FRESHET_PYTHON "Build the Python module if Python's headers, pybind11 and NumPy are found" ON)
set(FRESHET_PYTHON_MODULE OFF)
if(NOT FRESHET_PYTHON OR NOT FRESHET_RUN OR FRESHET_SANITIZE)  # a sanitizer must be linked to python3
  return()
endif()
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)  # Debian's packages are those of its python3
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.10 QUIET COMPONENTS Interpreter Development.Module NumPy)
if(Python_FOUND)
  find_package(pybind11 2.10 QUIET CONFIG)
endif()
if(pybind11_FOUND)
  set(FRESHET_PYTHON_MODULE ON)
else()
  message(STATUS "Python, pybind11 and NumPy are not all installed (python3-dev, pybind11-dev, python3-numpy): no Python module is built")
endif()
