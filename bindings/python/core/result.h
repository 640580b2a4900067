// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

namespace trivet::python {

/// engine::Result as trivet._core.Result, and the units in which it can be shown.
void bind_result(nanobind::module_& module);

}  // namespace trivet::python
