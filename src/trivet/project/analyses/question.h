// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/assembly/channels.h"

namespace trivet::project {

/// Which answers of which quantity under which excitations.
struct AnswerSelection {
  std::vector<std::string> of = {"coordinates"};
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<std::string> excitations;  ///< empty: all

  bool operator==(const AnswerSelection&) const = default;
};

/// An independent question of [analyses] (question_table.h). Parts of `selection` that it does not use have their
/// defaults.
struct Question {
  AnswerSelection selection;
  virtual ~Question() = default;
};

/// A question about a band of frequencies. None: the study chooses one.
struct BandQuestion : Question {
  std::optional<assembly::Band> band;
};

}  // namespace trivet::project
