// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/significant_digits.h"
#include "trivet/project/elements/catalogue.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

/// "temperature": "-30 … 80 °C".
std::string celsius_words(const Eigen::Vector2d& kelvin) {
  constexpr double zero_celsius = 273.15;
  const Eigen::Vector2d celsius = kelvin.array() - zero_celsius;
  return fmt::format("{:.4g} … {:.4g} °C", celsius(0), celsius(1));
}

/// Facts of a mount that its stiffness does not show.
void add_facts(const Mount& mount, std::vector<model::Fact>& facts) {
  const auto add = [&](const char* what, std::string value) { facts.push_back({what, std::move(value)}); };
  const auto add_length = [&](const char* what, const std::optional<double>& length) {
    if (length) add(what, foundation::prefixed_exactly(*length, "m", 6));
  };
  const model::Rating& rating = mount.rating;
  for (const std::size_t i : {std::size_t{2}, std::size_t{0}, std::size_t{1}})
    if (const auto& range = rating.load[i])
      add("static load", fmt::format("{} along e{}", foundation::prefixed_range((*range)(0), (*range)(1), "N"), i + 1));
  add_length("static deflection limit", rating.deflection);
  add_length("dynamic deflection limit", rating.dynamic_deflection);
  add_length("shock deflection limit", rating.shock_deflection);
  if (mount.creep > 1) add("creep", fmt::format("{:.4g} times the static deflection after years", mount.creep));
  if (mount.temperature) add("temperature", celsius_words(*mount.temperature) + ", not judged: the model has none");
  add_length("height without load", mount.height);
  if (mount.loss_factor) add("loss factor of the catalogue", fmt::format("{:.4g}", *mount.loss_factor));
  if (rating.mass) add("mass", fmt::format("{:.6g} kg, not in the model", *rating.mass));
  if (rating.price) add("price", price_words(*rating.price));
}

/// Adds errors of a catalogue that are not there yet: each element that reads it finds them again.
void add_errors_once(TableReader& reader, const foundation::Problems& of_catalogue) {
  foundation::Problems others;
  for (const foundation::Problem& problem : of_catalogue.list())
    if (std::ranges::none_of(reader.problems().list(), [&](const foundation::Problem& known) {
          return !problem.origin.source.empty() && known.origin.source == problem.origin.source &&
              known.origin.line == problem.origin.line && known.origin.column == problem.origin.column &&
              known.finding == problem.finding && known.subject.ends_with(": " + problem.subject);
        }))
      others.add(problem);
  reader.add_of_file("catalogue", others);
}

/// Adds warnings about a catalogue, which all elements that read it share.
void add_once(const foundation::Problems& of_catalogue, foundation::Problems& all) {
  for (const foundation::Problem& problem : of_catalogue.list())
    if (std::ranges::none_of(all.list(), [&](const foundation::Problem& known) {
          return known.origin.source == problem.origin.source && known.origin.line == problem.origin.line &&
              known.subject == problem.subject && known.finding == problem.finding;
        }))
      all.add(problem);
}

void read_catalogue_mount(TableReader& reader, Placement& ends, model::Element& element) {
  const std::string name = element.type.substr(element.type.find(':') + 1);
  std::vector<Catalogue> catalogues;
  if (reader.has("catalogue")) {
    const auto file = read_file_name(reader, "catalogue");
    if (!file) return;
    auto given = read_catalogue(*file);
    if (!given) {
      add_errors_once(reader, given.error());
      return;
    }
    add_once(given->warnings, reader.problems());
    catalogues.push_back(std::move(*given));
  }
  catalogues.push_back(generic_catalogue());
  const auto mount = mount_named(name, catalogues);
  if (!mount) {
    for (foundation::Problem problem : mount.error().list()) {
      problem.subject = "type";
      foundation::Problems one;
      one.add(std::move(problem));
      reader.add(one);
    }
    return;
  }
  elements::Vector6 constants;
  constants << mount->translation, mount->rotation;
  element.law.nominal_stiffness =
      elements::in_end_axes(elements::constants_at_point(constants, ends.span.arm, 0.5), ends.span.n_from_k);
  if (mount->loss_factor && !reader.has("damping")) element.law.damping = elements::LossFactor{*mount->loss_factor};
  element.facts.push_back({"mount", mount->name + (mount->maker.empty() ? "" : ", " + mount->maker)});
  element.rating = mount->rating;
  element.creep = mount->creep;
  stiffen(mount->stiffening, element);
  add_facts(*mount, element.facts);
  element.facts.push_back({"source", mount->source});
}

}  // namespace

const ElementLaw catalogue_law = {
    .type = "catalogue:NAME", .placed = read_catalogue_mount, .keys = R"json({"properties": {
   "catalogue": {"type": "string", "description": "catalogue of your own, relative to the project file"}}})json"};

}  // namespace trivet::project
