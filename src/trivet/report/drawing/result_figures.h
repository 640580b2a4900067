// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/report/drawing/figures.h"
#include "trivet/response/transient/transient.h"
#include "trivet/study/analyses/case_results.h"

/// The figures of each kind of result; empty if the case did not request it.
namespace trivet::report {

/// Power spectral densities per hertz, one figure per body, point or element.
[[nodiscard]] std::vector<Figure> random_figures(const study::CaseResults& results);

/// Measured levels of bands of the excitations, with the limits in the same bands and quantity.
[[nodiscard]] std::vector<Figure> band_level_figures(const project::Case& variant, const study::CaseResults& results);

/// Time histories, one figure per body, point or element, with extremes marked.
[[nodiscard]] std::vector<Figure> transient_figures(const study::CaseResults& results);

/// Amplitudes over shaft speed for each order and in total, grouped the same way; the Campbell diagram; a waterfall of
/// the highest curve.
[[nodiscard]] std::vector<Figure> run_up_figures(const study::CaseResults& results);
[[nodiscard]] std::vector<Figure> campbell_figures(const study::CaseResults& results);
[[nodiscard]] std::vector<Figure> waterfall_figures(const study::CaseResults& results);

/// Level in dB over frequency, with the crossover to isolation marked.
[[nodiscard]] std::vector<Figure> transmissibility_figures(const study::CaseResults& results);

/// Mean power into the ground at each mount and in total.
[[nodiscard]] std::vector<Figure> power_figures(const study::CaseResults& results);

/// Periodic motions of nonlinear machines, one figure per result: stable, unstable, jumps and harmonics.
[[nodiscard]] std::vector<Figure> steady_figures(const study::CaseResults& results);
/// Paths of bodies and points over one period, in the stable motion with the largest range and before and after jumps;
/// of one coordinate alone, its velocity over it.
[[nodiscard]] std::vector<Figure> orbit_figures(const study::CaseResults& results);
[[nodiscard]] std::vector<Figure> backbone_figures(const study::CaseResults& results);

/// Shock response spectra, one figure per excitation.
[[nodiscard]] std::vector<Figure> shock_figures(const study::CaseResults& results);

/// Root mean squares that a line over bands allows in each of them, times a factor.
[[nodiscard]] std::vector<double> limits_in_bands(const study::LimitLineResult& found, double factor);

/// Channels with their limit lines, exceeded bands shaded.
[[nodiscard]] std::vector<Figure> limit_figures(const study::CaseResults& results);

/// Measured amplitudes and phases over the computed ones.
[[nodiscard]] std::vector<Figure> measurement_figures(const study::CaseResults& results);

/// Operating deflection shapes in three views and an isometric one, at rest and at the largest excursion.
[[nodiscard]] std::vector<Figure> shape_figures(const project::Case& variant, const study::CaseResults& results);
/// The lowest modes, rigid-body ones excepted, each in the view in which it moves most.
[[nodiscard]] std::vector<Figure> mode_figures(const project::Case& variant, const study::CaseResults& results);

/// Map of the rules of a project over two of its numbers.
[[nodiscard]] std::vector<Figure> map_figures(const study::CaseResults& results);

/// Is a curve only round-off, below 1e-9 of the largest curve of its unit?
[[nodiscard]] bool is_round_off(const response::TransientResponse& transient, const response::TimeCurve& curve);

/// Largest finite value, at least 0. An undamped resonance is infinite.
[[nodiscard]] double highest_finite(const Eigen::VectorXd& values);

/// "Power of pump" or, in a named case, "Power of pump, stiff mounts".
[[nodiscard]] inline std::string case_title(const std::string& what, const study::CaseResults& results) {
  return results.case_name.empty() ? what : what + ", " + results.case_name;
}

/// The machine of [analyses.optimize] over the given one, if places, shapes or masses differ.
[[nodiscard]] std::vector<Figure> best_design_figures(const project::Case& variant, const study::CaseResults& results);

/// The bands of the designs within tolerances, the shares of the variance, and kept designs as lines.
[[nodiscard]] std::vector<Figure> sample_figures(const study::CaseResults& results);

/// The front of two results.
[[nodiscard]] std::vector<Figure> front_figures(const study::CaseResults& results);

}  // namespace trivet::report
