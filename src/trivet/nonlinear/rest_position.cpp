// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rest_position.h"

#include <fmt/format.h>

#include <optional>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/deflections.h"
#include "trivet/nonlinear/load_path.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<std::string> notes_about_rest(const model::System& system) {
  std::vector<std::string> notes;
  for (const model::Element& element : system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      if (notes.empty())
        notes.emplace_back("nonlinear machine: all but static, steady and backbone is for small motions about rest");
      const bool turns = part.axis >= 3;
      notes.push_back(fmt::format("{}: its laws have {:.4g} {} {} {} at rest, at a deflection of {:.4g} {}",
                                  element.name, elements::small_motion(part.laws, part.at_rest).stiffness,
                                  turns ? "N m/rad" : "N/m", turns ? "about" : "along", "xyz"[part.axis % 3],
                                  part.at_rest, turns ? "rad" : "m"));
    }
  return notes;
}

RestPosition rest_position(const model::System& system) {
  model::Description description = system.description();
  for (model::Element& element : description.elements)
    for (model::NonlinearPart& part : element.nonlinear_parts) part.at_rest = 0;
  const auto at = [&] { return *model::System::checked(description); };
  const LoadPath path(at());
  std::vector<double> limit_loads;
  if (path.loaded()) {
    const std::optional<VectorXd> only = path.only_one();
    const auto [deflections, turns] = only ? std::pair(*only, std::vector<double>()) : path.followed();
    limit_loads = turns;
    Index next = 0;
    for (model::Element& element : description.elements)
      for (model::NonlinearPart& part : element.nonlinear_parts) {
        part.at_rest = deflections(next++);
        const auto [low, high] = LawAbout(part.laws).range();
        if (part.at_rest >= low && part.at_rest <= high) continue;
        throw foundation::NotComputable(fmt::format(
            "static: {} rests at a deflection of {:.6g}, and its curve is known from {:.6g} to {:.6g} only; "
            "extend it, or take beyond = \"slope\"",
            element.name, part.at_rest, low, high));
      }
  }
  const model::System there = at();
  VectorXd deflections = VectorXd::Zero(to_index(path.deflections().size()));
  Index next = 0;
  for (const model::Element& element : description.elements)
    for (const model::NonlinearPart& part : element.nonlinear_parts) deflections(next++) = part.at_rest;
  return {with_references(there, tangents_at_rest(there)), limit_loads, path.is_stable(deflections)};
}

std::vector<RestState> rest_states(const model::System& system) {
  model::Description description = system.description();
  for (model::Element& element : description.elements)
    for (model::NonlinearPart& part : element.nonlinear_parts) part.at_rest = 0;
  const LoadPath path(*model::System::checked(description));
  std::vector<RestState> states;
  for (const VectorXd& deflections : path.all()) {
    RestState state{{}, path.is_stable(deflections)};
    for (Index j = 0; j < deflections.size(); ++j)
      state.deflections.push_back({path.deflections()[to_size(j)].name, deflections(j)});
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace trivet::nonlinear
