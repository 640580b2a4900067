// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"
#include "trivet/study/random_answer.h"

/// Root mean squares and spectral densities.
namespace trivet::results {
namespace json {
namespace {

Json random(const project::Case&, const study::Answers& answers) {
  const study::RandomResult& random = *answers.find<study::RandomResult>("random");
  Json result{{"results", Json::array()},
              {"method", response::name(random.response.method)},
              {"remark", random.response.remark},
              {"inputs", random.inputs},
              {"band", {random.response.from, number(random.response.to)}},
              {"angular_frequency", list(random.curves.angular_frequency)},
              {"warnings", warnings(answers.warnings)}};
  if (!random.total_values.empty()) {
    result["vibration_total_values"] = Json::object();
    result["vibration_total_axes"] = Json::object();
    for (const study::TotalValue& total : random.total_values) {
      result["vibration_total_values"][total.name] = total.value;
      result["vibration_total_axes"][total.name] = total.axes;
    }
  }
  for (std::size_t i = 0; i < random.response.answers.size(); ++i) {
    const response::RandomAnswer& a = random.response.answers[i];
    NumberList density;
    for (const double s : random.curves.density[i]) density.add(2 * std::numbers::pi * s);
    Json infinite = Json::array();
    for (const auto& [is, what] : {std::pair{a.infinite_rms, "rms"},
                                   {a.infinite_rms_of_derivative, "rms_of_derivative"},
                                   {a.infinite_weighted_rms, "weighted_rms"}})
      if (is) infinite.push_back(what);
    result["results"].push_back({{"name", a.name},
                                 {"unit", a.unit},
                                 {"rms", optional(a.rms)},
                                 {"three_sigma", optional(a.three_sigma)},
                                 {"rms_of_derivative", optional(a.rms_of_derivative)},
                                 {"zero_crossings", optional(a.zero_crossings)},
                                 {"weighted_rms", optional(a.weighted_rms)},
                                 {"infinite", std::move(infinite)},
                                 {"variance_share", a.variance_share},
                                 {"vanishes", a.vanishes},
                                 {"estimated_error", number(a.estimated_error)},
                                 {"reason", a.reason},
                                 {"density_per_hz", std::move(density).json()}});
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

using foundation::two_pi;

/// "inf" for an unbounded number, empty if there is none.
std::string bounded(const std::optional<double>& value, bool infinite) { return infinite ? "inf" : csv_number(value); }

/// ∞ for an unbounded number, NaN if there is none.
double bounded_number(const std::optional<double>& value, bool infinite) {
  return infinite ? std::numeric_limits<double>::infinity() : value.value_or(nothing);
}

/// Method and error of the variances, if any is finite.
std::string accuracy_text(const response::RandomResponse& random) {
  std::vector<double> errors;
  for (const response::RandomAnswer& a : random.answers)
    if (!std::isnan(a.estimated_error)) errors.push_back(a.estimated_error);
  if (errors.empty()) return "  no variance is finite\n";
  return fmt::format("  {}, relative error of the {} about {:.1e}{}\n",
                     random.method == response::RandomMethod::poles ? "exact integration over the poles"
                                                                    : "adaptive quadrature over the poles",
                     errors.size() == random.answers.size() ? "variances" : "finite variances",
                     *std::max_element(errors.begin(), errors.end()),
                     random.remark.empty() ? "" : "; " + random.remark);
}

std::string random_csv(const project::Case&, const study::Answers& answers) {
  std::string text = "name,unit,rms,three_sigma,rms_of_derivative [unit/s],zero_crossings [1/s],weighted_rms";
  const study::RandomResult& random = *answers.find<study::RandomResult>("random");
  for (const std::string& input : random.inputs) text += "," + csv_field("variance share " + input);
  text += "\n";
  for (const response::RandomAnswer& a : random.response.answers) {
    text +=
        fmt::format("{},{},{},{},{},{},{}", csv_field(a.name), csv_field(a.unit), bounded(a.rms, a.infinite_rms),
                    bounded(a.three_sigma, a.infinite_rms), bounded(a.rms_of_derivative, a.infinite_rms_of_derivative),
                    csv_number(a.zero_crossings), bounded(a.weighted_rms, a.infinite_weighted_rms));
    for (std::size_t i = 0; i < random.inputs.size(); ++i)
      text += "," + (i < a.variance_share.size() ? csv_number(a.variance_share[i]) : std::string());
    text += "\n";
  }
  return text;
}

std::string random_densities_csv(const project::Case&, const study::Answers& answers) {
  const study::RandomResult& random = *answers.find<study::RandomResult>("random");
  std::string text = "frequency [Hz]";
  for (const response::RandomAnswer& a : random.response.answers)
    text += "," + csv_field(fmt::format("{} [({})²/Hz]", a.name, a.unit));
  text += "\n";
  for (std::size_t k = 0; k < random.curves.angular_frequency.size(); ++k) {
    text += csv_number(random.curves.angular_frequency[k] / two_pi);
    for (const auto& density : random.curves.density) append_csv_number(text, two_pi * density[k]);
    text += "\n";
  }
  return text;
}

std::string random_text(const project::Case&, const study::Answers& answers) {
  const study::RandomResult& random = *answers.find<study::RandomResult>("random");
  const auto& list = random.response.answers;
  const bool weighted = std::any_of(list.begin(), list.end(), [](const response::RandomAnswer& a) {
    return a.weighted_rms || a.infinite_weighted_rms;
  });
  std::vector<std::string> header = {"result", "rms", "3σ", "unit", "upward zero crossings [1/s]"};
  if (weighted)
    header.push_back(fmt::format("weighted rms [{}, {}]", display_unit(answers.display, "m/s²").unit,
                                 display_unit(answers.display, "rad/s²").unit));
  if (random.inputs.size() > 1)
    for (const std::string& input : random.inputs) header.push_back("from " + input);
  TextTable table(header);
  std::string reasons;
  for (const response::RandomAnswer& a : list) {
    const DisplayUnit unit = display_unit(answers.display, a.unit);
    std::vector<std::string> row = {a.name, number_text(bounded_number(a.rms, a.infinite_rms) * unit.factor),
                                    number_text(bounded_number(a.three_sigma, a.infinite_rms) * unit.factor), unit.unit,
                                    number_text(a.zero_crossings.value_or(nothing), 4)};
    if (weighted)
      row.push_back(number_text(bounded_number(a.weighted_rms, a.infinite_weighted_rms) *
                                display_unit(answers.display, a.unit.starts_with("rad") ? "rad/s²" : "m/s²").factor));
    for (std::size_t i = 0; i < random.inputs.size() && random.inputs.size() > 1; ++i)
      row.push_back(i < a.variance_share.size() ? percent(a.variance_share[i]) : "–");
    table.add(row);
    if (!a.reason.empty()) reasons += "  " + a.name + ": " + a.reason + "\n";
  }
  const DisplayUnit acceleration = display_unit(answers.display, "m/s²");
  for (const study::TotalValue& total : random.total_values)
    reasons +=
        fmt::format("  {}: vibration total value of the weighted accelerations {} {}, of {}\n", total.name,
                    number_text(total.value * acceleration.factor, 4), acceleration.unit, fmt::join(total.axes, ", "));
  return fmt::format(
             "Random response, {} to {} {}\n", number_text(shown_frequency(answers.display, random.response.from), 4),
             number_text(shown_frequency(answers.display, random.response.to), 4), frequency_unit(answers.display)) +
      table.text() + reasons + accuracy_text(random.response);
}

void random_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::RandomAnswer;
  const study::RandomResult& random = *answers.find<study::RandomResult>("random");
  const std::vector<RandomAnswer>& results = random.response.answers;
  list.texts("result", "result", results, &RandomAnswer::name);
  list.texts("unit", "result", results, &RandomAnswer::unit);
  list.column("rms", unit_of_the_row, "result", results,
              [](const RandomAnswer& a) { return bounded_number(a.rms, a.infinite_rms); });
  list.column("three_sigma", unit_of_the_row, "result", results,
              [](const RandomAnswer& a) { return bounded_number(a.three_sigma, a.infinite_rms); });
  list.column("rms_of_derivative", std::string(unit_of_the_row) + "/s", "result", results,
              [](const RandomAnswer& a) { return bounded_number(a.rms_of_derivative, a.infinite_rms_of_derivative); });
  list.column("zero_crossings", "1/s", "result", results, &RandomAnswer::zero_crossings);
  list.column("weighted_rms", "m/s², rad/s²", "result", results,
              [](const RandomAnswer& a) { return bounded_number(a.weighted_rms, a.infinite_weighted_rms); });
  list.texts("input", "input", random.inputs);
  list.lists("variance_share", "1", {"result", "input"}, random.inputs.size(), results, &RandomAnswer::variance_share);
  list.column("vanishes", "1", "result", results, &RandomAnswer::vanishes);
  list.field("estimated_error", "1", "result", results, &RandomAnswer::estimated_error);
  list.texts("reason", "result", results, &RandomAnswer::reason);
  list.view("angular_frequency", "rad/s", "angular_frequency", random.curves.angular_frequency);
  for (std::size_t i = 0; i < results.size(); ++i)
    list.view(results[i].name + " density", "(" + results[i].unit + ")²/(rad/s)", "angular_frequency",
              random.curves.density[i]);
  if (random.total_values.empty()) return;
  list.texts("vibration_total", "vibration_total", random.total_values, &study::TotalValue::name);
  list.field("vibration_total.value", "m/s²", "vibration_total", random.total_values, &study::TotalValue::value);
}

}  // namespace

const AnswerWriter random_results = {
    .json = json::random,
    .tables = {{"random.csv", random_csv}, {"densities.csv", random_densities_csv}},
    .text = random_text,
    .arrays = random_arrays,
};

}  // namespace trivet::results
