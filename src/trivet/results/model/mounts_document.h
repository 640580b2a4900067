// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/project/project.h"

namespace trivet::results {

/// The elements of a machine as a data sheet lists them, equal ones in one row: static stiffness along the axes of
/// end K, dynamic stiffness and loss factor at 10 Hz, maker's mount, and the load, deflection and utilisation at rest.
[[nodiscard]] documents::Document mounts_document(const project::Case& variant);

}  // namespace trivet::results
