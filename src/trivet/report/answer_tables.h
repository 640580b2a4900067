// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/answers.h"

/// Key numbers of each kind of answer as HTML; empty if the case did not request it.
namespace trivet::report {

/// rms, 3σ, zero crossings, weighted rms, and the shares of the inputs in the variance.
[[nodiscard]] std::string random_table(const study::Answers& answers);

/// Extremes with their times.
[[nodiscard]] std::string transient_table(const study::Answers& answers);

/// Critical speeds, and below them the interference points.
[[nodiscard]] std::string run_up_tables(const study::Answers& answers);

/// Highest level, crossover, and isolation at the end of the band.
[[nodiscard]] std::string transmissibility_table(const study::Answers& answers);

/// Folds and largest motions of nonlinear machines.
[[nodiscard]] std::string steady_tables(const study::Answers& answers);
[[nodiscard]] std::string backbone_tables(const study::Answers& answers);

/// Largest power at each mount.
[[nodiscard]] std::string power_table(const study::Answers& answers);

[[nodiscard]] std::string shock_table(const study::Answers& answers);

/// Estimated maxima, and the modes used for them.
[[nodiscard]] std::string earthquake_tables(const study::Answers& answers);

/// Least margins and exceeded bands.
[[nodiscard]] std::string limit_line_table(const study::Answers& answers);

/// Differences of measured and computed curves, peaks and mode shapes.
[[nodiscard]] std::string measurement_tables(const study::Answers& answers);

/// Governing rules of a map, its best design, and the verdict on every case.
[[nodiscard]] std::string map_tables(const study::Answers& answers);

/// The best design: parameters, minimised amplitudes, requirements, and what holds it.
[[nodiscard]] std::string optimum_tables(const study::Answers& answers);

/// The points of a front.
[[nodiscard]] std::string front_tables(const study::Answers& answers);

[[nodiscard]] std::string load_sharing_table(const study::Answers& answers);

}  // namespace trivet::report
