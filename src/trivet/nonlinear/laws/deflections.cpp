// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/deflections.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::nonlinear {
namespace {

/// Calls `visit(element, part)` for all parts, in the order of the elements.
template <typename Visit>
void each_part(const std::vector<model::Element>& elements, const Visit& visit) {
  for (const model::Element& element : elements)
    for (const model::NonlinearPart& part : element.nonlinear_parts) visit(element, part);
}

template <typename Visit>
void each_distance(const std::vector<model::Element>& elements, const Visit& visit) {
  for (const model::Element& element : elements)
    for (const model::DistancePart& part : element.distance_parts) visit(part);
}

bool is_slack(const model::NonlinearPart& part) {
  return !elements::only<elements::DampingForce>(part.laws).empty() &&
      !(elements::small_motion(part.laws, part.at_rest).damping > 0);
}

/// Positive, and of the size of its forces over deflections of a millimetre or a milliradian. It only conditions the
/// equations.
elements::SmallMotion positive_reference(const model::NonlinearPart& part) {
  constexpr double small = 1e-3;
  constexpr double small_rate = 0.1;
  elements::SmallMotion about_rest = elements::small_motion(part.laws, part.at_rest);
  if (is_slack(part)) {
    for (const elements::DampingForce& damper : elements::only<elements::DampingForce>(part.laws))
      for (const double rate : {-small_rate, small_rate})
        about_rest.damping += std::abs(elements::force_of_rate(damper, rate).force) / (2 * small_rate);
  }
  if (about_rest.stiffness > 0) return about_rest;
  double largest = 0;
  std::vector<double> from = elements::kinks_at_rest(part.laws);
  from.push_back(part.at_rest);
  for (const double place : from)
    for (const double step : {-small, small})
      largest = std::max(largest,
                         std::abs(elements::force_at_rest(part.laws, place + step).force -
                                  elements::force_at_rest(part.laws, place).force) /
                             small);
  return {largest, about_rest.damping};
}

/// Over a distance, along its line and across it. Without tension nothing holds the ends across the line, and under
/// compression less than nothing: there it is as stiff as under the same tension, but at least a share of the stiffness
/// along the line. In all directions if the ends are at one place.
Eigen::Matrix3d positive_reference(const model::DistancePart& part) {
  constexpr double small = 1e-3, least_across = 1e-3;
  const elements::DistanceForce& law = part.law;
  Eigen::Vector3d line = law.offset + part.at_rest;
  Eigen::Matrix3d plane = Eigen::Matrix3d::Identity();
  if (law.across) line.z() = plane(2, 2) = 0;
  const double distance = line.norm();
  const auto force = [&](double at) { return elements::force_at_rest(law.laws, at - law.length).force; };
  std::vector<double> from = elements::kink_distances(law);
  from.push_back(distance);
  double largest = 0;
  for (const double place : from)
    for (const double step : {-small, small})
      largest = std::max(largest, std::abs(force(place + step) - force(place)) / small);
  if (!(distance > 0)) return largest * plane;
  const Eigen::Vector3d u = line / distance;
  const Eigen::Matrix3d along = u * u.transpose();
  const double tangent = u.dot(elements::force_in_motion(law, part.at_rest, Eigen::Vector3d::Zero()).by_deflection * u),
               stiffness = tangent > 0 ? tangent : largest,
               across = std::max(std::abs(force(distance)) / distance, least_across * stiffness);
  return stiffness * along + across * (plane - along);
}

ContactFriction contact_friction(const model::Element& element, const model::RubbingPart& part) {
  const model::NonlinearPart& along = element.nonlinear_parts[part.pressed_by];
  return {part.law, elements::only<elements::ElasticForce>(along.laws), along.at_rest};
}

}  // namespace

std::array<elements::Vector12, 2> rows_across(const model::NonlinearPart& along, const model::Span& span) {
  std::array<elements::Vector12, 2> rows;
  for (int i = 0; i < 2; ++i)
    rows[i] = elements::deflection_row((along.axis + 1 + i) % 3, span.arm, span.n_from_k, along.centre).transpose();
  return rows;
}

bool has_slack_dampers(const model::System& system) {
  bool found = false;
  each_part(system.elements(),
            [&](const model::Element&, const model::NonlinearPart& part) { found = found || is_slack(part); });
  return found;
}

References tangents_at_rest(const model::System& system) {
  References found;
  each_part(system.elements(), [&](const model::Element&, const model::NonlinearPart& part) {
    found.parts.push_back(elements::small_motion(part.laws, part.at_rest));
  });
  each_distance(system.elements(), [&](const model::DistancePart& part) {
    found.distances.push_back(elements::force_in_motion(part.law, part.at_rest, Eigen::Vector3d::Zero()).by_deflection);
  });
  return found;
}

References positive_references(const model::System& system) {
  References found;
  each_part(system.elements(), [&](const model::Element&, const model::NonlinearPart& part) {
    found.parts.push_back(positive_reference(part));
  });
  each_distance(system.elements(),
                [&](const model::DistancePart& part) { found.distances.push_back(positive_reference(part)); });
  return found;
}

model::System with_references(const model::System& system, const References& references) {
  model::Description description = system.description();
  std::size_t next = 0, next_distance = 0;
  for (model::Element& element : description.elements) {
    if (!model::has_laws(element)) continue;
    const model::Span span = model::span(description.bodies, element.n, element.k);
    elements::Linearization sum;
    if (element.law.inner)
      sum.inner_tangent = sum.inner_damping = sum.inner_offset = Eigen::VectorXd::Zero(element.law.inner->count());
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      if (part.is_inner()) {
        const elements::SmallMotion& reference = references.parts[next++];
        sum.inner_tangent(part.inner) += reference.stiffness;
        sum.inner_damping(part.inner) += reference.damping;
        sum.inner_offset(part.inner) +=
            elements::force_at_rest(part.laws, part.at_rest).force - reference.stiffness * part.at_rest;
        continue;
      }
      const elements::Vector12 row =
          elements::deflection_row(part.axis, span.arm, span.n_from_k, part.centre).transpose();
      const elements::SmallMotion& reference = references.parts[next++];
      sum.tangent += reference.stiffness * row * row.transpose();
      sum.damping += reference.damping * row * row.transpose();
      sum.offset += (elements::force_at_rest(part.laws, part.at_rest).force - reference.stiffness * part.at_rest) * row;
    }
    if (element.over_deflection) {  // the force at rest, as one that turns with the element
      const model::NonlinearPart& along = element.nonlinear_parts.front();
      const double force = elements::force_at_rest({along.laws.front()}, along.at_rest).force;
      element.law.preload =
          force * elements::deflection_row(along.axis, span.arm, span.n_from_k, along.centre).transpose();
      sum.offset -= *element.law.preload;
      sum.tangent += element.over_deflection->at(along.at_rest, force) - element.over_deflection->at(along.at_rest, 0);
    }
    for (const model::RubbingPart& part : element.rubbing_parts) {  // which bears no force at rest
      const Eigen::Matrix3d sticks = contact_friction(element, part).own_stiffness();
      const auto rows = rows_across(element.nonlinear_parts[part.pressed_by], span);
      for (std::size_t i = 0; i < 2; ++i) {
        const double stiffness = sticks(to_index(i) + 1, to_index(i) + 1);
        sum.tangent += stiffness * rows[i] * rows[i].transpose();
        sum.offset -= stiffness * part.at_rest(to_index(i)) * rows[i];
      }
    }
    for (const model::DistancePart& part : element.distance_parts) {
      const Eigen::Matrix<double, 3, 12> rows = elements::difference_rows(span.n_from_k);
      const elements::SpatialForce there = elements::force_in_motion(part.law, part.at_rest, Eigen::Vector3d::Zero());
      const Eigen::Matrix3d& reference = references.distances[next_distance++];
      sum.tangent += rows.transpose() * reference * rows;
      sum.damping += rows.transpose() * there.by_rate * rows;
      sum.offset += rows.transpose() * (there.force - reference * part.at_rest);
      if (!part.friction) continue;
      const Eigen::Matrix3d sticks = ContactFriction(*part.friction, part.law, part.at_rest).own_stiffness();
      sum.tangent += rows.transpose() * sticks * rows;
      sum.offset -= rows.transpose() * sticks * part.at_rest;
    }
    element.law.nonlinear = sum;
  }
  return system.in_other_state(std::move(description));
}

std::string name_of(const model::Element& element, const model::NonlinearPart& part) {
  if (part.is_inner()) return element.name + "." + element.law.inner->names[part.inner];
  return element.name + ".deflection." + model::coordinate_names[part.axis];
}

namespace {

/// @param row  of the ends of the element, then its inner coordinates
Deflection without_law(const std::string& name, bool is_rotation, const assembly::Assembled& assembled,
                       const assembly::ElementMap& map, const Eigen::RowVectorXd& row) {
  Deflection deflection{name, is_rotation, Eigen::VectorXd::Zero(assembled.matrices.size()),
                        Eigen::VectorXd::Zero(assembled.ground.size()), DeviationLaw({})};
  const Eigen::RowVectorXd on_free = row * map.ends, on_ground = row * map.ground_ends;
  for (Eigen::Index c = 0; c < on_free.size(); ++c) deflection.on_coordinates(map.rows[c]) += on_free(c);
  for (Eigen::Index c = 0; c < on_ground.size(); ++c) deflection.on_ground(map.ground_rows[c]) += on_ground(c);
  return deflection;
}

void add_distances(const model::System& system, const assembly::Assembled& assembled, const References& references,
                   std::vector<Deflection>& found) {
  std::size_t next = 0;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const assembly::ElementMap& map = assembled.elements[e];
    for (const model::DistancePart& part : element.distance_parts) {
      const Eigen::Matrix<double, 3, 12> rows =
          elements::difference_rows(model::span(system.bodies(), element.n, element.k).n_from_k);
      for (Eigen::Index a = 0; a < 3; ++a) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(map.ends.rows());
        row.head<12>() = rows.row(a);
        Deflection deflection =
            without_law(element.name + ".difference." + model::coordinate_names[a], false, assembled, map, row);
        if (a == 0) deflection.distance.emplace(part.law, part.at_rest, references.distances[next++]);
        found.push_back(std::move(deflection));
      }
    }
  }
}

}  // namespace

namespace {

bool has_coulomb_friction(const model::NonlinearPart& part) {
  const std::vector<elements::HystereticForce> all = elements::only<elements::HystereticForce>(part.laws);
  return std::ranges::any_of(all, elements::jumps_at_turns);
}

}  // namespace

Eigen::MatrixXd accelerations_per_force(const numerics::DynamicMatrices& matrices, const Eigen::MatrixXd& across) {
  constexpr double beyond = 1e6, farther = 10, grows = 2, round_off = 1e-12;
  double fastest = 1;
  for (Eigen::Index i = 0; i < matrices.size(); ++i)
    if (matrices.A(i, i) > 0) fastest = std::max(fastest, std::sqrt(std::abs(matrices.K(i, i)) / matrices.A(i, i)));
  const auto at = [&](double s) {
    const Eigen::MatrixXd dynamic = matrices.K + s * matrices.B + s * s * matrices.A;
    return Eigen::MatrixXd(s * s * numerics::PivotedLu<double>(dynamic).solve(across));
  };
  const Eigen::MatrixXd near = at(beyond * fastest);
  Eigen::MatrixXd far = at(farther * beyond * fastest);
  for (Eigen::Index j = 0; j < far.cols(); ++j) {
    const double least = round_off * near.col(j).cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < far.rows(); ++i)
      if (std::abs(far(i, j)) > grows * std::abs(near(i, j)) + least)
        far(i, j) = std::copysign(std::numeric_limits<double>::infinity(), far(i, j));
  }
  return far;
}

std::vector<Deflection> nonlinear_deflections(const model::System& system, const assembly::Assembled& assembled,
                                              const References& references) {
  std::vector<Deflection> found;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    if (element.nonlinear_parts.empty()) continue;
    const assembly::ElementMap& map = assembled.elements[e];
    const model::Span span = model::span(system.bodies(), element.n, element.k);
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(map.ends.rows());
      if (part.is_inner()) row(row.size() - element.law.inner->count() + part.inner) = 1;
      else row.head<12>() = elements::deflection_row(part.axis, span.arm, span.n_from_k, part.centre);
      Deflection deflection = without_law(name_of(element, part), part.is_rotation(), assembled, map, row);
      double acceleration = 0;
      if (has_coulomb_friction(part)) {
        deflection.accelerations = accelerations_per_force(assembled.matrices, deflection.on_coordinates);
        for (Eigen::Index c = 0; c < deflection.on_coordinates.size(); ++c)
          if (const double share = deflection.on_coordinates(c); share != 0)
            acceleration += share * deflection.accelerations(c);
      }
      deflection.law = DeviationLaw(part.laws, part.at_rest, references.parts[found.size()], acceleration);
      found.push_back(std::move(deflection));
    }
  }
  add_distances(system, assembled, references, found);
  return found;
}

void add_rubbings(const model::System& system, const assembly::Assembled& assembled, std::vector<Deflection>& found) {
  std::size_t next = 0;  // of the nonlinear parts
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const assembly::ElementMap& map = assembled.elements[e];
    for (const model::RubbingPart& part : element.rubbing_parts) {
      const model::NonlinearPart& along = element.nonlinear_parts[part.pressed_by];
      const auto rows = rows_across(along, model::span(system.bodies(), element.n, element.k));
      for (std::size_t i = 0; i < 2; ++i) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(map.ends.rows());
        row.head<12>() = rows[i].transpose();
        const int axis = (along.axis + 1 + static_cast<int>(i)) % 3;
        found.push_back(
            without_law(element.name + ".deflection." + model::coordinate_names[axis], false, assembled, map, row));
        if (i == 0) found.back().rubbing = Deflection::Rubbing{next + part.pressed_by, contact_friction(element, part)};
      }
    }
    next += element.nonlinear_parts.size();
  }
  for (const model::Element& element : system.elements())  // distances follow the parts over one deflection
    for (const model::DistancePart& part : element.distance_parts) {
      if (part.friction)
        found[next].rubbing = Deflection::Rubbing{next, ContactFriction(*part.friction, part.law, part.at_rest)};
      next += 3;
    }
}

}  // namespace trivet::nonlinear
