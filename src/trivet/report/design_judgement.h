// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/report/shown_case.h"

namespace trivet::report {

/// A verdict on the design: of a requirement, a clearance, a limit, a limit line, the rules of a map, or the best
/// design.
struct Judgement {
  enum class Outcome {
    met,
    violated,
    not_judged,        ///< it could not be computed
    violated_no_need,  ///< violated in a case in which the design need not hold
  };
  Outcome outcome = Outcome::met;
  const char* kind = "requirement";  ///< of which there are several
  std::string words;                 ///< what is judged: "machine.z ≤ 0.5 mm"
  std::string finding;               ///< by how much and where, or why it is not judged
  double margin = 0;                 ///< 1 on the limit; of judged ones
  std::size_t shown_case = 0;        ///< index of its case
  bool decides = true;               ///< the design has to hold in this case
};

/// All verdicts of the page. A limit that is also a requirement of its case is listed once.
[[nodiscard]] std::vector<Judgement> judgements(const std::vector<ShownCase>& cases);

/// The box at the top of the page: red if any verdict is violated, amber if one is missing or a check of the data
/// failed, green if everything is met, and neither if the file requires nothing. It names the worst ones.
[[nodiscard]] std::string judgement_box(const std::vector<ShownCase>& cases);

}  // namespace trivet::report
