// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/request_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/analyses/limits_reader.h"

namespace trivet::project {
namespace {

constexpr double most_starts = 1000, most_combinations = 1e6;

std::vector<std::string> names_of_choices(TableReader& root) {
  std::vector<std::string> names;
  const Node* table = root.has("parameters") ? root.node("parameters") : nullptr;
  for (std::size_t i = 0; table && i < table->keys.size(); ++i)
    if (is_mount_choice(table->items[i])) names.push_back(table->keys[i]);
  return names;
}

void check_names(TableReader& reader, const std::string& key, const std::vector<std::string>& words,
                 const ResultNames& names, assembly::MotionQuantity quantity) {
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (!names.component(*word, quantity))
      names.refuse(reader, key, *word, "one component of a body, BODY.POINT, an element or the ground");
    if (std::find(words.begin(), word, *word) != word)
      reader.error(key, foundation::quoted(*word), "it is named twice", "name it once");
  }
}

/// Amplitudes of the list under a key.
void check_objectives(TableReader& reader, const std::string& key, const std::vector<std::string>& words,
                      const ResultNames& names, const SymbolTable& symbols, assembly::MotionQuantity quantity) {
  if (symbols.harmonic_excitations.empty())
    reader.error(key, "no harmonic excitation in the model", "these are amplitudes under harmonic forces",
                 "add [excitations.NAME] with type = \"harmonic\"");
  check_names(reader, key, words, names, quantity);
}

/// The price of mounts, of which at least one has to vary.
void read_price(TableReader& reader, const std::vector<std::string>& choices, OptimizeRequest& request) {
  request.minimized = Minimized::price;
  const bool any = std::ranges::any_of(choices, [&](const std::string& choice) { return request.varies(choice); });
  if (!any)
    reader.error("minimize", "\"price\"", "no choice of mounts varies, so the price is the same in every design",
                 "add [parameters.NAME] with path = 'elements.NAME.type' and catalogue = \"FILE\"");
}

/// The transmissibilities of the requirements.
void read_isolation_objective(TableReader& root, TableReader& reader, OptimizeRequest& request) {
  request.minimized = Minimized::isolation;
  request.minimize = {"isolation"};
  const Node* requirements = root.has("requirements") ? root.node("requirements") : nullptr;
  if (!requirements || !requirements->find("isolation"))
    reader.error("minimize", "\"isolation\"", "no isolation is required, so it is not known of what and where",
                 "add isolation = {at = \"1480 rpm\", least = \"80 %\"} to [requirements]");
}

/// Results to minimise; "margin" alone stands for none, as "price" does.
void read_objective(TableReader& root, TableReader& reader, const ResultNames& names, const SymbolTable& symbols,
                    const std::vector<std::string>& choices, OptimizeRequest& request) {
  const auto words =
      reader.texts("minimize", R"("margin", "price", "isolation", or ["BODY.POINT.z", "ground.force.z"])");
  if (!words || (words->size() == 1 && words->front() == "margin")) return;
  if (words->size() == 1 && words->front() == "price") return read_price(reader, choices, request);
  if (words->size() == 1 && words->front() == "isolation") return read_isolation_objective(root, reader, request);
  if (words->empty())
    reader.error("minimize", "an empty list", "at least one result is minimised",
                 "minimize = \"margin\", or a list of results");
  check_objectives(reader, "minimize", *words, names, symbols, request.quantity);
  request.minimize = *words;
}

/// {"BODY.z" = 1, "ground.force.z" = 0.5}
void read_weights(TableReader& table, const ResultNames& names, const SymbolTable& symbols, OptimizeRequest& request) {
  const Node* weighted = table.table("weighted");
  if (!weighted) return;
  TableReader weights(*weighted, table.path() + ".weighted", table.problems());
  for (const std::string& name : weighted->keys) {
    const auto weight = weights.number(name, Quantity::pure);
    if (weight && !(*weight > 0 && std::isfinite(*weight)))
      weights.error(name, fmt::format("{:.6g}", *weight), "a weight is a number > 0", "remove what has no weight");
    request.minimize.push_back(name);
    request.weights.push_back(weight.value_or(1));
  }
  if (weighted->keys.empty())
    table.error("weighted", "no result", "at least one result is minimised", "weighted = {\"BODY.z\" = 1}");
  check_objectives(table, "weighted", request.minimize, names, symbols, request.quantity);
}

/// {weighted = {…}}, {rms = […]} or {static = […]}
void read_other_objective(TableReader& reader, const Node& minimize, const ResultNames& names,
                          const SymbolTable& symbols, OptimizeRequest& request) {
  TableReader table(minimize, reader.path() + ".minimize", reader.problems());
  const std::vector<std::pair<const char*, Minimized>> kinds = {{"rms", Minimized::rms},
                                                                {"static", Minimized::at_rest}};
  int found = table.has("weighted") ? 1 : 0;
  read_weights(table, names, symbols, request);
  for (const auto& [key, kind] : kinds) {
    const auto words = table.texts(key, R"(["BODY.POINT.z"])");
    if (!words) continue;
    ++found;
    request.minimized = kind;
    request.minimize = *words;
    if (kind == Minimized::at_rest) request.quantity = assembly::MotionQuantity::displacement;
    if (words->empty()) table.error(key, "an empty list", "at least one result is minimised", "name a result");
    check_names(table, key, *words, names, request.quantity);
  }
  if (found != 1)
    table.error("", fmt::format("{} of weighted, rms and static", found), "minimize has exactly one of them",
                "minimize = {weighted = {\"BODY.z\" = 1}}, {rms = [\"BODY.z\"]} or {static = [\"BODY.z\"]}");
  table.finish();
}

/// A whole number from 1 or more to `most`; none if it is not one.
std::optional<int> read_count(TableReader& reader, const std::string& key, double least, double most,
                              const std::string& remedy) {
  const auto count = reader.number(key, Quantity::pure);
  if (!count) return std::nullopt;
  if (*count >= least && *count <= most && *count == std::floor(*count)) return static_cast<int>(*count);
  reader.error(key, fmt::format("{:.6g}", *count),
               fmt::format("a whole number from {:.0f} to {:.0f} is expected", least, most), remedy);
  return std::nullopt;
}

/// `yield` or `worst_case`: what has to hold within the tolerances.
void read_robustness(const TableReader& root, TableReader& reader, const std::vector<std::string>& choices,
                     OptimizeRequest& request) {
  constexpr double most_yield = 0.999;  // beyond, 16,384 designs know too little
  request.yield = reader.number("yield", Quantity::pure);
  request.worst_case = reader.boolean("worst_case").value_or(false);
  if (request.yield && !(*request.yield >= least_wanted_yield && *request.yield <= most_yield))
    reader.error(
        "yield", fmt::format("{:.6g}", *request.yield),
        fmt::format("a share from {:.0f} % to {:.1f} % is expected", 100 * least_wanted_yield, 100 * most_yield),
        "write yield = \"99 %\", or worst_case = true for all machines within bounded tolerances");
  if (!request.is_robust()) return;
  const char* key = request.yield ? "yield" : "worst_case";
  if (request.yield && request.worst_case)
    reader.error("worst_case", "yield and worst_case", "one of them says what has to hold", "keep one of them");
  if (!root.has("tolerances"))
    reader.error(key, "no tolerances", "without them all machines are the same",
                 "write [tolerances.NAME] with path and half_width");
  if (reader.has("front"))
    reader.error(key, fmt::format("front and {}", key), "a front is searched without tolerances", "keep one of them");
  for (const std::string& choice : choices)
    if (request.varies(choice))
      reader.error(key, fmt::format("choice {} and {}", foundation::quoted(choice), key),
                   "mounts are chosen without tolerances",
                   "choose the mounts first, then name the numbers in parameters = [\"NAME\"]");
}

/// The results of a front.
void read_front(TableReader& reader, const ResultNames& names, const SymbolTable& symbols, OptimizeRequest& request) {
  const char* example = R"(["BODY.POINT.z", "ground.force.z"])";
  constexpr double fewest_points = 3, most_points = 101;
  constexpr std::size_t most_objectives = 3;
  if (const auto points = read_count(reader, "points", fewest_points, most_points, "11 is usual")) {
    request.points = *points;
    if (!reader.has("front"))
      reader.error("points", fmt::format("{}", *points), "only a front has points", "add front, or remove points");
  }
  const auto words = reader.texts("front", example);
  if (!words) return;
  if (words->size() < 2 || words->size() > most_objectives)
    reader.error("front", fmt::format("{} result{}", words->size(), words->size() == 1 ? "" : "s"),
                 "a front is between two or three results", std::string("front = ") + example);
  if (!request.minimize.empty() || request.minimized == Minimized::price)
    reader.error("front", "front and minimize", "a front minimises each of its results", "keep one of them");
  if (reader.has("points") && words->size() == most_objectives)
    reader.error("points", "a front of three results", "its points are the 21 of an even triangle", "remove points");
  check_objectives(reader, "front", *words, names, symbols, request.quantity);
  request.front = *words;
}

}  // namespace

void read_optimize(TableReader& root, TableReader& analyses, const ResultNames& names, const SymbolTable& symbols,
                   Analyses& result) {
  const Node* table = analyses.table("optimize");
  if (!table) return;
  TableReader reader(*table, "analyses.optimize", root.problems());
  OptimizeRequest request;
  if (result.response) request.quantity = result.response->selection.quantity;
  if (const auto quantity = read_quantity(reader)) request.quantity = *quantity;
  if (const auto wanted = reader.texts("parameters", R"(["NAME"])")) {
    std::vector<std::string> known;
    for (const DesignAxis& parameter : result.parameters) known.push_back(parameter.name);
    for (const std::string& choice : names_of_choices(root)) known.push_back(choice);
    for (const std::string& name : *wanted) {
      if (std::ranges::find(known, name) != known.end()) continue;
      const std::string guess = foundation::nearest_name(name, known);
      reader.error(
          "parameters", foundation::quoted(name), "no parameter has this name",
          guess.empty() ? "write [parameters.NAME] with path, from and to" : "did you mean \"" + guess + "\"?");
    }
    request.parameters = *wanted;
  }
  if (!root.has("parameters"))
    reader.error("", "no parameters", "a design varies at least one number",
                 "write [parameters.NAME] with path, from and to");
  if (const Node* minimize = reader.node("minimize"); minimize && minimize->kind == Node::Kind::table)
    read_other_objective(reader, *minimize, names, symbols, request);
  else read_objective(root, reader, names, symbols, names_of_choices(root), request);
  read_front(reader, names, symbols, request);
  request.starts = read_count(reader, "starts", 1, most_starts, "32 is usual");
  request.combinations =
      read_count(reader, "combinations", 1, most_combinations, "1000 is usual").value_or(request.combinations);
  read_robustness(root, reader, names_of_choices(root), request);
  reader.finish();
  result.optimize = std::move(request);
}

}  // namespace trivet::project
