// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/condensed_solid.h"

#include <fmt/format.h>

#include <array>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/elements/element_cache.h"
#include "trivet/project/elements/solid_states.h"

namespace trivet::project {
namespace {

void add_error_facts(const fem::SolidStiffness& s, model::Element& element) {
  element.facts.push_back(
      {"found by", fmt::format("finite elements: {} elements, {} unknowns", s.elements, s.unknowns)});
  if (s.relative_error.isZero(0)) {
    element.facts.push_back({"estimated error of the mesh", "not estimated: level 1 has no coarser mesh"});
    return;
  }
  std::string errors;
  static constexpr std::array<const char*, 6> words = {"shear x", "shear y", "axial", "tilt x", "tilt y", "torsion"};
  for (int j = 0; j < 6; ++j)
    errors += fmt::format("{}{} {:.2g} %", j ? ", " : "", words[j], 100 * s.relative_error(6 + j, 6 + j));
  element.facts.push_back({"estimated error of the mesh", errors});
  const elements::Vector12 scale = s.stiffness.diagonal().cwiseSqrt();
  element.evidence =
      model::Evidence{s.relative_error.cwiseProduct(scale * scale.transpose()), "estimated error of the mesh", {}};
}

}  // namespace

std::optional<Compression> read_compression(TableReader& reader) {
  const Node* table = reader.table("preload");
  if (!table) return std::nullopt;
  TableReader preload(*table, reader.path() + ".preload", reader.problems());
  const auto by = preload.number("compression", Quantity::length), with = preload.number("force", Quantity::force);
  if (preload.has("compression") == preload.has("force"))
    preload.error("force", preload.has("force") ? "compression and force" : "neither compression nor force",
                  "a preload is one of them, positive in compression", "give one");
  preload.finish();
  if (with) return Compression{*with, true};
  if (by) return Compression{*by, false};
  return std::nullopt;
}

void read_large_strain(TableReader& reader, fem::Material& material) {
  const auto mooney = reader.numbers("mooney_rivlin", Quantity::pressure),
             yeoh = reader.numbers("yeoh", Quantity::pressure);
  const double bulk = material.bulk_modulus;
  if (mooney && mooney->size() == 2) material = {.c10 = (*mooney)[0], .c01 = (*mooney)[1], .bulk_modulus = bulk};
  else if (mooney)
    reader.error("mooney_rivlin", fmt::format("{} numbers", mooney->size()), "it has two constants: [c10, c01]",
                 "give two");
  if (yeoh && yeoh->size() == 3)
    material = {.c10 = (*yeoh)[0], .c20 = (*yeoh)[1], .c30 = (*yeoh)[2], .bulk_modulus = bulk};
  else if (yeoh)
    reader.error("yeoh", fmt::format("{} numbers", yeoh->size()), "it has three constants: [c10, c20, c30]",
                 "give three");
  if (mooney && yeoh) reader.error("yeoh", "mooney_rivlin and yeoh", "a rubber has one law", "keep one of them");
  reader.add(fem::check(material),
             {{"shear_modulus",
               mooney     ? "mooney_rivlin"
                   : yeoh ? "yeoh"
                          : "material"},
              {"bulk_modulus", "material"}});
}

std::string constants_text(const fem::Material& m) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", m.c10, m.c01, m.c20, m.c30, m.bulk_modulus);
}

ElementLength condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                        const std::optional<Compression>& compression, const std::optional<Stroke>& stroke,
                        model::Element& element) {
  const std::size_t before = reader.errors();
  try {
    std::optional<Solid> solid;  // meshed once, and only if a result is not in the cache
    const MeshedSolid meshed = [&]() -> const Solid& {
      if (!solid) solid = make();
      return *solid;
    };
    if (!compression) {
      const fem::SolidStiffness s = free_solid(key, meshed);
      element.law.nominal_stiffness = s.stiffness;
      add_error_facts(s, element);
      if (stroke) add_stroke(*stroke, reader, key, meshed, element);
      return std::nullopt;
    }
    fem::Preload load;
    load.value(2) = -compression->value;
    load.is_load[2] = compression->is_force;
    const std::variant<LoadedSolid, std::string> under =
        solid_under(content_key(fmt::format("{} preload {:.17g} {}", key, compression->value, compression->is_force)),
                    meshed, load, fem::PreloadOptions().steps);
    if (const auto* failure = std::get_if<std::string>(&under)) throw foundation::NotComputable(*failure);
    const LoadedSolid& found = std::get<LoadedSolid>(under);
    element.law.nominal_stiffness = found.stiffness;
    element.law.preload = found.force;
    element.facts.push_back({"found by", "finite elements, linearised about its preload"});
    element.facts.push_back({"compressed by", fmt::format("{:.6g} m", -found.deflection)});
    element.facts.push_back({"preload", fmt::format("{:.6g} N of compression", -(*element.law.preload)(8))});
    if (found.negative_eigenvalues > 0)
      reader.error("preload", fmt::format("{} negative pivots", found.negative_eigenvalues),
                   "a mount that has buckled between its plates carries no load", "lower the preload");
    return found.distance;
  } catch (const foundation::InvalidInput& reason) {
    if (reader.errors() == before)  // the mesher reports more
      reader.error(reader.has("step") ? "step" : "type", reason.what(), "the solid cannot be condensed",
                   "correct the solid, its plates or its mesh");
  } catch (const foundation::NotComputable& reason) {
    reader.error(compression ? "preload" : "type", reason.what(), "a static equilibrium under the preload must exist",
                 "lower the preload, or check the solid and its plates");
  }
  return std::nullopt;
}

}  // namespace trivet::project
