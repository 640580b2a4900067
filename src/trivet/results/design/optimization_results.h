// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/study/optimize/optimization.h"

namespace trivet::results {

/// Parameters, requirements and natural frequencies of the given design beside those of the optimum, what holds it, and
/// how sure the search is.
[[nodiscard]] std::string optimization_text(const study::Optimization& found);
[[nodiscard]] std::string optimization_json(const study::Optimization& found, const foundation::Problems& warnings);
/// The settings that give the optimum: --set 'elements.mount.scale = 1.25', one per line.
[[nodiscard]] std::string optimization_settings(const study::Optimization& found);

/// Results that are minimised.
[[nodiscard]] std::vector<std::string> minimized_names(const study::Optimization& found);

/// "-0.42 %": the change of the objective by a step of one parameter; "violates" if it breaks a requirement.
[[nodiscard]] std::string step_words(const std::optional<study::OptimizedParameter::Step>& step,
                                     const study::Optimization& found);

/// The parts of the text that the report shows, too. The headline is one line: "Least margin of all requirements: 0.837
/// → 1.14, every requirement is met". The mounts (empty without a choice of them) and the search are lines.
[[nodiscard]] std::string optimization_headline(const study::Optimization& found);
[[nodiscard]] std::string optimization_mounts(const study::Optimization& found);
[[nodiscard]] std::string optimization_search(const study::Optimization& found);
/// "at the end of its range", "changes nothing here", or where the optimum is as good; often empty.
[[nodiscard]] std::string parameter_remark(const study::OptimizedParameter& parameter);

/// One row per parameter, values in its unit, and one per choice of mounts.
[[nodiscard]] std::string optimization_csv(const study::Optimization& found);

}  // namespace trivet::results
