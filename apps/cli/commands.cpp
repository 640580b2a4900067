// SPDX-License-Identifier: BSD-3-Clause
#include "cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "cli/answer_tables.h"
#include "cli/console.h"
#include "cli/further_tables.h"
#include "cli/strictness.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/modal/free_motions.h"
#include "trivet/plausibility/suspicion.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/units.h"
#include "trivet/results/answers_json.h"
#include "trivet/results/further_json.h"
#include "trivet/results/tables_csv.h"

namespace trivet::cli {

namespace {

/// "1,5 Hz" may be one number with a decimal comma, 1 rad/s and 5 Hz, or 1 Hz and 5 Hz: all values have a unit, or none has. The 0 of a band is 0 in every unit.
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
  throw BadArgument(fmt::format("{} \"{}\": some values have a unit and some have none; give each its unit as in {} \"1 Hz,5 Hz\", or none for rad/s; a decimal number has a point: \"1.5 Hz\"", option, text,
                                option));
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
      if (!converted) throw BadArgument(fmt::format("{}: \"{}\": {}; give rad/s, or a unit as in \"5 Hz\"", option, item, converted.error()));
      value = *converted;
    }
    if (const auto broken = project::outside_range(value, project::Quantity::angular_frequency)) throw BadArgument(fmt::format("{}: {:.6g} rad/s; {}", option, value, *broken));
    if (!(value >= 0)) throw BadArgument(fmt::format("{}: {:.6g} rad/s; an angular frequency is ≥ 0", option, value));
    result.push_back(value);
  }
  return result;
}

namespace {

project::Analyses wanted(const std::string& which, const project::Case& variant, const Options& options) {
  project::Analyses analyses;
  const project::Analyses& file = variant.analyses;
  if (which == "response") {
    analyses.response = file.response.value_or(project::ResponseRequest{});
    analyses.limits = file.limits;
    if (analyses.response->at.empty() && options.at.empty())
      analyses.limit_lines = file.limit_lines;  // lines are compared over a band
    if (!options.at.empty()) {
      analyses.response->at = frequencies("--at", options.at);
      analyses.response->band.reset();
    }
    if (!options.band.empty()) {
      const std::vector<double> band = frequencies("--band", options.band);
      if (band.size() != 2 || !(band[1] > band[0])) throw BadArgument(fmt::format("--band {}: a band is FROM,TO with FROM < TO", options.band));
      if (const auto broken = project::wrong_band(band[0], band[1])) throw BadArgument(fmt::format("--band {}: {}", options.band, *broken));
      analyses.response->band = response::Band{band[0], band[1]};
      analyses.response->at.clear();
      analyses.limit_lines = file.limit_lines;
    }
  } else if (which == "peaks") {
    analyses.peaks = file.peaks.value_or(project::PeaksRequest{file.response ? file.response->wanted : project::Wanted{}});
  } else if (which == "static") {
    std::vector<std::string> all = {"coordinates"};
    for (const auto& element : variant.system.elements()) all.push_back(element.name);
    all.push_back("ground");
    analyses.static_of = file.static_of.value_or(all);
    analyses.load_sharing = variant.system.description().gravity.has_value();
  } else if (which == "random") {
    analyses.random = file.random.value_or(project::RandomRequest{});
  } else if (which == "transient") {
    analyses.transient = file.transient.value_or(project::TransientRequest{});
  } else if (which == "orders") {
    if (!file.orders) throw BadArgument("orders: say over which speeds: add orders = {speed = [\"600 rpm\", \"3000 rpm\"]} to [analyses]");
    analyses.orders = file.orders;
  } else if (which == "transmissibility") {
    if (!file.transmissibility) throw BadArgument("transmissibility: say of what: add transmissibility = {force = \"EXCITATION\"} or {base = \"z\"} to [analyses]");
    analyses.transmissibility = file.transmissibility;
  }
  return analyses;
}

/// The questions of the file that a command looks at. Peaks are those of the response unless the file says otherwise.
std::vector<std::string> asked_by(const std::string& which) {
  if (which == "modes" || which == "roots") return {};
  if (which == "response") return {"response", "limits", "limit_lines"};
  if (which == "peaks") return {"peaks", "response"};
  return {which};
}

/// Which excitations act together in the response or the peaks, if there are several.
std::string excited_by(const project::Case& variant, const std::string& question) {
  const project::Analyses& asked = variant.analyses;
  const std::vector<std::string> chosen = question == "peaks" && asked.peaks ? asked.peaks->wanted.excitations
                                          : asked.response                   ? asked.response->wanted.excitations
                                                                             : std::vector<std::string>();
  std::string names;
  int count = 0;
  for (const model::Excitation& excitation : variant.system.description().excitations) {
    const bool acts = chosen.empty() || std::find(chosen.begin(), chosen.end(), excitation.name) != chosen.end();
    if (!acts || !std::holds_alternative<model::Harmonic>(excitation.course)) continue;
    names += (count++ > 0 ? ", " : "") + excitation.name;
  }
  return count > 1 ? "Excited at once by " + names + " (`excitations` of the question selects some)\n" : "";
}

std::string rendered(const std::string& which, const project::Case& variant, const study::Answers& answers, const Options& options) {
  if (which == "modes") return options.json ? results::modes_json(variant, answers) : options.csv ? results::modes_csv(variant, answers) : modes_text(variant, answers);
  if (which == "roots") return options.json ? results::roots_json(variant, answers) : options.csv ? results::roots_csv(answers) : roots_text(answers);
  if (which == "response")
    return options.json  ? results::response_json(answers)
           : options.csv ? results::response_csv(answers)
                         : excited_by(variant, which) + response_text(answers) + limits_text(answers) + limit_lines_text(answers);
  if (which == "peaks") return options.json ? results::peaks_json(answers) : options.csv ? results::peaks_csv(answers) : excited_by(variant, which) + peaks_text(answers);
  if (which == "random") return options.json ? results::random_json(answers) : options.csv ? results::random_csv(answers) : random_text(answers);
  if (which == "transient") return options.json ? results::transient_json(answers) : options.csv ? results::transient_csv(answers) : transient_text(answers);
  if (which == "orders") return options.json ? results::orders_json(answers) : options.csv ? results::orders_csv(answers) : orders_text(answers);
  if (which == "transmissibility")
    return options.json ? results::transmissibility_json(answers) : options.csv ? results::transmissibility_csv(answers) : transmissibility_text(answers);
  return options.json ? results::static_json(answers) : options.csv ? results::static_csv(answers) : static_text(answers) + (answers.load_sharing ? load_sharing_text(answers) : std::string());
}

}  // namespace

const project::Case& chosen_case(const project::Project& project, const std::string& name) {
  const project::Case* found = project.find(name);
  if (found) return *found;
  std::vector<std::string> names;
  for (const auto& c : project.cases) names.push_back(c.name);
  const std::string guess = foundation::nearest_name(name, names);
  std::string known;
  for (const auto& n : names)
    if (!n.empty()) known += (known.empty() ? "" : ", ") + n;
  throw BadArgument(fmt::format("--case \"{}\": no such case; {}", name, guess.empty() ? (known.empty() ? "the file has none" : "known: " + known) : "did you mean \"" + guess + "\"?"));
}

std::unique_ptr<results::PictureFile> new_picture(const Options& options) {
  if (options.picture.empty()) return nullptr;
  try {
    return std::make_unique<results::PictureFile>(options.picture, options.project);
  } catch (const foundation::InvalidInput& refused) {
    throw BadArgument(std::string("--picture ") + refused.what());
  }
}

project::Questions questions_of(const Options& options, std::vector<std::string> wanted) {
  return {std::move(wanted), options.case_name};
}

std::optional<project::Project> read_or_complain(const Options& options, const project::Questions& questions) {
  foundation::remove_abandoned_folders();
  auto project = project::read_project_for(questions, options.project, options.settings);
  if (project) return std::move(*project);
  if (options.json) write_output(results::problems_json(project.error(), {}));
  write_problems(project.error());
  return std::nullopt;
}

int check_command(const Options& options) {
  const auto project = read_or_complain(options);
  if (!project) return wrong_input;
  std::vector<std::string> free_motions;
  foundation::Problems warnings;
  std::string text;
  std::vector<results::CheckLine> base_lines;
  bool agrees = true;
  std::vector<results::CaseDeepCheck> compared;
  for (const project::Case& variant : project->cases) {
    foundation::Problems found = variant.warnings;
    const assembly::Assembled assembled = assembly::assemble(variant.system);
    const modal::Modes modes = modal::modes(variant.system, assembled);
    found.add(modes.warnings);
    found.add(modal::roots(variant.system, assembled, modes).warnings);
    warnings.add(found);
    std::vector<results::CheckLine> lines = results::check_lines(variant);
    if (variant.name.empty()) base_lines = lines;
    else std::erase_if(lines, [&](const results::CheckLine& line) { return std::find(base_lines.begin(), base_lines.end(), line) != base_lines.end(); });
    text += variant.name.empty() ? "Base model\n" : "Case " + variant.name + (lines.empty() ? ": checks as the base model\n" : "\n");
    if (!lines.empty()) text += checks_text(lines);
    for (const std::string& motion : modal::free_motions(variant.system, assembled, modes)) {
      text += "  note: " + motion + "\n";
      if (variant.name.empty()) free_motions.push_back(motion);
    }
    if (variant.name.empty())
      for (const std::string& note : plausibility::overturning_notes(variant.system)) text += "  note: " + note + "\n";
    if (options.deep) {
      const response::DeepCheck deep = study::deep_check(variant);
      agrees = agrees && deep.passed;
      compared.push_back({variant.name, deep});
      text += fmt::format("  two solvers at {} frequencies: largest difference {:.2e} at ω = {:.6g} rad/s, allowed there {:.2e} (round-off × condition): {}\n",
                          deep.frequencies, deep.worst_difference, deep.at_angular_frequency, deep.allowed, deep.verdict());
    }
  }
  warnings.sort_by_origin();
  if (options.json)
    write_output(results::problems_json(warnings, free_motions, compared));
  else {
    write_problems(warnings);
    write_output(text + fmt::format("{}: no errors{}\n", options.project, warnings.list().empty() ? "" : ", but read the warnings"));
  }
  Strictness strictness;
  strictness.add(warnings);
  return strictness.exit_code(options.strict, agrees ? done : not_computed);
}

int answer_command(const std::string& which, const Options& options) {
  const auto project = read_or_complain(options, questions_of(options, asked_by(which)));
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    const study::Answers answers = study::answers(variant, wanted(which, variant, options), progress());
    const bool only_beside =
        answers.response.has_value();  // what failed then is a limit or a limit line beside the response
    if (!answers.failures.empty() && !only_beside) throw foundation::NotComputable(answers.failures.front());
    if (options.csv) write_problems(answers.warnings);
    const bool plain = !options.csv && !options.json;
    write_output((plain ? warnings_text(answers) : std::string()) + rendered(which, variant, answers, options));
    Strictness strictness;
    strictness.add(answers);
    return strictness.exit_code(options.strict, answers.failures.empty() ? done : not_computed);
  } catch (const BadArgument& bad) {
    write_failure(bad);
    return wrong_input;
  }
}

}  // namespace trivet::cli
