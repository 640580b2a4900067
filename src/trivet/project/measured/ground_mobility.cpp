// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/ground_mobility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/project/elements/stiffness_column.h"

namespace trivet::project {

namespace {

/// Dynamic stiffness of all directions. The elements of a foundation need it one after another at each frequency; so
/// the last one of a thread is kept, with its mobility.
const Eigen::MatrixXcd& dynamic_stiffness_of_all(const std::shared_ptr<const GroundMobility>& mobility,
                                                 std::complex<double> omega, double near) {
  struct Last {
    std::weak_ptr<const GroundMobility> mobility;  // a later mobility at the same address is another one
    std::complex<double> omega;
    double near = 0;
    Eigen::MatrixXcd value;
  };
  thread_local Last last;
  const bool same = !last.mobility.owner_before(mobility) && !mobility.owner_before(last.mobility);
  if (!same || last.omega != omega || last.near != near)
    last = {mobility, omega, near, mobility->dynamic_stiffness(omega, near)};
  return last.value;
}

/// A table whose dynamic stiffness is taken from that of all directions.
elements::FrequencyDependence table(
    const std::shared_ptr<const GroundMobility>& mobility,
    const std::function<void(const Eigen::MatrixXcd& all, elements::Matrix12c& full)>& fill) {
  elements::FrequencyDependence result;
  result.elastic = false;
  result.from = mobility->knots.front();
  result.to = mobility->knots.back();
  result.knots = mobility->knots;
  result.stiffness = [mobility, fill](std::complex<double> omega, double near) {
    elements::Matrix12c full = elements::Matrix12c::Zero();
    fill(dynamic_stiffness_of_all(mobility, omega, near), full);
    return full;
  };
  return result;
}

}  // namespace

std::vector<int> GroundMobility::coordinates(std::size_t point) const {
  std::vector<int> result;
  for (const Direction& direction : directions)
    if (direction.point == point) result.push_back(direction.coordinate);
  return result;
}

Eigen::MatrixXcd GroundMobility::dynamic_stiffness(std::complex<double> omega, double near) const {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, near);
  const auto i = to_size(above - knots.begin());
  const std::complex<double> share = (omega - knots[i - 1]) / (knots[i] - knots[i - 1]);
  const Eigen::MatrixXcd y = (1.0 - share) * rows[i - 1] + share * rows[i];
  return std::complex<double>(0, 1) * omega * numerics::inverse(y);
}

void join_to_ground(const std::shared_ptr<const GroundMobility>& mobility, std::size_t point, model::Element& element) {
  const auto fill = [directions = mobility->directions, point](const Eigen::MatrixXcd& all, elements::Matrix12c& full) {
    for (std::size_t a = 0; a < directions.size(); ++a)
      for (std::size_t b = 0; b < directions.size(); ++b) {
        if (directions[a].point != point || directions[b].point != point) continue;
        const int i = directions[a].coordinate, j = directions[b].coordinate;
        full(i, j) = full(6 + i, 6 + j) = all(to_index(a), to_index(b));
        full(i, 6 + j) = full(6 + i, j) = -full(i, j);
      }
  };
  element.law.frequency_dependence = table(mobility, fill);
  // For starting values only: magnitude of the dynamic stiffness in the first row, per direction.
  elements::Matrix12c first_row = elements::Matrix12c::Zero();
  fill(mobility->dynamic_stiffness(mobility->knots.front(), mobility->knots.front()), first_row);
  const elements::Vector6 first = first_row.diagonal().head<6>().cwiseAbs();
  element.law.nominal_stiffness = elements::constants_at_point(first, Eigen::Vector3d::Zero(), 1);
  for (const GroundMobility::Direction& direction : mobility->directions)
    if (direction.point == point)
      element.facts.push_back(
          {"causality of " + direction.name,
           fmt::format("{:.3g} % rms from the nearest passive, causal mobility", 100 * direction.causality_rms)});
  element.facts.push_back(defined_range(mobility->knots.front(), mobility->knots.back()));
}

void couple(const std::shared_ptr<const GroundMobility>& mobility, std::size_t n, std::size_t k,
            model::Element& element) {
  element.law.frequency_dependence = table(
      mobility, [directions = mobility->directions, n, k](const Eigen::MatrixXcd& all, elements::Matrix12c& full) {
        for (std::size_t a = 0; a < directions.size(); ++a)
          for (std::size_t b = 0; b < directions.size(); ++b)
            if (directions[a].point == n && directions[b].point == k)
              full(directions[a].coordinate, 6 + directions[b].coordinate) =
                  full(6 + directions[b].coordinate, directions[a].coordinate) = all(to_index(a), to_index(b));
      });
  element.facts.push_back(defined_range(mobility->knots.front(), mobility->knots.back()));
}

void add_ground_point(GroundPoints& ground, const std::string& element, model::Description& description) {
  const auto mount = std::ranges::find(description.elements, element, &model::Element::name);
  const std::size_t point = ground.points.empty() ? 0 : ground.points.at(element);
  const std::vector<int> directions = ground.mobility ? ground.mobility->coordinates(point) : ground.directions;
  const auto count = to_index(directions.size());
  const std::string name = element + ".foundation";
  model::Foundation place{name, Eigen::MatrixXd::Zero(count, count), Eigen::MatrixXd::Zero(count, count),
                          Eigen::MatrixXd::Zero(count, count)};
  Eigen::Matrix<double, 6, Eigen::Dynamic> shape = Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int j = directions[i];
    place.mass(i, i) = ground.mass(j);
    shape(j, i) = 1;
  }
  // Couplings act on motions relative to the ground: the coordinates of coupled points are such motions.
  const bool relative = !ground.points.empty();
  const spatial::Matrix6 fixed = spatial::Matrix6::Identity() - (relative ? 0 : 1) * shape * shape.transpose();
  mount->n.foundation = model::OnFoundation{description.foundations.size(), shape, fixed};
  model::Element joint = ground.impedance;
  if (ground.mobility) join_to_ground(ground.mobility, point, joint);
  joint.name = name;
  joint.type = "foundation";
  joint.is_foundation = true;
  joint.n.at = joint.k.at = mount->n.at;
  joint.k.foundation = mount->n.foundation;
  ground.placed.push_back({point, joint.k, name});
  description.foundations.push_back(std::move(place));
  description.elements.push_back(std::move(joint));
}

void add_couplings(const GroundPoints& ground, model::Description& description) {
  for (std::size_t j = 1; j < ground.placed.size() && !ground.points.empty(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      model::Element coupling;
      coupling.type = "foundation";
      coupling.is_foundation = true;
      const GroundPoints::Placed &n = ground.placed[i], &k = ground.placed[j];
      coupling.name = n.name + " and " + k.name;
      coupling.n = n.end;
      coupling.k = k.end;
      for (model::End* end : {&coupling.n, &coupling.k}) end->foundation->fixed_directions.setZero();
      couple(ground.mobility, n.point, k.point, coupling);
      description.elements.push_back(std::move(coupling));
    }
}

}  // namespace trivet::project
