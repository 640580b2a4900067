// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/format/answer_writer.h"

/// Amplitude- and phase-frequency characteristics, and the limits on them.
namespace trivet::results {
namespace {

using study::ResponseAnswer;

double real_of(const std::complex<double>& value) { return value.real(); }
double imaginary_of(const std::complex<double>& value) { return value.imag(); }
double amplitude_of(const std::complex<double>& value) { return std::abs(value); }

Json solution_checks(const ResponseAnswer& answer) {
  const auto& check = answer.curves.check;
  const auto& deep = answer.deep;
  return {{"worst_backward_error", check.worst_backward_error},
          {"at_angular_frequency", check.at_angular_frequency},
          {"pivoted_fallbacks", check.fallbacks},
          {"solves", answer.curves.solves},
          {"interpolation_error", answer.curves.interpolation_error},
          {"undefined_at", check.undefined_at},
          {"second_solver",
           {{"frequencies", deep.frequencies},
            {"too_near_a_resonance", deep.incomparable},
            {"worst_difference", json::number(deep.worst_difference)},
            {"allowed", json::number(deep.allowed)},
            {"at_angular_frequency", deep.at_angular_frequency},
            {"passed", deep.passed}}}};
}

Curves response_curves(const ResponseAnswer& answer) {
  Curves curves{.axis = "angular_frequency",
                .unit = "rad/s",
                .points = answer.curves.angular_frequency,
                .file = "response.csv",
                .axis_columns = {"angular_frequency [rad/s]"}};
  for (const response::Curve& c : answer.curves.curves) {
    const auto heading = [&c](const char* part) { return fmt::format("{} {} [{}]", c.name, part, c.unit); };
    curves.list.push_back(
        {.name = c.name,
         .unit = c.unit,
         .values = c.value,
         .harmonic = true,
         .csv = {{heading("re"), real_of}, {heading("im"), imaginary_of}, {heading("amplitude"), amplitude_of}}});
  }
  for (std::size_t c = 0; c < answer.curves.curves.size(); ++c)
    curves.list.push_back({.name = answer.curves.curves[c].name + " phase", .unit = "rad", .values = answer.phase[c]});
  return curves;
}

Table response_rows(const ResponseAnswer& answer) {
  using response::Curve;
  const Rows row(answer.curves.curves);
  return {.key = "results",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "", &Curve::name), row("unit", Kind::words, "", &Curve::unit),
                      row.lists("complex", "", "", {}, &Curve::value),
                      row.lists("phase", "", "", {}, [&answer](std::size_t c) { return Numbers(answer.phase[c]); })},
          .forms = in_json};
}

/// A frequency that is a row for people.
struct Sample {
  std::size_t index = 0;
  double omega = 0;
};

std::vector<Sample> samples(const ResponseAnswer& answer) {
  constexpr std::size_t most_rows = 60;
  const std::vector<double>& frequencies = answer.curves.angular_frequency;
  const std::size_t step = (frequencies.size() + most_rows - 1) / most_rows;
  std::vector<Sample> list;
  for (std::size_t i = 0; i < frequencies.size(); i += step) list.push_back({i, frequencies[i]});
  return list;
}

/// Amplitudes and phases; on the page if there are few.
Table characteristics(const ResponseAnswer& answer, const project::ShownUnits& display) {
  constexpr std::size_t few_points = 24;
  const std::size_t count = answer.curves.angular_frequency.size();
  const Rows row(samples(answer));
  Table table{.title = fmt::format("Amplitude and phase ({}; a lag is negative)", level_words(display.level)),
              .rows = row.size(),
              .columns = {row("angular_frequency", Kind::angular_frequency, "ω", &Sample::omega)},
              .together = 2,
              .folded = count > 1,
              .forms = count > few_points || answer.model ? on_screen : on_screen | on_page};
  for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
    const response::Curve& curve = answer.curves.curves[c];
    const auto amplitude = [&curve](const Sample& at) { return std::abs(curve.value(to_index(at.index))); };
    const auto degrees = [&phase = answer.phase[c]](const Sample& at) {
      const double angle = phase(to_index(at.index)) * 360 / foundation::two_pi;
      return std::isnan(angle) ? "–" : fmt::format("{:.1f}°", angle);
    };
    table.columns.push_back(row("amplitude", Kind::amplitude, "|" + curve.name + "|", amplitude, {.unit = curve.unit}));
    table.columns.push_back(row("phase", Kind::number, "phase", degrees));
  }
  return table;
}

Table limit_table(const study::Answers& answers) {
  using study::LimitAnswer;
  const Rows row(answers.limits);
  const bool one = answers.response && answers.response->band.from == answers.response->band.to;
  return {
      .axis = answers.limits.empty() ? "" : "limit",
      .title = "Limits",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "limit on", &LimitAnswer::name),
                  row("unit", Kind::words, "", &LimitAnswer::unit),
                  row("allowed", Kind::amplitude, "allowed", &LimitAnswer::limit),
                  row("in_band", Kind::amplitude, one ? "at this ω alone" : "largest in band", &LimitAnswer::in_band),
                  row("share", Kind::share, "share of the limit",
                      [](const LimitAnswer& l) { return l.in_band / l.limit; }, {.forms = for_people}),
                  row("in_band_at", Kind::both_frequencies, "at", &LimitAnswer::in_band_at),
                  row("anywhere", Kind::amplitude, "largest at any ω", &LimitAnswer::anywhere),
                  row("met", Kind::yes_no, "", &LimitAnswer::met),
                  row("verdict", Kind::words, "verdict",
                      [one](const LimitAnswer& l) { return !l.met ? "✗ EXCEEDED"
                                                        : one     ? "✓ met at this ω"
                                                                  : "✓ met"; },
                      {.forms = for_people})},
      .arrays = {{"limit", "name"}, "unit", "allowed", "in_band", "in_band_at", "anywhere", "met"},
      .mark = [&answers](std::size_t i) { return answers.limits[i].met ? Mark::plain : Mark::bad; },
      .forms = in_arrays | on_screen | in_summary};
}

/// Remarks below the table on the screen.
void add_notes(const ResponseAnswer& answer, Document& document) {
  const auto note = [&](std::string words) {
    document.add(Sentence{.parts = {std::move(words)}, .place = Sentence::Place::note, .forms = on_screen});
  };
  const std::vector<Sample> rows = samples(answer);
  const std::size_t count = answer.curves.angular_frequency.size();
  const bool at_rest = std::ranges::any_of(answer.curves.curves, [&](const response::Curve& curve) {
    return std::ranges::any_of(rows, [&](const Sample& at) { return curve.value(to_index(at.index)) == 0.0; });
  });
  if (at_rest) note("(–: a result that is zero has no phase)");
  if (rows.size() < count)
    note(fmt::format("(every {}th of {} frequencies; --csv or --json gives all)", rows[1].index, count));
  note(fmt::format(
      "backward error ≤ {:.1e} at {} frequenc{}; second solver at {}: difference {:.1e}, allowed {:.1e} "
      "(round-off × condition): {}",
      answer.curves.check.worst_backward_error, answer.curves.solves, answer.curves.solves == 1 ? "y" : "ies",
      answer.deep.frequencies, answer.deep.worst_difference, answer.deep.allowed, answer.deep.verdict()));
  if (answer.curves.interpolation_error > 0)
    note(
        fmt::format("rows between the {} solved frequencies are interpolated by a rational model; its relative error "
                    "is at most {:.1e} at the tested frequencies",
                    answer.curves.solves, answer.curves.interpolation_error));
  for (const double omega : answer.curves.check.undefined_at)
    document.add(Sentence{.parts = {"ω = ", Quantity{omega, "rad/s", Kind::angular_frequency, 9},
                                    omega > 0 ? ": no steady state exists (shown as –); it is an undamped resonance"
                                              : ": no steady state exists (shown as –); a body is free to move, or the "
                                                "motion of the ground is given by its velocity or acceleration and "
                                                "unbounded"},
                          .place = Sentence::Place::note,
                          .forms = on_screen});
}

/// Line of `run` in place of the table, which is in the folder.
Sentence response_summary(const ResponseAnswer& answer) {
  return {
      .parts = {fmt::format(
          "Characteristics at {} frequencies from {} solves, backward error ≤ {:.1e}; second solver: {} (difference "
          "{:.1e}, allowed {:.1e})",
          answer.curves.angular_frequency.size(), answer.curves.solves, answer.curves.check.worst_backward_error,
          answer.deep.verdict(), answer.deep.worst_difference, answer.deep.allowed)},
      .forms = in_summary};
}

Document response_data(const study::Answers& answers) {
  const ResponseAnswer& answer = *answers.response;
  return {{{response_curves(answer)},
           {response_rows(answer)},
           {Single{.name = "checks", .value = solution_checks(answer)}},
           {warnings_part(answers)}}};
}

Document response_document(const project::Case& variant, const study::Answers& answers) {
  const ResponseAnswer& answer = *answers.response;
  Document document = response_data(answers);
  document.add(excited_part(variant, "response")).forms = on_screen;
  document.add(response_summary(answer));
  document.add(characteristics(answer, answers.display));
  add_notes(answer, document);
  document.add(limit_table(answers));
  Table& lines = document.add(limit_line_table(answers));
  lines.forms = on_screen;
  return document;
}

}  // namespace

Json json::response(const study::Answers& answers) { return as_json(response_data(answers)); }

std::string limits_html(const study::Answers& answers) {
  Table table = limit_table(answers);
  table.forms = on_page;
  table.title.clear();
  return as_html({{{std::move(table)}}}, answers.display);
}

const AnswerWriter response_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return answers.response.has_value(); },
    .document = response_document,
    .files = {"response.csv"}};

}  // namespace trivet::results
