// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

namespace trivet::python {

/// engine::Session as trivet._core.Project, and what needs no project.
void bind_project(nanobind::module_& module);

}  // namespace trivet::python
