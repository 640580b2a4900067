// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled_once.h"
#include "trivet/model/system.h"

/// Questions of an experienced engineer at first sight of a machine, about values that are possible but usually a slip.
/// docs/plausibility.md.
namespace trivet::plausibility {

/// One value that looks like a slip. All texts are for display, in SI units.
struct Suspicion {
  std::string kind;  ///< one of `kinds`
  /// "bodies.machine.mass"; its first two parts are the table in which the suspicion can be accepted
  std::string subject;
  std::string finding;   ///< the number found
  std::string rule;      ///< what is usual
  std::string probable;  ///< the probable slip, and what the number would be without it
  bool by_case = false;  ///< the number is a result of the case, not a number of the file
};

/// All kinds, as `accept` names them.
inline constexpr const char* kinds[] = {
    "mass",
    "inertia",
    "products of inertia",
    "center of mass",
    "density",
    "spread of mounts",
    "places",
    "gap",
    "stiffness",
    "stiffness per degree",
    "unequal mounts",
    "same place",
    "sag",
    "natural frequency",
    "rated load",
    "tipping",
    "lift-off",
    "gravity",
    "modal damping",
    "loss factor",
    "proportional damping",
    "rayleigh",
    "rotor",
    "transient",
    "band",
    "spectrum",
    "points",
    "viscous damping",
    "pulse",
    "speed",
    "scale",
    "limit",
    "ground motion",
    "measured range",
    "service speed",
};

/// A frequency range of an analysis or of an exciting spectrum. [rad/s]
struct Window {
  std::string subject;  ///< "analyses.response.band"
  double from = 0, to = 0;
  bool spectrum = false;
  bool avoided = false;  ///< no natural frequency shall be in it, and its numbers have no unit
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

/// A speed of a shaft that was typed without a unit.
struct Speed {
  std::string subject;  ///< "analyses.orders.speed"
  double value = 0;     ///< [rad/s]
};

/// Largest amplitude of a translation that is allowed.
struct AllowedMotion {
  std::string body;      ///< "frame"
  std::string subject;   ///< "limits.frame.z"
  std::string channel;   ///< "frame.z"
  double amplitude = 0;  ///< [m], [m/s]
  bool is_velocity = false;
  bool is_line = false;        ///< of a limit line; its rows are in SI
  double as_written = 1;       ///< number in the file, in SI, per amplitude: 1/√2 for a limit in rms
  std::string level_ending{};  ///< " rms"; empty if the file has none
};

/// A range over which amplitudes are limited. [rad/s]
struct LimitedRange {
  std::string subject;  ///< "analyses.response.band"
  double from = 0, to = 0;
};

/// A limit line over the bands of a random vibration. [rad/s]
struct BandLine {
  std::string subject;  ///< "limit_lines.floor"
  double from = 0, to = 0;
  std::vector<std::string> excitations;  ///< empty: all
};

/// Pistons, with the oscillating part of their rods.
struct Engine {
  std::string subject;  ///< "excitations.crank.engine.oscillating_mass"
  std::size_t body = 0;
  double oscillating_mass = 0, cylinders = 0;  ///< [kg] of one
};

/// A transient analysis.
struct TimeAnalysis {
  std::optional<double> to;              ///< [s]; empty: some periods after the last input
  std::vector<std::string> excitations;  ///< empty: all
};

/// Statements and analyses of the project that the system does not contain.
struct Stated {
  std::vector<bool> inertia_about_pole;  ///< per body
  std::vector<bool> from_solids;         ///< per body: mass and inertia come from solids
  std::vector<Window> windows;
  std::vector<Rotor> rotors;
  std::vector<Speed> speeds;
  std::vector<AllowedMotion> allowed_motions;
  std::vector<LimitedRange> limited_ranges;
  std::vector<BandLine> band_lines;
  std::vector<Engine> engines;
  std::optional<TimeAnalysis> transient;
  /// Table and kind of each suspicion that the user has accepted; an accepted value causes no suspicion about other
  /// values.
  std::vector<std::pair<std::string, std::string>> accepted;
};

/// The table in which a suspicion with this subject is accepted: "bodies.machine", "damping", "limits", "" for the top
/// of the file.
[[nodiscard]] std::string table_of(const std::string& subject);

/// Suspicions about frequency ranges alone.
[[nodiscard]] std::vector<Suspicion> suspicions_about(const model::System& system, const std::vector<Window>& windows);

/// All suspicions, one per cause, in the order body, layout, damping, loads, analyses.
/// @param assembled  the system
[[nodiscard]] std::vector<Suspicion> suspicions(const model::System& system, const assembly::AssembledOnce& assembled,
                                                const Stated& stated);

}  // namespace trivet::plausibility
