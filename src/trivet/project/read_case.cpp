// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/read_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/elements/element_reader.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/measured/measurements_reader.h"
#include "trivet/project/part_readers.h"
#include "trivet/project/report_settings.h"
#include "trivet/project/settings.h"
#include "trivet/project/text/bare_frequencies.h"
#include "trivet/project/text/element_types.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {
namespace {

/// False if this program does not know the format of the file.
bool is_known_format(TableReader& root) {
  if (!root.has("trivet")) root.missing("trivet", "start the file with trivet = 1");
  const auto version = root.number("trivet", Quantity::pure);
  if (version && *version != 1)
    root.error("trivet", fmt::format("format {:.6g}", *version), "this program reads format 1",
               "write trivet = 1, or use a newer program");
  return !version || *version == 1;
}

/// Part of a subject: "bodies.frame" of "bodies.frame.mass".
std::string part_path(const std::string& subject) {
  return subject.substr(0, subject.find('.', subject.find('.') + 1));
}

bool has_every_element(const model::Description& description, const SymbolTable& symbols) {
  const auto read =
      std::ranges::count_if(description.elements, [](const model::Element& element) { return !element.is_foundation; });
  return to_size(read) == symbols.elements.size();
}

/// Problems of the checked model that are not consequences of reading errors.
foundation::Problems beyond_reading(const foundation::Problems& found, const foundation::Problems& reading,
                                    bool every_body_was_read, bool every_element_was_read) {
  std::set<std::string> unread;
  bool misplaced = !every_body_was_read, lost_excitation = false;
  for (const auto& problem : reading.list()) {
    if (problem.severity != foundation::Severity::error) continue;
    unread.insert(part_path(problem.subject));
    lost_excitation = lost_excitation || problem.subject.starts_with("excitations.");
    const std::string path_in_part =
        problem.subject.substr(std::min(problem.subject.size(), part_path(problem.subject).size()));
    misplaced = misplaced ||
        ((problem.subject.starts_with("bodies.") || problem.subject.starts_with("nodes.")) &&
         (path_in_part.starts_with(".position") || path_in_part.starts_with(".orientation")));
  }
  foundation::Problems result;
  for (const auto& problem : found.list()) {
    if (unread.contains(part_path(problem.subject))) continue;
    if (misplaced && (problem.subject.starts_with("elements.") || problem.subject.starts_with("clearances.")))
      continue;  // lever arms are not known
    if ((misplaced || !every_element_was_read) && problem.subject.starts_with("nodes.")) continue;
    if (!every_body_was_read && problem.subject == "bodies") continue;
    if (!every_element_was_read && problem.subject.starts_with("bodies.") &&
        problem.severity == foundation::Severity::warning)
      continue;  // that nothing holds a body
    if (lost_excitation && (problem.subject == "excitations" || problem.subject.ends_with(".coherence"))) continue;
    result.add(problem);
  }
  return result;
}

/// Reads the parts of the model in the order in which they refer to each other.
model::Description read_description(const Node& document, TableReader& root, SymbolTable& symbols,
                                    const KnownModel* known) {
  model::Description description;
  description.title = root.text("title").value_or("");
  if (const Node* types = document.find("element_types"); types && types->kind == Node::Kind::table)
    symbols.element_types = types->keys;
  read_bodies(root, description, symbols, known);
  read_nodes(root, description, symbols);
  read_elements(root, description, symbols, known);
  read_foundations(root, description, symbols);
  read_system_damping(root, description, symbols);
  read_excitations(root, description, symbols);
  read_observations(root, description, symbols);
  for (const auto& adjust : symbols.adjustments) adjust(description);
  return description;
}

}  // namespace

std::optional<ReadCase> read_case(Node written, const std::string& name, foundation::Problems& problems,
                                  const KnownModel* known) {
  ReadCase read;
  read.name = name;
  std::optional<Node> completed = with_element_types(written, element_law_names(), read.of_text);
  read.document = completed ? std::move(*completed) : written;
  read.written = std::move(written);
  TableReader root(read.document, "", read.of_text);
  if (!is_known_format(root)) return problems.add(read.of_text), std::nullopt;
  SymbolTable symbols;
  model::Description description = read_description(read.document, root, symbols, known);
  read.title = description.title;
  read.analyses = read_analyses(root, symbols);
  read_measurements(root, description, symbols, read.analyses);
  read.analyses.choices = read_mount_choices(root, read.written);
  read.display = read_display(root);
  warn_of_bare_frequencies(read.document, read.display, read.of_text);
  static_cast<void>(read_report(root));  // for its problems; a report reads it when it is written
  root.also_known({"cases", "accept", "element_types", "tables"});
  root.finish();

  const bool every_body_was_read =
      !symbols.bodies_unknown && description.bodies.size() == symbols.bodies.size() + symbols.nodes.size();
  const bool every_element_was_read = has_every_element(description, symbols);
  read.has_every_part = every_body_was_read && every_element_was_read;
  read.bodies = description.bodies;
  auto system = model::System::checked(std::move(description));
  read.of_model = beyond_reading(system ? system->warnings() : system.error(), read.of_text, every_body_was_read,
                                 every_element_was_read);
  if (system) read.system = std::move(*system);
  return read;
}

Node without_analyses(Node document) {
  for (const char* analysis : {"analyses", "limits", "limit_lines", "measurements", "requirements", "parameters",
                               "tolerances", "cases", "operation"})
    if (const auto at = std::ranges::find(document.keys, analysis); at != document.keys.end()) {
      document.items.erase(document.items.begin() + (at - document.keys.begin()));
      document.keys.erase(at);
    }
  return document;
}

}  // namespace trivet::project
