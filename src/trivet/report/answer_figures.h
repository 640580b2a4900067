// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/report/figures.h"
#include "trivet/response/transient/transient.h"
#include "trivet/study/answers.h"

/// The figures of each kind of answer; none where the case did not ask for it.
namespace trivet::report {

/// Power spectral densities per hertz, one figure per body, point or element.
[[nodiscard]] std::vector<Figure> random_figures(const study::Answers& answers);

/// Time histories, likewise, extremes marked.
[[nodiscard]] std::vector<Figure> transient_figures(const study::Answers& answers);

/// Amplitudes over shaft speed for each order and together, likewise; then the Campbell diagram, then a waterfall of
/// the tallest curve.
[[nodiscard]] std::vector<Figure> run_up_figures(const study::Answers& answers);
[[nodiscard]] std::vector<Figure> campbell_figures(const study::Answers& answers);
[[nodiscard]] std::vector<Figure> waterfall_figures(const study::Answers& answers);

/// Level in dB over frequency, the crossover to isolation marked.
[[nodiscard]] std::vector<Figure> transmissibility_figures(const study::Answers& answers);

/// Mean power into the ground by each mount and in total.
[[nodiscard]] std::vector<Figure> power_figures(const study::Answers& answers);

/// Shock response spectra, one figure per excitation.
[[nodiscard]] std::vector<Figure> shock_figures(const study::Answers& answers);

/// Answers against their limit lines, what is exceeded shaded.
[[nodiscard]] std::vector<Figure> limit_figures(const study::Answers& answers);

/// Operating deflection shapes in three views and at an angle, at rest and when farthest from it.
[[nodiscard]] std::vector<Figure> shape_figures(const study::Answers& answers);

/// Two numbers of the project against its rules.
[[nodiscard]] std::vector<Figure> map_figures(const study::Answers& answers);

/// Nothing but round-off: 1e-9 of the largest curve of its unit.
[[nodiscard]] bool is_round_off(const response::TransientResponse& transient, const response::TimeCurve& curve);

/// Largest value that is finite; 0 if none is above. An undamped resonance is infinite.
[[nodiscard]] double highest_finite(const Eigen::VectorXd& values);

/// "Power of pump" or, in a named case, "Power of pump, stiff mounts".
[[nodiscard]] inline std::string case_title(const std::string& what, const study::Answers& answers) {
  return answers.case_name.empty() ? what : what + ", " + answers.case_name;
}

}  // namespace trivet::report
