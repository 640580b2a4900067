// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/response/sensitivity/peak_shares.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/explain/stated_words.h"

namespace trivet::study {

// Explains the peaks of a case: the modes that cause them, the elements that store their energy, and the parameters
// that change them.

struct ExplainRequest {
  std::vector<std::string> of;  ///< channels as in `peaks`; empty: those of the case's peaks (or response)
  int most =
      10;  ///< number of peaks explained, the highest relative to their curve; round-off of a symmetry is no peak
};

/// Effect of ten per cent more of one parameter on a peak.
struct Trial {
  std::string parameter;  ///< name
  std::string words;      ///< "the axial stiffness of \"front spring\""
  double amount = 0.1;
  std::optional<double> predicted_amplitude, predicted_angular_frequency;  ///< to first order
  std::optional<double> amplitude,
      angular_frequency;  ///< of the changed model, recomputed; none if it has no such peak
};

struct ExplainedPeak {
  std::string name, unit;
  response::Peak peak;
  response::PeakShares shares;
  std::vector<response::Sensitivity> sensitivities;  ///< strongest first, by the effect of `size` of the parameter on
                                                     ///< the height (on the frequency if unbounded)
  std::vector<std::string> notes;
  std::optional<Trial>
      trial;  ///< on the stiffness with most of the strain energy, or if that has no effect, on that with the most
  StatedWords sentence;
};

struct Explanation {
  std::vector<response::Parameter> parameters;
  std::vector<ExplainedPeak> peaks;  ///< by curve, then ascending
  int left_out = 0;                  ///< number of further peaks beyond `most`
  modal::Modes modes;
  foundation::Problems warnings;
  std::vector<std::string> notes;  ///< of a nonlinear machine: the tangents of its laws at rest
};

/// @throws foundation::InvalidInput for a channel that the model does not have, NotComputable without excitation
[[nodiscard]] Explanation explanation(const project::Case& variant, const ExplainRequest& request = {},
                                      const foundation::Progress& progress = {});

/// A value with a suitable SI prefix: "8.4 mm", "1.2 kN", "35 µrad".
[[nodiscard]] std::string value_words(double value, const std::string& unit);

/// "machine.x: 8.4 mm at 2.77 rad/s (0.441 Hz). Mode 2, rotation about x, contributes 93 % of it. …"
[[nodiscard]] StatedWords sentence(const project::Case& variant, const Explanation& explanation,
                                   const ExplainedPeak& peak);

}  // namespace trivet::study
