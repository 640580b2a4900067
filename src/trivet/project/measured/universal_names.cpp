// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/universal_names.h"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "trivet/foundation/plain_text.h"
#include "trivet/model/system.h"
#include "trivet/project/measured/measured_abscissa.h"

namespace trivet::project {

std::string point_name(const exchange::UniversalPoint& point) {
  const int direction = std::abs(point.direction);
  if (direction < 1 || direction > 6) return fmt::format("{}:scalar", point.node);
  return fmt::format("{}:{}{}", point.node, point.direction < 0 ? "-" : "+", model::coordinate_names[direction - 1]);
}

std::string universal_kind(const exchange::UniversalFunction& function) {
  using enum exchange::UniversalFunctionType;
  static const std::map<exchange::UniversalFunctionType, const char*> names = {
      {time_response, "time response"},
      {auto_spectrum, "auto spectrum"},
      {cross_spectrum, "cross spectrum"},
      {frequency_response, "frequency response"},
      {transmissibility, "transmissibility"},
      {coherence, "coherence"},
      {auto_correlation, "auto correlation"},
      {cross_correlation, "cross correlation"},
      {power_spectral_density, "power spectral density"},
      {energy_spectral_density, "energy spectral density"},
      {spectrum, "spectrum"},
      {shock_response_spectrum, "shock response spectrum"},
      {order_function, "order function"},
  };
  const auto name = names.find(function.type);
  const std::string kind = name == names.end() ? "function" : name->second;
  const std::string type = fmt::format("{} (type {})", kind, static_cast<int>(function.type));
  if (may_be_over_frequency(function)) return type;
  return fmt::format("{} over an abscissa of type {}", type, static_cast<int>(function.abscissa_axis.quantity));
}

std::string universal_kinds(const std::vector<exchange::UniversalFunction>& functions) {
  std::map<std::string, std::size_t> kinds;
  for (const exchange::UniversalFunction& function : functions) ++kinds[universal_kind(function)];
  std::vector<std::string> words;
  for (const auto& [kind, count] : kinds) words.push_back(fmt::format("{} × {}", count, kind));
  return words.empty() ? "no functions" : foundation::comma_separated(words);
}

}  // namespace trivet::project
