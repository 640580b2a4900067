// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/plausibility/inertia_slips.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace trivet::plausibility {
namespace {

/// Σ Jij²/(Jii Jjj) of the central products: deviation of the body axes from the principal axes. Machines described in
/// their main axes have little; this much is doubtful if the other sign leaves a ninth of it.
constexpr double much_coupling = 0.09, ratio_of_signs = 9;
/// Limits of mass / size³ of a machine [kg/m³], to choose among slips.
constexpr double least_density = 3, most_density = 20000;

Eigen::Matrix3d other_sign(const Eigen::Matrix3d& j) {
  Eigen::Matrix3d flipped = -j;
  flipped.diagonal() = j.diagonal();
  return flipped;
}

bool is_real(const spatial::MassProperties& mass) {
  if (!spatial::violated_bounds(mass).empty()) return false;
  const double density = mass.mass / std::pow(2 * mass_radius(mass), 3);
  return density > least_density && density < most_density;
}

double coupling(const Eigen::Matrix3d& j) {
  double sum = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b) sum += j(a, b) * j(a, b) / (j(a, a) * j(b, b));
  return sum;
}

}  // namespace

std::optional<InertiaSlip> slip_behind(const spatial::MassProperties& mass, bool inertia_about_pole) {
  if (!(mass.mass > 0) || spatial::violated_bounds(mass).empty()) return std::nullopt;
  const Eigen::Matrix3d about_pole = spatial::inertia_about_pole(mass),
                        typed = inertia_about_pole ? about_pole : mass.inertia_about_centre;
  const auto with = [&](double m, const Eigen::Vector3d& centre, const Eigen::Matrix3d& j) {
    return inertia_about_pole ? spatial::from_inertia_about_pole(m, centre, j) : spatial::MassProperties{m, centre, j};
  };
  const bool has_products = !typed.isDiagonal(0);
  if (has_products && is_real(with(mass.mass, mass.centre, other_sign(typed))))
    return InertiaSlip{
        "products of inertia",
        "suspicion \"products of inertia\": the body is possible with the opposite sign of its products of inertia: "
        "xy = ∫xy dm, not the entry of the tensor"};
  if (inertia_about_pole) {
    struct Unit {
      const char* kind;
      const char* words;
      double mass, centre, inertia;
    };
    static constexpr std::array<Unit, 8> units = {{{"mass", "mass in grams", 1e-3, 1, 1},
                                                   {"center of mass", "center_of_mass in millimetres", 1, 1e-3, 1},
                                                   {"center of mass", "center_of_mass in centimetres", 1, 1e-2, 1},
                                                   {"inertia", "inertia in t m²", 1, 1, 1e3},
                                                   {"inertia", "inertia in kg cm²", 1, 1, 1e-4},
                                                   {"inertia", "inertia in kg mm²", 1, 1, 1e-6},
                                                   {"inertia", "inertia in g cm²", 1, 1, 1e-7},
                                                   {"mass", "mass in tonnes", 1e3, 1, 1}}};
    InertiaSlip slip;
    if (is_real({mass.mass, mass.centre, typed}))
      slip = {"inertia",
              "suspicion \"inertia\": the body is possible if its inertia is about the centre of mass, not the pole"};
    for (const Unit& unit : units)
      if (is_real(with(unit.mass * mass.mass, unit.centre * mass.centre, unit.inertia * typed))) {
        slip.words += fmt::format("{}suspicion \"{}\": the body is possible with the {}",
                                  slip.words.empty() ? "" : ", or ", unit.kind, unit.words);
        slip.kind = slip.kind.empty() ? unit.kind : slip.kind;
      }
    if (!slip.kind.empty()) return slip;
  }
  return std::nullopt;
}

std::optional<Suspicion> doubtful_products(const std::string& body, const BodyPicture& picture) {
  if (!picture.inertia_about_pole || picture.from_solids) return std::nullopt;
  const spatial::MassProperties& mass = picture.mass;
  const spatial::MassProperties other =
      spatial::from_inertia_about_pole(mass.mass, mass.centre, other_sign(spatial::inertia_about_pole(mass)));
  if (!spatial::violated_bounds(other).empty()) return std::nullopt;
  const double now = coupling(mass.inertia_about_centre), then = coupling(other.inertia_about_centre);
  if (now < much_coupling || then * ratio_of_signs > now) return std::nullopt;
  const Eigen::Matrix3d& j = mass.inertia_about_centre;
  return Suspicion{
      "products of inertia", "bodies." + body + ".inertia",
      fmt::format("about the centre of mass xy = {:.4g}, xz = {:.4g}, yz = {:.4g} kg m² remain", -j(0, 1), -j(0, 2),
                  -j(1, 2)),
      "about the pole, products of inertia usually come from the position of the centre of mass: xy = m x y",
      fmt::format("with the opposite sign xy = {:.4g}, xz = {:.4g}, yz = {:.4g} kg m² would remain; xy = ∫xy dm",
                  -other.inertia_about_centre(0, 1), -other.inertia_about_centre(0, 2),
                  -other.inertia_about_centre(1, 2))};
}

}  // namespace trivet::plausibility
