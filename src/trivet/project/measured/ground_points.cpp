// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/ground_points.h"

#include <algorithm>

#include "trivet/foundation/index.h"

namespace trivet::project {

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
