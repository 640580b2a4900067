// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/analyses_reader.h"
#include "trivet/project/analyses/question_reader.h"
#include "trivet/project/analyses/question_sizes.h"
#include "trivet/project/analyses/requirements_reader.h"
#include "trivet/project/body_reader.h"
#include "trivet/project/display_reader.h"
#include "trivet/project/elements/element_reader.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/foundation_reader.h"
#include "trivet/project/map_numbers.h"
#include "trivet/project/measurements_reader.h"
#include "trivet/project/model_number.h"
#include "trivet/project/mount_choices.h"
#include "trivet/project/node_reader.h"
#include "trivet/project/observations_reader.h"
#include "trivet/project/questions.h"
#include "trivet/project/rest_of_clearances.h"
#include "trivet/project/settings.h"
#include "trivet/project/settled_system.h"
#include "trivet/project/standing_check.h"
#include "trivet/project/suspicions.h"
#include "trivet/project/text/acceptances.h"
#include "trivet/project/text/changes.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/element_types.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/part_tables.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_cases = 1000;

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

bool has_every_element(const model::Description& description, const NamesInFile& in_file) {
  const auto read = std::count_if(description.elements.begin(), description.elements.end(),
                                  [](const model::Element& element) { return !element.is_foundation; });
  return to_size(read) == in_file.elements.size();
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

/// Reads one variant of the document and adds all problems; none if there are errors. A map that equals that of `base`
/// is not checked again.
std::optional<Case> read_case(const Node& written, const std::string& name, std::string& title,
                              foundation::Problems& problems, const Questions& questions = {},
                              const Case* base = nullptr, const KnownModel* known = nullptr) {
  foundation::Problems reading;
  const std::optional<Node> completed = with_element_types(written, element_law_names(), reading);
  const Node& document = completed ? *completed : written;
  TableReader root(document, "", reading);
  model::Description description;
  NamesInFile in_file;
  if (!is_known_format(root)) return problems.add(reading), std::nullopt;
  title = root.text("title").value_or("");
  description.title = title;
  if (const Node* types = document.find("element_types"); types && types->kind == Node::Kind::table)
    in_file.element_types = types->keys;
  read_bodies(root, description, in_file, known);
  read_nodes(root, description, in_file);
  read_elements(root, description, in_file, known);
  read_foundations(root, description, in_file);
  read_system_damping(root, description, in_file);
  read_excitations(root, description, in_file);
  read_observations(root, description, in_file);
  for (const auto& adjust : in_file.adjustments) adjust(description);
  Analyses analyses = read_analyses(root, in_file);
  read_measurements(root, description, in_file, analyses);
  analyses.choices = read_mount_choices(root, written);
  const ShownUnits display = read_display(root);
  root.also_known({"cases", "accept", "element_types", "tables"});
  root.finish();

  const bool every_body_was_read =
      !in_file.bodies_unknown && description.bodies.size() == in_file.bodies.size() + in_file.nodes.size();
  const bool every_element_was_read = has_every_element(description, in_file);
  const std::vector<model::Body> bodies = description.bodies;
  auto system = model::System::checked(std::move(description));
  foundation::Problems all = reading;
  foundation::Problems physical = beyond_reading(system ? system->warnings() : system.error(), reading,
                                                 every_body_was_read, every_element_was_read);
  if (!system) name_slips(bodies, document, physical);
  if (system && every_body_was_read && every_element_was_read) settle(*system, physical);
  if (system) physical.add(too_large(system->description(), counted_part(questions, analyses)));
  if (system && !reading.has_errors()) {
    const auto answered = [&](const std::string& question) { return !is_only_setting(question, questions, name); };
    check_questions(*system, analyses, answered, physical);
    check_requirements(*system, analyses, physical);
    warn_of_small_motions(*system, analyses, physical);
  }
  locate(physical, document);
  all.add(physical);
  name_element_types(written, all);
  gather_columns(all);
  all = without_unrequested(all, questions, name, analyses);
  const bool new_map = analyses.map && (!base || !(base->analyses.map == analyses.map));
  const bool new_parameters = !base && !analyses.parameters.empty();
  if (new_map || new_parameters) {
    const auto known_here = system ? std::optional(KnownModel{document, system->description()}) : std::nullopt;
    const auto read_model = [&](const Node& model) {
      foundation::Problems found;
      std::string title_of_design;
      static_cast<void>(
          read_case(model, name, title_of_design, found, questions, nullptr, known_here ? &*known_here : nullptr));
      return found;
    };
    if (new_map) check_map_numbers(written, *analyses.map, read_model, all);
    if (new_parameters) check_parameters(written, analyses.parameters, read_model, all);
    all = without_unrequested(all, questions, name, analyses);
  }
  const bool good = !all.has_errors();
  all.sort_by_origin();
  problems.add(all);
  if (!good || !system) return std::nullopt;
  return Case{name, {}, std::move(*system), std::move(analyses), std::move(all), written, document, display};
}

/// Adds the suspicions of a case to its warnings, except those accepted, and the error of clearances without rest.
void judge(Case& variant, const Questions& questions, AcceptanceBook& book, foundation::Problems& problems) {
  foundation::Problems standing = standing_problems(variant.system);
  locate(standing, variant.document);
  problems.add(standing);
  if (!standing.has_errors()) variant.warnings.add(standing);
  if (is_requested("clearances", questions, variant.name)) problems.add(without_rest(variant));
  const std::vector<Acceptance> accepted = read_acceptances(variant.document, problems);
  std::vector<std::pair<std::string, std::string>> kinds;
  for (const Acceptance& one : accepted) kinds.emplace_back(one.table, one.kind);
  const foundation::Problems warnings =
      book.warnings(suspicions(variant, kinds), accepted, variant.document, variant.name);
  problems.add(warnings);
  variant.warnings.add(warnings);
  variant.warnings.sort_by_origin();
}

/// Adds the problems of a case that the base model does not have, under the name of the case.
void add_of_case(const foundation::Problems& found, const foundation::Problems& base, const std::string& name,
                 foundation::Problems& problems) {
  for (foundation::Problem problem : found.list()) {
    const bool known = std::any_of(base.list().begin(), base.list().end(), [&](const foundation::Problem& p) {
      return p.subject == problem.subject && p.finding == problem.finding && p.rule == problem.rule;
    });
    if (known) continue;
    problem.subject = "case \"" + name + "\": " + problem.subject;
    problems.add(problem);
  }
}

/// Number of bodies, nodes, elements and excitations in all cases together; each case has a separate model.
std::size_t parts_of_cases(const Node& document) {
  const auto count = [&](const char* table) { return document.find(table) ? document.find(table)->keys.size() : 0; };
  return count("cases") * (count("bodies") + count("nodes") + count("elements") + count("excitations"));
}

}  // namespace

std::filesystem::path folder_of_files(const Project& project) {
  if (!project.folder.empty()) return project.folder;
  const std::filesystem::path folder = std::filesystem::path(project.source).parent_path();
  return folder.empty() ? "." : folder;
}

const Case* Project::find(const std::string& name) const {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return c.name == name; });
  return found == cases.end() ? nullptr : &*found;
}

namespace {

std::optional<Case> read_changed(const Case& variant, Node document, const std::vector<Node>& changes,
                                 foundation::Problems& problems, bool may_fall = false) {
  for (const Node& change : changes) apply_changes(document, change, "", problems);
  std::string title;
  const KnownModel known{variant.document, variant.system.description()};
  auto changed = read_case(document, variant.name, title, problems, {}, nullptr, &known);
  if (changed && !may_fall) {
    foundation::Problems standing = standing_problems(changed->system);
    locate(standing, changed->document);
    problems.add(standing);
  }
  return problems.has_errors() ? std::nullopt : std::move(changed);
}

}  // namespace

foundation::Expected<model::System> changed_system(const Case& variant, const std::vector<Node>& changes,
                                                   bool may_fall) {
  foundation::Problems problems;
  auto changed = read_changed(variant, without_questions(variant.written), changes, problems, may_fall);
  if (changed) return std::move(changed->system);
  return tl::make_unexpected(std::move(problems));
}

foundation::Expected<Case> changed_case(const Case& variant, const std::vector<Node>& changes) {
  foundation::Problems problems;
  auto changed = read_changed(variant, without_questions(variant.written), changes, problems);
  if (!changed) return tl::make_unexpected(std::move(problems));
  changed->analyses = variant.analyses;
  changed->warnings = variant.warnings;
  return std::move(*changed);
}

foundation::Expected<model::System> changed_system(const Case& variant, const Design& design) {
  std::vector<Node> changes;
  for (const auto& [number, value] : design) changes.push_back(number.change(value));
  return changed_system(variant, changes);
}

namespace {

/// Reports cases that are not tables, or too many; false if there is none to read.
bool are_readable(const Node* cases, std::size_t parts, foundation::Problems& problems) {
  if (parts > most_parts_of_cases) {
    problems
        .error("cases", fmt::format("{} bodies, nodes, elements and excitations in all cases together", parts),
               fmt::format("at most {} are allowed", most_parts_of_cases), "split the file")
        .origin = cases->origin;
  } else if (cases && cases->kind != Node::Kind::table) {
    problems.error("cases", kind_name(cases->kind), "cases are tables", "write [cases.NAME]").origin = cases->origin;
  } else if (cases && cases->keys.size() > most_cases) {
    problems
        .error("cases", fmt::format("{} cases", cases->keys.size()), fmt::format("a file holds at most {}", most_cases),
               "split the file")
        .origin = cases->origin;
  } else {
    return cases != nullptr;
  }
  return false;
}

/// Reads the cases of a document and adds those without errors to the project.
/// @param written  the document without the settings of the command line
/// @param known    problems of the base model; a case reports them only once
void read_cases(const Node& document, const Node& written, const Settings& settings, const Questions& questions,
                const foundation::Problems& known, AcceptanceBook& book, Project& project,
                foundation::Problems& problems) {
  const Node* cases = document.find("cases");
  if (!are_readable(cases, parts_of_cases(document), problems)) return;
  for (std::size_t i = 0; i < cases->keys.size(); ++i) {
    const Node& change = cases->items[i];
    const std::string& name = cases->keys[i];
    if (change.kind != Node::Kind::table || name.empty()) {
      problems
          .error("cases." + name, name.empty() ? "name \"\"" : kind_name(change.kind), "a case is a table with a name",
                 "write [cases.NAME] and the changed numbers below")
          .origin = change.origin;
      continue;
    }
    Node variant = written;
    foundation::Problems of_case;
    apply_changes(variant, change, "", of_case);
    for (const Node& setting : settings.changes)
      apply_changes(variant, setting, "", of_case);  // the command line overrides the case
    std::string title;
    auto variant_case =
        read_case(variant, name, title, of_case, questions, project.cases.empty() ? nullptr : &project.base());
    if (variant_case) judge(*variant_case, questions, book, of_case);
    add_of_case(of_case, known, name, problems);
    if (!variant_case || project.cases.empty()) continue;
    variant_case->changes = change_lines(&change, settings, variant);
    project.cases.push_back(std::move(*variant_case));
  }
}

foundation::Expected<Project> project_for(const Questions& questions, const std::string& text,
                                          const std::string& source, const std::vector<std::string>& given,
                                          const std::string& folder = "") {
  foundation::Expected<Node> parsed = parse_toml(text, source);
  if (!parsed) return tl::make_unexpected(parsed.error());
  Node document = std::move(*parsed);
  foundation::Problems problems;
  std::string hashed = text;
  for (const std::string& setting : given) hashed += "\n" + setting;
  Project project;
  project.source = source;
  project.folder = folder;
  project.sha256 = sha256(hashed);
  if (!folder.empty()) set_folder(document, folder);
  const Settings settings = read_settings(given, folder_of_files(project), problems);
  put_tables_in_place(document, problems);
  foundation::Problems of_settings;
  const Node as_written = document;
  for (const Node& change : settings.changes) apply_changes(document, change, "", of_settings);
  problems.add(of_settings);

  foundation::Problems of_base;
  AcceptanceBook book;
  auto base = read_case(document, "", project.title, of_base, questions);
  if (base) judge(*base, questions, book, of_base);
  problems.add(of_base);
  if (base) base->changes = change_lines(nullptr, settings, document);
  if (base) project.cases.push_back(std::move(*base));
  of_base.add(of_settings);
  read_cases(document, as_written, settings, questions, of_base, book, project, problems);
  if (!questions.requested && !problems.has_errors()) {
    problems.add(book.unused_acceptances(!settings.changes.empty()));
    project.unused_parts = unused_parts(project.cases);
    problems.add(project.unused_parts);
    project.cases.front().warnings.add(project.unused_parts);
    project.cases.front().warnings.sort_by_origin();
  }
  problems.sort_by_origin();
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return project;
}

}  // namespace

foundation::Expected<Project> project_from_text(const std::string& text, const std::string& source,
                                                const std::vector<std::string>& settings, const std::string& folder) {
  return project_for({}, text, source, settings, folder);
}

foundation::Expected<Project> read_project_for(const Questions& questions, const std::filesystem::path& path,
                                               const std::vector<std::string>& settings) {
  const auto text = read_source(path);
  if (!text) return tl::make_unexpected(text.error());
  return project_for(questions, *text, path.string(), settings);
}

foundation::Expected<Project> read_project(const std::filesystem::path& path,
                                           const std::vector<std::string>& settings) {
  return read_project_for({}, path, settings);
}

}  // namespace trivet::project
