// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/material_reader.h"
#include "trivet/foundation/plain_text.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace trivet::project {
namespace {

void require_positive(TableReader& reader, const char* key, double value, const char* unit) {
  if (!(value > 0))
    reader.error(key, fmt::format("{:.6g} {}", value, unit), "it must be > 0", "correct the value or its unit");
}

std::optional<elements::Metal> named_metal(TableReader& reader) {
  std::vector<std::string> names;
  for (const elements::Metal& metal : elements::metals()) names.push_back(metal.name);
  const auto name = reader.choice("material", names);
  return name ? elements::metal(*name) : std::nullopt;
}

/// Warns of a possible value that is most likely in a wrong unit.
void warn_unlikely(TableReader& reader, const std::string& key, std::string finding, std::string rule) {
  foundation::Problems one;
  one.warning(key, std::move(finding), std::move(rule), "check the unit: a bare number is SI");
  reader.add(one);
}

/// Exactly one of some keys.
bool one_of(TableReader& reader, const std::vector<const char*>& keys, const char* remedy) {
  int given = 0;
  std::string list;
  for (const char* key : keys) {
    given += reader.has(key) ? 1 : 0;
    list += (list.empty() ? "" : ", ") + std::string(key);
  }
  if (given == 1) return true;
  const char* last = keys.front();
  for (const char* key : keys) {
    if (reader.has(key)) last = key;
    static_cast<void>(reader.node(key));
  }
  reader.error(last, given == 0 ? "missing" : fmt::format("{} of {}", given, list),
               "exactly one of " + list + " is expected", remedy);
  return false;
}

}  // namespace

std::optional<elements::Metal> read_metal(TableReader& reader) {
  const Node* node = reader.node("material");
  if (!node) {
    reader.missing("material",
                   "name one, material = \"spring_steel\", or give material = {E = \"206 GPa\", G = \"78.5 GPa\", "
                   "density = 7850}");
    return std::nullopt;
  }
  if (node->kind != Node::Kind::table) return named_metal(reader);
  const std::size_t before = reader.errors();
  TableReader table(*node, reader.path() + ".material", reader.problems());
  elements::Metal metal{"given", 0, 0, std::numeric_limits<double>::quiet_NaN(), "the project file"};
  metal.young_modulus = table.required_number("E", Quantity::pressure);
  if (table.errors() == before) require_positive(table, "E", metal.young_modulus, "Pa");
  double poisson = 0;
  if (one_of(table, {"G", "nu"}, "give the shear modulus, or Poisson's ratio")) {
    if (const auto shear = table.number("G", Quantity::pressure)) {
      metal.shear_modulus = *shear;
      require_positive(table, "G", *shear, "Pa");
      if (table.errors() == before) poisson = metal.young_modulus / (2 * *shear) - 1;
    }
    if (const auto nu = table.number("nu", Quantity::pure)) {
      poisson = *nu;
      metal.shear_modulus = metal.young_modulus / (2 * (1 + poisson));
    }
    if (!(poisson > -1 && poisson < 0.5))
      table.error(table.has("G") ? "G" : "nu",
                  table.has("G") ? fmt::format("E = {:.6g} Pa, G = {:.6g} Pa: Poisson's ratio {:.4g}",
                                               metal.young_modulus, metal.shear_modulus, poisson)
                                 : fmt::format("{:.6g}", poisson),
                  "Poisson's ratio of an isotropic material lies between −1 and 0.5",
                  std::string(table.has("G") ? "correct E or G" : "correct nu") +
                      "; steel has E = 206 GPa, G = 79 GPa, Poisson's ratio 0.3");
  }
  if (const auto density = table.number("density", Quantity::density)) {
    metal.density = *density;
    require_positive(table, "density", *density, "kg/m³");
  }
  constexpr double softest = 1e9, stiffest = 1.5e12, lightest = 300, heaviest = 25e3;
  if (metal.young_modulus > 0 && (metal.young_modulus < softest || metal.young_modulus > stiffest))
    warn_unlikely(table, "E", fmt::format("{:.4g} Pa", metal.young_modulus), "structural materials have 1 to 1000 GPa");
  if (metal.density > 0 && (metal.density < lightest || metal.density > heaviest))
    warn_unlikely(table, "density", fmt::format("{:.4g} kg/m³", metal.density), "solids have 500 to 20000 kg/m³");
  if (poisson > -1 && poisson < 0)
    warn_unlikely(table, table.has("G") ? "G" : "nu", fmt::format("Poisson's ratio {:.3g}", poisson),
                  "metals have about 0.3");
  table.finish();
  return reader.errors() == before ? std::optional(metal) : std::nullopt;
}

namespace {

/// Poisson's ratio in place of the bulk modulus: K = 2G(1 + ν)/(3(1 − 2ν)), and E = 2G(1 + ν).
void read_poisson(TableReader& table, elements::Rubber& rubber) {
  const auto nu = table.number("nu", Quantity::pure);
  if (!nu) return;
  constexpr double least_of_rubber = 0.45;
  if (table.has("bulk_modulus"))
    table.error("nu", "nu and bulk_modulus", "only one of them sets the compressibility", "remove one");
  if (!(*nu >= 0 && *nu < 0.5)) {
    table.error("nu", fmt::format("{:.6g}", *nu),
                "Poisson's ratio of a compressible rubber lies between 0 and 0.5, 0.5 excluded",
                "rubber has 0.4990 to 0.4999; or give bulk_modulus");
    return;
  }
  if (*nu < least_of_rubber)
    warn_unlikely(table, "nu", fmt::format("Poisson's ratio {:.4g}", *nu),
                  "solid rubber has more than 0.499; formulas of bonded rubber hold for nearly incompressible rubber");
  if (table.has("E")) rubber.shear_modulus *= 3 / (2 * (1 + *nu));
  rubber.bulk_modulus = 2 * rubber.shear_modulus * (1 + *nu) / (3 * (1 - 2 * *nu));
}

}  // namespace

std::optional<elements::Rubber> read_rubber(TableReader& reader) {
  constexpr const char* remedy = "give the rubber: material = {G = \"0.7 MPa\"} or {hardness = 55}";
  if (const Node* given = reader.node("material"); given && given->kind == Node::Kind::text) {
    reader.error("material", foundation::quoted(given->text),
                 "rubbers of one name differ, so a modulus or a hardness is needed", remedy);
    return std::nullopt;
  }
  const Node* node = reader.table("material");
  if (!node) {
    if (!reader.has("material")) reader.missing("material", remedy);
    return std::nullopt;
  }
  const std::size_t before = reader.errors();
  TableReader table(*node, reader.path() + ".material", reader.problems());
  elements::Rubber rubber;
  if (one_of(table, {"G", "E", "hardness"},
             "give the shear modulus, Young's modulus, or the hardness (Shore A or IRHD)")) {
    if (const auto shear = table.number("G", Quantity::pressure)) {
      rubber.shear_modulus = *shear;
      require_positive(table, "G", *shear, "Pa");
    }
    if (const auto young = table.number("E", Quantity::pressure)) {
      rubber.shear_modulus = *young / 3;
      require_positive(table, "E", *young, "Pa");
    }
    if (const auto hardness = table.number("hardness", Quantity::pure)) {
      const foundation::Problems findings = elements::check_hardness(*hardness);
      table.add(findings);
      rubber.shear_modulus = findings.has_errors() ? 1 : elements::young_modulus_from_hardness(*hardness) / 3;
    }
  }
  constexpr double softest = 0.05e6, hardest = 50e6;
  if (rubber.shear_modulus > 0 && (rubber.shear_modulus < softest || rubber.shear_modulus > hardest))
    warn_unlikely(table,
                  table.has("G")       ? "G"
                      : table.has("E") ? "E"
                                       : "hardness",
                  fmt::format("a shear modulus of {:.4g} Pa", rubber.shear_modulus), "rubber has 0.2 to 5 MPa");
  if (const auto bulk = table.number("bulk_modulus", Quantity::pressure)) {
    rubber.bulk_modulus = *bulk;
    require_positive(table, "bulk_modulus", *bulk, "Pa");
  }
  read_poisson(table, rubber);
  if (const auto stiffening = table.number("stiffening", Quantity::pure)) {
    if (!(*stiffening >= 1))
      table.error("stiffening", fmt::format("{:.6g}", *stiffening), "dynamic over static modulus is ≥ 1",
                  "rubber is 1.1 to 3 times stiffer in vibration");
  }
  if (const auto creep = table.number("creep", Quantity::pure); creep && !(*creep >= 1))
    table.error("creep", fmt::format("{:.6g}", *creep), "static deflection after years over that at once is ≥ 1",
                "rubber has 1.1 to 1.5");
  table.finish();
  return reader.errors() == before ? std::optional(rubber) : std::nullopt;
}

}  // namespace trivet::project
