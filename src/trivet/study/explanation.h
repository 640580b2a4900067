// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/response/sensitivity/peak_shares.h"
#include "trivet/study/answers.h"

/// Why is this peak here? For the peaks of a case: who makes them, where their energy is, and what would change them.
namespace trivet::study {

struct ExplainRequest {
  std::vector<std::string> of;  ///< answers as in `peaks`; empty: those of the case's peaks (or response)
  int most =
      10;  ///< peaks explained, the tallest relative to their curve; peaks that are round-off of a symmetry never
};

/// What ten per cent more of one parameter do to a peak.
struct Trial {
  std::string parameter;  ///< its name
  std::string words;      ///< "the axial stiffness of \"front spring\""
  double amount = 0.1;
  std::optional<double> predicted_amplitude, predicted_angular_frequency;  ///< to first order
  std::optional<double> amplitude,
      angular_frequency;  ///< of the changed model, solved again; none if it has no such peak
};

struct ExplainedPeak {
  std::string name, unit;
  response::Peak peak;
  response::PeakShares shares;
  std::vector<response::Sensitivity> sensitivities;  ///< strongest first, by what `size` of the parameter does to the
                                                     ///< height (to the frequency where unbounded)
  std::vector<std::string> notes;
  std::optional<Trial>
      trial;  ///< of what holds most of the strain energy, or of what changes the peak most if that does nothing
  std::string sentence;
};

struct Explanation {
  std::vector<response::Parameter> parameters;
  std::vector<ExplainedPeak> peaks;  ///< by curve, then ascending
  int left_out = 0;                  ///< further peaks beyond `most`
  modal::Modes modes;
  foundation::Problems warnings;
};

/// @throws foundation::InvalidInput for an answer that the model does not have, NotComputable if nothing excites it
[[nodiscard]] Explanation explanation(const project::Case& variant, const ExplainRequest& request = {},
                                      const foundation::Progress& progress = {});

/// A value with the prefix that an engineer would choose: "8.4 mm", "1.2 kN", "35 µrad".
[[nodiscard]] std::string value_words(double value, const std::string& unit);

}  // namespace trivet::study
