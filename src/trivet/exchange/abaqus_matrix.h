// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/exchange/named_matrix.h"

namespace trivet::exchange {

/// Reads a matrix text (.mtx) of Abaqus or CalculiX:
/// – substructure matrix output: *USER ELEMENT with its nodes and components, then *MATRIX, TYPE=STIFFNESS;
/// – Abaqus matrix output in the form MATRIX INPUT: row node, row component, column node, column component, value.
/// @param type  of the requested *MATRIX: "stiffness", "mass", …
/// [Abaqus Keywords Guide, *MATRIX, *MATRIX OUTPUT; CalculiX User's Manual, *SUBSTRUCTURE MATRIX OUTPUT]
[[nodiscard]] foundation::Expected<NamedMatrix> read_abaqus_matrix(std::string_view text, const std::string& source,
                                                                   const std::string& type = "stiffness");

}  // namespace trivet::exchange
