// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/optimize/design_front.h"
#include "trivet/study/optimize/optimization.h"

/// The best design and the front between several results, and their parts in words.
namespace trivet::results {

[[nodiscard]] Document optimization_document(const study::Optimization& found);
/// What was found: the objective, the parameters and the chosen mounts, without comparisons and the search.
[[nodiscard]] Document optimum_in_short(const study::Optimization& found);
[[nodiscard]] Document front_document(const study::DesignFront& front);

/// The best design, or the front, with the warnings of the command.
[[nodiscard]] std::string optimum_json(const study::CaseResults& results, const foundation::Problems& warnings);

/// The settings that give the optimum, or a point of the front: --set 'elements.mount.scale = 1.25', one per line.
[[nodiscard]] std::string optimization_settings(const study::Optimization& found);
[[nodiscard]] std::string front_settings(const study::DesignFront& front, std::size_t point);

/// Requirements, natural frequencies and decoupling of the given design beside those of the optimum, for people.
void add_comparison(const study::Optimization& found, Document& document);

/// "case hot: machine.z ≤ 1 mm". @param c  index of the case in `found.after`
[[nodiscard]] std::string words_in_case(const study::Optimization& found, std::size_t c, const std::string& words);

/// Results that are minimised.
[[nodiscard]] std::vector<std::string> minimized_names(const study::Optimization& found);

/// "-0.42 %": the change of the objective by a step of one parameter; "violates" if it breaks a requirement.
[[nodiscard]] std::string step_words(const std::optional<study::OptimizedParameter::Step>& step,
                                     const study::Optimization& found);

/// "Least margin of all requirements: 0.837 → 1.14"
[[nodiscard]] std::string objective_change(const study::Optimization& found);
/// What is judged of the best design, as a sentence; within tolerances of the machines that have them.
[[nodiscard]] std::string best_design_words(const study::Optimization& found);
/// The change of the objective and whether every requirement is met: "…: 0.837 → 1.14, every requirement is met"
[[nodiscard]] std::string optimization_headline(const study::Optimization& found);
/// The mounts that were chosen and the next best; empty without a choice of them.
[[nodiscard]] std::vector<std::string> mounts_lines(const study::Optimization& found);
/// The same for programs.
void add_mounts(const study::Optimization& found, Document& document);
/// How sure the search is.
[[nodiscard]] std::vector<std::string> search_lines(const study::Optimization& found);
/// "at the end of its range", "changes nothing here", or where the optimum is as good; often empty.
[[nodiscard]] std::string parameter_remark(const study::OptimizedParameter& parameter);

}  // namespace trivet::results
