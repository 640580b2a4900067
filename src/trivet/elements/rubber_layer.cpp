// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/rubber_layer.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/elements/checks.h"
#include "trivet/elements/pressure_modulus.h"
#include "trivet/foundation/first_error.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::elements {
namespace {

using std::numbers::pi;

// Edge layers of a thin layer, in thicknesses, from plane-strain and axisymmetric finite elements
// (docs/elements/rubber.md): the pressure falls to zero as if the edge were this far inside, and an edge normal to the
// shearing direction carries no load over this width.
constexpr double pressure_edge = 0.05;
constexpr double shear_edge = 0.1153;

/// Transition of a layer of shape factor S from tall (0) to thin (1): 1 − e^{−S/scale}.
double thinness(double shape_factor, double scale) { return 1 - std::exp(-shape_factor / scale); }

/// k = (G A/h)/(1 + edges + bending): bending flexibility h² A/(36 I) of a tall layer, reduced by the plates if it is
/// low.
double shear_flexibility(double edges, double bending, double slenderness, double hold) {
  return 1 + edges + bending * slenderness / (slenderness + hold);
}

/// Share of the uniform stretching, over 3G: 1 for a tall solid disc, 1.147 for a thin one, 4/3 and 1.53 for a strip,
/// as rubber cannot move along the strip. A ring is a curved strip; a small hole increases the share.
double ring_axial_share(double hole_ratio, double shape_factor) {
  const double thin = 0.527 + 0.0125 / (hole_ratio * hole_ratio), scale = 0.2 + 0.02 / (hole_ratio * hole_ratio);
  return 1 + thin * (1 - std::exp(-std::pow(shape_factor / scale, 1.2)));
}
double ring_bending_share(double hole_ratio, double shape_factor) {
  const double thin = 0.33 + 0.19 * (1 - std::exp(-hole_ratio / 0.28));
  return 1 + thin * thinness(shape_factor, 0.65 - 0.6 * hole_ratio);
}

struct Moduli {
  double axial = 0, bending_1 = 0, bending_2 = 0;  // [Pa]
};

Moduli disc_moduli(const RubberDisc& d) {
  const double e0 = 3 * d.rubber.shear_modulus, s = disc_shape_factor(d.radius, d.hole_radius, d.thickness);
  const double radius = d.radius / (1 + pressure_edge * d.thickness / d.radius), shrink = radius / d.radius;
  const double axial =
      std::pow(shrink, 2) * disc_pressure_modulus(d.rubber, radius, d.thickness) + e0 * (1 + 0.147 * thinness(s, 0.18));
  const double bending = std::pow(shrink, 4) * disc_pressure_bending_modulus(d.rubber, radius, d.thickness) +
      e0 * (1 + 0.333 * thinness(s, 0.58));
  return {axial, bending, bending};
}

Moduli ring_moduli(const RubberDisc& d) {
  const double e0 = 3 * d.rubber.shear_modulus, s = disc_shape_factor(d.radius, d.hole_radius, d.thickness),
               p = d.hole_radius / d.radius;
  const double middle = (d.radius + d.hole_radius) / 2, half = (d.radius - d.hole_radius) / 2;
  const double half_width = half / (1 + pressure_edge * d.thickness / half), outer = middle + half_width,
               inner = middle - half_width;
  const auto powers = [](double a, double b, int n) { return std::pow(a, n) - std::pow(b, n); };
  const double area = powers(outer, inner, 2) / powers(d.radius, d.hole_radius, 2),
               moment = powers(outer, inner, 4) / powers(d.radius, d.hole_radius, 4);
  const double axial = area * ring_pressure_modulus(d.rubber, outer, inner, d.thickness) + e0 * ring_axial_share(p, s);
  const double bending =
      moment * ring_pressure_bending_modulus(d.rubber, outer, inner, d.thickness) + e0 * ring_bending_share(p, s);
  return {axial, bending, bending};
}

/// Constraint of the rubber along the longer side: 1 for a square or tall block, 4/3 for a strip (Gent and Meinecke
/// 1970).
double strip_factor(double a, double b, double h) {
  return 4.0 / 3 - 2.0 / 3 * (a * b + h * h) / (a * a + b * b + 2 * h * h);
}

/// Share of the stretching in the bending of a block, over 3G, strains varying over the width `along`; the longer the
/// other width, the more the block is a strip. Corners increase the share.
double block_bending_share(double along, double across, double h, double shape_factor) {
  const double squares = along * along + across * across, squareness = 2 * along * across / squares;
  const double tall = strip_factor(along, across, h), thin = 1.52 - 0.19 * squareness;
  const double direction = 1 + 0.1 * squareness * (across * across - along * along) / squares;
  return direction * (tall + (thin - tall) * thinness(shape_factor, 0.57)) +
      0.1 * squareness * thinness(shape_factor, 1.2);
}

double block_axial_share(double a, double b, double h, double shape_factor) {
  const double squareness = 2 * a * b / (a * a + b * b);
  return strip_factor(a, b, h) * (1 + 0.147 * thinness(shape_factor, 0.2)) +
      0.25 * squareness * thinness(shape_factor, 1);
}

Moduli block_moduli(const RubberBlock& b) {
  const double e0 = 3 * b.rubber.shear_modulus, h = b.thickness, s = block_shape_factor(b.width_1, b.width_2, h);
  const double shrink_1 = 1 / (1 + 2 * pressure_edge * h / b.width_1),
               shrink_2 = 1 / (1 + 2 * pressure_edge * h / b.width_2);
  const double w1 = shrink_1 * b.width_1, w2 = shrink_2 * b.width_2;
  const double axial = shrink_1 * shrink_2 * block_pressure_modulus(b.rubber, w1, w2, h);
  const double bending_1 = shrink_1 * std::pow(shrink_2, 3) * block_pressure_bending_modulus(b.rubber, w2, w1, h);
  const double bending_2 = shrink_2 * std::pow(shrink_1, 3) * block_pressure_bending_modulus(b.rubber, w1, w2, h);
  return {axial + e0 * block_axial_share(b.width_1, b.width_2, h, s),
          bending_1 + e0 * block_bending_share(b.width_2, b.width_1, h, s),
          bending_2 + e0 * block_bending_share(b.width_1, b.width_2, h, s)};
}

Moduli textbook_moduli(const Rubber& rubber, double shape_factor) {
  const double bending = gent_meinecke_bending_modulus(rubber, shape_factor);
  return {gent_lindley_modulus(rubber, shape_factor), bending, bending};
}

double disc_shear_flexibility(const RubberDisc& d) {
  const double x = d.thickness / (d.radius - d.hole_radius), p = d.hole_radius / d.radius;
  return shear_flexibility(shear_edge * x, x * x / 9 * (0.53 + 0.47 * std::exp(-10 * p)), x, 2.6);
}

double block_shear_flexibility(double along, double across, double h) {
  const double strip = strip_factor(along, across, h), x = 2 * h / along;
  return shear_flexibility(shear_edge * x, h * h / (3 * along * along * strip), x, 2.6 + 2.4 * (strip - 1));
}

/// Torsion constant of a block with ends that cannot warp, the factor on G/h [m⁴]: uniform torque with the warping χ(z)
/// φ(x, y), φ = c₁xy + c₂x³y + c₃xy³, by Ritz. The stiffness is G I_p/h for a low block and G J/h for a tall one.
double block_torsion_constant(const RubberBlock& b) {
  const double a = b.width_1 / 2, c = b.width_2 / 2;
  const auto integral = [&](int i, int j) {  // ∫ xⁱ yʲ over the section
    return i % 2 || j % 2 ? 0.0 : 4 * std::pow(a, i + 1) * std::pow(c, j + 1) / ((i + 1) * (j + 1));
  };
  const int px[] = {1, 3, 1}, py[] = {1, 1, 3};
  Eigen::Matrix3d gradient, square;
  Eigen::Vector3d load;  // ∫ (y φ,x − x φ,y)
  for (int m = 0; m < 3; ++m) {
    load(m) = px[m] * integral(px[m] - 1, py[m] + 1) - py[m] * integral(px[m] + 1, py[m] - 1);
    for (int n = 0; n < 3; ++n) {
      const int x = px[m] + px[n], y = py[m] + py[n];
      gradient(m, n) = px[m] * px[n] * integral(x - 2, y) + py[m] * py[n] * integral(x, y - 2);
      square(m, n) = integral(x, y);
    }
  }
  const Eigen::Vector3d warping = numerics::cholesky_solution(gradient, load);
  const double polar = integral(2, 0) + integral(0, 2), relief = load.dot(warping), constant = polar - relief;
  if (relief <= 1e-14 * polar) return polar;
  const double k = std::sqrt(relief * constant / (3 * polar * warping.dot(square * warping))), x = k * b.thickness / 2;
  return polar / (1 + relief / constant * (1 - std::tanh(x) / x));
}

}  // namespace

LayerConstants layer_constants(const RubberDisc& d) {
  foundation::refuse_errors(check(d));
  const double area = pi * (d.radius * d.radius - d.hole_radius * d.hole_radius), h = d.thickness;
  const double moment = pi * (std::pow(d.radius, 4) - std::pow(d.hole_radius, 4)) / 4, factor = d.dynamic_factor;
  const bool textbook = d.formulas == LayerFormulas::textbook;
  const Moduli moduli = textbook ? textbook_moduli(d.rubber, disc_shape_factor(d.radius, d.hole_radius, h))
      : d.hole_radius > 0        ? ring_moduli(d)
                                 : disc_moduli(d);
  const double shear = factor * d.rubber.shear_modulus * area / h / (textbook ? 1 : disc_shear_flexibility(d));
  return {.shear_1 = shear,
          .shear_2 = shear,
          .axial = factor * moduli.axial * area / h,
          .bending_1 = factor * moduli.bending_1 * moment / h,
          .bending_2 = factor * moduli.bending_2 * moment / h,
          .torsion = factor * d.rubber.shear_modulus * 2 * moment / h};
}

LayerConstants layer_constants(const RubberBlock& b) {
  foundation::refuse_errors(check(b));
  const double area = b.width_1 * b.width_2, h = b.thickness, factor = b.dynamic_factor,
               shear = factor * b.rubber.shear_modulus * area / h;
  const bool textbook = b.formulas == LayerFormulas::textbook;
  const Moduli moduli =
      textbook ? textbook_moduli(b.rubber, block_shape_factor(b.width_1, b.width_2, h)) : block_moduli(b);
  return {.shear_1 = shear / (textbook ? 1 : block_shear_flexibility(b.width_1, b.width_2, h)),
          .shear_2 = shear / (textbook ? 1 : block_shear_flexibility(b.width_2, b.width_1, h)),
          .axial = factor * moduli.axial * area / h,
          .bending_1 = factor * moduli.bending_1 * area * b.width_2 * b.width_2 / (12 * h),
          .bending_2 = factor * moduli.bending_2 * area * b.width_1 * b.width_1 / (12 * h),
          .torsion = factor * b.rubber.shear_modulus * block_torsion_constant(b) / h};
}

namespace {
Matrix12 at_mid_height(const LayerConstants& c, double thickness) {
  const Vector6 constants =
      (Vector6() << c.shear_1, c.shear_2, c.axial, c.bending_1, c.bending_2, c.torsion).finished();
  return constants_at_point(constants, {0, 0, thickness}, 0.5);
}
}  // namespace

Matrix12 rubber_disc(const RubberDisc& disc) { return at_mid_height(layer_constants(disc), disc.thickness); }
Matrix12 rubber_block(const RubberBlock& block) { return at_mid_height(layer_constants(block), block.thickness); }

foundation::Problems check(const RubberDisc& d) {
  constexpr double smallest_hole = 0.1, small_hole = 0.2;
  foundation::Problems problems = check(d.rubber);
  const bool sized = check_lengths(problems, {{"radius", d.radius}, {"thickness", d.thickness}});
  check_factor(problems, d.dynamic_factor);
  if (sized) check_slenderness(problems, "thickness", d.radius, d.thickness);
  if (!(d.radius > 0)) return problems;  // the hole cannot be compared with it
  if (!(d.hole_radius >= 0 && d.hole_radius < d.radius))
    problems.error("hole_radius", fmt::format("a radius of {:.6g} m", d.hole_radius),
                   fmt::format("it must be ≥ 0 and below the radius {:.6g} m", d.radius), "0 is a solid disc");
  else if (d.hole_radius > 0 && d.hole_radius < smallest_hole * d.radius)
    problems.error(
        "hole_radius",
        fmt::format("hole_radius = {:.6g} m is {:.3g} of the radius", d.hole_radius, d.hole_radius / d.radius),
        "the formulas hold for holes from 0.1 of the radius", "omit the hole or use a finite-element mount");
  else if (d.hole_radius > 0 && d.hole_radius < small_hole * d.radius)
    problems.warning(
        "hole_radius",
        fmt::format("hole_radius = {:.6g} m is {:.3g} of the radius", d.hole_radius, d.hole_radius / d.radius),
        "below 0.2 of the radius the axial stiffness is accurate to 10 % only", "use a finite-element mount");
  if (sized && d.hole_radius >= 0 && d.hole_radius < d.radius)
    check_shape_factor(problems, disc_shape_factor(d.radius, d.hole_radius, d.thickness));
  return problems;
}

foundation::Problems check(const RubberBlock& b) {
  foundation::Problems problems = check(b.rubber);
  const bool sized =
      check_lengths(problems, {{"width_1", b.width_1}, {"width_2", b.width_2}, {"thickness", b.thickness}});
  check_factor(problems, b.dynamic_factor);
  if (sized) check_slenderness(problems, "thickness", b.width_1, b.thickness);
  if (sized && !problems.has_errors()) check_slenderness(problems, "thickness", b.width_2, b.thickness);
  if (sized) check_shape_factor(problems, block_shape_factor(b.width_1, b.width_2, b.thickness));
  return problems;
}

}  // namespace trivet::elements
