// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/robust_parts.h"
#include "trivet/results/design/search_parts.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/result_writer.h"

/// The best design: its parameters, requirements and natural frequencies beside those of the given one, what holds it,
/// and how sure the search is. Parameters are in their units.
namespace trivet::results {
namespace {

using study::Optimization;

const std::string& case_of(const Optimization& found, std::size_t c) { return found.after[c].case_name; }

/// The columns "case" of programs, and "words" of people: what a row is about, and in which case.
template <typename Row>
std::vector<Column> columns_of_case(const Optimization& found, const Rows<Row>& row, const std::string& heading,
                                    std::string Row::* words) {
  return {row("case", Kind::words, "", [&found](const Row& one) { return case_of(found, one.result_case); },
              {.forms = for_programs}),
          row("words", Kind::words, heading,
              [&found, words](const Row& one) { return words_in_case(found, one.result_case, one.*words); },
              {.forms = for_people})};
}

Table minimized_table(const Optimization& found) {
  using study::MinimizedAmplitude;
  const Rows row(found.minimized);
  Table table{.key = "minimized",
              .axis = found.minimized.empty() ? "" : "minimized",
              .rows = row.size(),
              .columns = columns_of_case(found, row, "minimised", &MinimizedAmplitude::name),
              .arrays = {{"minimized", "name"}, "unit", "case", "limit", "before", "after"}};
  table.columns.push_back(row("name", Kind::words, "", &MinimizedAmplitude::name));
  table.columns.push_back(row("unit", Kind::words, "", &MinimizedAmplitude::unit));
  const Kind kind = found.minimized_kind == project::Minimized::amplitude ? Kind::amplitude : Kind::quantity;
  add_largest(row, kind, "limit", "limit", &MinimizedAmplitude::limit, table.columns);
  add_largest(row, kind, "before", "given", &MinimizedAmplitude::before, table.columns);
  add_largest(row, kind, "after", "optimum", &MinimizedAmplitude::after, table.columns);
  return table;
}

Json step_json(const std::optional<study::OptimizedParameter::Step>& step) {
  if (!step) return nullptr;
  return {{"value", step->value}, {"objective", cell(step->objective)}, {"met", step->met}};
}

Table optimized_parameters(const Optimization& found) {
  using study::OptimizedParameter;
  std::vector<SearchedParameter> searched;
  for (const OptimizedParameter& p : found.parameters) searched.push_back({&p.axis, p.given});
  const Rows row(found.parameters);
  Table table{.key = "parameters",
              .axis = "parameter",
              .plain_names = true,
              .rows = row.size(),
              .columns = parameter_columns(std::move(searched))};
  const auto add = [&](Column column) { table.columns.push_back(std::move(column)); };
  const ColumnOptions in_unit = {.unit = unit_of_the_row};
  const std::string what = found.minimizes ? "minimised" : "margin";
  add(row("optimum", Kind::number, "optimum", &OptimizedParameter::best, in_unit));
  add(row("as_good_from", Kind::number, "", &OptimizedParameter::least, in_unit));
  add(row("as_good_to", Kind::number, "", &OptimizedParameter::most, in_unit));
  add(row("at_bound", Kind::yes_no, "", &OptimizedParameter::at_bound));
  const auto add_step = [&](const char* name, const std::string& heading, auto step) {
    add(row(name, Kind::words, "", [step](const OptimizedParameter& p) { return step_json(p.*step); },
            {.forms = in_json}));
    add(row(name, Kind::number, heading,
            [&found, step](const OptimizedParameter& p) { return step_words(p.*step, found); }, {.forms = for_people}));
  };
  add_step("one_percent_less", what + " if lowered by 1 % of its range", &OptimizedParameter::below);
  add_step("one_percent_more", "raised by 1 %", &OptimizedParameter::above);
  add(row("idle", Kind::yes_no, "", &OptimizedParameter::idle));
  add(row("remark", Kind::words, "remark", parameter_remark, {.forms = for_people}));
  return table;
}

/// One row per parameter, and one per choice of mounts.
Table optimum_file(const Optimization& found) {
  struct Line {
    std::string name, unit;
    Json from, to, given, optimum;
  };
  std::vector<Line> lines;
  for (const study::OptimizedParameter& p : found.parameters)
    lines.push_back({p.axis.name, axis_unit(p.axis), p.axis.from, p.axis.to, cell(p.given), p.best});
  for (std::size_t c = 0; found.mounts && c < found.mounts->choices.size(); ++c) {
    const project::MountChoice& choice = found.mounts->choices[c];
    lines.push_back({choice.name, "", nullptr, nullptr, nullptr, choice.mounts[found.mounts->chosen[c]]});
  }
  const Rows row(std::move(lines));
  return {.file = "optimum.csv",
          .rows = row.size(),
          .columns = {row("parameter", Kind::words, "", &Line::name), row("unit", Kind::words, "", &Line::unit),
                      row("from", Kind::number, "", &Line::from), row("to", Kind::number, "", &Line::to),
                      row("given", Kind::number, "", &Line::given), row("optimum", Kind::number, "", &Line::optimum)},
          .forms = in_csv};
}

Table optimum_cases(const Optimization& found) {
  const Rows row(found.after);
  const auto frequencies = [](const std::vector<study::DesignSummary>& list) {
    return [&list](std::size_t c) { return json::list(list[c].angular_frequencies); };
  };
  const auto decoupling = [](const std::vector<study::DesignSummary>& list) {
    return [&list](std::size_t c) {
      Json bodies = Json::object();
      for (const study::BodyDecoupling& one : list[c].decoupling) bodies[one.body] = one.least;
      return bodies;
    };
  };
  const auto one = [&](const char* name, auto value) { return row(name, Kind::words, "", value); };
  return {.key = "cases",
          .rows = row.size(),
          .columns = {one("case", &study::CaseVerdict::case_name),
                      one("before", [&found](std::size_t c) { return json::verdict(found.before[c]); }),
                      one("after", [&found](std::size_t c) { return json::verdict(found.after[c]); }),
                      one("angular_frequencies_before", frequencies(found.summaries_before)),
                      one("angular_frequencies_after", frequencies(found.summaries_after)),
                      one("decoupling_before", decoupling(found.summaries_before)),
                      one("decoupling_after", decoupling(found.summaries_after))},
          .forms = in_json};
}

Table active_table(const Optimization& found) {
  using study::ActiveRequirement;
  const Rows row(found.active);
  Table table{.key = "active",
              .axis = "active",
              .rows = row.size(),
              .columns = columns_of_case(found, row, "requirement that limits the optimum",
                                         &ActiveRequirement::words_for_people),
              .arrays = {{"active", "requirement"}, "case", "multiplier"}};
  table.columns.push_back(row("requirement", Kind::words, "", &ActiveRequirement::words));
  table.columns.push_back(row("minimized", Kind::yes_no, "", &ActiveRequirement::minimized));
  table.columns.push_back(row("multiplier", Kind::number, "", &ActiveRequirement::multiplier));
  table.columns.push_back(
      row("gain", Kind::number, "gain if its bound is 1 % looser [%]",
          [](const ActiveRequirement& one) { return one.minimized ? Json() : Json(one.multiplier); },
          {.digits = 3, .forms = for_people}));
  return table;
}

Table gone_peaks_table(const Optimization& found) {
  using study::GonePeak;
  const Rows row(found.gone_peaks);
  Table table{.key = "gone_peaks",
              .title = "The search went on to the design furthest from a peak, by the fall of the curves:",
              .rows = row.size(),
              .columns = columns_of_case(found, row, "no peak of", &GonePeak::name)};
  table.columns.push_back(row("name", Kind::words, "", &GonePeak::name));
  table.columns.push_back(row("measure", Kind::number, "", &GonePeak::measure));
  table.columns.push_back(row("gone_by", Kind::number, "gone by", [](const GonePeak& one) { return -one.measure; },
                              {.digits = 4, .forms = for_people}));
  table.columns.push_back(
      row("angular_frequency", Kind::frequency, "nearest to one at", &GonePeak::angular_frequency, {.digits = 4}));
  return table;
}

Table conflict_table(const Optimization& found) {
  using study::Conflict;
  const Rows row(found.conflicts);
  Table table{.key = "conflicts",
              .title = found.conflicts.size() == 1
                  ? "This requirement cannot be met within the ranges, but with its bound eased by the factor:"
                  : "These requirements contradict each other within the ranges. All can be met with every bound eased "
                    "by its factor:",
              .rows = row.size(),
              .columns = columns_of_case(found, row, "requirement", &Conflict::words_for_people),
              .mark = [](std::size_t) { return Mark::bad; }};
  table.columns.push_back(row("requirement", Kind::words, "", &Conflict::words));
  table.columns.push_back(row("factor", Kind::number, "factor", &Conflict::factor, {.digits = 4}));
  table.columns.push_back(row("without", Kind::number, "least margin of the others without it", &Conflict::without));
  return table;
}

Table other_optima(const Optimization& found) {
  using study::OtherOptimum;
  const Rows row(found.search.others);
  return {.key = "others",
          .rows = row.size(),
          .columns = {row.lists("values", "", "", {}, &OtherOptimum::values),
                      row("objective", Kind::number, "", &OtherOptimum::objective),
                      row("starts", Kind::number, "", &OtherOptimum::starts)},
          .forms = in_json};
}

void add_conditions(const Optimization& found, Document& document) {
  const auto note = [&](std::string words) {
    document.add(Sentence{.parts = {std::move(words)}, .place = Sentence::Place::note});
  };
  document.add(active_table(found));
  if (found.cut_short) note("What holds the optimum is not known: the search was ended before it was complete.");
  else if (found.robust && !found.no_slopes.empty())
    note("What holds the optimum is not one requirement of one design: trivet sample shows what breaks first there.");
  else if (!found.no_slopes.empty())
    note("What holds the optimum is not known: there are no slopes next to it (" + found.no_slopes + ").");
  else if (found.active.empty()) note("Nothing holds the optimum: no requirement limits it.");
  else note(fmt::format("Residual of the optimality conditions: {:.2g} of the largest slope.", found.residual));
  document.add(gone_peaks_table(found));
  document.add(
      Single{.name = "residual", .value = found.no_slopes.empty() && !found.cut_short ? Json(found.residual) : Json()});
  document.add(Single{.name = "no_slopes", .value = found.no_slopes});
  document.add(conflict_table(found));
}

/// What is sought, and how good the given design and the best one are.
void add_objective(const Optimization& found, Document& document) {
  const bool cheapest = found.mounts && found.mounts->price;
  const std::string unit = found.objective_unit.empty() ? "1" : found.objective_unit;
  const auto value = [&](const char* name, const std::optional<double>& objective) {
    const unsigned forms = objective ? in_json | in_arrays : in_json;
    document.add(Single{.name = name, .value = cell(objective), .unit = unit, .forms = forms});
  };
  document.add(Sentence{.parts = {optimization_headline(found) + "."}});
  document.add(Single{.name = "objective",
                      .value = found.minimizes ? Json(minimized_names(found)) : Json(cheapest ? "price" : "margin")});
  document.add(Single{.name = "weights", .value = found.weights});
  document.add(Single{.name = "falls_short", .value = found.falls_short});
  document.add(minimized_table(found));
  value("before", found.objective_before);
  value("after", found.objective_after);
  document.add(Single{.name = "unit", .value = unit});
  document.add(Single{.name = "feasible", .value = found.feasible});
  add_robust(found, document);
}

}  // namespace

Document optimization_document(const Optimization& found) {
  Document document;
  const auto add = [&](const char* name, Json value) { document.add(Single{.name = name, .value = std::move(value)}); };
  add_objective(found, document);
  document.add(optimized_parameters(found));
  document.add(optimum_file(found));
  document.add(optimum_cases(found));
  for (const std::string& line : mounts_lines(found))
    document.add(Sentence{.parts = {line}, .place = Sentence::Place::note});
  add_comparison(found, document);
  add_conditions(found, document);
  add("cut_short", found.cut_short);
  add("starts", found.search.starts);
  if (found.cut_short) add("finished", found.search.finished);
  add("agreeing", found.search.agreeing);
  add("stuck", found.search.stuck);
  document.add(other_optima(found));
  add("designs", found.search.evaluations);
  add("failed", found.search.failed);
  document.add(differenced_part(found.search.differenced, found.search.differences));
  add("looked_at", found.search.looked_at);
  add("families", found.families);
  add("no_families", found.no_families);
  add_mounts(found, document);
  add_search_lines(search_lines(found), document);
  return document;
}

Document optimum_in_short(const Optimization& found) {
  Document document;
  document.add(Sentence{.parts = {optimization_headline(found) + "."}});
  document.add(minimized_table(found));
  document.add(optimized_parameters(found));
  for (const std::string& line : mounts_lines(found))
    document.add(Sentence{.parts = {line}, .place = Sentence::Place::note});
  return document;
}

namespace {

Document optimize_document(const project::Case&, const study::CaseResults& results) {
  return results.front ? front_document(*results.front) : optimization_document(*results.optimization);
}

}  // namespace

/// The best design, or the front.
const ResultWriter optimize_results = {
    .has_result = [](const project::Case&,
                     const study::CaseResults& results) { return results.optimization || results.front; },
    .document = optimize_document,
    .files = {"optimum.csv"}};

std::string optimum_json(const study::CaseResults& results, const foundation::Problems& warnings) {
  Document document = results.front ? front_document(*results.front) : optimization_document(*results.optimization);
  document.add(Single{.name = "warnings", .value = json::warnings(warnings)});
  return as_json_text(document);
}

}  // namespace trivet::results
