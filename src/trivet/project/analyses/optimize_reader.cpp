// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/optimize_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/amplitude_limits.h"

namespace trivet::project {
namespace {

constexpr double most_starts = 1000;

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
  if (const auto starts = reader.number("starts", Quantity::pure)) {
    if (*starts >= 1 && *starts <= most_starts && *starts == std::floor(*starts))
      request.starts = static_cast<int>(*starts);
    else
      reader.error("starts", fmt::format("{:.6g}", *starts),
                   fmt::format("a whole number from 1 to {:.0f} is expected", most_starts), "32 is usual");
  }
  reader.finish();
  result.optimize = std::move(request);
}

}  // namespace trivet::project
