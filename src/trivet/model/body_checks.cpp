// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "trivet/model/checks.h"
#include "trivet/model/point_mass.h"
#include "trivet/numerics/linalg/complete_pivoting.h"

namespace trivet::model {
namespace {

/// True if the mass matrix of the free coordinates is invertible; otherwise there is no equation of motion.
bool has_regular_mass(const Body& body) {
  const spatial::Matrix6 a = spatial::mass_matrix(body.mass);
  std::vector<int> rows;
  for (int j = 0; j < 6; ++j)
    if (body.free[j]) rows.push_back(j);
  if (rows.empty()) return true;  // no free coordinate: reported separately
  Eigen::MatrixXd block = a(rows, rows);
  for (Eigen::Index i = 0; i < block.rows(); ++i)
    if (block(i, i) == 0) return false;
  const Eigen::VectorXd d = block.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  block = (d.asDiagonal() * block * d.asDiagonal()).eval();
  return numerics::is_regular(block, 1e-13);
}

}  // namespace

void check_body(const Body& body, foundation::Problems& problems) {
  const std::string subject = path_of(body);
  const bool may_move = std::ranges::any_of(body.free, [](bool f) { return f; }) ||
      std::ranges::any_of(body.left_out, [](bool left) { return left; });
  if (!may_move)
    problems.error(subject + ".free", "no free coordinate",
                   body.is_node ? "a node must be able to move" : "a body must be able to move",
                   "name at least one of x, y, z, rx, ry, rz, or make it part of the ground");
  if (body.is_node || is_point_mass(body)) return;
  const bool turns = body.free[3] || body.free[4] || body.free[5];
  if (!body.has_inertia && turns)
    problems.error(subject, "no inertia", "a body that can turn needs its moments of inertia",
                   "give inertia = {about = \"center_of_mass\", xx = …, yy = …, zz = …}; xx = 0, yy = 0, zz = 0 is a "
                   "point mass");
  if (turns && body.has_inertia && body.mass.mass > 0 && body.mass.inertia_about_centre.isZero(0)) {
    problems.error(subject + ".center_of_mass",
                   fmt::format("[{:.6g}, {:.6g}, {:.6g}] m of a point mass", body.mass.centre.x(), body.mass.centre.y(),
                               body.mass.centre.z()),
                   "a body whose inertia is zero has its pole at its centre of mass",
                   "move `position` there and leave out center_of_mass, or give the inertia");
    return;
  }
  std::vector<spatial::ViolatedBound> violated;
  if (body.has_inertia) {
    violated = spatial::violated_bounds(body.mass);
  } else if (!(body.mass.mass > 0)) {
    violated.push_back({fmt::format("mass = {:.6g} kg", body.mass.mass), "a mass must be > 0"});
  }
  const bool regular = has_regular_mass(body);
  for (const auto& bound : violated) {
    const bool of_mass = bound.finding.starts_with("mass =");
    const std::string subject_of_bound = subject + (of_mass ? ".mass" : ".inertia");
    if (body.allow_unphysical && regular)
      problems.warning(subject_of_bound, bound.finding, bound.rule,
                       "no real body has these numbers (allow_unphysical is set): every result is doubtful");
    else
      problems.error(subject_of_bound, bound.finding, bound.rule,
                     of_mass       ? "give a positive mass"
                         : regular ? "correct the value, its sign or its point of reference; allow_unphysical = true "
                                     "computes anyway and marks every result"
                                   : "correct the value: with a singular mass matrix no motion can be computed, even "
                                     "with allow_unphysical");
  }
}

void check_loose_bodies(const Description& description, foundation::Problems& problems) {
  if (description.elements.empty()) return;
  std::vector<bool> held(description.bodies.size(), false);
  for (const Element& element : description.elements)
    for (const End* end : {&element.k, &element.n})
      if (end->body) held[*end->body] = true;
  for (std::size_t b = 0; b < held.size(); ++b)
    if (!held[b] && !description.bodies[b].is_node)
      problems.warning("bodies." + description.bodies[b].name, "no element ends on it",
                       "a body that nothing holds moves freely, with a rigid-body mode at 0 Hz for each coordinate",
                       "name it in `on` or `from` of an element; if it is meant to be free, change nothing");
}

}  // namespace trivet::model
