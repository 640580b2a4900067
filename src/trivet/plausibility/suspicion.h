// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/model/system.h"

/// What an experienced engineer asks back at first sight of a machine: numbers that are possible, but mostly a slip.
/// docs/plausibility.md.
namespace trivet::plausibility {

/// One number that looks like a slip. Everything in words, SI.
struct Suspicion {
  std::string kind;     ///< one of `kinds`
  /// "bodies.machine.mass"; its first two parts are the table in which the suspicion can be accepted
  std::string subject;
  std::string finding;  ///< the number found
  std::string rule;     ///< what is usual
  std::string probable; ///< the probable slip, and what the number would be without it
};

/// All kinds, as `accept` names them.
inline constexpr const char* kinds[] = {
    "mass",          "inertia",     "products of inertia", "center of mass", "density",      "spread of mounts",
        "places",
    "stiffness",     "stiffness per degree", "unequal mounts", "same place", "sag",          "natural frequency",
        "rated load",
    "tipping",       "lift-off",    "gravity",             "modal damping",  "loss factor",  "proportional damping",
        "rayleigh",
    "rotor",         "transient",   "band",                "spectrum",       "points",       "viscous damping",
    "pulse",         "speed",       "scale",               "limit",
};

/// A stretch of frequencies that was asked for, or over which a spectrum drives. [rad/s]
struct Window {
  std::string subject;  ///< "analyses.response.band"
  double from = 0, to = 0;
  bool spectrum = false;
};

/// What a catalogue says of the mount behind an element.
struct Rating {
  std::size_t element = 0;
  double highest_load = 0;  ///< static compression along e3 [N]
  std::string mount;
};

/// A rotor on a body.
struct Rotor {
  std::string excitation;
  std::size_t body = 0;
  std::optional<double> mass;               ///< [kg]
  std::optional<double> mass_eccentricity;  ///< as typed [kg m]
  std::optional<double> grade;              ///< of balancing [mm/s]
  std::optional<double> service_speed;      ///< [rad/s]
};

/// A speed of a shaft, as typed without a unit or with one.
struct Speed {
  std::string subject;  ///< "analyses.orders.speed"
  double value = 0;     ///< [rad/s]
};

/// Largest amplitude of a translation that is allowed.
struct AllowedMotion {
  std::string subject;    ///< "bodies.frame"
  std::string answer;     ///< "frame.z"
  double amplitude = 0;   ///< [m]
};

/// A question for a motion in time.
struct TimeQuestion {
  double to = 0;                         ///< [s]
  std::vector<std::string> excitations;  ///< empty: all
};

/// What the system does not hold of what was stated and asked.
struct Stated {
  std::vector<bool> inertia_about_pole;  ///< per body
  std::vector<bool> from_solids;         ///< per body: mass and inertia come from solids
  std::vector<Window> windows;
  std::vector<Rating> ratings;
  std::vector<Rotor> rotors;
  std::vector<Speed> speeds;
  std::vector<AllowedMotion> allowed_motions;
  std::optional<TimeQuestion> transient;
};

/// Everything suspicious, one entry per cause, in the order body, layout, damping, loads, questions.
[[nodiscard]] std::vector<Suspicion> suspicions(const model::System& system, const Stated& stated);

}  // namespace trivet::plausibility
