// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/assembly/channels.h"

namespace trivet::project {

/// Which channels, of which quantity, under which excitations.
struct ChannelSelection {
  std::vector<std::string> of = {"coordinates"};
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<std::string> excitations;  ///< empty: all

  bool operator==(const ChannelSelection&) const = default;
};

/// An independent analysis of [analyses] (analysis_table.h). Parts of `selection` that it does not use have their
/// defaults.
struct Analysis {
  ChannelSelection selection;
};

/// An analysis over a band of frequencies. None: the study chooses one.
struct BandAnalysis : Analysis {
  std::optional<assembly::Band> band;
};

}  // namespace trivet::project
