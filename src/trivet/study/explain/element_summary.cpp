// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/element_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/modes.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::study {
namespace {

using spatial::Vector6;

/// Displacement of an end in its local axes in a mode.
Vector6 end_displacement(const model::End& end, const modal::Mode& mode) {
  if (!end.body) return Vector6::Zero();
  const Vector6 body = mode.shape.segment<6>(6 * to_index(*end.body));
  return spatial::both_blocks(end.axes).transpose() * spatial::rigid_motion(end.at) * body;
}

/// Motion of K relative to a rigid motion of the element with N.
Vector6 deformation(const model::Element& element, const model::Span& span, const modal::Mode& mode) {
  const Vector6 n_in_axes_of_k = spatial::both_blocks(span.n_from_k).transpose() * end_displacement(element.n, mode);
  return end_displacement(element.k, mode) - spatial::rigid_motion(span.arm) * n_in_axes_of_k;
}

}  // namespace

elements::MatrixVerdict matrix_verdict(const project::Case& variant, const model::Element& element,
                                       const elements::Matrix12& matrix) {
  const model::Span span = model::span(variant.system.bodies(), element.n, element.k);
  const bool of_stiffness = element.law.preload && matrix == elements::stiffness(element.law);
  return elements::examine(matrix, elements::rigid_motions(span.arm, span.n_from_k),
                           of_stiffness ? elements::turned_preload(*element.law.preload, span.n_from_k)
                                        : Eigen::Matrix<double, 12, 6>::Zero().eval());
}

namespace {

bool has_dampers(const elements::ScalarLaws& laws) {
  const std::vector<elements::LuGreFriction> bristles = elements::only<elements::LuGreFriction>(laws);
  return !elements::only<elements::DampingForce>(laws).empty() ||
      std::ranges::any_of(bristles,
                          [](const elements::LuGreFriction& law) { return law.damping > 0 || law.viscous > 0; });
}

/// The force along the line of a strut, or across the axis of a ring, in both senses.
ElementLaws over_distance(const model::DistancePart& part) {
  model::NonlinearPart shown;
  shown.laws = part.law.laws;
  if (!part.law.across) {
    shown.at_rest = part.law.distance(part.at_rest) - part.law.length;
    return {"distance", "over the distance of its ends", false, shown.at_rest, has_dampers(part.law.laws),
            true,       nonlinear::law_loops(shown, 0)};
  }
  for (elements::ScalarLaw& law : shown.laws)
    if (auto* elastic = std::get_if<elements::ElasticForce>(&law))
      if (auto* stop = std::get_if<elements::GapStop>(elastic)) stop->gap_below = stop->gap_above;
  return {"across", "across its axis", false, 0, has_dampers(part.law.laws), true, nonlinear::law_loops(shown, 0)};
}

}  // namespace

std::vector<ElementLaws> element_laws(const project::Case& variant, std::size_t index) {
  const model::Element& element = variant.system.elements()[index];
  const model::Span span = model::span(variant.system.bodies(), element.n, element.k);
  std::vector<ElementLaws> all;
  for (const model::NonlinearPart& part : element.nonlinear_parts) {
    if (part.is_inner()) continue;
    const Eigen::Matrix<double, 1, 12> row = elements::deflection_row(part.axis, span.arm, span.n_from_k, part.centre);
    const double own =
        element.law.scale * row.dot(row * element.law.nominal_stiffness) / std::pow(row.squaredNorm(), 2);
    model::NonlinearPart shown = part;
    const bool whole = element.over_deflection && &part == &element.nonlinear_parts.front();
    if (whole) shown.laws.erase(shown.laws.begin() + 1);  // less the linear law
    const char* axis = model::coordinate_names[part.axis];
    all.push_back({axis, fmt::format("{} {}", part.is_rotation() ? "about" : "along", "xyz"[part.axis % 3]),
                   part.is_rotation(), part.at_rest, has_dampers(part.laws), whole,
                   nonlinear::law_loops(shown, whole ? 0 : own)});
  }
  for (const model::DistancePart& part : element.distance_parts) all.push_back(over_distance(part));
  return all;
}

std::vector<nonlinear::AmplitudeStiffness> stiffness_over_amplitude(const project::Case& variant, std::size_t index) {
  const model::Element& element = variant.system.elements()[index];
  const bool has_inner_laws =
      std::ranges::any_of(element.nonlinear_parts, [](const model::NonlinearPart& part) { return part.is_inner(); });
  if (!has_inner_laws) return {};
  // The slowest column of fluid against all chambers resonates there; the usual amplitudes of test rigs.
  const elements::InnerParts& inner = *element.law.inner;
  double slowest = foundation::infinity;
  for (Eigen::Index i = 12; i < 12 + inner.count(); ++i)
    slowest = std::min(slowest, std::sqrt(inner.stiffness(i, i) / inner.mass(i, i)));
  const std::vector<double> amplitudes = {5e-5, 1e-4, 2e-4, 5e-4, 1e-3};
  return nonlinear::stiffness_over_amplitude(variant.system, index, foundation::two_pi,
                                             std::max(50 * foundation::two_pi, 3 * slowest), amplitudes);
}

ElementSummary element_summary(const project::Case& variant, std::size_t index) {
  const model::Element& element = variant.system.elements()[index];
  const model::Span span = model::span(variant.system.bodies(), element.n, element.k);
  ElementSummary summary;
  summary.stiffness = elements::stiffness(element.law);
  summary.verdict = matrix_verdict(variant, element, summary.stiffness);
  summary.stiffness_properties = elements::stiffness_properties(summary.stiffness);
  for (const modal::Mode& mode : modal::modes(variant.system).list) {
    if (!mode.strain_energy_share) continue;
    const Eigen::VectorXd of_stored = modal::stored_energy(mode);
    summary.modes.push_back({mode.number, mode.name, mode.angular_frequency,
                             (*mode.strain_energy_share)(to_index(index)),
                             of_stored.size() > 0 ? of_stored(to_index(index)) : 0,
                             elements::energy_shares(summary.stiffness, deformation(element, span, mode))});
  }
  summary.laws = element_laws(variant, index);
  summary.over_amplitude = stiffness_over_amplitude(variant, index);
  const std::string path = "elements." + element.name;
  for (const auto& problem : variant.warnings.list())
    if (problem.subject == path || problem.subject.starts_with(path + ".")) summary.warnings.add(problem);
  return summary;
}

std::string component_name(int component) {
  static constexpr const char* names[] = {"u_x", "u_y", "u_z", "θ_x", "θ_y", "θ_z"};
  return names[component % 6];
}

}  // namespace trivet::study
