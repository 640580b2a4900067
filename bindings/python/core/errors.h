// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <exception>
#include <utility>

#include "trivet/engine/program.h"

namespace trivet::python {

/// Problems of the input; trivet.InputError in Python.
struct WrongInput : std::exception {
  explicit WrongInput(foundation::Problems found) : problems(std::move(found)) {}
  [[nodiscard]] const char* what() const noexcept override { return "wrong input"; }
  foundation::Problems problems;
};

/// The value, or its problems as WrongInput.
template <typename T>
T value_or_throw(foundation::Expected<T>&& expected) {
  if (!expected) throw WrongInput(std::move(expected.error()));
  return std::move(*expected);
}

/// The problem with the word of Python for what the command line calls --set: the argument `changes`.
[[nodiscard]] foundation::Problem in_words_of_python(const foundation::Problem& problem);

void bind_errors(nanobind::module_& module);

}  // namespace trivet::python
