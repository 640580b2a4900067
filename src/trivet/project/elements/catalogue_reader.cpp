// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/project/elements/catalogue.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/file_name.h"
#include "trivet/project/text/price.h"

namespace trivet::project {
namespace {

void read_catalogue_mount(TableReader& reader, Placement& ends, model::Element& element) {
  const std::string name = element.type.substr(element.type.find(':') + 1);
  std::vector<Catalogue> catalogues;
  if (reader.has("catalogue")) {
    const auto file = read_file_name(reader, "catalogue");
    if (!file) return;
    auto given = read_catalogue(*file);
    if (!given) {
      reader.add_of_file("catalogue", given.error());
      return;
    }
    reader.add_of_file("catalogue", given->warnings);
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
  element.rating =
      model::Rating{mount->static_load, mount->static_deflection_limit, mount->mass, price_from(mount->price)};
  if (mount->static_load)
    element.facts.push_back(
        {"static load", fmt::format("{:.6g} … {:.6g} N along e3", (*mount->static_load)(0), (*mount->static_load)(1))});
  if (mount->static_deflection_limit)
    element.facts.push_back({"static deflection limit", fmt::format("{:.6g} m", *mount->static_deflection_limit)});
  if (mount->loss_factor)
    element.facts.push_back({"loss factor of the catalogue", fmt::format("{:.4g}", *mount->loss_factor)});
  if (mount->mass) element.facts.push_back({"mass", fmt::format("{:.6g} kg, not in the model", *mount->mass)});
  if (!mount->price.empty()) element.facts.push_back({"price", mount->price});
  element.facts.push_back({"source", mount->source});
}

}  // namespace

const ElementLaw catalogue_law = {
    .type = "catalogue:NAME", .placed = read_catalogue_mount, .keys = R"json({"properties": {
   "catalogue": {"type": "string", "description": "catalogue of your own, relative to the project file"}}})json"};

}  // namespace trivet::project
