// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/asked_questions.h"

#include <algorithm>

#include "trivet/foundation/invalid_input.h"

namespace trivet::study {
namespace {

using project::Analyses;
using project::Case;

Analyses modes_of(const Case&) { return {.modes = true}; }
Analyses roots_of(const Case&) { return {.roots = true}; }

Analyses response_of(const Case& variant) {
  Analyses asked;
  asked.response = variant.analyses.response.value_or(project::ResponseRequest{});
  asked.limits = variant.analyses.limits;
  if (asked.response->at.empty()) asked.limit_lines = variant.analyses.limit_lines;  // lines are compared over a band
  return asked;
}

Analyses peaks_of(const Case& variant) {
  const Analyses& file = variant.analyses;
  Analyses asked;
  asked.peaks = file.peaks.value_or(project::PeaksRequest{file.response ? file.response->wanted : project::Wanted{}});
  return asked;
}

Analyses static_of(const Case& variant) {
  std::vector<std::string> all = {"coordinates"};
  for (const auto& element : variant.system.elements()) all.push_back(element.name);
  all.push_back("ground");
  Analyses asked;
  asked.static_of = variant.analyses.static_of.value_or(all);
  asked.load_sharing = variant.system.description().gravity.has_value();
  return asked;
}

Analyses random_of(const Case& variant) {
  Analyses asked;
  asked.random = variant.analyses.random.value_or(project::RandomRequest{});
  return asked;
}

Analyses transient_of(const Case& variant) {
  Analyses asked;
  asked.transient = variant.analyses.transient.value_or(project::TransientRequest{});
  return asked;
}

/// The file's own question, which has no default.
template <auto Question>
Analyses of_file(const Case& variant, const char* what_to_add) {
  if (!(variant.analyses.*Question)) throw foundation::InvalidInput(what_to_add);
  Analyses asked;
  asked.*Question = variant.analyses.*Question;
  return asked;
}

Analyses orders_of(const Case& variant) {
  return of_file<&Analyses::orders>(variant, "orders: say over which speeds: add orders = {speed = [\"600 rpm\", \"3000 rpm\"]} to [analyses]");
}

Analyses transmissibility_of(const Case& variant) {
  return of_file<&Analyses::transmissibility>(variant, "transmissibility: say of what: add transmissibility = {force = \"EXCITATION\"} or {base = \"z\"} to [analyses]");
}

Analyses power_of(const Case& variant) {
  Analyses asked;
  asked.power = variant.analyses.power.value_or(project::PowerRequest{});
  return asked;
}

Analyses shapes_of(const Case& variant) {
  return of_file<&Analyses::shapes>(variant, "shapes: say at which frequencies: add shapes = {at = [\"25 Hz\"]} to [analyses]");
}

Analyses shock_spectrum_of(const Case& variant) {
  return of_file<&Analyses::shock_spectrum>(variant, "shock_spectrum: say over which natural frequencies: add shock_spectrum = {band = [\"5 Hz\", \"2000 Hz\"]} to [analyses]");
}

Analyses earthquake_of(const Case& variant) {
  return of_file<&Analyses::earthquake>(variant, "earthquake: say by which spectrum: add earthquake = {direction = \"x\", rows = [[0.02, 3], [0.1, 9], …]} to [analyses]");
}

Analyses limit_lines_of(const Case& variant) {
  if (variant.analyses.limit_lines.empty())
    throw foundation::InvalidInput("limit_lines: say which: add [limit_lines.NAME] with of = \"BODY.z\" and rows = [[10, 2e-3], [60, 2e-3]]");
  Analyses asked = response_of(variant);
  asked.response->at.clear();
  asked.limit_lines = variant.analyses.limit_lines;
  return asked;
}

}  // namespace

const std::vector<AskedQuestion>& asked_questions() {
  static const std::vector<AskedQuestion> list = {
      {"modes", "undamped natural frequencies and modes", {}, modes_of},
      {"roots", "damped roots", {}, roots_of},
      {"response", "amplitude- and phase-frequency characteristics", {"response", "limits", "limit_lines"}, response_of},
      {"peaks", "exact resonance peaks", {"peaks", "response"}, peaks_of},
      {"static", "static displacements and forces", {"static"}, static_of},
      {"random", "root mean squares under random excitations", {"random"}, random_of},
      {"transient", "motion in time", {"transient"}, transient_of},
      {"orders", "run-up: response over shaft speed, critical speeds", {"orders"}, orders_of},
      {"transmissibility", "force or motion that the mounts let through", {"transmissibility"}, transmissibility_of},
      {"power", "mean power into the ground at each mount", {"power"}, power_of},
      {"shapes", "operating deflection shapes", {"shapes"}, shapes_of},
      {"shock_spectrum", "shock response spectra of ground motions in time", {"shock_spectrum"}, shock_spectrum_of},
      {"earthquake", "largest answers to an earthquake by its response spectrum", {"earthquake"}, earthquake_of},
      {"limit_lines", "answers of the response against lines over frequency", {"response", "limit_lines"}, limit_lines_of},
  };
  return list;
}

const AskedQuestion& asked_question(const std::string& name) {
  const auto& list = asked_questions();
  const auto found = std::find_if(list.begin(), list.end(), [&](const AskedQuestion& one) { return one.name == name; });
  if (found == list.end()) throw foundation::InvalidInput("no question is called \"" + name + "\"");
  return *found;
}

}  // namespace trivet::study
