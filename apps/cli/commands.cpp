// SPDX-License-Identifier: BSD-3-Clause
#include "cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <stdexcept>

#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/strictness.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/message_list.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/project/analyses/steady_question.h"
#include "trivet/project/suspicions.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/units.h"
#include "trivet/results/check_text.h"
#include "trivet/results/project_json.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/asked_questions.h"
#include "trivet/study/cut_short.h"
#include "trivet/study/explanation.h"
#include "trivet/study/whole_study.h"

namespace trivet::cli {

namespace {

/// Rejects lists in which only some values have a unit: "1,5 Hz" may be one number with a decimal comma, 1 rad/s and
/// 5 Hz, or 1 Hz and 5 Hz. The 0 of a band is 0 in every unit.
void refuse_mixed_units(const std::string& option, const std::string& text, const std::vector<std::string>& items) {
  const bool band = option == "--band";
  std::size_t bare = 0, with_unit = 0;
  for (const std::string& item : items) {
    double value = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
    const bool plain = error == std::errc() && end == item.data() + item.size();
    if (!plain) ++with_unit;
    else if (!(band && value == 0)) ++bare;
  }
  if (bare == 0 || with_unit == 0) return;
  throw BadArgument(
      fmt::format("{} \"{}\": some values have a unit and some have none; give each its unit as in {} \"1 Hz,5 Hz\", "
                  "or none for rad/s; a decimal number has a point: \"1.5 Hz\"",
                  option, text, option));
}

}  // namespace

std::vector<double> frequencies(const std::string& option, const std::string& text) {
  std::vector<double> result;
  std::vector<std::string> items;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string item = text.substr(from, comma - from);
    item.erase(0, item.find_first_not_of(' '));
    items.push_back(item.substr(0, item.find_last_not_of(' ') + 1));
    from = comma + 1;
  }
  refuse_mixed_units(option, text, items);
  for (const std::string& item : items) {
    double value = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
    if (error != std::errc() || end != item.data() + item.size()) {
      const auto converted = project::to_si(item, project::Quantity::angular_frequency);
      if (!converted)
        throw BadArgument(
            fmt::format("{}: \"{}\": {}; give rad/s, or a unit as in \"5 Hz\"", option, item, converted.error()));
      value = *converted;
    }
    if (const auto broken = project::outside_range(value, project::Quantity::angular_frequency))
      throw BadArgument(fmt::format("{}: {:.6g} rad/s; {}", option, value, *broken));
    if (!(value >= 0)) throw BadArgument(fmt::format("{}: \"{}\"; a frequency is ≥ 0; remove the sign", option, item));
    result.push_back(value);
  }
  return result;
}

namespace {

/// The request of a command: the question, with the frequencies of the command line instead of those of the file.
project::Analyses analyses_for(const study::AskedQuestion& question, const project::Case& variant,
                               const Options& options) {
  project::Analyses analyses;
  try {
    analyses = question.asked(variant);
  } catch (const foundation::InvalidInput& missing) {
    throw BadArgument(missing.what());
  }
  if (options.lowest > 0) analyses.lowest_modes = options.lowest;
  if (options.deep) {
    auto steady = std::make_shared<project::SteadyQuestion>(*analyses.find<project::SteadyQuestion>("steady"));
    steady->deep = true;
    analyses.questions["steady"] = std::move(steady);
  }
  if (!options.at.empty() && !analyses.response) {
    auto steady = std::make_shared<project::SteadyQuestion>(*analyses.find<project::SteadyQuestion>("steady"));
    if (steady->over_load_factor)
      throw BadArgument("--at " + options.at +
                        ": the steady motion of the file is over the load factor, at one frequency; remove "
                        "over = \"load_factor\" from the file");
    steady->harmonics_at = frequencies("--at", options.at);
    analyses.questions["steady"] = std::move(steady);
    return analyses;
  }
  assert(analyses.response || (options.at.empty() && options.band.empty()));  // options of `response` only
  if (!options.at.empty()) {
    analyses.response->at = frequencies("--at", options.at);
    analyses.response->band.reset();
    analyses.limit_lines.clear();
  }
  if (!options.band.empty()) {
    const std::vector<double> band = frequencies("--band", options.band);
    if (band.size() != 2 || !(band[1] > band[0]))
      throw BadArgument(fmt::format("--band {}: a band is FROM,TO with FROM < TO", options.band));
    if (const auto broken = project::wrong_band(band[0], band[1]))
      throw BadArgument(fmt::format("--band {}: {}", options.band, *broken));
    analyses.response->band = response::Band{band[0], band[1]};
    analyses.response->at.clear();
    analyses.limit_lines = variant.analyses.limit_lines;
  }
  return analyses;
}

std::string rendered(const std::string& which, const project::Case& variant, const study::Answers& answers,
                     const Options& options) {
  if (options.json) return results::answer_json(which, variant, answers);
  return options.csv ? results::answer_csv(which, variant, answers) : results::answer_text(which, variant, answers);
}

}  // namespace

std::string warnings_text(const study::Answers& answers) {
  foundation::Problems warnings;
  for (const foundation::Problem& warning : answers.warnings.list())
    if (std::find(answers.failures.begin(), answers.failures.end(), warning.subject) == answers.failures.end())
      warnings.add(warning);
  std::string text = foundation::message_list(warnings);
  for (const std::string& failure : answers.failures) text += "NOT COMPUTED: " + failure + "\n";
  for (const auto* notes : {&answers.free_motions, &answers.notes})
    for (const std::string& note : *notes) text += "note: " + note + "\n";
  return text.empty() ? text : text + "\n";
}

const project::Case& chosen_case(const project::Project& project, const std::string& name) {
  const project::Case* found = project.find(name);
  if (found) return *found;
  std::vector<std::string> names;
  for (const auto& c : project.cases) names.push_back(c.name);
  const std::string guess = foundation::nearest_name(name, names);
  std::string known;
  for (const auto& n : names)
    if (!n.empty()) known += (known.empty() ? "" : ", ") + n;
  throw BadArgument(fmt::format(
      "--case \"{}\": no such case; {}", name,
      guess.empty() ? (known.empty() ? "the file has none" : "known: " + known) : "did you mean \"" + guess + "\"?"));
}

std::unique_ptr<results::PictureFile> new_picture(const Options& options) {
  if (options.picture.empty()) return nullptr;
  try {
    return std::make_unique<results::PictureFile>(options.picture, options.project);
  } catch (const foundation::InvalidInput& refused) {
    throw BadArgument(std::string("--picture ") + refused.what());
  }
}

project::Questions questions_of(const Options& options, std::vector<std::string> names) {
  return {std::move(names), options.case_name};
}

std::optional<project::Project> read_or_complain(const Options& options, const project::Questions& questions) {
  foundation::remove_abandoned_folders();
  auto project = project::read_project_for(questions, options.project, options.settings);
  if (project) return std::move(*project);
  complain(options, project.error());
  return std::nullopt;
}

/// The note that requirements are judged by `verdict`; empty if the file has nothing to judge.
std::string judged_by_verdict(const project::Project& project, const std::string& file) {
  const project::Analyses& asked = project.base().analyses;
  const bool clearances = !project.base().system.description().clearances.empty();
  if (!asked.requirements && !clearances && asked.limits.empty() && asked.limit_lines.empty()) return "";
  return fmt::format("Not judged here: requirements{} and limits, in all cases. Judge them by: trivet verdict {}\n",
                     clearances ? ", clearances" : "", file);
}

int complain(const Options& options, const foundation::Problems& problems) {
  if (options.json) write_output(results::problems_json(problems, {}));
  write_problems(problems);
  return wrong_input;
}

int check_command(const Options& options) {
  const auto project = read_or_complain(options);
  if (!project) return wrong_input;
  const std::vector<study::CaseCheck> cases = study::check(*project, options.deep);
  foundation::Problems warnings;
  for (const study::CaseCheck& one : cases) warnings.add(one.warnings);
  warnings.sort_by_origin();
  if (options.json) {
    write_output(results::problems_json(warnings, cases.front().free_motions, cases));
  } else {
    std::string text;
    for (const study::CaseCheck& one : cases) text += results::case_check_text(one);
    write_problems(warnings);
    write_output(
        text + judged_by_verdict(*project, options.project) +
        fmt::format("{}: no errors{}\n", options.project, warnings.list().empty() ? "" : ", but there are warnings"));
  }
  const bool agrees = std::all_of(cases.begin(), cases.end(),
                                  [](const study::CaseCheck& one) { return !one.deep || one.deep->passed; });
  Strictness strictness;
  strictness.add(warnings);
  return strictness.exit_code(options.strict, agrees ? done : not_computed);
}

int answer_command(const std::string& which, const Options& options) {
  const study::AskedQuestion& question = study::asked_question(which);
  project::Questions looked_at = questions_of(options, question.looks_at);
  looked_at.command = which;
  looked_at.lowest_modes = options.lowest;
  const auto project = read_or_complain(options, looked_at);
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    const project::Analyses asked = analyses_for(question, variant, options);
    study::Answers answers = study::answers(variant, asked, progress());
    if (!options.band.empty()) answers.warnings.add(project::doubts_about_band(variant, *asked.response->band));
    const bool only_beside = which == "response" && answers.response;  // then only a limit or a limit line failed
    if (!answers.failures.empty() && !only_beside) throw foundation::NotComputable(answers.failures.front());
    if (options.csv) write_problems(answers.warnings);
    const bool plain = !options.csv && !options.json;
    write_output((plain ? warnings_text(answers) : std::string()) + rendered(which, variant, answers, options));
    Strictness strictness;
    strictness.add(answers);
    const bool complete = answers.failures.empty() && !study::is_cut_short(answers);
    return strictness.exit_code(options.strict, complete ? done : not_computed);
  } catch (const BadArgument& bad) {
    write_failure(bad);
    return wrong_input;
  }
}

}  // namespace trivet::cli
