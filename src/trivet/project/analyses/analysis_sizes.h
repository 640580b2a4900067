// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"

/// Cost of analyses, estimated before any computation: curves, points, memory and time.
namespace trivet::project {

/// Most free coordinates of a system, as of three hundred free bodies: modes take six seconds and two gigabytes then,
/// and the time grows with the third power of the number.
inline constexpr std::size_t most_coordinates = 1800;

/// The same if the lowest modes suffice: a thousand free bodies. The matrices take two gigabytes.
inline constexpr std::size_t most_coordinates_of_lowest_modes = 6000;

/// Number of modes computed where only a response at given frequencies is requested: the second solver checks it at
/// their frequencies.
inline constexpr int modes_beside_a_response = 20;

/// True if only a number of the lowest modes is requested, and nothing that needs the others: at most a response at
/// given frequencies.
[[nodiscard]] bool lowest_modes_suffice(const Analyses& request);

/// The same for analyses that were measured up to this size only: all but modes, roots, static results, response, peaks
/// and those marked `of_large_systems`.
inline constexpr std::size_t most_coordinates_of_others = 600;

/// Most coordinates with those that represent frequency-dependent laws in modes and roots: 21 per direction of a
/// fractional law, 126 for a mount with such a law in all six directions.
inline constexpr std::size_t most_with_laws = 2000;

/// Most curves of one analysis: tables, figures and a page of more curves are useless.
inline constexpr std::size_t most_curves = 2000;

/// Most bodies, elements and excitations in all cases of a file together: each takes about ten kilobytes.
inline constexpr std::size_t most_parts_of_cases = 50'000;

/// Number of coordinates of bodies, elements with inner coordinates and foundations.
/// @param with_laws  also those that represent frequency-dependent laws in modes and roots
[[nodiscard]] std::size_t coordinates(const model::Description& description, bool with_laws = false);

/// An error for each analysis that is too large for this program, with its size, the limit and what to do.
[[nodiscard]] foundation::Problems too_large(const model::Description& description, const Analyses& request);

/// Number of frequencies at which a second solver in extended precision checks a system of this size: 64 for small
/// systems, fewer if each takes seconds.
[[nodiscard]] int deep_check_frequencies(Eigen::Index coordinates);

}  // namespace trivet::project
