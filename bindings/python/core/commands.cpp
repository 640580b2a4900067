// SPDX-License-Identifier: BSD-3-Clause
#include "core/commands.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <set>

#include "core/errors.h"
#include "trivet/exports/format.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/toml_value.h"
#include "trivet/report/element_picture.h"
#include "trivet/report/study_folder.h"
#include "trivet/results/check_text.h"
#include "trivet/results/element_json.h"
#include "trivet/results/element_text.h"
#include "trivet/results/explanation_json.h"
#include "trivet/results/explanation_text.h"
#include "trivet/results/project_json.h"
#include "trivet/results/suspension_json.h"
#include "trivet/results/suspension_text.h"
#include "trivet/results/verdict_results.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/asked_questions.h"

namespace trivet::python {
namespace {

/// Something that an answer refers to, with the project it was computed from.
template <typename Found>
struct Held {
  ProjectPointer project;
  Found found;
};
template <typename Found>
std::shared_ptr<const Held<Found>> hold(const ProjectPointer& project, Found found) {
  return std::make_shared<const Held<Found>>(Held<Found>{project, std::move(found)});
}

Answer new_answer(const ProjectPointer& project, const std::string& question, const std::string& case_name = "") {
  Answer answer;
  answer.question = question;
  answer.case_name = case_name;
  answer.title = project->title;
  return answer;
}

project::Case with_display(project::Case variant, const project::ShownUnits& display) {
  variant.display = display;
  return variant;
}

std::string case_list(const project::Project& project) {
  std::string known;
  for (const project::Case& variant : project.cases)
    if (!variant.name.empty()) known += (known.empty() ? "known: " : ", ") + variant.name;
  return known.empty() ? "the project has none" : known;
}

std::size_t element_of(const project::Case& variant, const std::string& name) {
  std::vector<std::string> names;
  for (const model::Element& element : variant.system.elements()) names.push_back(element.name);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return i;
  const std::string guess = foundation::nearest_name(name, names);
  throw foundation::InvalidInput(fmt::format(
      "\"{}\": no element has this name; {}", name,
      guess.empty() ? fmt::format("they are {}", fmt::join(names, ", ")) : "did you mean \"" + guess + "\"?"));
}

}  // namespace

const project::Case& case_of(const project::Project& project, const std::string& name) {
  if (const project::Case* found = project.find(name)) return *found;
  std::vector<std::string> names;
  for (const project::Case& variant : project.cases) names.push_back(variant.name);
  const std::string guess = foundation::nearest_name(name, names);
  throw foundation::InvalidInput(fmt::format("case \"{}\": no such case; {}", name,
                                             guess.empty() ? case_list(project) : "did you mean \"" + guess + "\"?"));
}

foundation::Problems without_unused(const project::Project& project, const foundation::Problems& warnings) {
  std::set<std::string> unused;
  for (const foundation::Problem& one : project.unused_parts.list()) unused.insert(foundation::message(one));
  foundation::Problems kept;
  for (const foundation::Problem& one : warnings.list())
    if (!unused.contains(foundation::message(one))) kept.add(one);
  return kept;
}

Answer asked(const ProjectPointer& project, const std::string& question, const std::string& case_name,
             const Progress& progress) {
  const study::AskedQuestion& row = study::asked_question(question);
  const project::Case& variant = case_of(*project, case_name);
  study::Answers found = study::answers(variant, row.asked(variant), progress);
  found.warnings = without_unused(*project, found.warnings);
  const auto held = hold(project, std::move(found));
  const study::Answers& answers = held->found;
  const bool only_beside = question == "response" && answers.response;  // then only a limit or a limit line failed
  if (!answers.failures.empty() && !only_beside) throw foundation::NotComputable(answers.failures.front());
  Answer answer = new_answer(project, question, case_name);
  answer.warnings = answers.warnings;
  answer.failures = answers.failures;
  for (const auto* notes : {&answers.free_motions, &answers.notes})
    answer.notes.insert(answer.notes.end(), notes->begin(), notes->end());
  answer.json = [held, question, &variant] { return results::answer_json(question, variant, held->found); };
  answer.text = [held, question, &variant] { return results::answer_text(question, variant, held->found); };
  answer.text_in = [held, question, &variant](const project::ShownUnits& display) {
    study::Answers shown = held->found;
    shown.display = display;
    return results::answer_text(question, with_display(variant, display), shown);
  };
  for (const results::AnswerTable& table : results::answer_tables(question))
    answer.tables.emplace_back(table.file, [held, &variant, table] { return table.csv(variant, held->found); });
  answer.arrays = results::answer_arrays(question, variant, answers);
  answer.held = held;
  return answer;
}

Answer judged(const ProjectPointer& project, const Progress& progress) {
  const auto held = hold(project, study::verdict(*project, progress));
  Answer answer = new_answer(project, "verdict");
  for (const study::CaseVerdict& one : held->found.cases) answer.warnings.add(one.warnings);
  answer.warnings.sort_by_origin();
  answer.json = [held] { return results::verdict_json(held->found); };
  answer.text = [held] { return results::verdict_text(held->found); };
  answer.text_in = [held](const project::ShownUnits& display) {
    study::Verdict shown = held->found;
    for (study::CaseVerdict& one : shown.cases) one.display = display;
    shown.envelope.display = display;
    return results::verdict_text(shown);
  };
  answer.tables.emplace_back("verdict.csv", [held] { return results::verdict_csv(held->found); });
  return answer;
}

Answer checked(const ProjectPointer& project, bool deep) {
  const auto held = hold(project, study::check(*project, deep));
  Answer answer = new_answer(project, "check");
  for (const study::CaseCheck& one : held->found) answer.warnings.add(one.warnings);
  answer.warnings.sort_by_origin();
  answer.json = [held, warnings = answer.warnings] {
    return results::problems_json(warnings, held->found.front().free_motions, held->found);
  };
  const auto text = [](const std::vector<study::CaseCheck>& cases) {
    std::string all;
    for (const study::CaseCheck& one : cases) all += results::case_check_text(one);
    return all;
  };
  answer.text = [held, text] { return text(held->found); };
  answer.text_in = [held, text](const project::ShownUnits& display) {
    std::vector<study::CaseCheck> shown = held->found;
    for (study::CaseCheck& one : shown) one.display = display;
    return text(shown);
  };
  return answer;
}

Answer explained(const ProjectPointer& project, const std::string& case_name, const std::vector<std::string>& of,
                 int most, const Progress& progress) {
  const project::Case& variant = case_of(*project, case_name);
  study::Explanation found = study::explanation(variant, {of, most}, progress);
  found.warnings = without_unused(*project, found.warnings);
  const auto held = hold(project, std::move(found));
  Answer answer = new_answer(project, "explain", case_name);
  answer.warnings = held->found.warnings;
  answer.json = [held, &variant] { return results::explain_json(variant, held->found); };
  answer.text = [held, &variant] { return results::explain_text(variant, held->found); };
  answer.tables.emplace_back("explain.csv", [held] { return results::explain_csv(held->found); });
  return answer;
}

Answer suspended(const ProjectPointer& project, const std::string& case_name,
                 const std::vector<std::vector<double>>& torques, const std::vector<double>& excitations) {
  const project::Case& variant = case_of(*project, case_name);
  std::vector<Eigen::Vector3d> axes;
  for (const std::vector<double>& torque : torques) {
    if (torque.size() != 3) throw foundation::InvalidInput("torques: a moment has three numbers, as in (0.9, 0, 0.1)");
    axes.emplace_back(torque[0], torque[1], torque[2]);
    if (!axes.back().allFinite() || axes.back().isZero(0))
      throw foundation::InvalidInput("torques: a moment needs a direction of finite numbers");
  }
  for (const double omega : excitations)
    if (!(omega > 0) || !std::isfinite(omega))
      throw foundation::InvalidInput(
          fmt::format("excitations: {} rad/s; a frequency of excitation is > 0 and finite", omega));
  study::SuspensionAnswer found = study::suspension(variant, axes, excitations);
  found.warnings = without_unused(*project, found.warnings);
  const auto held = hold(project, std::move(found));
  Answer answer = new_answer(project, "suspension", case_name);
  answer.warnings = held->found.warnings;
  answer.json = [held, &variant] { return results::suspension_json(variant, held->found); };
  answer.text = [held, &variant] { return results::suspension_text(variant, held->found); };
  answer.text_in = [held, &variant](const project::ShownUnits& display) {
    return results::suspension_text(with_display(variant, display), held->found);
  };
  answer.tables.emplace_back("suspension.csv",
                             [held, &variant] { return results::suspension_csv(variant, held->found); });
  return answer;
}

Answer element(const ProjectPointer& project, const std::string& name, const std::string& case_name, bool all,
               const Progress& progress) {
  const project::Case& variant = case_of(*project, case_name);
  const std::size_t number = element_of(variant, name);
  struct Found {
    study::ElementSummary summary;
    std::optional<study::Simplification> simple;
  };
  Found found{study::element_summary(variant, number), {}};
  std::vector<std::size_t> replaced = {number};
  if (all) {
    replaced.resize(variant.system.elements().size());
    std::iota(replaced.begin(), replaced.end(), std::size_t{0});
  }
  try {
    found.simple = study::simplification(variant, replaced, progress);
  } catch (const foundation::NotComputable& reason) {
    found.summary.warnings.warning("comparison with three springs", "not computed", reason.what(), "");
  }
  found.summary.warnings = without_unused(*project, found.summary.warnings);
  const auto held = hold(project, std::move(found));
  Answer answer = new_answer(project, "element", case_name);
  answer.warnings = held->found.summary.warnings;
  answer.json = [held, &variant, number] {
    return results::element_json(variant, number, held->found.summary, held->found.simple);
  };
  const auto text = [held, number](const project::Case& shown) {
    return results::element_text(shown, number, held->found.summary) +
        (held->found.simple ? "\n" + results::simplification_text(*held->found.simple) : "");
  };
  answer.text = [text, &variant] { return text(variant); };
  answer.text_in = [text, &variant](const project::ShownUnits& display) {
    return text(with_display(variant, display));
  };
  answer.figures.emplace_back("element.svg",
                              [held, &variant, number] { return report::element_picture(variant, number); });
  return answer;
}

std::vector<Answer> ran(const ProjectPointer& project, const std::string& folder, const Progress& progress) {
  const auto held = hold(project, report::write_study(*project, folder, progress));
  std::vector<Answer> all;
  for (std::size_t i = 0; i < project->cases.size(); ++i) {
    const project::Case& variant = project->cases[i];
    const study::Answers& answers = held->found.answers[i];
    Answer answer = new_answer(project, "run", variant.name);
    answer.warnings = answers.warnings;
    answer.failures = answers.failures;
    answer.notes = i == 0 ? held->found.notes : std::vector<std::string>();
    answer.text = [held, &variant, &answers] { return results::answers_summary(variant, answers); };
    answer.json = [held, project, &variant, &answers] {
      return results::case_results_json(*project, variant, answers);
    };
    all.push_back(std::move(answer));
  }
  return all;
}

std::vector<std::string> exported(const ProjectPointer& project, const std::string& format, const std::string& target,
                                  const std::vector<std::string>& what, const std::string& case_name,
                                  const Progress& progress) {
  return exports::export_project(*project, case_of(*project, case_name), format, what, target, progress);
}

}  // namespace trivet::python
