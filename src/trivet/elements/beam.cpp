// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/beam.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trivet/elements/checks.h"
#include "trivet/foundation/first_error.h"

namespace trivet::elements {
namespace {

using std::numbers::pi;

double poisson(const Metal& metal) { return metal.young_modulus / (2 * metal.shear_modulus) - 1; }

double rectangle_torsion(double a, double b) {
  const double wide = std::max(a, b), narrow = std::min(a, b);
  double sum = 0;
  for (int n = 1; n < 200; n += 2) sum += std::tanh(n * pi * wide / (2 * narrow)) / std::pow(n, 5);
  return wide * std::pow(narrow, 3) * (1.0 / 3 - 64 * narrow / (std::pow(pi, 5) * wide) * sum);
}

/// Bending in one plane: Φ = 12EI/(κGA L²), the ratio of shear to bending flexibility of a guided beam.
struct Plane {
  double bending = 0;  // EI [N m²]
  double phi = 0;
  double rotary = 0;  // ρI [kg m]
  int translation = 0, rotation = 0;
  double sign = 1;  // du/dz = sign · θ
};

std::array<Plane, 2> planes(const Beam& b) {
  const auto plane = [&](double moment, double shear_factor, int translation, int rotation, double sign) {
    const double bending = b.metal.young_modulus * moment;
    return Plane{bending,
                 12 * bending / (shear_factor * b.metal.shear_modulus * b.section.area * b.length * b.length),
                 b.metal.density * moment,
                 translation,
                 rotation,
                 sign};
  };
  return {plane(b.section.moment_2, b.section.shear_factor_1, 0, 4, 1),
          plane(b.section.moment_1, b.section.shear_factor_2, 1, 3, -1)};
}

/// Deflection and rotation at ξ = z/L of the static shapes for unit (u_N, θ_N, u_K, θ_K) with du/dz = θ.
struct Shapes {
  Eigen::Vector4d deflection, rotation;
};
Shapes shapes(double x, double phi, double length) {
  const double half = phi / 2;
  Shapes s;
  s.deflection << 2 * x * x * x - 3 * x * x - phi * x + 1 + phi,
      length * (x * x * x - (2 + half) * x * x + (1 + half) * x), -2 * x * x * x + 3 * x * x + phi * x,
      length * (x * x * x - (1 - half) * x * x - half * x);
  s.rotation << 6 * (x * x - x) / length, 3 * x * x - (4 + phi) * x + 1 + phi, -6 * (x * x - x) / length,
      3 * x * x - (2 - phi) * x;
  s.deflection /= 1 + phi;
  s.rotation /= 1 + phi;
  return s;
}

/// dw/dz at ξ of the same deflections.
Eigen::Vector4d slopes(double x, double phi, double length) {
  const double half = phi / 2;
  Eigen::Vector4d slope;
  slope << 6 * x * x - 6 * x - phi, length * (3 * x * x - 2 * (2 + half) * x + 1 + half), -6 * x * x + 6 * x + phi,
      length * (3 * x * x - 2 * (1 - half) * x - half);
  return slope / (length * (1 + phi));
}

/// ∫ w′ᵀw′ dz of one plane over (u_N, θ_N, u_K, θ_K); three Gauss points integrate the fourth-degree polynomials
/// exactly.
Eigen::Matrix4d plane_per_tension(const Plane& p, double length) {
  const double outer = std::sqrt(0.6), points[] = {-outer, 0, outer}, weights[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector4d slope = slopes((1 + points[i]) / 2, p.phi, length);
    sum += weights[i] * length / 2 * slope * slope.transpose();
  }
  return sum;
}

/// Adds a matrix of one plane to the 12×12.
void add_plane(const Plane& p, const Eigen::Matrix4d& local, Matrix12& whole) {
  const int at[] = {p.translation, p.rotation, p.translation + 6, p.rotation + 6};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) whole(at[i], at[j]) += local(i, j) * (i % 2 ? p.sign : 1) * (j % 2 ? p.sign : 1);
}

/// Mass of one plane over (u_N, θ_N, u_K, θ_K); four Gauss points integrate the sixth-degree polynomials exactly.
Eigen::Matrix4d plane_mass(const Plane& p, double line_mass, double length) {
  const double points[] = {-0.861136311594052575, -0.339981043584856265, 0.339981043584856265, 0.861136311594052575};
  const double weights[] = {0.347854845137453857, 0.652145154862546143, 0.652145154862546143, 0.347854845137453857};
  Eigen::Matrix4d mass = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 4; ++i) {
    const Shapes s = shapes((1 + points[i]) / 2, p.phi, length);
    mass += weights[i] * length / 2 *
        (line_mass * s.deflection * s.deflection.transpose() + p.rotary * s.rotation * s.rotation.transpose());
  }
  return mass;
}

}  // namespace

Section round_section(double diameter, const Metal& metal) { return tube_section(diameter, 0, metal); }

Section tube_section(double outer_diameter, double inner_diameter, const Metal& metal) {
  const double ratio = inner_diameter / outer_diameter, nu = poisson(metal),
               q = (1 + ratio * ratio) * (1 + ratio * ratio);
  const double moment = pi * (std::pow(outer_diameter, 4) - std::pow(inner_diameter, 4)) / 64;
  const double shear_factor = 6 * (1 + nu) * q / ((7 + 6 * nu) * q + (20 + 12 * nu) * ratio * ratio);
  return {.area = pi * (outer_diameter * outer_diameter - inner_diameter * inner_diameter) / 4,
          .moment_1 = moment,
          .moment_2 = moment,
          .torsion_constant = 2 * moment,
          .shear_factor_1 = shear_factor,
          .shear_factor_2 = shear_factor};
}

Section rectangular_section(double width_1, double width_2, const Metal& metal) {
  const double nu = poisson(metal), shear_factor = 10 * (1 + nu) / (12 + 11 * nu);
  return {.area = width_1 * width_2,
          .moment_1 = width_1 * std::pow(width_2, 3) / 12,
          .moment_2 = width_2 * std::pow(width_1, 3) / 12,
          .torsion_constant = rectangle_torsion(width_1, width_2),
          .shear_factor_1 = shear_factor,
          .shear_factor_2 = shear_factor};
}

Matrix12 beam_stiffness(const Beam& b) {
  foundation::refuse_errors(check(b));
  Matrix6 moved_end = Matrix6::Zero();
  moved_end(2, 2) = b.metal.young_modulus * b.section.area / b.length;
  moved_end(5, 5) = b.metal.shear_modulus * b.section.torsion_constant / b.length;
  for (const Plane& p : planes(b)) {
    const double unit = p.bending / (std::pow(b.length, 3) * (1 + p.phi));
    moved_end(p.translation, p.translation) = 12 * unit;
    moved_end(p.rotation, p.rotation) = (4 + p.phi) * b.length * b.length * unit;
    moved_end(p.translation, p.rotation) = moved_end(p.rotation, p.translation) = -p.sign * 6 * b.length * unit;
  }
  return from_moved_end(moved_end, {0, 0, b.length});
}

Matrix12 beam_mass(const Beam& b) {
  foundation::refuse_errors(check(b));
  Matrix12 mass = Matrix12::Zero();
  const double line_mass = b.metal.density * b.section.area,
               line_polar = b.metal.density * (b.section.moment_1 + b.section.moment_2);
  for (const auto& [i, per_length] : {std::pair{2, line_mass}, std::pair{5, line_polar}}) {
    mass(i, i) = mass(i + 6, i + 6) = per_length * b.length / 3;
    mass(i, i + 6) = mass(i + 6, i) = per_length * b.length / 6;
  }
  for (const Plane& p : planes(b)) add_plane(p, plane_mass(p, line_mass, b.length), mass);
  return mass;
}

Matrix12 beam_stiffness_per_tension(const Beam& b) {
  foundation::refuse_errors(check(b));
  Matrix12 sum = Matrix12::Zero();
  for (const Plane& p : planes(b)) add_plane(p, plane_per_tension(p, b.length), sum);
  const double torsion = (b.section.moment_1 + b.section.moment_2) / (b.section.area * b.length);
  sum(5, 5) = sum(11, 11) = torsion;
  sum(5, 11) = sum(11, 5) = -torsion;
  return sum;
}

foundation::Problems check(const Beam& b) {
  constexpr double stubby = 3;
  foundation::Problems problems;
  const auto positive = [&](const char* key, double value, const char* unit) {
    if (!(value > 0) || !std::isfinite(value))
      problems.error(key, fmt::format("{} = {:.6g} {}", key, value, unit), "it must be > 0",
                     "check the dimensions of the section");
  };
  const bool sized = check_length(problems, "length", b.length);
  positive("young_modulus", b.metal.young_modulus, "Pa"), positive("shear_modulus", b.metal.shear_modulus, "Pa");
  positive("area", b.section.area, "m²"), positive("moment_1", b.section.moment_1, "m⁴"),
      positive("moment_2", b.section.moment_2, "m⁴");
  positive("torsion_constant", b.section.torsion_constant, "m⁴");
  if (!(b.section.shear_factor_1 > 0 && b.section.shear_factor_2 > 0))
    problems.error("shear_factor",
                   fmt::format("shear factors {:.6g} and {:.6g}", b.section.shear_factor_1, b.section.shear_factor_2),
                   "they must be > 0", "5/6 suits most solid sections");
  if (!(b.metal.density >= 0) || !std::isfinite(b.metal.density))
    problems.error("density", fmt::format("density = {:.6g} kg/m³", b.metal.density), "it must be ≥ 0",
                   "0 is a massless beam");
  const double depth =
      std::sqrt(12 * std::max(b.section.moment_1, b.section.moment_2) / b.section.area);  // of a rectangle
  if (sized && !problems.has_errors() && b.length < stubby * depth)
    problems.warning("length", fmt::format("length = {:.4g} m is {:.3g} of the depth", b.length, b.length / depth),
                     "a beam is at least three times as long as deep", "use a finite-element solid");
  return problems;
}

Matrix12 link_stiffness_per_tension(double length) {
  Matrix12 sum = Matrix12::Zero();
  for (int i = 0; i < 2; ++i) {
    sum(i, i) = sum(i + 6, i + 6) = 1 / length;
    sum(i, i + 6) = sum(i + 6, i) = -1 / length;
  }
  return sum;
}

Matrix12 link_stiffness(const Link& link) {
  foundation::refuse_errors(check(link));
  const Eigen::Vector3d diagonal(link.tension / link.length, link.tension / link.length, link.axial_stiffness);
  Matrix12 stiffness = Matrix12::Zero();
  for (int i = 0; i < 3; ++i) {
    stiffness(i, i) = stiffness(i + 6, i + 6) = diagonal(i);
    stiffness(i, i + 6) = stiffness(i + 6, i) = -diagonal(i);
  }
  return stiffness;
}

spatial::Vector12 link_preload(const Link& link) {
  spatial::Vector12 forces = spatial::Vector12::Zero();
  forces(2) = -link.tension;
  forces(8) = link.tension;
  return forces;
}

foundation::Problems check(const Link& link) {
  foundation::Problems problems;
  check_length(problems, "length", link.length);
  if (!(link.axial_stiffness >= 0) || !std::isfinite(link.axial_stiffness))
    problems.error("axial_stiffness", fmt::format("axial_stiffness = {:.6g} N/m", link.axial_stiffness),
                   "it must be ≥ 0", "it is E A/length of a rod");
  if (!std::isfinite(link.tension))
    problems.error("tension", fmt::format("tension = {:.6g} N", link.tension), "it must be a finite number",
                   "0 is an unloaded link");
  else if (link.tension < 0)
    problems.warning("tension", fmt::format("tension = {:.6g} N", link.tension),
                     "a compressed link pushes its joints sideways: negative stiffness",
                     "check that the joints are guided");
  return problems;
}

}  // namespace trivet::elements
