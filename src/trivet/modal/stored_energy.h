// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/modal/modes.h"

/// Where the strain energy of a mode is, in words. Energies of elements with a negative stiffness, of struts under
/// compression or of weight above a mount are negative: then shares of the sum, Mode::strain_energy_share, exceed 1.
namespace trivet::modal {

/// Energy of every element over the sum of the positive ones: at most 1, negative where an element gives back. Empty as
/// the shares of the mode are, or if no element stores energy.
[[nodiscard]] Eigen::VectorXd stored_energy(const Mode& mode);

/// Energies of a mode or a vibration that are given back, over those that are stored, from which on words say so.
constexpr double noticeably_given_back = 0.005;

struct MostStrained {
  std::size_t element = 0;
  double share = 0;       ///< of what is stored, 0 … 1
  int alike = 0;          ///< further elements with the same share but for rounding
  double given_back = 0;  ///< by elements with negative energy, over what is stored, ≥ 0
};
/// The element with the most strain energy; none if `stored_energy` is empty.
[[nodiscard]] std::optional<MostStrained> most_strained(const Mode& mode);

/// ", 77 % of it given back" for a noticeable share; else empty.
[[nodiscard]] std::string given_back_words(double given_back);

}  // namespace trivet::modal
