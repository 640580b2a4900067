// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/limit_line.h"
#include "trivet/excitation/frequency_bands.h"

namespace trivet::project {

/// A channel with a limit line: of the response, or, in bands, of random vibration or of the orders of a machine.
struct LimitLineRequest {
  std::string of;
  assembly::LimitLine line;
  std::optional<excitation::BandWidth> bands = {};  ///< the line bounds the root mean square in each band
  std::vector<std::string> excitations = {};        ///< of a random vibration; empty: all
  std::string source = {};                          ///< the publication of a named line
};

}  // namespace trivet::project
