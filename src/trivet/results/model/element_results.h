// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/explain/element_summary.h"
#include "trivet/study/explain/simplification.h"

namespace trivet::results {

/// One element: type, ends, how its law was determined, the 12×12 in its local frame (order N, K, scale included),
/// damping, checks, principal stiffnesses, elastic centre, energy, laws, uncertainty, and the effect of three springs
/// in its place if it is known.
[[nodiscard]] Document element_document(const project::Case& variant, std::size_t element,
                                        const study::ElementSummary& summary,
                                        const std::optional<study::Simplification>& simple);

// Its parts.

[[nodiscard]] Group damping_group(const model::Element& element);
/// Loops of its nonlinear laws, and its dynamic stiffness over the amplitude if it has nonlinear inner parts.
void add_law_loops(const study::ElementSummary& summary, const project::DisplayUnits& display, Document& document);
void add_uncertainty(const model::Element& element, Document& document);
/// Natural frequencies and highest peaks with the full elements and with three springs in their place.
[[nodiscard]] Group simplification_group(const study::Simplification& simple);

}  // namespace trivet::results
