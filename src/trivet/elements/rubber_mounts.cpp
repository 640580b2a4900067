// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/rubber_mounts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/elements/checks.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {

namespace {

double layer_thickness(const Sandwich& s) {
  return std::visit([](const auto& layer) { return layer.thickness; }, s.layer);
}

/// Inverse of a 6×6 of newtons and newton metres, scaled by its diagonal; the flag shows whether it is regular.
std::pair<Matrix6, bool> inverse(const Matrix6& matrix) {
  const Vector6 scale = matrix.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return {Matrix6::Zero(), false};
  const Matrix6 scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  return {scale.asDiagonal() * numerics::completely_pivoted_inverse(scaled) * scale.asDiagonal(),
          numerics::is_regular(scaled)};
}

}  // namespace

Matrix12 in_series(const std::vector<SeriesPart>& parts, const std::vector<Eigen::Vector3d>& spacers) {
  if (parts.empty() || spacers.size() + 1 != parts.size())
    throw foundation::InvalidInput(
        fmt::format("elements in series: {} spacers between {} parts, must be one fewer than the parts", spacers.size(),
                    parts.size()));
  Matrix6 flexibility = Matrix6::Zero();
  Eigen::Vector3d to_end = Eigen::Vector3d::Zero();  // from K of the current part to the last K
  for (std::size_t i = parts.size(); i-- > 0;) {
    const auto [own, regular] = inverse(parts[i].stiffness.bottomRightCorner<6, 6>());
    if (!regular) throw foundation::InvalidInput(fmt::format("elements in series: part {} is free to move", i + 1));
    const Matrix6 carry = spatial::rigid_motion(to_end);
    flexibility += carry * own * carry.transpose();
    to_end += parts[i].arm;
    if (i > 0) to_end += spacers[i - 1];
  }
  return from_moved_end(inverse(flexibility).first, to_end);
}

double height(const Sandwich& s) { return s.layers * layer_thickness(s) + (s.layers - 1) * s.plate_thickness; }

Matrix12 sandwich(const Sandwich& s) {
  foundation::refuse_errors(check(s));
  const SeriesPart part{std::holds_alternative<RubberDisc>(s.layer) ? rubber_disc(std::get<RubberDisc>(s.layer))
                                                                    : rubber_block(std::get<RubberBlock>(s.layer)),
                        {0, 0, layer_thickness(s)}};
  const auto count = to_size(s.layers);
  return in_series(std::vector(count, part), std::vector(count - 1, Eigen::Vector3d(0, 0, s.plate_thickness)));
}

foundation::Problems check(const Sandwich& s) {
  constexpr int most_layers = 1000;
  foundation::Problems problems = std::visit([](const auto& layer) { return check(layer); }, s.layer);
  if (s.layers < 1 || s.layers > most_layers)
    problems.error("layers", fmt::format("layers = {}", s.layers),
                   fmt::format("a sandwich has 1 … {} rubber layers", most_layers), "give the number of rubber layers");
  if (s.plate_thickness > 0) static_cast<void>(check_length(problems, "plate_thickness", s.plate_thickness));
  else if (s.plate_thickness != 0)
    problems.error("plate_thickness", fmt::format("plate_thickness = {:.6g} m", s.plate_thickness), "it must be ≥ 0",
                   "give a length in metres");
  return problems;
}

namespace {

using std::numbers::pi;

/// Radial stiffness of a plane bonded ring per G and length, exact for Poisson's ratio ν in plane strain.
double plane_ring(double poisson, double radius_ratio) {
  const double stiffening = 3 - 4 * poisson, squared = radius_ratio * radius_ratio;
  return 8 * pi * (1 - poisson) * stiffening /
      (stiffening * stiffening * std::log(radius_ratio) - (squared - 1) / (squared + 1));
}

/// Tilting stiffness of a slice per G ri² and length by transverse shear alone, ∫ |grad w + (h, h)|² r dr/π: at the
/// tilting pin w = −r, in-plane motion is h = ln(ro/r)/ln(ro/ri), and w(r) minimises the energy. r in units of ri.
double slice_tilt(double radius_ratio) {
  constexpr int steps = 64;
  const double log_ratio = std::log(radius_ratio), c = 1 / (2 * log_ratio);
  const double a = (1 / radius_ratio - radius_ratio / 2) / (radius_ratio - 1 / radius_ratio), b = -1 - a;
  const auto energy = [&](double r) {
    const double h = 1 - std::log(r) / log_ratio, slope = c * (std::log(r) + 1) + a - b / (r * r),
                 chord = c * std::log(r) + a + b / (r * r);
    return ((h + slope) * (h + slope) + (h + chord) * (h + chord)) * r;
  };
  const double step = (radius_ratio - 1) / steps;
  double sum = energy(1) + energy(radius_ratio);
  for (int i = 1; i < steps; ++i) sum += (i % 2 ? 4 : 2) * energy(1 + i * step);
  return pi * step / 3 * sum;
}

/// Mean over 2x decay lengths of a pressure that falls to 0 at the free ends, for a uniform and for a linear load.
double even_mean(double x) { return x < 1e-3 ? x * x / 3 : 1 - std::tanh(x) / x; }
double odd_mean(double x) { return x < 0.05 ? x * x / 15 : 1 - 3 * (x / std::tanh(x) - 1) / (x * x); }

/// Axial decay length [m] of the pressure due to radial motion: about the mean radius, less if compressible.
double decay_length(const RubberBush& b) {
  const double mean = (b.inner_radius + b.outer_radius) / 2, wall = b.outer_radius - b.inner_radius;
  const double around = mean * (1 + 0.15 * wall / (2 * mean));
  return 1 / std::sqrt(1 / (around * around) + 12 * b.rubber.shear_modulus / (b.rubber.bulk_modulus * wall * wall));
}

}  // namespace

double long_bush_axial(const RubberBush& b) {
  return 2 * pi * b.rubber.shear_modulus * b.length / std::log(b.outer_radius / b.inner_radius);
}

double bush_torsion(const RubberBush& b) {
  return 4 * pi * b.rubber.shear_modulus * b.length /
      (1 / (b.inner_radius * b.inner_radius) - 1 / (b.outer_radius * b.outer_radius));
}

double long_bush_radial(const RubberBush& b) {
  return b.rubber.shear_modulus * b.length * plane_ring(poisson_ratio(b.rubber), b.outer_radius / b.inner_radius);
}

double short_bush_radial(const RubberBush& b) {
  const double poisson = poisson_ratio(b.rubber);
  return b.rubber.shear_modulus * b.length * plane_ring(poisson / (1 + poisson), b.outer_radius / b.inner_radius);
}

BushConstants bush_constants(const RubberBush& b) {
  constexpr double shear_edge =
      0.1153;  // wall thicknesses at each free end that carry no axial shear, as at the edge of a thin layer
  foundation::refuse_errors(check(b));
  const double wall = b.outer_radius - b.inner_radius, ends = 1 - 2 * shear_edge * wall / b.length,
               x = b.length / (2 * decay_length(b));
  const double relieved = short_bush_radial(b), kept = long_bush_radial(b) - relieved,
               radius_squared = b.inner_radius * b.inner_radius;
  const double shear_tilt =
      b.rubber.shear_modulus * b.length * radius_squared * slice_tilt(b.outer_radius / b.inner_radius);
  return {.radial = b.dynamic_factor * (relieved + kept * even_mean(x)),
          .axial = b.dynamic_factor * ends * long_bush_axial(b),
          .tilt = b.dynamic_factor * ((relieved + kept * odd_mean(x)) * b.length * b.length / 12 + ends * shear_tilt),
          .torsion = b.dynamic_factor * bush_torsion(b)};
}

Matrix12 rubber_bush(const RubberBush& bush) {
  const BushConstants c = bush_constants(bush);
  return constants_at_point((Vector6() << c.radial, c.radial, c.axial, c.tilt, c.tilt, c.torsion).finished(),
                            Eigen::Vector3d::Zero(), 0);
}

foundation::Problems check(const RubberBush& b) {
  constexpr double shortest = 0.5, short_length = 1, thinnest = 1.1, thickest = 5;
  foundation::Problems problems = check(b.rubber);
  const bool sized = check_lengths(
      problems, {{"inner_radius", b.inner_radius}, {"outer_radius", b.outer_radius}, {"length", b.length}});
  check_factor(problems, b.dynamic_factor);
  if (!sized) return problems;
  const double wall = b.outer_radius - b.inner_radius, ratio = b.outer_radius / b.inner_radius;
  if (!(wall > 0)) {
    problems.error("outer_radius", fmt::format("an outer radius of {:.6g} m", b.outer_radius),
                   fmt::format("it must exceed the inner radius {:.6g} m", b.inner_radius),
                   "exchange the radii if they were swapped");
    return problems;
  }
  check_slenderness(problems, "outer_radius", b.outer_radius, wall);
  check_slenderness(problems, "length", wall, b.length);
  if (ratio < thinnest || ratio > thickest)
    problems.warning("outer_radius", fmt::format("outer over inner radius = {:.4g}", ratio),
                     "the formulas were checked for ratios from 1.1 to 5", "use a finite-element mount");
  if (b.length < shortest * wall)
    problems.error("length", fmt::format("length = {:.6g} m is {:.3g} of the wall", b.length, b.length / wall),
                   "the formulas hold for bushes at least half as long as their wall is thick",
                   "use a finite-element mount");
  else if (b.length < short_length * wall)
    problems.warning("length", fmt::format("length = {:.6g} m is {:.3g} of the wall", b.length, b.length / wall),
                     "below one wall thickness the formulas are accurate to 10 % only", "use a finite-element mount");
  return problems;
}

}  // namespace trivet::elements
