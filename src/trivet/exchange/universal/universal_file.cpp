// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_file.h"

#include <numbers>

namespace trivet::exchange {

double natural_frequency_hz(const UniversalMode& mode) {
  if (const auto* normal = std::get_if<UniversalNormalMode>(&mode.parameters)) return normal->frequency_hz;
  return std::abs(std::get<UniversalComplexMode>(mode.parameters).eigenvalue) / (2 * std::numbers::pi);
}

double damping_ratio(const UniversalMode& mode) {
  if (const auto* normal = std::get_if<UniversalNormalMode>(&mode.parameters)) return normal->damping_ratio;
  const std::complex<double> eigenvalue = std::get<UniversalComplexMode>(mode.parameters).eigenvalue;
  const double magnitude = std::abs(eigenvalue);
  return magnitude > 0 ? -eigenvalue.real() / magnitude : 0;
}

std::vector<double> abscissa_values(const UniversalFunction& function) {
  if (const auto* uneven = std::get_if<std::vector<double>>(&function.abscissa)) return *uneven;
  const EvenAbscissa& even = std::get<EvenAbscissa>(function.abscissa);
  std::vector<double> values(function.values.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = even.first + static_cast<double>(i) * even.step;
  return values;
}

}  // namespace trivet::exchange
