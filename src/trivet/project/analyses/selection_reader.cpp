// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/selection_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {

ResultNames::ResultNames(const SymbolTable& symbols)
    : forces_(symbols.elements),
      relatives_(symbols.relative_motions),
      clearances_(symbols.clearances),
      guided_(symbols.guided) {
  forces_.push_back("ground");
  forces_.insert(forces_.end(), symbols.sections.begin(), symbols.sections.end());
  motions_ = symbols.bodies;
  motions_.insert(motions_.end(), symbols.nodes.begin(), symbols.nodes.end());
  motions_.insert(motions_.end(), symbols.points.begin(), symbols.points.end());
  groups_ = {"coordinates"};
  for (const auto* names : {&motions_, &forces_}) groups_.insert(groups_.end(), names->begin(), names->end());
  const std::size_t places = motions_.size();
  motions_.push_back("base");
  for (std::size_t i = 0; i < places; ++i) motions_.push_back(motions_[i] + ".relative");
  for (const std::string& element : symbols.elements)
    for (const char* end : {".deflection", ".foot"}) motions_.push_back(element + end);
  groups_.insert(groups_.end(), motions_.begin() + static_cast<std::ptrdiff_t>(places), motions_.end());
  for (const auto* names : {&relatives_, &clearances_}) groups_.insert(groups_.end(), names->begin(), names->end());
}

bool ResultNames::is_group(const std::string& name) const { return std::ranges::find(groups_, name) != groups_.end(); }

bool ResultNames::is_guided(const std::string& name) const { return std::ranges::find(guided_, name) != guided_.end(); }

std::optional<Quantity> ResultNames::component(const std::string& name, assembly::MotionQuantity quantity) const {
  static constexpr Quantity translation[] = {Quantity::length, Quantity::velocity, Quantity::acceleration};
  static constexpr Quantity rotation[] = {Quantity::angle, Quantity::angular_velocity, Quantity::angular_acceleration};
  if (is_guided(name)) return std::nullopt;
  const auto after = [&](const std::string& group) -> std::string_view {
    return name.size() > group.size() && name[group.size()] == '.' && name.starts_with(group)
        ? std::string_view(name).substr(group.size() + 1)
        : std::string_view();
  };
  for (const std::string& group : motions_)
    for (std::size_t j = 0; j < 6; ++j)
      if (after(group) == model::coordinate_names[j])
        return (j < 3 ? translation : rotation)[static_cast<int>(quantity)];
  for (const std::string& group : relatives_)
    for (std::size_t j = 0; j < 6; ++j)
      if (after(group) == model::relative_components[j])
        return (j < 3 ? translation : rotation)[static_cast<int>(quantity)];
  for (const std::string& group : clearances_)
    if (after(group) == model::approach_component) return translation[static_cast<int>(quantity)];
  for (const std::string& group : forces_) {
    const std::string_view rest = after(group);
    if (rest == "force.x" || rest == "force.y" || rest == "force.z") return Quantity::force;
    if (rest == "moment.x" || rest == "moment.y" || rest == "moment.z") return Quantity::moment;
  }
  return std::nullopt;
}

bool ResultNames::is_force(const std::string& name) const {
  const auto measured = component(name, assembly::MotionQuantity::displacement);
  return std::ranges::find(forces_, name) != forces_.end() || measured == Quantity::force ||
      measured == Quantity::moment;
}

std::vector<std::string> ResultNames::components() const {
  std::vector<std::string> names;
  for (const std::string& group : motions_)
    for (const char* coordinate : model::coordinate_names) names.push_back(group + "." + coordinate);
  for (const std::string& group : forces_)
    for (const char* component : {".force.x", ".force.y", ".force.z", ".moment.x", ".moment.y", ".moment.z"})
      names.push_back(group + component);
  for (const std::string& group : relatives_)
    for (const char* component : model::relative_components) names.push_back(group + "." + component);
  for (const std::string& group : clearances_) names.push_back(group + "." + model::approach_component);
  std::erase_if(names, [&](const std::string& name) { return is_guided(name); });
  return names;
}

void ResultNames::refuse(TableReader& reader, const std::string& key, const std::string& name,
                         const std::string& known) const {
  std::vector<std::string> longer;
  bool two_directions = false;
  for (const std::string& component : components()) {
    const bool of_two = component.starts_with(name + "_");
    if (of_two || component.starts_with(name + ".")) longer.push_back("\"" + component + "\"");
    two_directions = two_directions || of_two;
  }
  if (!longer.empty()) {
    reader.error(key, foundation::quoted(name),
                 two_directions ? "a motion across the axis is an ellipse: its results are the two components"
                                : "a result is one component of a force or moment",
                 fmt::format("name the component: {}", fmt::join(longer, ", ")));
    return;
  }
  const std::string guess = foundation::nearest_name(name, groups_);
  reader.error(key, foundation::quoted(name), "no such result; known are " + known,
               guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
}

std::optional<std::vector<std::string>> read_result_names(TableReader& reader, const ResultNames& names,
                                                          const std::string& key, const std::string& without) {
  auto words = reader.texts(key, R"(["coordinates", "BODY.x", "ELEMENT.force.z"])");
  if (!words) return std::nullopt;
  if (words->size() > most_curves) {
    reader.error(key, fmt::format("{} results", words->size()), fmt::format("one analysis has at most {}", most_curves),
                 "name fewer");
    return std::nullopt;
  }
  for (const std::string& word : *words) {
    if (names.is_group(word) || names.component(word, assembly::MotionQuantity::displacement)) continue;
    names.refuse(reader, key, word,
                 "coordinates, ground, base, a body, BODY.POINT, an element, one of these with .relative, .deflection "
                 "or .foot, a relative motion, a section, a clearance, or one component (x … rz of a motion that is "
                 "free, force.x … moment.z of an element, a section or the ground)");
  }
  if (words->empty()) reader.error(key, "an empty list", "at least one result is expected", without);
  return words;
}

void read_of(TableReader& reader, const ResultNames& names, std::vector<std::string>& of) {
  if (auto words = read_result_names(reader, names, "of", "remove `of` for all coordinates")) of = std::move(*words);
}

namespace {

void refuse_excitation(TableReader& reader, const std::string& name, const std::vector<std::string>& known,
                       const std::string& kind) {
  const std::string guess = foundation::nearest_name(name, known);
  reader.error("excitations", foundation::quoted(name), "no " + kind + " excitation has this name",
               guess.empty() ? "check the name, and its type" : "did you mean \"" + guess + "\"?");
}

/// Reports an empty list; without the key, all excitations are taken.
void refuse_none(TableReader& reader, const std::vector<std::string>& names) {
  if (names.empty())
    reader.error("excitations", "an empty list", "at least one excitation is expected", "remove `excitations` for all");
}

}  // namespace

std::vector<std::string> read_selected(TableReader& reader, const std::vector<std::string>& known,
                                       const std::string& kind) {
  const auto names = reader.texts("excitations", R"(["NAME"], or leave it out for all)");
  if (!names) return {};
  refuse_none(reader, *names);
  for (const std::string& name : *names)
    if (std::ranges::find(known, name) == known.end()) refuse_excitation(reader, name, known, kind);
  return *names;
}

void refuse_limit(TableReader& reader, const ResultNames& names, const std::string& name) {
  const std::string guess = foundation::nearest_name(name, names.components());
  if (names.is_guided(name))
    reader.error(name, "constrained", "this coordinate is not in `free` of its body, so it does not move",
                 "limit a free coordinate or the force of an element, or add it to `free`");
  else
    reader.error(name, "no such result",
                 "a limit belongs to one component, in quotes: \"BODY.x\", \"BODY.POINT.rz\", \"ELEMENT.force.z\"",
                 guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
}

namespace {

std::vector<std::pair<std::string, const std::vector<std::string>*>> by_other_types(const SymbolTable& symbols) {
  return {{"orders", &symbols.order_excitations},
          {"random", &symbols.random_excitations},
          {"time", &symbols.time_excitations},
          {"constant", &symbols.constant_excitations}};
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

std::string other_excitations(const SymbolTable& symbols) {
  std::string text;
  for (const auto& [type, names] : by_other_types(symbols))
    for (const std::string& name : *names)
      if (!holds(symbols.harmonic_excitations, name))
        text += (text.empty() ? "" : ", ") + foundation::quoted(name) + " is of type " + type;
  return text;
}

std::vector<std::string> read_selected_harmonic(TableReader& reader, const SymbolTable& symbols) {
  const auto names = reader.texts("excitations", R"(["NAME"], or leave it out for all)");
  if (!names) return {};
  refuse_none(reader, *names);
  const auto type_of = [&](const std::string& name) -> std::string {
    for (const auto& [type, others] : by_other_types(symbols))
      if (holds(*others, name) && !holds(symbols.harmonic_excitations, name)) return type;
    return "";
  };
  for (const std::string& name : *names)
    if (const std::string type = type_of(name); !type.empty())
      reader.error("excitations", foundation::quoted(name) + ", of type " + type,
                   "only harmonic forces drive this analysis (types harmonic, base, unbalance)", "name one of these");
    else if (!holds(symbols.harmonic_excitations, name))
      refuse_excitation(reader, name, symbols.harmonic_excitations, "harmonic");
  return *names;
}

void read_results(TableReader& reader, const ResultNames& result_names, ChannelSelection& selection) {
  read_of(reader, result_names, selection.of);
  const auto quantity = reader.choice("quantity", assembly::motion_names());
  if (quantity)  // also "displacement": the selection may begin as a copy of another one
    selection.quantity = assembly::motion_quantity(*quantity);
  if (quantity && reader.has("of") &&
      std::ranges::all_of(selection.of, [&](const std::string& name) { return result_names.is_force(name); }))
    warn_at_key(reader, "quantity", "\"" + *quantity + "\" of forces alone",
                "it applies to motions only, and no motion is requested", "remove it, or request motions");
}

void read_selection(TableReader& reader, const ResultNames& result_names, const std::vector<std::string>& known,
                    const std::string& kind, ChannelSelection& selection) {
  read_results(reader, result_names, selection);
  if (reader.has("excitations")) selection.excitations = read_selected(reader, known, kind);
}

void read_peak_shares(TableReader& reader, double& min_prominence, double& peak_tolerance) {
  if (const auto share = reader.number("min_prominence", Quantity::pure)) {
    if (!(*share >= 0 && *share < 1))
      reader.error("min_prominence", fmt::format("{:.6g}", *share),
                   "it is a share of the curve's largest amplitude: 0 or more, less than 1", "give a fraction");
    min_prominence = *share;
  }
  if (const auto share = reader.number("peak_tolerance", Quantity::pure)) {
    if (!(*share >= 0))
      reader.error(
          "peak_tolerance", fmt::format("{:.6g}", *share),
          "it is a share of the minimum next to a peak: 0 or more; with 1, a peak may rise to twice that minimum",
          "give 0.01 for 1 %");
    peak_tolerance = *share;
  }
}

}  // namespace trivet::project
