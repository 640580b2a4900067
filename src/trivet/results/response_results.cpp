// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Amplitude- and phase-frequency characteristics, and the limits on them.
namespace trivet::results {

namespace json {
namespace {

/// Real and imaginary parts alternating in one list, which is shorter than a list of pairs.
template <typename Vector>
Json complex_list(const Vector& values) {
  NumberList result;
  for (const std::complex<double>& value : values) {
    result.add(value.real());
    result.add(value.imag());
  }
  return std::move(result).json();
}

Json solution_checks(const study::ResponseAnswer& answer) {
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
            {"worst_difference", number(deep.worst_difference)},
            {"allowed", number(deep.allowed)},
            {"at_angular_frequency", deep.at_angular_frequency},
            {"passed", deep.passed}}}};
}

}  // namespace

Json response(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  Json result{{"angular_frequency", list(answer.curves.angular_frequency)},
              {"results", Json::array()},
              {"checks", solution_checks(answer)},
              {"warnings", warnings(answers.warnings)}};
  for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
    const response::Curve& curve = answer.curves.curves[c];
    result["results"].push_back(
        {{"name", curve.name}, {"unit", curve.unit}, {"complex", list(curve.value)}, {"phase", list(answer.phase[c])}});
  }
  return result;
}

Json drawn_response(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  if (!answer.model) return response(answers);
  const response::CurveModel& model = *answer.model;
  Json result{{"band", {model.band.from, model.band.to}},
              {"delays", model.delays},
              {"pieces", Json::array()},
              {"continuous_phase", answer.continuous_phase},
              {"undefined_at", answer.curves.check.undefined_at},
              {"results", Json::array()}};
  for (const response::ModelPiece& piece : model.pieces) {
    Json values = Json::array();
    for (Eigen::Index row = 0; row < piece.fit.values.rows(); ++row)
      values.push_back(complex_list(piece.fit.values.row(row)));
    result["pieces"].push_back({{"band", {piece.band.from, piece.band.to}},
                                {"nodes", list(piece.fit.nodes)},
                                {"weights", complex_list(piece.fit.weights)},
                                {"values", std::move(values)}});
  }
  for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
    Json extrema = Json::array();
    for (const response::Extremum& extremum : answer.extrema[c])
      extrema.push_back({extremum.angular_frequency, extremum.maximum ? Json(extremum.amplitude) : Json(nullptr)});
    const Eigen::VectorXd& phase = answer.phase[c];
    const auto first = std::find_if(phase.begin(), phase.end(), [](double angle) { return std::isfinite(angle); });
    result["results"].push_back({{"name", answer.curves.curves[c].name},
                                 {"unit", answer.curves.curves[c].unit},
                                 {"extrema", std::move(extrema)},
                                 {"first_phase", first == phase.end() ? Json(nullptr) : Json(*first)}});
  }
  return result;
}

}  // namespace json

std::string limits_text(const study::Answers& answers) {
  if (answers.limits.empty()) return "";
  const bool one = answers.response && answers.response->band.from == answers.response->band.to;
  TextTable table({"limit on", "allowed", one ? "at this ω alone" : "largest in band",
                   "at " + frequency_heading(answers.display, "rad/s"), "largest at any ω", "unit", "verdict"});
  for (const study::LimitAnswer& limit : answers.limits) {
    const DisplayUnit unit = amplitude_unit(answers.display, limit.unit);
    table.add({limit.name, number_text(limit.limit * unit.factor), number_text(limit.in_band * unit.factor),
               number_text(shown_frequency(answers.display, limit.in_band_at, "rad/s")),
               number_text(limit.anywhere * unit.factor), unit.label(),
               !limit.met ? "EXCEEDED"
                   : one  ? "met at this ω"
                          : "met"});
  }
  return "Limits\n" + table.text();
}

namespace {

constexpr std::size_t most_rows = 60;  // of a characteristic on the screen

std::string response_csv(const project::Case&, const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  std::string text = "angular_frequency [rad/s]";
  for (const auto& curve : answer.curves.curves)
    for (const char* part : {"re", "im", "amplitude"})
      text += "," + csv_field(fmt::format("{} {} [{}]", curve.name, part, curve.unit));
  for (const auto& curve : answer.curves.curves) text += "," + csv_field(curve.name + " phase [rad]");
  text += "\n";
  for (std::size_t i = 0; i < answer.curves.angular_frequency.size(); ++i) {
    const auto row = to_index(i);
    text += csv_number(answer.curves.angular_frequency[i]);
    for (const auto& curve : answer.curves.curves) {
      const std::complex<double> z = curve.value(row);
      for (const double value : {z.real(), z.imag(), std::abs(z)}) append_csv_number(text, value);
    }
    for (const auto& phase : answer.phase) append_csv_number(text, phase(row));
    text += "\n";
  }
  return text;
}

std::string response_table(const project::Case& variant, const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  std::vector<std::string> header = {frequency_heading(variant.display, "rad/s")};
  std::vector<DisplayUnit> units;
  for (const auto& curve : answer.curves.curves) {
    units.push_back(amplitude_unit(variant.display, curve.unit));
    header.push_back(fmt::format("|{}| [{}]", curve.name, units.back().label()));
    header.push_back("phase");
  }
  TextTable table(header, 2);
  bool at_rest = false;  // a result is zero: no phase
  const std::size_t count = answer.curves.angular_frequency.size();
  const std::size_t step = (count + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < count; i += step) {
    std::vector<std::string> row = {
        number_text(shown_frequency(variant.display, answer.curves.angular_frequency[i], "rad/s"))};
    for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
      row.push_back(number_text(std::abs(answer.curves.curves[c].value(to_index(i))) * units[c].factor));
      const double degrees = answer.phase[c](to_index(i)) * 360 / foundation::two_pi;
      at_rest |= answer.curves.curves[c].value(to_index(i)) == 0.0;
      row.push_back(std::isnan(degrees) ? "–" : fmt::format("{:.1f}°", degrees));
    }
    table.add(row);
  }
  std::string text =
      fmt::format("Amplitude and phase ({}; a lag is negative)\n", level_words(variant.display.level)) + table.text();
  if (at_rest) text += "  (–: a result that is zero has no phase)\n";
  if (step > 1) text += fmt::format("  (every {}th of {} frequencies; --csv or --json gives all)\n", step, count);
  text += fmt::format(
      "  backward error ≤ {:.1e} at {} frequenc{}; second solver at {}: difference {:.1e}, allowed {:.1e} "
      "(round-off × condition): {}\n",
      answer.curves.check.worst_backward_error, answer.curves.solves, answer.curves.solves == 1 ? "y" : "ies",
      answer.deep.frequencies, answer.deep.worst_difference, answer.deep.allowed, answer.deep.verdict());
  if (answer.curves.interpolation_error > 0)
    text += fmt::format(
        "  rows between the {} solved frequencies are interpolated by a rational model; its relative error is at most "
        "{:.1e} at the tested frequencies\n",
        answer.curves.solves, answer.curves.interpolation_error);
  for (const double omega : answer.curves.check.undefined_at)
    text += fmt::format("  ω = {} rad/s: no steady state exists (shown as –); {}\n", number_text(omega, 9),
                        omega > 0 ? "it is an undamped resonance"
                                  : "a body is free to move, or the motion of the ground is given by its velocity or "
                                    "acceleration and unbounded");
  return text;
}

std::string response_text(const project::Case& variant, const study::Answers& answers) {
  return excited_at_once(variant, "response") + response_table(variant, answers) + limits_text(answers) +
      limit_lines_text(answers);
}

/// Text for `run`, without the table, which is in the folder.
std::string response_summary(const project::Case&, const study::Answers& answers) {
  const auto& check = answers.response->curves.check;
  return fmt::format(
             "Characteristics at {} frequencies from {} solves, backward error ≤ {:.1e}; second solver: {} (difference "
             "{:.1e}, allowed {:.1e})\n",
             answers.response->curves.angular_frequency.size(), answers.response->curves.solves,
             check.worst_backward_error, answers.response->deep.verdict(), answers.response->deep.worst_difference,
             answers.response->deep.allowed) +
      limits_text(answers);
}

json::Json response_json(const project::Case&, const study::Answers& answers) { return json::response(answers); }

void response_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using study::LimitAnswer;
  const study::ResponseAnswer& answer = *answers.response;
  const std::vector<response::Curve>& curves = answer.curves.curves;
  list.view("angular_frequency", "rad/s", "angular_frequency", answer.curves.angular_frequency);
  for (const response::Curve& curve : curves) {
    list.view(curve.name, curve.unit, "angular_frequency", curve.value);
    list.mark_harmonic({curve.name});
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
    list.view(curves[c].name + " phase", "rad", "angular_frequency", answer.phase[c]);
  if (answers.limits.empty()) return;
  list.texts("limit", "limit", answers.limits, &LimitAnswer::name);
  list.texts("limit.unit", "limit", answers.limits, &LimitAnswer::unit);
  list.field("limit.allowed", unit_of_the_row, "limit", answers.limits, &LimitAnswer::limit);
  list.field("limit.in_band", unit_of_the_row, "limit", answers.limits, &LimitAnswer::in_band);
  list.field("limit.in_band_at", "rad/s", "limit", answers.limits, &LimitAnswer::in_band_at);
  list.field("limit.anywhere", unit_of_the_row, "limit", answers.limits, &LimitAnswer::anywhere);
  list.column("limit.met", "1", "limit", answers.limits, &LimitAnswer::met);
  list.mark_harmonic({"limit.unit", "limit.allowed", "limit.in_band", "limit.anywhere"});
}

}  // namespace

const AnswerWriter response_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return answers.response.has_value(); },
    .json = response_json,
    .tables = {{"response.csv", response_csv}},
    .text = response_text,
    .summary = response_summary,
    .arrays = response_arrays,
};

}  // namespace trivet::results
