// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/tables_csv.h"

#include <fmt/format.h>

#include <cmath>

namespace trivet::results {
namespace {

/// A field in quotes where commas, quotes or line breaks ask for it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

/// Shortest digits that read back the same; empty where there is no number.
std::string number(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

template <typename T>
std::string optional(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

std::string modes_csv(const project::Case& variant, const study::Answers& answers) {
  std::string text = "mode,eigenvalue_squared [rad2/s2],angular_frequency [rad/s],frequency [Hz],name";
  for (const auto& body : variant.system.bodies())
    for (const char* coordinate : model::coordinate_names) text += "," + field(fmt::format("shape {}.{}", body.name, coordinate));
  for (const auto& element : variant.system.elements()) text += "," + field("strain energy share " + element.name);
  text += "\n";
  for (const modal::Mode& mode : answers.modes.list) {
    text += fmt::format("{},{},{},{},{}", mode.number, number(mode.eigenvalue_squared), optional(mode.angular_frequency),
                        mode.angular_frequency ? number(*mode.angular_frequency / 6.283185307179586) : "", field(mode.name));
    for (const double component : mode.shape) text += "," + number(component);
    for (std::size_t e = 0; e < variant.system.elements().size(); ++e)
      text += "," + (mode.strain_energy_share ? number((*mode.strain_energy_share)(static_cast<Eigen::Index>(e))) : std::string());
    text += "\n";
  }
  return text;
}

std::string roots_csv(const study::Answers& answers) {
  std::string text = "real [1/s],imaginary [rad/s],kind,angular_frequency [rad/s],damping_ratio,nearest_mode\n";
  for (const modal::Root& root : answers.roots.list)
    text += fmt::format("{},{},{},{},{},{}\n", number(root.eigenvalue.real()), number(root.eigenvalue.imag()), modal::name(root.kind),
                        optional(root.angular_frequency), optional(root.damping_ratio), optional(root.nearest_mode));
  return text;
}

std::string response_csv(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  std::string text = "angular_frequency [rad/s]";
  for (const auto& curve : answer.curves.curves)
    for (const char* part : {"re", "im", "amplitude"}) text += "," + field(fmt::format("{} {} [{}]", curve.name, part, curve.unit));
  for (const auto& curve : answer.curves.curves) text += "," + field(curve.name + " phase [rad]");
  text += "\n";
  for (std::size_t i = 0; i < answer.curves.angular_frequency.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    text += number(answer.curves.angular_frequency[i]);
    for (const auto& curve : answer.curves.curves) {
      const std::complex<double> z = curve.value(row);
      text += fmt::format(",{},{},{}", number(z.real()), number(z.imag()), number(std::abs(z)));
    }
    for (const auto& phase : answer.phase) text += "," + number(phase(row));
    text += "\n";
  }
  return text;
}

std::string peaks_csv(const study::Answers& answers) {
  std::string text = "name,unit,angular_frequency [rad/s],amplitude,prominence,relative_prominence,ratio_to_static,nearest_mode,angular_frequency_uncertainty [rad/s],amplitude_uncertainty,method\n";
  const response::Peaks& found = answers.peaks->peaks;
  for (const response::Peak& peak : found.list)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", field(found.curves[peak.curve].name), field(found.curves[peak.curve].unit), number(peak.angular_frequency),
                        number(peak.amplitude), number(peak.prominence), number(relative_prominence(peak)), optional(peak.ratio_to_static), optional(peak.nearest_mode),
                        number(peak.frequency_uncertainty), number(peak.amplitude_uncertainty), response::method(found, peak));
  return text;
}

std::string static_csv(const study::Answers& answers) {
  std::string text = "name,unit,value\n";
  for (const response::StaticValue& value : answers.statics->values) text += fmt::format("{},{},{}\n", field(value.name), field(value.unit), number(value.value));
  return text;
}

}  // namespace trivet::results
