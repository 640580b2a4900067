// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/stored_energy.h"

#include <cassert>

#include <fmt/format.h>

#include "trivet/foundation/index.h"

namespace trivet::modal {

Eigen::VectorXd stored_energy(const Mode& mode) {
  if (!mode.strain_energy_share || mode.strain_energy_share->size() == 0) return {};
  const double sign = mode.eigenvalue_squared < 0 ? -1 : 1;  // of the sum, over which the shares are
  const Eigen::VectorXd energies = sign * *mode.strain_energy_share;
  const double stored = energies.cwiseMax(0).sum();
  if (!(stored > 0)) return {};
  // The largest positive energy is one of the terms of their sum.
  assert(energies.maxCoeff() <= stored && "no element stores more than all together");
  return energies / stored;
}

std::optional<MostStrained> most_strained(const Mode& mode) {
  const Eigen::VectorXd energies = stored_energy(mode);
  if (energies.size() == 0) return std::nullopt;
  constexpr double same_share = 5e-4;
  Eigen::Index most = 0;
  const double share = energies.maxCoeff(&most);
  const auto alike = ((energies.array() - share).abs() < same_share).count() - 1;
  return MostStrained{to_size(most), share, static_cast<int>(alike), -energies.cwiseMin(0).sum()};
}

std::string given_back_words(double given_back) {
  return given_back < noticeably_given_back ? "" : fmt::format(", {:.3g} % of it given back", 100 * given_back);
}

}  // namespace trivet::modal
