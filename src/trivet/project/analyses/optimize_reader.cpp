// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/optimize_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/amplitude_limits.h"
#include "trivet/project/analyses/mount_choice.h"

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

std::optional<int> read_count(TableReader& reader, const std::string& key, double most, const std::string& usual) {
  const auto number = reader.number(key, Quantity::pure);
  if (!number) return std::nullopt;
  if (*number >= 1 && *number <= most && *number == std::floor(*number)) return static_cast<int>(*number);
  reader.error(key, fmt::format("{:.6g}", *number), fmt::format("a whole number from 1 to {:.0f} is expected", most),
               usual);
  return std::nullopt;
}

/// Results to minimise; "margin" alone stands for none.
std::vector<std::string> read_objective(TableReader& reader, const ResultNames& names, const NamesInFile& in_file,
                                        assembly::MotionQuantity quantity) {
  const auto words = reader.texts("minimize", R"("margin", or ["BODY.POINT.z", "ground.force.z"])");
  if (!words || (words->size() == 1 && words->front() == "margin")) return {};
  if (words->empty())
    reader.error("minimize", "an empty list", "something is made small", "minimize = \"margin\", or a list of results");
  if (in_file.harmonic_excitations.empty())
    reader.error("minimize", "no harmonic excitation in the model", "these are amplitudes under harmonic forces",
                 "add [excitations.NAME] with type = \"harmonic\"");
  for (auto word = words->begin(); word != words->end(); ++word) {
    if (!names.component(*word, quantity))
      names.refuse(reader, "minimize", *word, "one component of a body, BODY.POINT, an element or the ground");
    if (std::find(words->begin(), word, *word) != word)
      reader.error("minimize", foundation::quoted(*word), "it is named twice", "name it once");
  }
  return *words;
}

}  // namespace

void read_optimize(TableReader& root, TableReader& analyses, const ResultNames& names, const NamesInFile& in_file,
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
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
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
  request.minimize = read_objective(reader, names, in_file, request.quantity);
  if (const auto starts = read_count(reader, "starts", most_starts, "32 is usual")) request.starts = *starts;
  if (const auto count = read_count(reader, "combinations", most_combinations, "1000 is usual"))
    request.combinations = *count;
  reader.finish();
  result.optimize = std::move(request);
}

}  // namespace trivet::project
