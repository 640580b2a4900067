// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>

#include "trivet/exchange/universal/universal_reading.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/model/system.h"
#include "trivet/project/measured/measured_axes.h"
#include "trivet/project/measured/measured_file.h"
#include "trivet/project/measured/measured_places.h"
#include "trivet/project/measured/universal_names.h"

namespace trivet::project {
namespace {

using exchange::UniversalFunction;
using exchange::UniversalFunctionType;
using exchange::UniversalQuantity;

bool is_compared(const UniversalFunction& function) {
  if (!may_be_over_frequency(function)) return false;
  return function.type == UniversalFunctionType::general || function.type == UniversalFunctionType::spectrum ||
      function.type == UniversalFunctionType::frequency_response;
}

MeasuredFunction measured_function(const UniversalFunction& function, FunctionUnit unit) {
  MeasuredFunction result;
  result.response = function.response;
  result.reference = function.reference;
  result.unit = std::move(unit.unit);
  result.unit_error = std::move(unit.error);
  for (const std::string& id : function.ids)
    if (!id.empty()) result.texts.push_back(id);
  result.name =
      function.response.node == 0 && !result.texts.empty() ? result.texts.front() : point_name(function.response);
  const std::vector<double> hertz = exchange::abscissa_values(function);
  std::vector<std::complex<double>> values;
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    if (!(hertz[i] > 0)) continue;
    result.angular_frequency.push_back(foundation::two_pi * hertz[i]);
    values.push_back(function.values[i] * (result.unit ? result.unit->factor : 1));
  }
  result.value = Eigen::Map<const Eigen::VectorXcd>(values.data(), to_index(values.size()));
  return result;
}

bool same_point(const exchange::UniversalPoint& a, const exchange::UniversalPoint& b) {
  return a.node == b.node && std::abs(a.direction) == std::abs(b.direction);
}

void check_coherences(const UniversalFunction& function, const std::string& source, foundation::Problems& found) {
  for (const std::complex<double>& value : function.values) {
    if (is_coherence(value.real())) continue;
    found
        .error("", fmt::format("coherence {:.6g} of function {}", value.real(), point_name(function.response)),
               "a coherence is between 0 and 1", "correct the values, or the type of the function")
        .origin = {source, function.line};
    return;
  }
}

/// The function of type 6 at the same points and frequencies.
const UniversalFunction* coherence_of(const MeasuredFunction& measured, const std::vector<UniversalFunction>& all) {
  for (const UniversalFunction& function : all) {
    if (function.type != UniversalFunctionType::coherence || !same_point(function.response, measured.response) ||
        !same_point(function.reference, measured.reference))
      continue;
    std::vector<double> frequencies;
    for (const double hertz : exchange::abscissa_values(function))
      if (hertz > 0) frequencies.push_back(foundation::two_pi * hertz);
    if (same_frequencies(frequencies, measured.angular_frequency)) return &function;
  }
  return nullptr;
}

/// Coherences of a function at its frequencies; empty if there are none.
Eigen::VectorXd coherences(const MeasuredFunction& measured, const exchange::UniversalFile& file,
                           const std::string& source, foundation::Problems& found) {
  const UniversalFunction* function = coherence_of(measured, file.functions);
  if (!function) return {};
  check_coherences(*function, source, found);
  const std::vector<double> hertz = exchange::abscissa_values(*function);
  std::vector<double> values;
  for (std::size_t i = 0; i < hertz.size(); ++i)
    if (hertz[i] > 0) values.push_back(function->values[i].real());
  return Eigen::Map<const Eigen::VectorXd>(values.data(), to_index(values.size()));
}

/// Warns of functions that are not compared: times, power spectra, orders.
void report_other_functions(const exchange::UniversalFile& file, foundation::Problems& warnings) {
  std::vector<UniversalFunction> others;
  for (const UniversalFunction& function : file.functions) {
    if (is_compared(function) || function.type == UniversalFunctionType::coherence) continue;
    others.push_back(function);
    others.back().values.clear();
  }
  if (others.empty()) return;
  warnings.warning(
      "", universal_kinds(others),
      "frequency responses (type 4), spectra (12) and general functions (0) over frequency are compared; "
      "a time response or a power spectrum has no phase of a force",
      "they are ignored; export frequency responses (an excitation reads a time response as its `history`, "
      "a power spectral density as its `psd`)");
}

}  // namespace

std::optional<int> node_number(const std::string& text) {
  int node = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), node);
  return failed == std::errc() && end == text.data() + text.size() ? std::optional(node) : std::nullopt;
}

foundation::Expected<MeasuredFile> read_measured_universal(const std::filesystem::path& path, const GivenUnits& units,
                                                           bool with_coherence) {
  const auto read = exchange::read_universal(path);
  if (!read) return tl::make_unexpected(read.error());
  MeasuredFile result;
  result.warnings = read->warnings;
  result.modes = read->file.modes;
  for (const exchange::UniversalNode& node : read->file.nodes) {
    if (node.position_known && node.axes_known) result.nodes[node.label] = node.position;
    if (node.axes_known && !node.axes.isIdentity(0)) result.axes[node.label] = node.axes;
  }
  turn_to_ground(read->file.nodes, result.modes);
  result.nodes_in_systems = nodes_in_systems(read->file);
  std::vector<const UniversalFunction*> compared;
  MeasuredAxes axes(units, path.string());
  for (const UniversalFunction& function : read->file.functions) {
    if (!is_compared(function)) continue;
    compared.push_back(&function);
    result.functions.push_back(measured_function(function, axes.unit_of(function)));
    MeasuredFunction& measured = result.functions.back();
    if (with_coherence) measured.coherence = coherences(measured, read->file, path.string(), result.warnings);
  }
  if (!compared.empty()) result.idle_units = axes.judge_idle_units();
  report_other_functions(read->file, result.warnings);
  result.warnings.add(judge_abscissas(compared, path.string()));
  if (result.warnings.has_errors()) return tl::make_unexpected(std::move(result.warnings));
  return result;
}

}  // namespace trivet::project
