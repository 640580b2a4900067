// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"
#include "trivet/study/transmissibility_answer.h"

/// Force or motion that the mounts transmit.
namespace trivet::results {
namespace json {
namespace {

Json transmissibility(const project::Case&, const study::Answers& answers) {
  const study::TransmissibilityResult& t = *answers.find<study::TransmissibilityResult>("transmissibility");
  Json result{{"of", t.words},
              {"angular_frequency", list(t.curves.angular_frequency)},
              {"results", Json::array()},
              {"peaks", Json::array()},
              {"warnings", warnings(answers.warnings)}};
  for (std::size_t i = 0; i < t.curves.curves.size(); ++i) {
    const response::Curve& c = t.curves.curves[i];
    NumberList level, efficiency;
    for (const auto& value : c.value) {
      level.add(response::transmissibility_level(std::abs(value)));
      efficiency.add(response::isolation_efficiency(std::abs(value)));
    }
    Json one = curve(c);
    one["level_db"] = std::move(level).json();
    one["isolation_efficiency"] = t.is_share(i) ? Json() : std::move(efficiency).json();
    one["highest_in_band"] = number(t.in_band[i].amplitude);
    one["highest_in_band_at"] = number(t.in_band[i].angular_frequency);
    one["isolates_from"] = t.is_share(i) ? Json() : optional(t.crossovers[i].angular_frequency);
    result["results"].push_back(std::move(one));
  }
  for (const response::Peak& peak : t.peaks.list)
    result["peaks"].push_back({{"name", t.peaks.curves[peak.curve].name},
                               {"angular_frequency", peak.angular_frequency},
                               {"amplitude", number(peak.amplitude)},
                               {"nearest_mode", optional(peak.nearest_mode)}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string transmissibility_csv(const project::Case&, const study::Answers& answers) {
  const study::TransmissibilityResult& t = *answers.find<study::TransmissibilityResult>("transmissibility");
  std::string text = "angular_frequency [rad/s]";
  for (const response::Curve& c : t.curves.curves)
    text += "," + csv_field(c.name + " [1]") + "," + csv_field(c.name + " [dB]");
  text += "\n";
  for (std::size_t k = 0; k < t.curves.angular_frequency.size(); ++k) {
    text += csv_number(t.curves.angular_frequency[k]);
    for (const response::Curve& c : t.curves.curves) {
      const double size = std::abs(c.value(to_index(k)));
      for (const double value : {size, response::transmissibility_level(size)}) append_csv_number(text, value);
    }
    text += "\n";
  }
  return text;
}

std::string transmissibility_text(const project::Case&, const study::Answers& answers) {
  const study::TransmissibilityResult& t = *answers.find<study::TransmissibilityResult>("transmissibility");
  const std::string unit = " [" + frequency_unit(answers.display) + "]";
  const auto in_unit = [&](double omega) { return number_text(shown_frequency(answers.display, omega), 5); };
  TextTable table({"result", "highest |T| in the band", "at" + unit, "level [dB]", "at any frequency", "at" + unit,
                   "isolates from" + unit, "at the end of the band", "efficiency there"});
  for (std::size_t i = 0; i < t.curves.curves.size(); ++i) {
    const response::CurveSummary& summary = t.peaks.curves[i];
    const Eigen::VectorXcd& values = t.curves.curves[i].value;
    const double last = std::abs(values(values.size() - 1));
    const design::LargestAmplitude& largest = t.in_band[i];
    table.add({summary.name, number_text(largest.amplitude), in_unit(largest.angular_frequency),
               number_text(response::transmissibility_level(largest.amplitude), 4), number_text(summary.highest),
               in_unit(summary.highest_at),
               t.crossovers[i].angular_frequency && !t.is_share(i) ? in_unit(*t.crossovers[i].angular_frequency) : "–",
               number_text(last, 4), t.is_share(i) ? "–" : percent(response::isolation_efficiency(last))});
  }
  const std::string shares = t.is_share(1)
      ? "  the force of a single mount is only a share; isolation is that of the total force on the ground\n"
      : "";
  return "Transmissibility: " + t.words + "\n" + table.text() + shares;
}

void transmissibility_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::CurveSummary;
  using response::Peak;
  const study::TransmissibilityResult& t = *answers.find<study::TransmissibilityResult>("transmissibility");
  list.view("angular_frequency", "rad/s", "angular_frequency", t.curves.angular_frequency);
  for (const response::Curve& c : t.curves.curves)  // "ground" or an element: such a name may be that of another array
    list.view(c.name + " transmissibility", "1", "angular_frequency", c.value);
  list.texts("result", "result", t.peaks.curves, &CurveSummary::name);
  list.field("result.highest", "1", "result", t.peaks.curves, &CurveSummary::highest);
  list.field("result.highest_at", "rad/s", "result", t.peaks.curves, &CurveSummary::highest_at);
  list.field("result.highest_in_band", "1", "result", t.in_band, &design::LargestAmplitude::amplitude);
  list.field("result.highest_in_band_at", "rad/s", "result", t.in_band, &design::LargestAmplitude::angular_frequency);
  std::vector<double> isolates_from;
  for (std::size_t i = 0; i < t.crossovers.size(); ++i)
    isolates_from.push_back(t.is_share(i) ? nothing : t.crossovers[i].angular_frequency.value_or(nothing));
  list.copy("result.isolates_from", "rad/s", "result", std::move(isolates_from));
  list.count("peak", t.peaks.list.size());
  list.texts("peak.name", "peak", t.peaks.list, [&](const Peak& peak) { return t.peaks.curves[peak.curve].name; });
  list.field("peak.angular_frequency", "rad/s", "peak", t.peaks.list, &Peak::angular_frequency);
  list.field("peak.amplitude", "1", "peak", t.peaks.list, &Peak::amplitude);
  list.column("peak.nearest_mode", "1", "peak", t.peaks.list, &Peak::nearest_mode);
}

}  // namespace

const AnswerWriter transmissibility_results = {
    .json = json::transmissibility,
    .tables = {{"transmissibility.csv", transmissibility_csv}},
    .text = transmissibility_text,
    .arrays = transmissibility_arrays,
};

}  // namespace trivet::results
