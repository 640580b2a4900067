// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {
namespace {

/// Largest motion of a free body under its unbalance / rms size of the body: shakers have 0.01.
constexpr double largest_throw = 0.03;
constexpr double coarsest_grade = 4000;  ///< [mm/s] of ISO 21940-11: large rigid engines
constexpr double fastest_rim = 600;      ///< [m/s] steel bursts
constexpr double density_of_steel = 7850;

/// Radius of a steel cylinder twice as long as thick: m = ρ π r² 4r [m].
double radius_of(double mass) { return std::cbrt(mass / (4 * std::numbers::pi * density_of_steel)); }

void judge_balancing(const Rotor& rotor, const std::string& subject, Suspicions& found) {
  if (rotor.grade && *rotor.grade > coarsest_grade)
    found.push_back(
        {"rotor", subject + ".grade", fmt::format("G {:.6g}", *rotor.grade),
         fmt::format("balancing grades are between 0.4 and {:.0f} mm/s", coarsest_grade),
         fmt::format("it would be G {:.6g} with the decimal point three places to the left", *rotor.grade / 1000)});
  if (!rotor.mass || !rotor.service_speed || !(*rotor.mass > 0)) return;
  const double rim = radius_of(*rotor.mass) * *rotor.service_speed;
  if (rim > fastest_rim)
    found.push_back({"speed", subject + ".service_speed",
                     fmt::format("{:.6g} rpm", *rotor.service_speed * foundation::rpm_per_rad_s),
                     fmt::format("the rim of a steel rotor of {:.4g} kg would run at {:.0f} m/s", *rotor.mass, rim),
                     "check its unit: rpm, Hz or rad/s"});
}

void judge_mass(const model::System& system, const Rotor& rotor, const std::string& subject, Suspicions& found) {
  const model::Body& body = system.bodies()[rotor.body];
  if (body.is_node) return;
  if (rotor.mass && *rotor.mass > body.mass.mass)
    found.push_back(
        {"rotor", subject + ".rotor_mass", fmt::format("{:.6g} kg", *rotor.mass),
         fmt::format("a rotor weighs less than its machine, \"{}\" of {:.6g} kg", body.name, body.mass.mass),
         "check the unit of both"});
  if (!rotor.mass_eccentricity || !body.has_inertia || !(body.mass.inertia_about_centre.trace() > 0)) return;
  const double thrown = *rotor.mass_eccentricity / body.mass.mass;
  if (thrown > largest_throw * mass_radius(body.mass))
    found.push_back({"rotor", subject + ".mass_eccentricity", fmt::format("{:.6g} kg m", *rotor.mass_eccentricity),
                     fmt::format("\"{}\" of {:.6g} kg would move by {}", body.name, body.mass.mass,
                                 foundation::prefixed(thrown, "m")),
                     "kg mm and g mm are smaller by 1e3 and 1e6: write the unit"});
}

}  // namespace

void judge_speeds(const std::vector<Speed>& speeds, Suspicions& found) {
  static constexpr double synchronous[] = {600, 750, 900, 1000, 1200, 1500, 1800, 3000, 3600};  // [rpm]
  constexpr double slip = 0.05;  // of induction motors, whose speeds are whole numbers on their plates
  for (const Speed& speed : speeds)
    if (speed.value == std::floor(speed.value) &&
        std::any_of(std::begin(synchronous), std::end(synchronous),
                    [&](double usual) { return speed.value <= usual && speed.value >= (1 - slip) * usual; }))
      found.push_back({"speed", speed.subject,
                       fmt::format("{:.0f}, which is {:.0f} rpm", speed.value, speed.value * foundation::rpm_per_rad_s),
                       "a number without a unit is in rad/s",
                       fmt::format("write \"{:.0f} rpm\" if revolutions per minute are meant", speed.value)});
}

void judge_engines(const model::System& system, const std::vector<Engine>& engines, Suspicions& found) {
  for (const Engine& engine : engines) {
    const model::Body& body = system.bodies()[engine.body];
    if (body.is_node) continue;
    const double all = engine.cylinders * engine.oscillating_mass;
    if (all > body.mass.mass)
      found.push_back(
          {"rotor", engine.subject,
           fmt::format("{:.6g} kg in each of {:.0f} cylinders", engine.oscillating_mass, engine.cylinders),
           fmt::format("pistons weigh less than their machine, \"{}\" of {:.6g} kg", body.name, body.mass.mass),
           "write \"g\" or \"kg\""});
  }
}

void judge_rotors(const model::System& system, const std::vector<Rotor>& rotors, Suspicions& found) {
  for (const Rotor& rotor : rotors) {
    const std::string subject = "excitations." + rotor.excitation;
    judge_balancing(rotor, subject, found);
    judge_mass(system, rotor, subject, found);
  }
}

}  // namespace trivet::plausibility
