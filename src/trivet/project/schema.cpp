// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/schema.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "trivet/project/analyses/analysis_reader.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/text/embedded_text.h"

namespace trivet::project {
namespace {

using Json = nlohmann::ordered_json;

Json reference(const char* name) { return {{"$ref", std::string("#/$defs/") + name}}; }

Json parsed(const char* of, const char* keys) {
  try {
    return Json::parse(keys);
  } catch (const Json::parse_error& wrong) {
    throw std::logic_error(std::string("the schema of ") + of + ": " + wrong.what());
  }
}

/// Adds properties and required keys, and copies other constraints.
void add_keys(Json& object, const Json& keys) {
  for (const auto& [key, value] : keys.items()) {
    if (key == "properties") object[key].update(value);
    else if (key == "required") object[key].insert(object[key].end(), value.begin(), value.end());
    else if (key != "with") object[key] = value;
  }
}

/// Schema of an object with these keys, those of the groups listed under `with`, and no others.
/// @throws std::out_of_range if there is no such group
Json closed(const Json& own, const Json& common, const std::vector<std::string>& required, const Json& groups) {
  Json all = {{"type", "object"}, {"properties", common}, {"required", required}, {"additionalProperties", false}};
  add_keys(all, own);
  if (own.contains("with"))
    for (const auto& group : own["with"]) add_keys(all, groups.at(group.get<std::string>()));
  return all;
}

Json type_of(const ElementLaw& law) {
  const std::string type = law.type;
  const std::size_t colon = type.find(':');
  if (colon == std::string::npos) return {{"const", type}};
  return {{"type", "string"}, {"pattern", "^" + type.substr(0, colon + 1) + ".+"}};
}

void add_element_laws(Json& definitions) {
  const Json common = definitions["element_of_any_law"]["properties"], groups = definitions["shared_keys"];
  definitions.erase("element_of_any_law");
  definitions.erase("shared_keys");
  Json& elements = definitions["element"]["anyOf"];
  Json& built_in = elements[0]["properties"]["type"]["not"]["anyOf"];
  for (const ElementLaw* law : element_laws()) {
    built_in.push_back(type_of(*law));
    Json keys = common;
    keys["type"] = type_of(*law);
    keys["from_at"] = reference(law->sized ? "element_from_at_of_length" : "element_from_at");
    if (law->placed) keys["from_orientation"] = reference("element_from_orientation");
    const Json variants = parsed(law->type, law->keys);
    for (const Json& own : variants.is_array() ? variants : Json::array({variants}))
      elements.push_back(closed(own, keys, {"type", "on"}, groups));
  }
}

void add_analyses(Json& file) {
  Json& analyses = file["analyses"]["properties"];
  for (const AnalysisReader& analysis : analysis_readers())
    (analysis.at_top ? file : analyses)[analysis.name] =
        closed(parsed(analysis.name, analysis.keys), {{"accept", reference("accept")}}, {}, {});
}

}  // namespace

std::string project_schema() {
  Json schema = Json::parse(schema_text());
  add_element_laws(schema["$defs"]);
  add_analyses(schema["properties"]);
  return schema.dump(1) + "\n";
}

}  // namespace trivet::project
