// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <functional>

#include "trivet/foundation/constants.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"
#include "trivet/study/shock_spectrum_answer.h"

/// Shock response spectra.
namespace trivet::results {
namespace json {
namespace {

Json shock_spectrum(const project::Case&, const study::Answers& answers) {
  Json result{{"spectra", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const study::ShockSpectrumResult& spectrum :
       *answers.find<std::vector<study::ShockSpectrumResult>>("shock_spectrum")) {
    Json rows = Json::array();
    for (const excitation::ShockResponse& r : spectrum.spectrum)
      rows.push_back({{"angular_frequency", r.angular_frequency},
                      {"largest", r.largest()},
                      {"smallest", r.smallest()},
                      {"maximax", r.maximax()},
                      {"primary", r.primary()},
                      {"residual", r.residual()},
                      {"relative_displacement", r.relative_displacement},
                      {"pseudo_velocity", r.pseudo_velocity()}});
    result["spectra"].push_back({{"excitation", spectrum.excitation},
                                 {"unit", spectrum.unit},
                                 {"damping_ratio", spectrum.damping_ratio},
                                 {"rows", std::move(rows)}});
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

using foundation::two_pi;

std::string shock_spectrum_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "excitation,natural frequency [Hz],largest [m/s²],smallest [m/s²],maximax [m/s²],pseudo velocity [m/s],relative "
      "displacement [m]\n";
  for (const study::ShockSpectrumResult& spectrum :
       *answers.find<std::vector<study::ShockSpectrumResult>>("shock_spectrum"))
    for (const excitation::ShockResponse& r : spectrum.spectrum)
      text += fmt::format("{},{},{},{},{},{},{}\n", csv_field(spectrum.excitation), r.angular_frequency / two_pi,
                          r.largest(), r.smallest(), r.maximax(), r.pseudo_velocity(), r.relative_displacement);
  return text;
}

std::string shock_spectrum_text(const project::Case&, const study::Answers& answers) {
  constexpr std::size_t most_rows = 24;
  std::string text;
  for (const study::ShockSpectrumResult& spectrum :
       *answers.find<std::vector<study::ShockSpectrumResult>>("shock_spectrum")) {
    const DisplayUnit acceleration = display_unit(answers.display, "m/s²"),
                      speed = display_unit(answers.display, "m/s"), length = display_unit(answers.display, "m");
    TextTable table({"natural frequency [" + frequency_unit(answers.display) + "]",
                     "largest [" + acceleration.unit + "]", "smallest [" + acceleration.unit + "]",
                     "pseudo velocity [" + speed.unit + "]", "relative displacement [" + length.unit + "]"});
    const std::size_t step = (spectrum.spectrum.size() + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < spectrum.spectrum.size(); i += step) {
      const excitation::ShockResponse& r = spectrum.spectrum[i];
      table.add({number_text(shown_frequency(answers.display, r.angular_frequency), 5),
                 number_text(r.largest() * acceleration.factor), number_text(r.smallest() * acceleration.factor),
                 number_text(r.pseudo_velocity() * speed.factor),
                 number_text(r.relative_displacement * length.factor)});
    }
    text += fmt::format("Shock response spectrum of {}, damping ratio {:.4g} (absolute acceleration)\n",
                        spectrum.excitation, spectrum.damping_ratio) +
        table.text();
  }
  return text;
}

/// One number of all spectra; they have the same natural frequencies.
template <typename Number>
void add_shock_numbers(const char* name, const char* unit, const std::vector<study::ShockSpectrumResult>& spectra,
                       const Number& number, LabelledArrays& list) {
  list.lists(name, unit, {"excitation", "angular_frequency"}, spectra.front().spectrum.size(), spectra,
             [&](const study::ShockSpectrumResult& spectrum) {
               std::vector<double> numbers;
               for (const excitation::ShockResponse& r : spectrum.spectrum) numbers.push_back(std::invoke(number, r));
               return numbers;
             });
}

void shock_spectrum_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using excitation::ShockResponse;
  using study::ShockSpectrumResult;
  const auto& spectra = *answers.find<std::vector<ShockSpectrumResult>>("shock_spectrum");
  if (spectra.empty()) return;
  list.field("angular_frequency", "rad/s", "angular_frequency", spectra.front().spectrum,
             &ShockResponse::angular_frequency);
  list.texts("excitation", "excitation", spectra, &ShockSpectrumResult::excitation);
  list.field("damping_ratio", "1", "excitation", spectra, &ShockSpectrumResult::damping_ratio);
  add_shock_numbers("largest", "m/s²", spectra, &ShockResponse::largest, list);
  add_shock_numbers("smallest", "m/s²", spectra, &ShockResponse::smallest, list);
  add_shock_numbers("maximax", "m/s²", spectra, &ShockResponse::maximax, list);
  add_shock_numbers("primary", "m/s²", spectra, &ShockResponse::primary, list);
  add_shock_numbers("residual", "m/s²", spectra, &ShockResponse::residual, list);
  add_shock_numbers("pseudo_velocity", "m/s", spectra, &ShockResponse::pseudo_velocity, list);
  add_shock_numbers("relative_displacement", "m", spectra, &ShockResponse::relative_displacement, list);
}

}  // namespace

const AnswerWriter shock_spectrum_results = {
    .json = json::shock_spectrum,
    .tables = {{"shock_spectrum.csv", shock_spectrum_csv}},
    .text = shock_spectrum_text,
    .arrays = shock_spectrum_arrays,
};

}  // namespace trivet::results
