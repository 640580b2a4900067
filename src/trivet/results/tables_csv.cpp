// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/tables_csv.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/results/csv_field.h"

namespace trivet::results {

std::string modes_csv(const project::Case& variant, const study::Answers& answers) {
  std::string text = "mode,eigenvalue_squared [rad2/s2],angular_frequency [rad/s],frequency [Hz],name";
  for (const auto& body : variant.system.bodies())
    for (const char* coordinate : model::coordinate_names) text += "," + csv_field(fmt::format("shape {}.{}", body.name, coordinate));
  for (const auto& element : variant.system.elements()) text += "," + csv_field("strain energy share " + element.name);
  text += "\n";
  for (const modal::Mode& mode : answers.modes.list) {
    text += fmt::format("{},{},{},{},{}", mode.number, csv_number(mode.eigenvalue_squared), csv_number(mode.angular_frequency),
                        mode.angular_frequency ? csv_number(*mode.angular_frequency / 6.283185307179586) : "", csv_field(mode.name));
    for (const double component : mode.shape) text += "," + csv_number(component);
    for (std::size_t e = 0; e < variant.system.elements().size(); ++e)
      text += "," + (mode.strain_energy_share ? csv_number((*mode.strain_energy_share)(static_cast<Eigen::Index>(e))) : std::string());
    text += "\n";
  }
  return text;
}

std::string roots_csv(const study::Answers& answers) {
  std::string text = "real [1/s],imaginary [rad/s],kind,angular_frequency [rad/s],damping_ratio,nearest_mode\n";
  for (const modal::Root& root : answers.roots.list)
    text += fmt::format("{},{},{},{},{},{}\n", csv_number(root.eigenvalue.real()), csv_number(root.eigenvalue.imag()), modal::name(root.kind),
                        csv_number(root.angular_frequency), csv_number(root.damping_ratio), csv_number(root.nearest_mode));
  return text;
}

std::string response_csv(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  std::string text = "angular_frequency [rad/s]";
  for (const auto& curve : answer.curves.curves)
    for (const char* part : {"re", "im", "amplitude"}) text += "," + csv_field(fmt::format("{} {} [{}]", curve.name, part, curve.unit));
  for (const auto& curve : answer.curves.curves) text += "," + csv_field(curve.name + " phase [rad]");
  text += "\n";
  for (std::size_t i = 0; i < answer.curves.angular_frequency.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    text += csv_number(answer.curves.angular_frequency[i]);
    for (const auto& curve : answer.curves.curves) {
      const std::complex<double> z = curve.value(row);
      text += fmt::format(",{},{},{}", csv_number(z.real()), csv_number(z.imag()), csv_number(std::abs(z)));
    }
    for (const auto& phase : answer.phase) text += "," + csv_number(phase(row));
    text += "\n";
  }
  return text;
}

std::string peaks_csv(const study::Answers& answers) {
  std::string text = "name,unit,angular_frequency [rad/s],amplitude,prominence,relative_prominence,ratio_to_static,nearest_mode,angular_frequency_uncertainty [rad/s],amplitude_uncertainty,method\n";
  const response::Peaks& found = answers.peaks->peaks;
  for (const response::Peak& peak : found.list)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(found.curves[peak.curve].name), csv_field(found.curves[peak.curve].unit), csv_number(peak.angular_frequency),
                        csv_number(peak.amplitude), csv_number(peak.prominence), csv_number(relative_prominence(peak)), csv_number(peak.ratio_to_static), csv_number(peak.nearest_mode),
                        csv_number(peak.frequency_uncertainty), csv_number(peak.amplitude_uncertainty), response::method(found, peak));
  return text;
}

std::string static_csv(const study::Answers& answers) {
  std::string text = "name,unit,value\n";
  for (const response::StaticValue& value : answers.statics->values) text += fmt::format("{},{},{}\n", csv_field(value.name), csv_field(value.unit), csv_number(value.value));
  return text;
}

}  // namespace trivet::results
