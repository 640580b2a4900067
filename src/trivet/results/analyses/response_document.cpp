// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/format/result_writer.h"

/// Amplitude- and phase-frequency characteristics, and the limits on them.
namespace trivet::results {
namespace {

using study::ResponseResult;

double real_of(const std::complex<double>& value) { return value.real(); }
double imaginary_of(const std::complex<double>& value) { return value.imag(); }
double amplitude_of(const std::complex<double>& value) { return std::abs(value); }

Json solution_checks(const ResponseResult& result) {
  const auto& check = result.curves.check;
  const auto& deep = result.deep;
  return {{"worst_backward_error", check.worst_backward_error},
          {"at_angular_frequency", check.at_angular_frequency},
          {"pivoted_fallbacks", check.fallbacks},
          {"solves", result.curves.solves},
          {"interpolation_error", result.curves.interpolation_error},
          {"undefined_at", check.undefined_at},
          {"second_solver",
           {{"frequencies", deep.frequencies},
            {"too_near_a_resonance", deep.incomparable},
            {"worst_difference", json::number(deep.worst_difference)},
            {"allowed", json::number(deep.allowed)},
            {"at_angular_frequency", deep.at_angular_frequency},
            {"passed", deep.passed}}}};
}

Curves response_curves(const ResponseResult& result) {
  Curves curves{.axis = "angular_frequency",
                .unit = "rad/s",
                .points = result.curves.angular_frequency,
                .file = "response.csv",
                .axis_columns = {"angular_frequency [rad/s]"}};
  for (const response::Curve& c : result.curves.curves) {
    const auto heading = [&c](const char* part) { return fmt::format("{} {} [{}]", c.name, part, c.unit); };
    curves.list.push_back(
        {.name = c.name,
         .unit = c.unit,
         .values = c.value,
         .harmonic = true,
         .csv = {{heading("re"), real_of}, {heading("im"), imaginary_of}, {heading("amplitude"), amplitude_of}}});
  }
  for (std::size_t c = 0; c < result.curves.curves.size(); ++c)
    curves.list.push_back({.name = result.curves.curves[c].name + " phase", .unit = "rad", .values = result.phase[c]});
  return curves;
}

Table response_rows(const ResponseResult& result) {
  using response::Curve;
  const Rows row(result.curves.curves);
  return {.key = "results",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "", &Curve::name), row("unit", Kind::words, "", &Curve::unit),
                      row.lists("complex", "", "", {}, &Curve::value),
                      row.lists("phase", "", "", {}, [&result](std::size_t c) { return Numbers(result.phase[c]); })},
          .forms = in_json};
}

/// A frequency that is a row for people.
struct Sample {
  std::size_t index = 0;
  double omega = 0;
};

std::vector<Sample> samples(const ResponseResult& result) {
  constexpr std::size_t most_rows = 60;
  const std::vector<double>& frequencies = result.curves.angular_frequency;
  const std::size_t step = (frequencies.size() + most_rows - 1) / most_rows;
  std::vector<Sample> list;
  for (std::size_t i = 0; i < frequencies.size(); i += step) list.push_back({i, frequencies[i]});
  return list;
}

/// Amplitudes and phases; on the page if there are few.
Table characteristics(const ResponseResult& result) {
  constexpr std::size_t few_points = 24;
  const std::size_t count = result.curves.angular_frequency.size();
  const Rows row(samples(result));
  Table table{.title = "Amplitude and phase (a lag is negative)",
              .rows = row.size(),
              .columns = {row("angular_frequency", Kind::frequency, "ω", &Sample::omega)},
              .together = 2,
              .folded = count > 1,
              .forms = count > few_points || result.model ? on_screen : on_screen | on_page};
  LargestOfKind largest;
  for (const response::Curve& curve : result.curves.curves)
    for (const Sample& at : samples(result)) largest.add(curve.unit, std::abs(curve.value(to_index(at.index))));
  for (std::size_t c = 0; c < result.curves.curves.size(); ++c) {
    const response::Curve& curve = result.curves.curves[c];
    const auto amplitude = [&curve](const Sample& at) { return std::abs(curve.value(to_index(at.index))); };
    const auto degrees = [&curve, &phase = result.phase[c], largest](const Sample& at) {
      const double angle = phase(to_index(at.index)) * 360 / foundation::two_pi;
      const bool is_zero = largest.shown(curve.unit, std::abs(curve.value(to_index(at.index)))) == 0;
      return std::isnan(angle) || is_zero ? "–" : fmt::format("{:.1f}°", angle);
    };
    table.columns.push_back(row("amplitude", Kind::amplitude, "|" + curve.name + "|", amplitude, {.unit = curve.unit}));
    table.columns.push_back(row("phase", Kind::number, "phase", degrees));
  }
  return table;
}

Table limit_table(const study::CaseResults& results) {
  using study::LimitResult;
  const Rows row(results.limits);
  const bool one = results.response && results.response->band.from == results.response->band.to;
  return {
      .axis = results.limits.empty() ? "" : "limit",
      .title = "Limits",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "limit on", &LimitResult::name),
                  row("unit", Kind::words, "", &LimitResult::unit),
                  row("allowed", Kind::amplitude, "allowed", &LimitResult::limit),
                  row("in_band", Kind::amplitude, one ? "at this ω alone" : "largest in band", &LimitResult::in_band),
                  row("share", Kind::share, "share of the limit",
                      [](const LimitResult& l) { return l.in_band / l.limit; }, {.forms = for_people}),
                  row("in_band_at", Kind::frequency, "at", &LimitResult::in_band_at),
                  row("anywhere", Kind::amplitude, "largest at any ω", &LimitResult::anywhere),
                  row("met", Kind::yes_no, "", &LimitResult::met),
                  row("verdict", Kind::words, "verdict",
                      [one](const LimitResult& l) { return !l.met ? "✗ VIOLATED"
                                                        : one     ? "✓ met at this ω"
                                                                  : "✓ met"; },
                      {.forms = for_people})},
      .arrays = {{"limit", "name"}, "unit", "allowed", "in_band", "in_band_at", "anywhere", "met"},
      .mark = [&results](std::size_t i) { return results.limits[i].met ? Mark::plain : Mark::bad; },
      .forms = in_arrays | on_screen | in_summary};
}

/// Remarks below the table on the screen.
void add_notes(const ResponseResult& result, Document& document) {
  const auto note = [&](std::string words) {
    document.add(Sentence{.parts = {std::move(words)}, .place = Sentence::Place::note, .forms = on_screen});
  };
  const std::vector<Sample> rows = samples(result);
  const std::size_t count = result.curves.angular_frequency.size();
  const bool at_rest = std::ranges::any_of(result.curves.curves, [&](const response::Curve& curve) {
    return std::ranges::any_of(rows, [&](const Sample& at) { return curve.value(to_index(at.index)) == 0.0; });
  });
  if (at_rest) note("(–: a result that is zero has no phase)");
  if (rows.size() < count)
    note(fmt::format("(every {}th of {} frequencies; --csv or --json gives all)", rows[1].index, count));
  note(fmt::format(
      "backward error ≤ {:.1e} at {} frequenc{}; second solver at {}: difference {:.1e}, allowed {:.1e} "
      "(round-off × condition): {}",
      result.curves.check.worst_backward_error, result.curves.solves, result.curves.solves == 1 ? "y" : "ies",
      result.deep.frequencies, result.deep.worst_difference, result.deep.allowed, result.deep.verdict()));
  if (result.curves.interpolation_error > 0)
    note(
        fmt::format("rows between the {} solved frequencies are interpolated by a rational model; its relative error "
                    "is at most {:.1e} at the tested frequencies",
                    result.curves.solves, result.curves.interpolation_error));
  for (const double omega : result.curves.check.undefined_at)
    document.add(Sentence{.parts = {Quantity{omega, "rad/s", Kind::frequency, 9},
                                    omega > 0 ? ": no steady state exists (shown as –); it is an undamped resonance"
                                              : ": no steady state exists (shown as –); a body is free to move, or the "
                                                "motion of the ground is given by its velocity or acceleration and "
                                                "unbounded"},
                          .place = Sentence::Place::note,
                          .forms = on_screen});
}

/// Line of `run` in place of the table, which is in the folder.
Sentence response_summary(const ResponseResult& result) {
  return {
      .parts = {fmt::format(
          "Characteristics at {} frequencies from {} solves, backward error ≤ {:.1e}; second solver: {} (difference "
          "{:.1e}, allowed {:.1e})",
          result.curves.angular_frequency.size(), result.curves.solves, result.curves.check.worst_backward_error,
          result.deep.verdict(), result.deep.worst_difference, result.deep.allowed)},
      .forms = in_summary};
}

Document response_data(const study::CaseResults& results) {
  const ResponseResult& result = *results.response;
  return {{{response_curves(result)},
           {response_rows(result)},
           {Single{.name = "checks", .value = solution_checks(result)}},
           {warnings_part(results)}}};
}

Document response_document(const project::Case& variant, const study::CaseResults& results) {
  const ResponseResult& result = *results.response;
  Document document = response_data(results);
  document.add(excited_part(variant, "response")).forms = on_screen;
  document.add(response_summary(result));
  document.add(characteristics(result));
  add_notes(result, document);
  document.add(limit_table(results));
  Table& lines = document.add(limit_line_table(results, variant.display));
  lines.forms = on_screen;
  return document;
}

}  // namespace

Json json::response(const study::CaseResults& results) { return as_json(response_data(results)); }

std::string limits_html(const study::CaseResults& results) {
  Table table = limit_table(results);
  table.forms = on_page;
  table.title.clear();
  return as_html({{{std::move(table)}}}, results.display);
}

const ResultWriter response_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return results.response.has_value(); },
    .document = response_document,
    .files = {"response.csv"}};

}  // namespace trivet::results
