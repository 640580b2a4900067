// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/spatial/mass_properties.h"

#include <fmt/format.h>

#include <limits>

#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::spatial {
namespace {

Eigen::Matrix3d point_mass_inertia(double mass, const Eigen::Vector3d& c) {
  return mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
}

}  // namespace

Eigen::Matrix3d inertia_about_pole(const MassProperties& p) {
  return p.inertia_about_centre + point_mass_inertia(p.mass, p.centre);
}

MassProperties from_inertia_about_pole(double mass, const Eigen::Vector3d& centre, const Eigen::Matrix3d& inertia) {
  return {mass, centre, inertia - point_mass_inertia(mass, centre)};
}

Matrix6 mass_matrix(const MassProperties& p) {
  Matrix6 a;
  const Eigen::Matrix3d s = p.mass * cross_matrix(p.centre);
  a << p.mass * Eigen::Matrix3d::Identity(), s.transpose(), s, inertia_about_pole(p);
  return a;
}

PrincipalInertia principal_inertia(const MassProperties& p) {
  const numerics::SymmetricEigen<Eigen::Matrix3d> eigen = numerics::symmetric_eigen(p.inertia_about_centre);
  return {eigen.values, eigen.vectors};
}

std::vector<ViolatedBound> violated_bounds(const MassProperties& p) {
  std::vector<ViolatedBound> violated;
  if (!(p.mass > 0)) violated.push_back({fmt::format("mass = {:.6g} kg", p.mass), "a mass must be > 0"});

  const Eigen::Matrix3d about_pole = inertia_about_pole(p);
  const Eigen::Vector3d c = p.centre;
  const double rounding = 64 * std::numeric_limits<double>::epsilon() *
      (about_pole.cwiseAbs().maxCoeff() + p.inertia_about_centre.cwiseAbs().maxCoeff());
  const char* axis[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const double offset = p.mass * (c.squaredNorm() - c(i) * c(i));
    if (about_pole(i, i) < offset - rounding)
      violated.push_back(
          {fmt::format("J{0} = {1:.6g} kg m² about the pole, {2:.6g} kg m² about the centre of mass", axis[i],
                       about_pole(i, i), p.inertia_about_centre(i, i)),
           fmt::format("J{0} about the pole cannot be below {1:.6g} kg m², the mass times the squared distance of the "
                       "centre of mass from the {0} axis",
                       axis[i], offset)});
  }
  const Eigen::Vector3d moments = principal_inertia(p).moments;
  const std::string found = fmt::format("principal moments about the centre of mass = {:.6g}, {:.6g}, {:.6g} kg m²",
                                        moments(0), moments(1), moments(2));
  if (moments(0) <= rounding) {
    const Vector6 mass = numerics::symmetric_eigenvalues(mass_matrix(p));
    const auto negative = (mass.array() < 0).count();
    violated.push_back(
        {found,
         fmt::format("all three must be > 0, otherwise some motion has negative kinetic energy (the 6×6 mass "
                     "matrix has {} positive and {} negative eigenvalues, the lowest {:.6g})",
                     6 - negative, negative, mass(0))});
  }
  if (moments(0) + moments(1) < moments(2) - rounding)
    violated.push_back(
        {found,
         fmt::format("no moment may exceed the sum of the other two (triangle inequality); it does by {:.6g} kg m²",
                     moments(2) - moments(0) - moments(1))});
  return violated;
}

}  // namespace trivet::spatial
