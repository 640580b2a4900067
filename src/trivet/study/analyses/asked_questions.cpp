// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/asked_questions.h"

#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/question_sizes.h"
#include "trivet/study/analyses/question_answer.h"

namespace trivet::study {
namespace {

using project::Analyses;
using project::Case;

Analyses modes_of(const Case& variant) {
  Analyses asked;
  asked.modes = true;
  asked.lowest_modes = variant.analyses.lowest_modes;
  return asked;
}

Analyses roots_of(const Case&) {
  Analyses asked;
  asked.roots = true;
  return asked;
}

/// @throws foundation::InvalidInput if the model has no excitation of the kind that the question needs
void require_excitation(const std::string& question, const Case& variant) {
  const project::Drive drive = project::drive_of(question);
  if (drive == project::Drive::none || project::is_driven(variant.system, drive)) return;
  const project::MissingExcitation missing = project::missing_excitation(drive);
  throw foundation::InvalidInput(question + ": " + missing.finding + "; this analysis needs one; " + missing.remedy);
}

Analyses response_of(const Case& variant) {
  require_excitation("response", variant);
  Analyses asked;
  asked.response = variant.analyses.response.value_or(project::ResponseRequest{});
  asked.limits = variant.analyses.limits;
  asked.lowest_modes = project::modes_beside_a_response;
  if (asked.response->at.empty()) asked.limit_lines = variant.analyses.limit_lines;  // lines are compared over a band
  return asked;
}

Analyses peaks_of(const Case& variant) {
  require_excitation("peaks", variant);
  const Analyses& file = variant.analyses;
  Analyses asked;
  asked.peaks =
      file.peaks.value_or(project::PeaksRequest{file.response ? file.response->selection : project::AnswerSelection{}});
  return asked;
}

Analyses static_of(const Case& variant) {
  std::vector<std::string> all = {"coordinates"};
  for (const auto& element : variant.system.elements()) all.push_back(element.name);
  all.push_back("ground");
  Analyses asked;
  asked.static_of = variant.analyses.static_of.value_or(all);
  asked.all_rest_states = variant.analyses.all_rest_states;
  asked.load_sharing = variant.system.description().gravity.has_value();
  return asked;
}

/// The question of the file; if it has none, the question with defaults.
Analyses own_question(const QuestionAnswer& question, const Case& variant) {
  Analyses asked;
  const auto found = variant.analyses.questions.find(question.name);
  const bool in_file = found != variant.analyses.questions.end();
  if (!in_file && question.to_add) throw foundation::InvalidInput(question.to_add);
  if (!in_file) require_excitation(question.name, variant);
  asked.questions[question.name] = in_file ? found->second : question.by_default();
  return asked;
}

Analyses limit_lines_of(const Case& variant) {
  if (variant.analyses.limit_lines.empty())
    throw foundation::InvalidInput(
        "limit_lines: none given; add [limit_lines.NAME] with of = \"BODY.z\" and rows = [[10, 2e-3], [60, 2e-3]]");
  Analyses asked = response_of(variant);
  asked.response->at.clear();
  asked.limit_lines = variant.analyses.limit_lines;
  return asked;
}

Analyses measurements_of(const Case& variant) {
  if (variant.analyses.measurements.empty())
    throw foundation::InvalidInput(
        "measurements: none given; add [measurements.NAME] with file = \"frf.uff\" and a response to [analyses]");
  Analyses asked;
  asked.response = variant.analyses.response;
  asked.measurements = variant.analyses.measurements;
  return asked;
}

}  // namespace

const std::vector<AskedQuestion>& asked_questions() {
  static const std::vector<AskedQuestion> list = [] {
    std::vector<AskedQuestion> all = {
        {"modes", "undamped natural frequencies and modes", {}, modes_of},
        {"roots", "damped roots", {}, roots_of},
        {"response",
         "amplitude- and phase-frequency characteristics",
         {"response", "limits", "limit_lines"},
         response_of},
        {"peaks", "exact resonance peaks", {"peaks", "response"}, peaks_of},
        {"static", "static displacements and forces", {"static"}, static_of},
    };
    for (const QuestionAnswer& question : question_answers())
      all.push_back({question.name, question.about, {question.name}, [&question](const Case& variant) {
                       return own_question(question, variant);
                     }});
    all.push_back({"limit_lines",
                   "response curves compared with limit lines over frequency",
                   {"response", "limit_lines"},
                   limit_lines_of});
    all.push_back({"measurements",
                   "measured curves and mode shapes compared with computed ones",
                   {"response", "measurements"},
                   measurements_of});
    return all;
  }();
  return list;
}

const AskedQuestion& asked_question(const std::string& name) {
  const auto& list = asked_questions();
  const auto found = std::ranges::find(list, name, &AskedQuestion::name);
  if (found == list.end()) throw foundation::InvalidInput("no question is called \"" + name + "\"");
  return *found;
}

}  // namespace trivet::study
