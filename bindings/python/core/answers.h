// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

namespace trivet::python {

/// Answers to the questions of a notebook's widget, as `trivet serve` gives them: trivet._core.Answers.
void bind_answers(nanobind::module_& module);

}  // namespace trivet::python
