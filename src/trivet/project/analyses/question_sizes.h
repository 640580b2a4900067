// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"

/// What questions cost, estimated before any work begins: curves, points, memory and time.
namespace trivet::project {

/// Free coordinates that a system may have: dense eigenproblems of more take minutes to hours. A hundred free bodies
/// have as many.
inline constexpr std::size_t most_coordinates = 600;

/// The same with those that stand for laws of their own in modes and roots: 21 per direction of a fractional law, so
/// 126 of such a mount.
inline constexpr std::size_t most_with_laws = 2000;

/// Curves of one question: tables, figures and a page of more are read by nobody.
inline constexpr std::size_t most_curves = 2000;

/// Copies of bodies, elements and excitations that all cases of a file hold together: each costs some ten kilobytes.
inline constexpr std::size_t most_things_of_cases = 50'000;

/// Of bodies, elements with inner coordinates and foundations.
/// @param with_laws  also those that stand for frequency-dependent laws in modes and roots
[[nodiscard]] std::size_t coordinates(const model::Description& description, bool with_laws = false);

/// An error for each question that is too large for this program, with its size, the limit and what to do.
[[nodiscard]] foundation::Problems too_large(const model::Description& description, const Analyses& asked);

/// Frequencies at which a second solver in extended precision checks a system of so many coordinates: 64 for small
/// ones, fewer where each takes seconds.
[[nodiscard]] int deep_check_frequencies(Eigen::Index coordinates);

}  // namespace trivet::project
