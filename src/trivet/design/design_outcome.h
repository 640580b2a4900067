// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "trivet/design/design_rules.h"

namespace trivet::design {

/// One rule of a map, as shown to the user.
struct MapRule {
  DesignRule::Kind kind = DesignRule::Kind::amplitude;
  std::string channel;                ///< "aggregate.rz"
  std::string unit;                   ///< SI unit of the result
  double allowed = 0;                 ///< amplitude [SI], or relative prominence
  std::string words;                  ///< of data: "aggregate.rz ≤ 0.08 rad", "no peak of aggregate.rz"
  std::string requirement = {};       ///< kind of a requirement: "damping_ratio"
  std::string words_for_people = {};  ///< of a requirement, at the level that people read, without a further case
  std::string level = {};             ///< of a requirement in data: "0-p", "rms" or empty
  std::string shown_level = {};       ///< that people read, with values times `shown_factor`
  double shown_factor = 1;
  std::string in_case = {};  ///< a further case in which it is judged; its words name that case too

  /// Notes a further case and names it in the words.
  void set_case(const std::string& name);
  void unset_case();
  /// The words with the bound at the level that people read, if it has one.
  [[nodiscard]] std::string stated() const {
    return words_for_people.empty() ? words : words_for_people + case_words();
  }
  [[nodiscard]] std::string case_words() const;  ///< " in case \"soft\"", empty in the case of the map
};

/// Values of the two parameters, in the units of the axes.
struct DesignPoint {
  double x = 0, y = 0;
};

/// All that a map stores for a design.
struct DesignOutcome {
  static constexpr std::uint8_t no_model = 255, not_computed = 254;
  static constexpr std::size_t most_rules = 250;
  float margin = 0;                ///< of the governing rule, 1 on its limit; 0 without a model
  std::uint8_t governing = 0;      ///< the rule with the least margin, or `no_model` or `not_computed`
  std::uint8_t modes_in_band = 0;  ///< undamped natural frequencies in the band of the amplitudes
  std::uint16_t modes_below = 0;   ///< below that band; both 0 if the band has an open end or no amplitude has a limit

  [[nodiscard]] int modes_up_to() const { return modes_below + modes_in_band; }
  [[nodiscard]] bool known() const { return governing < not_computed; }
  [[nodiscard]] bool feasible() const { return known() && margin >= 1; }
};

/// A margin as it is stored: rounded, but on the same side of 1.
[[nodiscard]] float rounded_margin(double margin);

/// One kind of reason why designs have no outcome: messages that differ only in their numbers are one kind.
struct MissingReason {
  std::string words;  ///< with the numbers of the first such design
  std::size_t designs = 0;
  std::size_t first = 0;  ///< index of that design
};

/// One design with all its results.
struct JudgedDesign {
  RuleValues rules;
  std::vector<double> margins;  ///< of each rule
  Governing governing;
  response::Peaks peaks;                            ///< peaks of the results that have rules
  std::vector<double> natural_frequencies_squared;  ///< undamped [rad²/s²]; negative for an unstable motion
};

/// How designs were evaluated, for the user.
struct EvaluationReport {
  std::size_t proven = 0;    ///< designs judged by poles and residues, many at once
  std::size_t fallback = 0;  ///< designs whose fast result was not certain: judged again with the poles of an
                             ///< eigensolver, or by bounds on discs free of poles
  std::size_t assembled_separately = 0;  ///< designs assembled from the changed project and searched separately
  std::string family;                    ///< how the matrices of the proven and fallback designs were interpolated
  std::string no_family;                 ///< why they could not be interpolated; otherwise empty
  std::size_t with_requirements = 0;     ///< designs assembled separately for their requirements
  std::vector<std::string> further;      ///< how requirements and designs of further cases were judged
  std::vector<MissingReason> missing;

  [[nodiscard]] std::string summary() const;
};

/// A message with its numbers replaced by "#": equal for messages of one kind. Digits in a word ("mount2") remain.
[[nodiscard]] std::string without_numbers(const std::string& message);

struct EvaluationOptions {
  int threads = 0;   ///< 0: as many as the machine has
  bool fast = true;  ///< false: every design is assembled and searched separately
};

}  // namespace trivet::design
