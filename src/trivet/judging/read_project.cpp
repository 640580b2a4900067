// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/read_project.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "trivet/judging/acceptances.h"
#include "trivet/judging/checked_case.h"
#include "trivet/judging/rest_checks.h"
#include "trivet/judging/suspicions.h"
#include "trivet/judging/tolerance_reach.h"
#include "trivet/project/read_case.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/written_project.h"

namespace trivet::judging {
namespace {

using project::AnalysisFilter;
using project::Case;
using project::Project;

/// Adds the suspicions of a case to its warnings, except those accepted, and the error of clearances without rest.
void judge(Case& variant, const AnalysisFilter& filter, AcceptanceBook& book, foundation::Problems& problems) {
  const assembly::AssembledOnce assembled(variant.system);
  const foundation::Problems standing = standing_problems(variant, assembled);
  problems.add(standing);
  if (!standing.has_errors()) variant.warnings.add(standing);
  if (project::is_requested("clearances", filter, variant.name)) problems.add(without_rest(variant, assembled));
  const std::vector<Acceptance> accepted = read_acceptances(variant.document, problems);
  std::vector<std::pair<std::string, std::string>> kinds;
  for (const Acceptance& one : accepted) kinds.emplace_back(one.table, one.kind);
  const foundation::Problems warnings =
      book.warnings(suspicions(variant, assembled, kinds), accepted, variant.document, variant.name);
  problems.add(warnings);
  variant.warnings.add(warnings);
  variant.warnings.sort_by_origin();
}

/// Adds the problems of a case that the base model does not have, under the name of the case.
void add_of_case(const foundation::Problems& found, const foundation::Problems& base, const std::string& name,
                 foundation::Problems& problems) {
  for (foundation::Problem problem : found.list()) {
    const bool known = std::ranges::any_of(base.list(), [&](const foundation::Problem& p) {
      return p.subject == problem.subject && p.finding == problem.finding && p.rule == problem.rule;
    });
    if (known) continue;
    problem.subject = "case \"" + name + "\": " + problem.subject;
    problems.add(problem);
  }
}

/// Reads and judges the cases of a text one by one.
class CaseReader {
 public:
  /// @param earlier  a project of the same text, whose parts need not be read again; null if there is none
  CaseReader(const AnalysisFilter& filter, const Project* earlier) : filter_(filter), earlier_(earlier) {}

  /// One case; none if it has errors. @param title  of the file  @param base  null for the base model
  std::optional<Case> read(project::WrittenCase written, const Case* base, std::string& title,
                           foundation::Problems& problems) {
    const Case* before = earlier_ ? earlier_->find(written.name) : nullptr;
    std::optional<project::KnownModel> known;
    if (before) known.emplace(before->document, before->system.description(), &before->of_text);
    auto read = project::read_case(std::move(written.document), written.name, problems, known ? &*known : nullptr);
    if (!read) return std::nullopt;
    title = read->title;
    std::optional<Case> variant = checked_case(std::move(*read), filter_, base, problems);
    if (!variant) return std::nullopt;
    judge(*variant, filter_, book_, problems);
    if (!base && project::is_requested("tolerances", filter_, "")) {
      const foundation::Problems reach = tolerance_reach(*variant);
      problems.add(reach);
      variant->warnings.add(reach);
    }
    variant->changes = std::move(written.changes);
    return variant;
  }

  [[nodiscard]] foundation::Problems unused_acceptances(bool changed) const {
    return book_.unused_acceptances(changed);
  }

 private:
  const AnalysisFilter& filter_;
  const Project* earlier_;
  AcceptanceBook book_;
};

foundation::Expected<Project> judged(project::WrittenProject written, const AnalysisFilter& filter,
                                     const Project* earlier = nullptr) {
  Project project = std::move(written.project);
  foundation::Problems problems = std::move(written.problems), of_base;
  CaseReader reader(filter, earlier);
  if (auto base = reader.read(std::move(written.base), nullptr, project.title, of_base))
    project.cases.push_back(std::move(*base));
  problems.add(of_base);
  of_base.add(written.of_settings);
  for (project::WrittenCase& one : written.cases) {
    if (!one.is_readable) {
      problems.add(one.problems);
      continue;
    }
    foundation::Problems of_case = std::move(one.problems);
    std::string title;
    const std::string name = one.name;
    auto variant = reader.read(std::move(one), project.cases.empty() ? nullptr : &project.base(), title, of_case);
    add_of_case(of_case, of_base, name, problems);
    if (variant && !project.cases.empty()) project.cases.push_back(std::move(*variant));
  }
  if (!project.cases.empty() && project::is_requested("requirements", filter, ""))
    project.cases.front().warnings.add(written.over_cases);
  if (!filter.requested && !problems.has_errors()) {
    problems.add(reader.unused_acceptances(!project.settings.empty()));
    project.unused_parts = project::unused_parts(project.cases);
    problems.add(project.unused_parts);
    project.cases.front().warnings.add(project.unused_parts);
    project.cases.front().warnings.sort_by_origin();
  }
  problems.sort_by_origin();
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return project;
}

}  // namespace

foundation::Expected<Project> project_from_text_for(const AnalysisFilter& filter, const std::string& text,
                                                    const std::string& source, const std::vector<std::string>& settings,
                                                    const std::string& folder) {
  auto written = project::written_project(text, source, settings, folder);
  if (!written) return tl::make_unexpected(written.error());
  return judged(std::move(*written), filter);
}

foundation::Expected<Project> project_from_text(const std::string& text, const std::string& source,
                                                const std::vector<std::string>& settings, const std::string& folder) {
  return project_from_text_for({}, text, source, settings, folder);
}

foundation::Expected<Project> read_project(const std::filesystem::path& path,
                                           const std::vector<std::string>& settings) {
  const auto text = project::read_source(path);
  if (!text) return tl::make_unexpected(text.error());
  return project_from_text(*text, path.string(), settings);
}

foundation::Expected<Project> changed_project(const Project& project, const std::vector<std::string>& settings) {
  return judged(project::written_project(project, settings), {}, &project);
}

}  // namespace trivet::judging
