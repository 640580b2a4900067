// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/unsupported_keys.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace trivet::project {
namespace {

using Words = std::vector<std::string_view>;

const Words nonlinear_laws = {"law",
                              "laws",
                              "nonlinear",
                              "nonlinearity",
                              "cubic",
                              "quadratic",
                              "quintic",
                              "gap",
                              "gaps",
                              "clearance",
                              "backlash",
                              "bump_stop",
                              "bump_stops",
                              "stop",
                              "stops",
                              "end_stop",
                              "end_stops",
                              "snubber",
                              "snubbers",
                              "contact",
                              "impact",
                              "friction",
                              "dry_friction",
                              "coulomb",
                              "stick_slip",
                              "iwan",
                              "bouc_wen",
                              "lugre",
                              "hardening",
                              "softening",
                              "progressive",
                              "characteristic",
                              "characteristics",
                              "force_curve",
                              "curve",
                              "hydromount",
                              "unilateral",
                              "restoring",
                              "force_deflection",
                              "load_deflection",
                              "piecewise_linear",
                              "tension_only",
                              "compression_only",
                              "amplitude_dependent"};
const Words optimising = {"optimise", "optimize", "optimisation", "optimization", "optimum", "objective",
                          "minimise", "minimize", "select",       "selection",    "choose"};
const Words scattering = {"sample", "samples",    "sampling", "tolerance",  "tolerances",
                          "robust", "robustness", "yield",    "monte_carlo"};
const Words nonlinear_analyses = {"nonlinear",       "continuation", "harmonic_balance", "backbone",  "backbones",
                                  "nonlinear_modes", "limit_cycle",  "limit_cycles",     "stability", "bifurcations"};
const Words turning = {"gyroscopic", "gyroscopic_moment", "spin", "spin_speed", "rotor", "rotors"};

const UnsupportedKey of_elements = {
    "no such key here: nonlinear laws are keys of `laws`, of elements with a stiffness matrix; stops and struts have "
    "their own keys (docs/nonlinear.md)",
    "write for instance laws.z = {cubic = \"1e10 N/m^3\"}, or type = \"stop\"; or remove the key"};
const UnsupportedKey of_designs = {
    "the best design is requested in [analyses.optimize], and mounts are chosen by trivet select",
    "write [parameters] and [requirements], and then [analyses.optimize] (docs/design.md); or remove the key"};
const UnsupportedKey of_scatter = {
    "numbers that differ from machine to machine are tables of [tolerances], their study is [analyses.sample]",
    "write [tolerances.NAME] with path and half_width, and sample = {} in [analyses] (docs/sample.md); or remove the "
    "key"};
const UnsupportedKey of_motions = {"no such analysis: nonlinear machines have steady and backbone",
                                   "see docs/nonlinear.md; or remove the key"};
const UnsupportedKey of_shafts = {
    "gyroscopic terms of turning shafts are outside this version",
    "bodies vibrate about rest; give the shaft as an excitation of type \"unbalance\" or \"orders\""};

bool holds(const Words& words, const std::string& key) { return std::ranges::find(words, key) != words.end(); }

bool is_in(const std::string& path, const std::string& part) { return path == part || path.starts_with(part + "."); }

}  // namespace

std::optional<UnsupportedKey> unsupported_key(const std::string& path, const std::string& key) {
  if ((is_in(path, "elements") || is_in(path, "foundations")) && holds(nonlinear_laws, key)) return of_elements;
  if ((path.empty() || path == "analyses") && holds(optimising, key)) return of_designs;
  if ((path.empty() || path == "analyses") && holds(scattering, key)) return of_scatter;
  if ((path.empty() || is_in(path, "analyses")) && holds(nonlinear_analyses, key)) return of_motions;
  if (path.empty() && holds(nonlinear_laws, key)) return of_elements;
  if (is_in(path, "bodies") && holds(turning, key)) return of_shafts;
  return std::nullopt;
}

std::optional<UnsupportedKey> unsupported_type(const std::string& type) {
  const bool spring = type.ends_with("_spring") &&
      holds(nonlinear_laws, type.substr(0, type.size() - std::string_view("_spring").size()));
  const bool damper = type.ends_with("_damper") &&
      holds(nonlinear_laws, type.substr(0, type.size() - std::string_view("_damper").size()));
  return spring || damper || holds(nonlinear_laws, type) ? std::optional(of_elements) : std::nullopt;
}

bool is_unsupported_analysis(const std::string& key) { return unsupported_key("analyses", key).has_value(); }

}  // namespace trivet::project
