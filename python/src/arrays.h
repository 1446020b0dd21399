// SPDX-License-Identifier: MIT
/// NumPy arrays of the library's numbers.
#pragma once
#include <freshet/error.h>
#include <pybind11/numpy.h>

#include <span>
#include <vector>

namespace freshet::python {

namespace py = pybind11;

/// A read-only array over memory that `owner` keeps alive, n numbers or rows of `width` numbers.
template <class T> py::array array_over(std::span<const T> numbers, int width, py::handle owner) {
  std::vector<py::ssize_t> shape{py::ssize_t(numbers.size())};
  if (width > 0) shape = {shape[0] / width, width};
  py::array_t<T> array(std::move(shape), numbers.data(), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// An array with numbers of its own.
template <class T> py::array array_of(std::span<const T> numbers, int width = 0) {
  std::vector<py::ssize_t> shape{py::ssize_t(numbers.size())};
  if (width > 0) shape = {shape[0] / width, width};
  return py::array_t<T>(std::move(shape), numbers.data());
}
inline py::array array_of(const std::vector<double>& numbers) {
  return array_of(std::span<const double>(numbers));
}

/// (severity, place, message) of each.
py::list diagnostics_list(const std::vector<Diagnostic>& diagnostics);

}  // namespace freshet::python
