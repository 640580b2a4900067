// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/study/part_readers.h"

namespace trivet::study {
namespace {

constexpr int most_points = 2'000'000;

/// Unit of a full result name, if it is one: a group, a dot and a component.
std::optional<Quantity> component_quantity(const std::string& name, const std::vector<std::string>& groups, assembly::Quantity wanted) {
  for (const std::string& group : groups) {
    if (!name.starts_with(group + ".")) continue;
    const std::string component = name.substr(group.size() + 1);
    for (std::size_t j = 0; j < 6; ++j) {
      static constexpr Quantity translation[] = {Quantity::length, Quantity::velocity, Quantity::acceleration};
      static constexpr Quantity rotation[] = {Quantity::angle, Quantity::angular_velocity, Quantity::angular_acceleration};
      if (component == model::coordinate_names[j]) return (j < 3 ? translation : rotation)[static_cast<int>(wanted)];
    }
    for (const char* letter : {"x", "y", "z"}) {
      if (component == std::string("force.") + letter) return Quantity::force;
      if (component == std::string("moment.") + letter) return Quantity::moment;
    }
  }
  return std::nullopt;
}

void read_of(TableReader& reader, const model::Description& description, std::vector<std::string>& of) {
  const auto words = reader.texts("of");
  if (!words) return;
  const std::vector<std::string> groups = assembly::channel_words(description);
  for (const std::string& word : *words) {
    const bool group = std::find(groups.begin(), groups.end(), word) != groups.end();
    if (group || component_quantity(word, groups, assembly::Quantity::displacement)) continue;
    const std::string guess = foundation::nearest_name(word, groups);
    reader.error("of", "\"" + word.substr(0, 60) + "\"", "it names no result: coordinates, ground, a body, BODY.POINT, an element, or one component of these",
                 guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  if (words->empty()) reader.error("of", "an empty list", "at least one result is wanted", "remove `of` for all coordinates");
  of = *words;
}

void read_wanted(TableReader& reader, const model::Description& description, Wanted& wanted) {
  read_of(reader, description, wanted.of);
  const auto quantity = reader.choice("quantity", {"displacement", "velocity", "acceleration"});
  if (quantity == "velocity") wanted.quantity = assembly::Quantity::velocity;
  if (quantity == "acceleration") wanted.quantity = assembly::Quantity::acceleration;
  if (const auto names = reader.texts("excitations")) {
    std::vector<std::string> known;
    for (const auto& force : description.harmonic_forces) known.push_back(force.name);
    for (const std::string& name : *names)
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        const std::string guess = foundation::nearest_name(name, known);
        reader.error("excitations", "\"" + name.substr(0, 60) + "\"", "no harmonic excitation has this name",
                     guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
      }
    wanted.excitations = *names;
  }
}

ResponseRequest read_response(const Node& node, const model::Description& description, foundation::Problems& problems) {
  TableReader reader(node, "analyses.response", problems);
  ResponseRequest request;
  read_wanted(reader, description, request.wanted);
  if (const auto band = reader.numbers("band", Quantity::angular_frequency)) {
    if (band->size() == 2 && (*band)[0] >= 0 && (*band)[1] > (*band)[0]) request.band = response::Band{(*band)[0], (*band)[1]};
    else
      reader.error("band", fmt::format("{} numbers{}", band->size(), band->size() == 2 ? fmt::format(", {:.6g} to {:.6g} rad/s", (*band)[0], (*band)[1]) : ""),
                   "a band is [from, to] with 0 ≤ from < to", "for instance [\"0 Hz\", \"50 Hz\"]");
  }
  const auto spacing = reader.choice("spacing", {"automatic", "linear", "logarithmic"});
  if (spacing == "linear") request.spacing = response::Spacing::linear;
  if (spacing == "logarithmic") request.spacing = response::Spacing::logarithmic;
  if (request.spacing == response::Spacing::logarithmic && request.band && !(request.band->from > 0))
    reader.error("band", "a band from 0", "a logarithmic grid starts above 0", "raise the lower end");
  if (const auto points = reader.number("points", Quantity::pure)) {
    if (*points >= 2 && *points <= most_points && *points == static_cast<int>(*points)) request.points = static_cast<int>(*points);
    else reader.error("points", fmt::format("{:.6g}", *points), fmt::format("a whole number from 2 to {} is wanted", most_points), "change it");
    if (request.spacing == response::Spacing::automatic)
      reader.error("points", "points without spacing", "an automatic grid chooses its points itself", "add spacing = \"linear\" or \"logarithmic\"");
  }
  if (const auto at = reader.numbers("at", Quantity::angular_frequency)) {
    for (const double omega : *at)
      if (omega < 0) reader.error("at", fmt::format("{:.6g} rad/s", omega), "an angular frequency is ≥ 0", "remove the sign");
    if (at->empty()) reader.error("at", "an empty list", "at least one frequency is wanted", "give one, or a band");
    if (reader.has("band")) reader.error("at", "at and band", "only one of them says where", "remove one");
    request.at = *at;
  }
  request.continuous_phase = reader.choice("phase", {"wrapped", "continuous"}) == "continuous";
  reader.finish();
  return request;
}

PeaksRequest read_peaks(const Node& node, const model::Description& description, const std::optional<ResponseRequest>& response,
                        foundation::Problems& problems) {
  TableReader reader(node, "analyses.peaks", problems);
  PeaksRequest request;
  if (response) request.wanted = response->wanted;  // the peaks of the same curves, unless it says otherwise
  read_wanted(reader, description, request.wanted);
  for (const auto& [key, target] : {std::pair{"min_prominence", &request.min_prominence}, {"peak_tolerance", &request.peak_tolerance}})
    if (const auto value = reader.number(key, Quantity::pure)) {
      if (!(*value >= 0 && *value < 1)) reader.error(key, fmt::format("{:.6g}", *value), "it is a share of the amplitude, 0 … 1", "give a fraction");
      *target = *value;
    }
  reader.finish();
  return request;
}

std::vector<Limit> read_limits(TableReader& root, const model::Description& description, assembly::Quantity quantity) {
  std::vector<Limit> limits;
  const Node* table = root.table("limits");
  if (!table) return limits;
  TableReader reader(*table, "limits", root.problems());
  const std::vector<std::string> groups = assembly::channel_words(description);
  for (const std::string& name : table->keys) {
    const auto measured = component_quantity(name, groups, quantity);
    if (!measured) {
      static_cast<void>(reader.node(name));
      reader.error(name, "no such result", "a limit belongs to one component, in quotes: \"BODY.x\", \"BODY.POINT.rz\", \"ELEMENT.force.z\"", "check the name");
      continue;
    }
    const auto amplitude = reader.number(name, *measured);
    if (amplitude && !(*amplitude > 0)) reader.error(name, fmt::format("{:.6g} {}", *amplitude, si_unit(*measured)), "a limit is > 0", "change it");
    if (amplitude) limits.push_back({name, *amplitude});
  }
  return limits;
}

}  // namespace

Analyses read_analyses(TableReader& root, const model::Description& description) {
  Analyses analyses;
  if (const Node* table = root.table("analyses")) {
    TableReader reader(*table, "analyses", root.problems());
    for (const auto& [key, wanted] : {std::pair{"modes", &analyses.modes}, {"roots", &analyses.roots}})
      if (const Node* node = reader.table(key)) {
        TableReader(*node, std::string("analyses.") + key, root.problems()).finish();
        *wanted = true;
      }
    if (const Node* node = reader.table("response")) analyses.response = read_response(*node, description, root.problems());
    if (const Node* node = reader.table("peaks")) analyses.peaks = read_peaks(*node, description, analyses.response, root.problems());
    if (const Node* node = reader.table("static")) {
      TableReader inside(*node, "analyses.static", root.problems());
      analyses.static_of = std::vector<std::string>{"coordinates"};
      for (const auto& element : description.elements) analyses.static_of->push_back(element.name);
      analyses.static_of->push_back("ground");
      read_of(inside, description, *analyses.static_of);
      inside.finish();
    }
    reader.finish();
  }
  analyses.limits = read_limits(root, description, analyses.response ? analyses.response->wanted.quantity : assembly::Quantity::displacement);
  return analyses;
}

}  // namespace trivet::study
