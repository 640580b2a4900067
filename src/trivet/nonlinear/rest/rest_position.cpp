// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rest/rest_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/loads.h"
#include "trivet/assembly/second_order.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/message_list.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/rest/load_path.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using foundation::prefixed;

namespace {

/// Where its stops close; nothing without stops.
std::string stops_words(const model::NonlinearPart& part) {
  std::string words;
  for (const elements::ElasticForce& law : elements::only<elements::ElasticForce>(part.laws))
    if (const auto* stop = std::get_if<elements::GapStop>(&law)) {
      for (const double closed_from : {stop->upper(), stop->lower()})
        if (std::isfinite(closed_from))
          words += fmt::format(", {} from {}", words.empty() ? "closed" : "and",
                               prefixed(closed_from, part.is_rotation() ? "rad" : "m"));
      if (part.at_rest > stop->upper() || part.at_rest < stop->lower()) words += ": it bears";
      else if (part.at_rest == stop->upper() || part.at_rest == stop->lower()) words += ": it is just touched";
    }
  return words;
}

}  // namespace

std::vector<std::string> notes_about_rest(const model::System& system) {
  std::vector<std::string> notes;
  double round_off = 0;
  for (const model::Element& element : system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts)
      round_off = std::max(round_off, 1e-12 * std::abs(part.at_rest));
  for (const model::Element& element : system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      if (notes.empty())
        notes.emplace_back("nonlinear machine: all but static, steady and backbone is for small motions about rest");
      const bool turns = part.is_rotation();
      if (part.is_inner()) continue;
      for (const elements::HystereticForce& law : elements::only<elements::HystereticForce>(part.laws))
        if (const auto* friction = std::get_if<elements::CoulombFriction>(&law))
          notes.push_back(
              fmt::format("{}: friction without a stiffness is left out of all but steady: forces below {} do not move "
                          "it at all",
                          element.name, prefixed(friction->limit(), turns ? "N m" : "N")));
      if (element.over_deflection && &part == &element.nonlinear_parts.front()) {
        const Index along_k = 6 + part.axis;
        const bool is_bush = part.axis < 2;
        notes.push_back(fmt::format("{}: {} along {} at rest, {} by {}; its 12×12 is the one there", element.name,
                                    prefixed(element.law.nominal_stiffness(along_k, along_k) +
                                                 elements::small_motion(part.laws, part.at_rest).stiffness,
                                             "N/m"),
                                    "xyz"[part.axis],
                                    is_bush ? "displaced" : (part.at_rest > 0 ? "stretched" : "compressed"),
                                    prefixed(is_bush ? part.at_rest : std::abs(part.at_rest), "m")));
        continue;
      }
      notes.push_back(fmt::format(
          "{}: tangent stiffness {} {} {} at rest, at a deflection of {}{}", element.name,
          prefixed(elements::small_motion(part.laws, part.at_rest).stiffness, turns ? "N m/rad" : "N/m"),
          turns ? "about" : "along", "xyz"[part.axis % 3],
          prefixed(std::abs(part.at_rest) > round_off ? part.at_rest : 0.0, turns ? "rad" : "m"), stops_words(part)));
    }
  for (const model::Element& element : system.elements())
    for (const model::RubbingPart& part : element.rubbing_parts) {
      const double pressed = std::abs(elements::force_at_rest(element.nonlinear_parts[part.pressed_by].laws,
                                                              element.nonlinear_parts[part.pressed_by].at_rest)
                                          .force);
      if (pressed > 0)
        notes.push_back(fmt::format("{}: pressed with {} at rest, where it bears no friction and sticks with {}",
                                    element.name, prefixed(pressed, "N"), prefixed(part.law.stiffness, "N/m")));
    }
  for (const model::Element& element : system.elements())
    for (const model::DistancePart& part : element.distance_parts) {
      if (notes.empty())
        notes.emplace_back("nonlinear machine: all but static, steady and backbone is for small motions about rest");
      const elements::SpatialForce there = elements::force_in_motion(part.law, part.at_rest, Eigen::Vector3d::Zero());
      if (there.force.norm() == 0) continue;
      notes.push_back(fmt::format(
          "{}: a force of {} at rest, over a distance of {}{}", element.name, prefixed(there.force.norm(), "N"),
          prefixed(part.law.distance(part.at_rest), "m"),
          assembly::has_second_order(system) ? "" : "; its lever changes as bodies rotate, which is left out"));
      if (part.friction)
        notes.push_back(
            fmt::format("{}: pressed at rest, where it bears no friction and sticks with {} around and along its wall",
                        element.name, prefixed(part.friction->stiffness, "N/m")));
    }
  return foundation::grouped(notes);
}

namespace {

/// In the order of nonlinear_deflections, and of LoadPath::deflections.
template <typename Elements, typename Visit>
void each_deflection_at_rest(Elements& elements, const Visit& visit) {
  for (auto& element : elements)
    for (auto& part : element.nonlinear_parts) visit(part.at_rest);
  for (auto& element : elements)
    for (auto& part : element.distance_parts)
      for (auto& deflection : part.at_rest) visit(deflection);
  for (auto& element : elements)
    for (auto& part : element.rubbing_parts)
      for (auto& deflection : part.at_rest) visit(deflection);
}

VectorXd deflections_at_rest(const std::vector<model::Element>& elements) {
  std::vector<double> all;
  each_deflection_at_rest(elements, [&](double deflection) { all.push_back(deflection); });
  return Eigen::Map<const VectorXd>(all.data(), to_index(all.size()));
}

void set_deflections_at_rest(const VectorXd& deflections, std::vector<model::Element>& elements) {
  Index next = 0;
  each_deflection_at_rest(elements, [&](double& deflection) { deflection = deflections(next++); });
}

/// Elements whose 12×12 follows their deflection keep the one where they rested.
void undeform(model::Description& description) {
  for (model::Element& element : description.elements)
    if (element.over_deflection) model::set_linear_law_at(element.nonlinear_parts.front().at_rest, element);
  each_deflection_at_rest(description.elements, [](double& deflection) { deflection = 0; });
}

/// Stops whose gaps are those of the machine at rest.
template <typename Elements, typename Visit>
void each_gap_at_rest(Elements& all, const Visit& visit) {
  for (auto& element : all)
    for (auto& part : element.nonlinear_parts)
      for (auto& law : part.laws)
        if (auto* elastic = std::get_if<elements::ElasticForce>(&law))
          if (auto* stop = std::get_if<elements::GapStop>(elastic); stop && stop->gaps_at_rest) visit(part, *stop);
}

RestPosition rest_in(const model::System& undeformed);

void require_force_domain(const model::Element& element) {
  for (const model::NonlinearPart& part : element.nonlinear_parts)
    if (const auto [low, high] = DeviationLaw(part.laws).range(); !(part.at_rest >= low && part.at_rest <= high))
      throw foundation::NotComputable(fmt::format(
          "static: {} rests at a deflection of {:.6g}, and its forces are known from {:.6g} to {:.6g} only; {}",
          element.name, part.at_rest, low, high,
          element.over_deflection ? "give it a larger range, or less load"
                                  : "correct them, or take beyond = \"slope\" for a curve"));
  for (const model::DistancePart& part : element.distance_parts) {
    const auto [low, high] = DistanceAbout(part.law).range();
    if (const double distance = part.law.distance(part.at_rest); !(distance >= low && distance <= high))
      throw foundation::NotComputable(
          fmt::format("static: {} rests at a length of {:.6g} m, and its forces are known from {:.6g} to {:.6g} m "
                      "only; correct them, or take beyond = \"slope\" for a curve",
                      element.name, distance, low, high));
  }
}

/// The machine rests without the stops whose gaps are counted from there.
RestPosition rest_between_gaps(const model::System& undeformed) {
  model::Description description = undeformed.description(), open = description;
  each_gap_at_rest(open.elements, [](model::NonlinearPart&, elements::GapStop& stop) {
    stop.gap_above = stop.gap_below = elements::GapStop::none;
    stop.gaps_at_rest = false;
  });
  const RestPosition found = rest_in(undeformed.in_other_state(std::move(open)));
  set_deflections_at_rest(deflections_at_rest(found.system.elements()), description.elements);
  each_gap_at_rest(description.elements,
                   [](model::NonlinearPart& part, elements::GapStop& stop) { stop.counted_from = part.at_rest; });
  const model::System there = undeformed.in_other_state(std::move(description));
  return {with_references(there, tangents_at_rest(there)), found.limit_loads, found.stable};
}

RestPosition rest_of(const model::System& undeformed) {
  bool counts_from_rest = false;
  each_gap_at_rest(undeformed.elements(),
                   [&](const model::NonlinearPart&, const elements::GapStop&) { counts_from_rest = true; });
  return counts_from_rest ? rest_between_gaps(undeformed) : rest_in(undeformed);
}

/// The same machine without the friction of stops, which bears no force at rest.
model::System without_rubbing(const model::System& settled) {
  model::Description description = settled.description();
  for (model::Element& element : description.elements) {
    element.rubbing_parts.clear();
    for (model::DistancePart& part : element.distance_parts) part.friction.reset();
  }
  const model::System there = settled.in_other_state(std::move(description));
  return with_references(there, tangents_at_rest(there));
}

/// The deflections of all nonlinear parts of a machine with tangents at rest, under its static load.
void move_to_equilibrium(const model::System& given, model::Description& description) {
  const model::System settled = without_rubbing(given);
  const assembly::Assembled assembled = assembly::assemble_first_order(settled);
  const VectorXd displacement =
      numerics::PivotedLu<double>(assembled.matrices.K).solve(assembly::static_load(settled, assembled));
  std::vector<Deflection> deflections = nonlinear_deflections(settled, assembled, tangents_at_rest(settled));
  add_rubbings(given, assembled, deflections);
  VectorXd at_rest(to_index(deflections.size()));
  for (Index j = 0; j < at_rest.size(); ++j) at_rest(j) = deflections[j].on_coordinates.dot(displacement);
  set_deflections_at_rest(at_rest, description.elements);
  for (model::Element& element : description.elements)
    if (element.over_deflection) model::set_linear_law_at(element.nonlinear_parts.front().at_rest, element);
}

/// With tangents at rest. Friction bears no force there.
bool is_stable(const model::System& settled) {
  const auto stiffness = [&](const References& references) {
    return assembly::assemble_first_order(with_references(settled, references)).matrices.K;
  };
  const model::System there = without_rubbing(settled);
  return is_positive(assembly::assemble_first_order(there).matrices.K, stiffness(positive_references(settled)));
}

}  // namespace

/// Elements whose 12×12 follows their deflection: from the position of rest with that of the undeformed ones by
/// Newton's method, with the forces that turn with elements and bodies.
RestPosition rest_position(const model::System& system) {
  model::Description description = system.description();
  undeform(description);
  bool follows = false;
  for (model::Element& element : description.elements) {
    if (!element.over_deflection) continue;
    follows = true;
    model::set_linear_law_at(0, element);
  }
  RestPosition found = rest_of(system.in_other_state(std::move(description)));
  if (!follows) return found;
  constexpr int most = 50;
  constexpr double accurate = 1e-9;
  for (int i = 0; i < most; ++i) {
    model::Description there = found.system.description();
    move_to_equilibrium(found.system, there);
    const VectorXd at_rest = deflections_at_rest(there.elements);
    const double change = (at_rest - deflections_at_rest(found.system.elements())).cwiseAbs().maxCoeff(),
                 largest = at_rest.cwiseAbs().maxCoeff();
    const model::System moved = found.system.in_other_state(std::move(there));
    found.system = with_references(moved, tangents_at_rest(moved));
    if (change > accurate * largest) continue;
    for (const model::Element& element : found.system.elements()) require_force_domain(element);
    found.stable = is_stable(found.system);
    return found;
  }
  throw foundation::NotComputable(
      "static: the position of rest was not found: the stiffness of its mounts changes too much with their "
      "compression");
}

namespace {

RestPosition rest_in(const model::System& undeformed) {
  model::Description description = undeformed.description();
  const LoadPath path(undeformed);
  std::vector<double> limit_loads;
  if (path.loaded()) {
    const std::optional<VectorXd> only = path.only_one();
    const auto [deflections, turns] = only ? std::pair(*only, std::vector<double>()) : path.followed();
    limit_loads = turns;
    set_deflections_at_rest(deflections, description.elements);
    for (const model::Element& element : description.elements) require_force_domain(element);
  }
  const model::System there = undeformed.in_other_state(std::move(description));
  return {with_references(there, tangents_at_rest(there)), limit_loads,
          path.is_stable(deflections_at_rest(there.elements()))};
}

}  // namespace

namespace {

LoadPath path_from_undeformed(const model::System& system) {
  model::Description description = system.description();
  undeform(description);
  return LoadPath(system.in_other_state(std::move(description)));
}

}  // namespace

std::vector<VectorXd> to_other_positions_of_rest(const model::System& system) {
  constexpr double same = 1e-6;
  const VectorXd here = deflections_at_rest(system.elements());
  std::vector<VectorXd> found;
  for (const VectorXd& there : path_from_undeformed(system).all())
    if ((there - here).norm() > same * std::max(there.norm(), here.norm())) found.push_back(there - here);
  return found;
}

std::vector<RestState> rest_states(const model::System& system) {
  const LoadPath path = path_from_undeformed(system);
  std::vector<RestState> states;
  for (const VectorXd& deflections : path.all()) {
    RestState state{{}, path.is_stable(deflections)};
    for (Index j = 0; j < deflections.size(); ++j)
      state.deflections.push_back({path.deflections()[j].name, deflections(j)});
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace trivet::nonlinear
