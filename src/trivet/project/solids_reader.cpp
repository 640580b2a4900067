// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/part_readers.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/thread_progress.h"
#include "trivet/project/body_solids.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/source_file.h"
#include "trivet/solids/rigid_solid.h"

namespace trivet::project {
namespace {

using solids::Part;

constexpr const char* shapes_known =
    "a solid is one of {box = [x, y, z]}, {cylinder = [diameter, length]}, {tube = [outer, inner, length]}, {sphere = "
    "diameter}, {cone = [start, end, length]}, "
    "{file = \"….step\"}, {file = \"….stl\", unit = \"1 mm\"}";

constexpr const char* solid_keys[] = {"box", "cylinder", "tube", "sphere", "cone", "file"};

/// Key of a finding: that of the shape if the finding is about one of its lengths.
std::string key_of(const Node& part, const std::string& found) {
  if (part.find(found)) return found;
  for (const char* key : solid_keys)
    if (part.find(key)) return std::string(key) + " (" + found + ")";
  return found;
}

/// Exactly `count` lengths of a key.
std::optional<std::vector<double>> lengths(TableReader& reader, const char* key, std::size_t count) {
  auto numbers = reader.numbers(key, Quantity::length);
  if (numbers && numbers->size() != count) {
    reader.error(key, fmt::format("{} lengths", numbers->size()), fmt::format("{} are expected", count), shapes_known);
    return std::nullopt;
  }
  return numbers;
}

void read_file(TableReader& reader, Part& part) {
  const auto file = read_file_name(reader, "file");
  std::string ending = file ? file->extension().string() : "";
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".stl") {
    if (!reader.has("unit")) reader.missing("unit", "an STL file does not state its unit: unit = \"1 mm\"");
    part.shape = solids::StlSolid{*file, reader.number("unit", Quantity::length).value_or(1)};
  } else if (file) {
    solids::StepSolid step{*file, {}};
    if (const auto chosen = reader.numbers("solids", Quantity::pure))
      for (const double number : *chosen) {
        if (number >= 1 && number < 1e9 && number == std::floor(number))
          step.solids.push_back(static_cast<int>(number));
        else
          reader.error("solids", fmt::format("{:.6g}", number), "solids are numbered from 1 in the order of the file",
                       "give whole numbers");
      }
    part.shape = step;
  } else {
    reader.also_known({"unit"});
  }
  reader.also_known({"solids"});
}

enum class Density { required, optional };

Part read_part(TableReader& reader, const std::string& name, Density needed) {
  Part part;
  part.name = name;
  part.density = reader.number("density", Quantity::density).value_or(solids::not_given);
  part.mass = reader.number("mass", Quantity::mass).value_or(solids::not_given);
  if (needed == Density::required && !reader.has("density") && !reader.has("mass"))
    reader.missing("density", "give density = 7850, or the mass of the solid, or that of the whole body");
  part.pose.position = reader.vector("at", Quantity::length).value_or(Eigen::Vector3d::Zero());
  part.pose.rotation = reader.orientation("orientation").value_or(Eigen::Matrix3d::Identity());
  int shapes = 0;
  for (const char* key : solid_keys) shapes += reader.has(key) ? 1 : 0;
  if (shapes != 1)
    reader
        .error("density", shapes == 0 ? "no shape" : fmt::format("{} shapes", shapes), shapes_known, "give exactly one")
        .subject = reader.path();
  if (const auto l = lengths(reader, "box", 3)) part.shape = solids::Box{(*l)[0], (*l)[1], (*l)[2]};
  if (const auto l = lengths(reader, "cylinder", 2)) part.shape = solids::Cylinder{(*l)[0], (*l)[1]};
  if (const auto l = lengths(reader, "tube", 3)) part.shape = solids::Tube{(*l)[0], (*l)[1], (*l)[2]};
  if (const auto d = reader.number("sphere", Quantity::length)) part.shape = solids::Sphere{*d};
  if (const auto l = lengths(reader, "cone", 3)) part.shape = solids::Cone{(*l)[0], (*l)[1], (*l)[2]};
  if (reader.has("file")) read_file(reader, part);
  reader.finish();
  return part;
}

/// Warns of a density that no material has.
void check_density(const Part& part, const solids::PartResult& result, const foundation::Origin& origin,
                   TableReader& body) {
  constexpr double lightest = 10, heaviest = 25e3;
  const double density = result.properties.mass / result.volume;
  if (density >= lightest && density <= heaviest) return;
  const bool given = !std::isnan(part.density);
  body.problems()
      .warning(body.path() + "." + part.name + (given ? ".density" : ".mass"),
               fmt::format("{:.4g} kg/m³{}", density, given ? "" : ", mass over volume"),
               "solids have 500 to 20000 kg/m³, foams down to 20", "check the unit: a bare number is SI")
      .origin = origin;
}

}  // namespace

bool read_solids(TableReader& body, solids::KnownMass known, model::Body& result) {
  const Node* list = body.node("solids");
  if (list->kind != Node::Kind::array || list->items.empty()) {
    body.error("solids", list->kind == Node::Kind::array ? "no solid" : kind_name(list->kind), "it is a list of solids",
               "write solids = [{box = [1, 0.5, 0.2], density = 7850}]");
    return false;
  }
  const std::size_t before = body.errors();
  std::vector<Part> parts;
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    const std::string name = fmt::format("solids[{}]", i);
    if (list->items[i].kind != Node::Kind::table) {
      body.error("solids", kind_name(list->items[i].kind), "a solid is a table", shapes_known);
      continue;
    }
    TableReader reader(list->items[i], body.path() + "." + name, body.problems());
    const std::size_t before_part = body.errors();
    Part part = read_part(reader, name, body.has("mass") ? Density::optional : Density::required);
    if (body.errors() == before_part) parts.push_back(std::move(part));
  }
  const std::size_t before_mass = body.errors();
  known.whole = body.number("mass", Quantity::mass).value_or(solids::not_given);
  if (parts.empty() || body.errors() > before_mass) return false;
  const auto solid = solids::rigid_solid(parts, known, foundation::thread_progress());
  const foundation::Problems& findings = solid ? solid->remarks : solid.error();
  for (foundation::Problem problem : findings.list()) {
    const Node* whole = problem.subject == "mass" ? body.node("mass") : nullptr;
    problem.origin = whole ? whole->origin : list->origin;
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      const std::string part = fmt::format("solids[{}].", i);
      if (!problem.subject.starts_with(part)) continue;
      problem.origin = list->items[i].origin;
      problem.subject = part + key_of(list->items[i], problem.subject.substr(part.size()));
      break;
    }
    problem.subject = body.path() + "." + problem.subject;
    body.problems().add(std::move(problem));
  }
  if (!solid || body.errors() > before) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) check_density(parts[i], solid->parts[i], list->items[i].origin, body);
  result.mass = solid->properties;
  return true;
}

std::vector<Part> body_solids(const Node& body) {
  std::vector<Part> parts;
  const Node* list = body.find("solids");
  if (!list || list->kind != Node::Kind::array) return parts;
  foundation::Problems reported_before;
  for (const Node& solid : list->items) {
    if (solid.kind != Node::Kind::table) continue;
    TableReader reader(solid, "solids", reported_before);
    parts.push_back(read_part(reader, "solid", Density::optional));
  }
  return parts;
}

}  // namespace trivet::project
