// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"

/// Bodies that their weight tilts: docs/theory.md, "Forces at rest".
namespace trivet::plausibility {

/// A body that tilts about a horizontal axis while all else follows in equilibrium.
struct Tilting {
  std::size_t body = 0;
  double overturning = 0;  ///< moment of the forces at rest per angle [N m/rad]; negative: the body hangs
  double restoring = 0;    ///< moment of the elements per angle, to first order [N m/rad]
  double height = 0;       ///< of the centre of mass over the pole, against gravity [m]
  double standing = 0;     ///< height from which it falls over [m]
};

/// The body whose weight makes the machine fall over: its stiffness is not positive, but that of the first order is.
[[nodiscard]] std::optional<Tilting> falling_body(const model::System& system, const assembly::Assembled& assembled);

/// "falls over: …", with its moments and the height at which it stands.
[[nodiscard]] std::string falling_words(const model::System& system, const Tilting& tilting);

/// Share of the tilting stiffness that gravity may take before it is reported: the tilting frequency is then 13 %
/// lower.
inline constexpr double worth_a_word = 0.25;

/// Notes on bodies so high above their mounts that gravity takes more than a share of the tilting stiffness, one
/// sentence per body.
[[nodiscard]] std::vector<std::string> overturning_notes(const model::System& system,
                                                         const assembly::Assembled& assembled,
                                                         double from_share = worth_a_word);

/// Where the weight acts to first order only: as requested, on bodies that it moves without end, in taut beams.
[[nodiscard]] std::vector<std::string> first_order_notes(const model::System& system,
                                                         const assembly::Assembled& assembled);

}  // namespace trivet::plausibility
