// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/documents/document.h"
#include "trivet/project/project.h"

/// What the laws of elements and their damping assume, in words; docs/elements/README.md has the same sentences.
namespace trivet::results {

struct LawAssumption {
  const char *law, *words;
};
/// Of all types of elements, "beam", "catalogue:NAME", then of all kinds of damping and of nonlinear laws.
[[nodiscard]] std::vector<LawAssumption> law_assumptions();

/// Each type of elements, each kind of damping and other law that a machine has, with its elements and what it assumes.
[[nodiscard]] documents::Document assumptions_document(const project::Case& variant);

}  // namespace trivet::results
