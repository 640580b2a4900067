// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "trivet/response/transient/earthquake.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Largest response to an earthquake.
namespace trivet::results {
namespace json {
namespace {

Json earthquake(const project::Case&, const study::Answers& answers) {
  const response::EarthquakeResponse& e = *answers.find<response::EarthquakeResponse>("earthquake");
  Json result{{"results", Json::array()},
              {"modes", Json::array()},
              {"effective_mass_share", e.effective_mass_share},
              {"warnings", warnings(answers.warnings)}};
  for (const response::CombinedAnswer& a : e.answers)
    result["results"].push_back({{"name", a.name},
                                 {"unit", a.unit},
                                 {"srss", a.square_root_of_sum_of_squares},
                                 {"cqc", a.complete_quadratic},
                                 {"modal_maxima", list(a.modal_maxima)}});
  for (const response::ModalShare& m : e.modes)
    result["modes"].push_back({{"angular_frequency", m.angular_frequency},
                               {"damping_ratio", m.damping_ratio},
                               {"participation", m.participation},
                               {"effective_mass", m.effective_mass},
                               {"spectral_acceleration", number(m.spectral_acceleration)}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

/// Modal maxima for all modes; NaN for a mode outside the spectrum.
std::vector<double> maxima_of_all_modes(const response::EarthquakeResponse& e, const response::CombinedAnswer& a) {
  std::vector<double> maxima;
  Eigen::Index counted = 0;
  for (const response::ModalShare& m : e.modes)
    maxima.push_back(std::isnan(m.spectral_acceleration) ? nothing : a.modal_maxima(counted++));
  return maxima;
}

/// One row per answer, with its largest value in each mode.
std::string earthquake_csv(const project::Case&, const study::Answers& answers) {
  const response::EarthquakeResponse& e = *answers.find<response::EarthquakeResponse>("earthquake");
  std::string text = "name,unit,cqc,srss";
  for (std::size_t m = 0; m < e.modes.size(); ++m)
    text += "," + csv_field(fmt::format("largest in mode at {:.6g} Hz", hertz(e.modes[m].angular_frequency)));
  text += "\n";
  for (const response::CombinedAnswer& a : e.answers) {
    text += fmt::format("{},{},{},{}", csv_field(a.name), csv_field(a.unit), csv_number(a.complete_quadratic),
                        csv_number(a.square_root_of_sum_of_squares));
    for (const double largest : maxima_of_all_modes(e, a)) append_csv_number(text, largest);
    text += "\n";
  }
  return text;
}

std::string earthquake_text(const project::Case&, const study::Answers& answers) {
  const response::EarthquakeResponse& e = *answers.find<response::EarthquakeResponse>("earthquake");
  const project::ShownUnits& display = answers.display;
  const DisplayUnit mass = display_unit(display, "kg"), acceleration = display_unit(display, "m/s²");
  TextTable modes({frequency_heading(display), "damping ratio", "effective mass [" + mass.unit + "]",
                   "S_a [" + acceleration.unit + "]"});
  for (const response::ModalShare& m : e.modes)
    modes.add({number_text(shown_frequency(display, m.angular_frequency), 5), number_text(m.damping_ratio, 3),
               number_text(m.effective_mass * mass.factor, 5),
               number_text(m.spectral_acceleration * acceleration.factor, 5)});
  TextTable table({"result", "CQC", "SRSS", "unit"});
  std::map<std::string, double> largest;  // by unit
  for (const response::CombinedAnswer& a : e.answers)
    largest[a.unit] = std::max({largest[a.unit], a.complete_quadratic, a.square_root_of_sum_of_squares});
  for (const response::CombinedAnswer& a : e.answers) {
    const DisplayUnit unit = display_unit(display, a.unit);
    const auto shown = [&](double value) {
      return number_text(without_round_off(value, largest[a.unit]) * unit.factor);
    };
    table.add({a.name, shown(a.complete_quadratic), shown(a.square_root_of_sum_of_squares), unit.unit});
  }
  return "Earthquake response from the spectrum (motions relative to the ground, accelerations absolute)\n" +
      modes.text() + table.text() +
      fmt::format("  the spectrum covers modes with {} of the effective mass\n", percent(e.effective_mass_share));
}

void earthquake_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::CombinedAnswer;
  using response::ModalShare;
  const response::EarthquakeResponse& e = *answers.find<response::EarthquakeResponse>("earthquake");
  list.texts("result", "result", e.answers, &CombinedAnswer::name);
  list.texts("unit", "result", e.answers, &CombinedAnswer::unit);
  list.field("cqc", unit_of_the_row, "result", e.answers, &CombinedAnswer::complete_quadratic);
  list.field("srss", unit_of_the_row, "result", e.answers, &CombinedAnswer::square_root_of_sum_of_squares);
  list.lists("modal_maxima", unit_of_the_row, {"result", "mode"}, e.modes.size(), e.answers,
             [&](const CombinedAnswer& a) { return maxima_of_all_modes(e, a); });
  list.field("mode.angular_frequency", "rad/s", "mode", e.modes, &ModalShare::angular_frequency);
  list.field("mode.damping_ratio", "1", "mode", e.modes, &ModalShare::damping_ratio);
  list.field("mode.participation", "√kg", "mode", e.modes, &ModalShare::participation);
  list.field("mode.effective_mass", "kg", "mode", e.modes, &ModalShare::effective_mass);
  list.field("mode.spectral_acceleration", "m/s²", "mode", e.modes, &ModalShare::spectral_acceleration);
  list.value("effective_mass_share", "1", e.effective_mass_share);
}

}  // namespace

const AnswerWriter earthquake_results = {
    .json = json::earthquake,
    .tables = {{"earthquake.csv", earthquake_csv}},
    .text = earthquake_text,
    .arrays = earthquake_arrays,
};

}  // namespace trivet::results
