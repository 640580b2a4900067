// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

namespace trivet::python {

/// The command line as a function, for the command `trivet` of the package.
void bind_command(nanobind::module_& module);

}  // namespace trivet::python
