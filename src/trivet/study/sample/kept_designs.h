// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "trivet/study/sample/drawn_name.h"
#include "trivet/study/sample/file_unit.h"

namespace trivet::study {

/// A number of the model that tolerances move.
struct VariedNumber {
  std::string path;
  FileUnit unit;
  std::string si_unit;  ///< of its values; empty: a pure number
  double given = 0;     ///< in the file [SI]
  std::size_t tolerance = 0, place = 0;
  std::size_t draw = 0;  ///< the drawn number that moves it
  DrawnName drawn;       ///< its name
};

/// A design of a sample with its numbers and margins.
struct KeptDesign {
  enum class Reason { first, failing, extreme };

  std::uint64_t number = 0;
  Reason reason = Reason::first;                       ///< why it is kept
  bool has_least_margin = false, has_largest = false;  ///< of all designs
  std::vector<double> numbers;                         ///< of all varied numbers [SI]
  std::vector<double> margins;  ///< of all requirements of all cases, in their order; none: it could not be judged

  [[nodiscard]] bool is_judged() const { return !margins.empty(); }
  /// The requirement with the least margin, the first of equal ones; only of a judged design.
  [[nodiscard]] std::size_t governing() const;
  [[nodiscard]] bool is_met() const { return is_judged() && margins[governing()] >= 1; }
};

/// The first designs of a sample, which are a sample themselves, and the first later ones that do not meet all
/// requirements: by their numbers, so that they are the same for any threads and parts. And those with the least and
/// the largest least margin of all.
struct KeptDesigns {
  static constexpr std::uint64_t first = 400;  ///< all with a number below
  static constexpr std::size_t failing = 100;  ///< at most so many later ones that do not meet all requirements

  std::vector<VariedNumber> numbers;
  std::vector<KeptDesign> list;  ///< by their numbers
};

}  // namespace trivet::study
