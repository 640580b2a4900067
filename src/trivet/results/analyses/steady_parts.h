// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/results/format/axis_words.h"

/// Parts of the document of steady motions (steady_document.cpp).
namespace trivet::results {

/// A motion with its curve: 0 is the connected one, others are numbered as further ones.
struct PointOfCurve {
  std::size_t number;
  const nonlinear::SteadyBranch* curve;
  const nonlinear::SteadyPoint* point;
};
/// All points of a list of each curve: `points`, or `at`.
[[nodiscard]] std::vector<PointOfCurve> points_of_curves(
    const nonlinear::SteadyBranch& branch, std::vector<nonlinear::SteadyPoint> nonlinear::SteadyBranch::* list);

/// A line for each motion, and its numbers for programs and people.
[[nodiscard]] Table steady_points(const nonlinear::SteadyBranch& branch, std::vector<PointOfCurve> points);
/// Points, folds and changes of one curve for programs; its changes also for people.
[[nodiscard]] Group followed_curve(const nonlinear::SteadyBranch& branch, const nonlinear::SteadyBranch& curve);

/// Harmonics of all motions found at the parameters that were requested (`trivet steady --at`): for people, and CSV.
void add_harmonics(const nonlinear::SteadyBranch& branch, Document& document);
[[nodiscard]] Json harmonics_json(const nonlinear::SteadyBranch& branch);

/// Curves that were sought, or begin where another one loses its stability.
void add_further_curves(const nonlinear::SteadyBranch& branch, Document& document);
[[nodiscard]] Table further_points(const nonlinear::SteadyBranch& branch);
/// Where motions jump, and stretches without known stable ones.
void add_jumps(const nonlinear::SteadyBranch& branch, Document& document);
/// "rising frequency"
[[nodiscard]] std::string jump_of(const nonlinear::SteadyBranch& curve, const nonlinear::Fold& fold);

[[nodiscard]] std::ptrdiff_t unstable_points(const nonlinear::SteadyBranch& curve);
[[nodiscard]] std::ptrdiff_t uncertain_points(const nonlinear::SteadyBranch& curve);
/// Is it stable: "yes", "no" or "uncertain".
[[nodiscard]] const char* stability_word(const nonlinear::SteadyPoint& point);

/// The parameter of a curve: kind and options of its column, and a quantity.
[[nodiscard]] Kind varied_kind(const nonlinear::SteadyBranch& branch);
[[nodiscard]] ColumnOptions varied_options(const nonlinear::SteadyBranch& branch, int digits);
[[nodiscard]] Quantity varied_quantity(const nonlinear::SteadyBranch& branch, double parameter, int digits);

[[nodiscard]] inline Sentence steady_item(std::vector<std::variant<std::string, Quantity>> parts) {
  return {.parts = std::move(parts), .place = Sentence::Place::item};
}

}  // namespace trivet::results
