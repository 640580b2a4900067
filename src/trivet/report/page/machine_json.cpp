// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/machine_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "trivet/documents/json_text.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/results/analyses/modes_document.h"
#include "trivet/results/format/written_results.h"
#include "trivet/results/scene/scene_document.h"

namespace trivet::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::ptrdiff_t most_motions = 30;  ///< of modes and of shapes of a case: a list to choose from

/// Numbers to as many digits as a drawing may need when it is enlarged.
void round_numbers(Json& json) {
  if (json.is_number_float()) {
    const std::string text = fmt::format("{:.7g}", json.get<double>());
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);  // 0 if it is below the least double
    json = number;
  } else if (json.is_structured()) {
    for (Json& part : json) round_numbers(part);
  }
}

Json rounded(const Document& document) {
  Json json = Json::parse(documents::json::text(as_json(document)));
  round_numbers(json);
  return json;
}

/// The members of an object that the view reads.
Json only(const Json& json, std::initializer_list<const char*> keys) {
  Json result = Json::object();
  for (const char* key : keys)
    if (json.contains(key)) result[key] = json[key];
  return result;
}
void keep_in_list(Json& list, std::initializer_list<const char*> keys) {
  for (Json& one : list) one = only(one, keys);
}

Json modes_json(const ShownCase& shown) {
  const auto& list = shown.results.modes.list;
  study::CaseResults lowest;  // a document of hundreds of modes would take longer than the page
  lowest.modes.list.assign(list.begin(), list.begin() + std::min(most_motions, std::ssize(list)));
  Json json = only(rounded(results::modes_document(shown.variant, lowest, 0)), {"feet", "modes"});
  keep_in_list(json["modes"], {"number", "angular_frequency", "name", "shape", "feet"});
  json["all"] = list.size();
  return json;
}

/// The damped motions of the modes in the list, if the run has them: of each mode the root nearest to it.
Json roots_json(const ShownCase& shown) {
  if (!shown.variant.analyses.roots) return nullptr;
  study::CaseResults nearest;
  for (const modal::Root& root : shown.results.roots.list)
    if (root.eigenvalue.imag() > 0 && root.nearest_mode && *root.nearest_mode <= most_motions)
      nearest.roots.list.push_back(root);
  if (nearest.roots.list.empty()) return nullptr;
  Json json = only(rounded(results::result_document("roots", shown.variant, nearest)), {"feet", "roots"});
  keep_in_list(json["roots"], {"eigenvalue", "nearest_mode", "shape", "feet"});
  return json;
}

/// A shape of the list with what it is of, as "980 rpm, order 1"; empty: the frequency says it.
struct NamedShape {
  response::DeflectionShape shape;
  std::string at;
};
std::vector<NamedShape> shapes_of(const study::CaseResults& results) {
  std::vector<NamedShape> list;
  if (results.operation)
    for (const study::OperatingSpeed& at : results.operation->speeds)
      for (const auto& [order, shape] : at.shapes)
        list.push_back({shape, fmt::format("{}, order {:.6g}", study::speed_words(at.speed), order)});
  if (results.shapes)
    for (const response::DeflectionShape& shape : *results.shapes) list.push_back({shape, ""});
  return list;
}

Json shapes_json(const ShownCase& shown) {
  const std::vector<NamedShape> list = shapes_of(shown.results);
  if (list.empty()) return nullptr;
  study::CaseResults drawn;
  drawn.shapes.emplace();
  for (std::ptrdiff_t i = 0; i < std::min(most_motions, std::ssize(list)); ++i)
    drawn.shapes->push_back(list[static_cast<std::size_t>(i)].shape);
  Json json = only(rounded(results::result_document("shapes", shown.variant, drawn)), {"shapes"});
  json["all"] = list.size();
  keep_in_list(json["shapes"], {"angular_frequency", "places"});
  for (std::size_t i = 0; i < json["shapes"].size(); ++i) {
    keep_in_list(json["shapes"][i]["places"], {"name", "motion"});
    if (!list[i].at.empty()) json["shapes"][i]["at"] = list[i].at;
  }
  return json;
}

/// Different values, each once, in the order in which they came.
class Distinct {
 public:
  /// The place of a value, which is added if it is a new one.
  std::size_t place_of(Json value) {
    const auto [known, is_new] = places_.try_emplace(value.dump(), list_.size());
    if (is_new) list_.push_back(std::move(value));
    return known->second;
  }
  Json list() && { return std::move(list_); }

 private:
  Json list_ = Json::array();
  std::map<std::string, std::size_t> places_;
};

/// Most cases change neither what is drawn nor, if they do, the surfaces of the solids, which are most of the bytes.
struct Drawn {
  Distinct scenes, surfaces;

  std::size_t place_of_scene(const ShownCase& shown) {
    Json scene = rounded(results::scene_document(shown.variant, results::scene_of(shown.variant)));
    for (Json& body : scene["bodies"])
      for (Json& solid : body["solids"]) solid = surfaces.place_of(std::move(solid));
    return scenes.place_of(std::move(scene));
  }
};

}  // namespace

bool has_moving_machine(const std::vector<ShownCase>& cases) {
  return !cases.empty() && !cases.front().variant.system.bodies().empty();
}

std::string machine_json(const std::vector<ShownCase>& cases) {
  Drawn drawn;
  Json list = Json::array();
  for (const ShownCase& shown : cases)
    list.push_back({{"name", shown.name()},
                    {"scene", drawn.place_of_scene(shown)},
                    {"modes", modes_json(shown)},
                    {"roots", roots_json(shown)},
                    {"shapes", shapes_json(shown)}});
  const project::DisplayUnits& display = cases.front().variant.display;
  const Json json{{"frequency", {{"unit", frequency_unit(display)}, {"factor", shown_frequency(display, 1)}}},
                  {"surfaces", std::move(drawn.surfaces).list()},
                  {"scenes", std::move(drawn.scenes).list()},
                  {"cases", std::move(list)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trivet::report
