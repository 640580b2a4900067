// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/select/mount_combinations.h"

namespace trivet::study {

/// The price of all catalogue mounts together, of any combination of the mounts that are chosen.
class MountPrices {
 public:
  /// @param variant  one of the cases of `all`
  /// @throws foundation::InvalidInput that names the mounts without a price, or with one in another currency
  MountPrices(const MountCombinations& all, const project::Case& variant);

  [[nodiscard]] model::Price of(std::size_t combination) const;

 private:
  const MountCombinations& all_;
  model::Price at_other_places_;             ///< of the mounts that stay
  std::vector<std::vector<double>> prices_;  ///< per choice and mount, at all its places
};

}  // namespace trivet::study
