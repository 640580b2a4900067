// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/response/steady/frequency_grid.h"

namespace trivet::project {

/// Which answers of which quantity under which excitations.
struct Wanted {
  std::vector<std::string> of = {"coordinates"};
  assembly::Quantity quantity = assembly::Quantity::displacement;
  std::vector<std::string> excitations;  ///< empty: all

  bool operator==(const Wanted&) const = default;
};

/// An independent question of [analyses] (question_table.h). Parts of `wanted` that it does not use have their
/// defaults.
struct Question {
  Wanted wanted;
  virtual ~Question() = default;
};

/// A question about a band of frequencies. None: the study chooses one.
struct BandQuestion : Question {
  std::optional<response::Band> band;
};

}  // namespace trivet::project
