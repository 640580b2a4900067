// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/symbol_table.h"

/// Keys that change a part as described, with all else unchanged (docs/project-file.md, "Adjustments").
namespace trivet::project {

/// `stiffness_factor`, `damping_factor` and `moved` of an element whose other keys are read.
/// @param complete  it was read without an error, so what it lacks does not exist
void read_element_adjustments(TableReader& reader, const model::Element& element, bool complete, SymbolTable& symbols);

/// `mass_about_center`, `center_moved` and `inertia_about_center` of a body. @param index  of the body in the
/// description
void read_body_adjustments(TableReader& reader, const model::Body& body, std::size_t index, SymbolTable& symbols);

/// `modal_factor` of the damping of the system.
void read_damping_adjustment(TableReader& reader, SymbolTable& symbols);

}  // namespace trivet::project
