// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/excitations/universal_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "trivet/exchange/universal/universal_reading.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured/measured_axes.h"
#include "trivet/project/measured/universal_names.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

using exchange::UniversalFunction;
using exchange::UniversalFunctionType;
using exchange::UniversalQuantity;

/// Some programs round the factors of set 164.
constexpr double rounded_densities = 3e-3;

/// The functions of a file that a key may name.
struct CourseKind {
  const char* key;
  const char* words;  ///< "a time response (type 1)"
  std::function<bool(const UniversalFunction&)> is_one;
  std::size_t most;
};

bool is_over_time(const UniversalFunction& function) {
  const auto& axis = function.abscissa_axis;
  return axis.quantity == UniversalQuantity::time || (axis.quantity == UniversalQuantity::unknown && axis.unit == "s");
}

bool is_time_response(const UniversalFunction& function) {
  return (function.type == UniversalFunctionType::time_response || function.type == UniversalFunctionType::general) &&
      is_over_time(function);
}

/// "g^2/Hz", in one label or in those of both axes.
std::optional<double> density_in_label(const UniversalFunction& function, Quantity quantity) {
  const std::string &numerator = function.numerator.stated.label, &denominator = function.denominator.stated.label;
  if (numerator.empty()) return std::nullopt;
  if (const auto whole = to_density("1 " + numerator, quantity)) return *whole;
  if (denominator.empty()) return std::nullopt;
  const auto ratio = to_density(fmt::format("1 ({})/{}", numerator, denominator), quantity);
  return ratio ? std::optional(*ratio) : std::nullopt;
}

/// Auto spectra of type 2 are mean squares of lines, unless their label says that they are per hertz.
bool is_density(const UniversalFunction& function) {
  const auto& axis = function.abscissa_axis;
  const bool over_frequency = axis.quantity == UniversalQuantity::frequency ||
      (axis.quantity == UniversalQuantity::unknown && axis.unit == "Hz");
  if (!over_frequency) return false;
  if (function.type == UniversalFunctionType::power_spectral_density) return true;
  const auto quantity = quantity_of_numerator(function);
  return function.type == UniversalFunctionType::auto_spectrum && quantity && density_in_label(function, *quantity);
}

const CourseKind time_responses{"value", "a time response (type 1)", is_time_response, most_rows_over_time};
const CourseKind densities{"psd", "a power spectral density (type 9)", is_density, most_rows_over_frequency};

/// A function, and −1 if it was measured along the opposite direction.
struct NamedFunction {
  UniversalFunction function;
  double sign = 1;
};

std::optional<double> sign_of_name(const UniversalFunction& function, const std::string& name) {
  exchange::UniversalPoint opposite = function.response;
  opposite.direction = -opposite.direction;
  if (point_name(function.response) == name || std::ranges::find(function.ids, name) != function.ids.end()) return 1;
  return function.response.direction != 0 && point_name(opposite) == name ? std::optional(-1.0) : std::nullopt;
}

/// "3:+z", or the first id line of a function without a node.
std::string name_in_list(const UniversalFunction& function) {
  const auto id = std::ranges::find_if(function.ids, [](const auto& text) { return !text.empty(); });
  return function.response.node == 0 && id != function.ids.end() ? *id : point_name(function.response);
}

std::optional<NamedFunction> chosen_function(TableReader& reader, std::vector<UniversalFunction>& functions,
                                             const CourseKind& kind) {
  std::vector<UniversalFunction> suitable;
  for (UniversalFunction& function : functions)
    if (kind.is_one(function)) suitable.push_back(std::move(function));
  const auto refuse = [&](const char* key, std::string finding, std::string rule, std::string remedy) {
    reader.error(key, std::move(finding), std::move(rule), std::move(remedy));
    return std::nullopt;
  };
  if (suitable.empty())
    return refuse("file", "the file has: " + universal_kinds(functions),
                  fmt::format("{} is read from a universal file here", kind.words),
                  "choose another file, or export such a function");
  std::vector<std::string> names;
  for (const UniversalFunction& function : suitable) names.push_back(name_in_list(function));
  const auto wanted = reader.text(kind.key);
  if (!wanted && suitable.size() == 1) return NamedFunction{std::move(suitable.front()), 1};
  const std::string example = fmt::format("name it: {} = {}", kind.key, foundation::quoted(names.back()));
  if (!wanted)
    return refuse("file", "several functions: " + foundation::comma_separated(names), "one is read", example);
  std::optional<NamedFunction> found;
  for (UniversalFunction& function : suitable) {
    const auto sign = sign_of_name(function, *wanted);
    if (sign && found)
      return refuse(kind.key, foundation::quoted(*wanted) + " names several functions", "one is read",
                    "write a file with one of them, or name an id line");
    if (sign) found = NamedFunction{std::move(function), *sign};
  }
  if (!found)
    return refuse(kind.key, foundation::quoted(*wanted), "no function of the file has this node and direction, or name",
                  "the file has: " + foundation::comma_separated(names));
  return found;
}

/// The function of the file that the table names; none after an error.
std::optional<NamedFunction> read_function_of_file(TableReader& reader, const CourseKind& kind) {
  const auto path = read_file_name(reader, "file");
  if (!path) return std::nullopt;
  auto read = exchange::read_universal(*path);
  reader.add_of_file("file", read ? read->warnings : read.error());
  if (!read) return std::nullopt;
  auto chosen = chosen_function(reader, read->file.functions, kind);
  if (!chosen) return std::nullopt;
  const auto& values = chosen->function.values;
  if (std::ranges::any_of(values, [](const auto& value) { return value.imag() != 0; })) {
    reader.error("file", "complex values", fmt::format("{} is real", kind.words), "export it as real numbers");
    return std::nullopt;
  }
  if (values.size() > kind.most) {
    reader.error("file", fmt::format("{} points", values.size()),
                 fmt::format("a function of this kind has at most {}", kind.most), "take the part that is needed");
    return std::nullopt;
  }
  return chosen;
}

/// Rejects a function of another quantity than the excitation.
bool is_driven_quantity(TableReader& reader, const UniversalFunction& function, Quantity wanted) {
  const auto quantity = quantity_of_numerator(function);
  if (!quantity || *quantity == wanted) return true;
  if (function.response.direction == 0 && underived(*quantity) != underived(wanted) &&
      derivatives_of(*quantity) == derivatives_of(wanted) && is_motion(*quantity) == is_motion(wanted))
    return true;  // a scalar may be a rotation
  const char* remedy = is_motion(*quantity) && is_motion(wanted)
      ? "state the quantity of the excitation: quantity = \"acceleration\", \"velocity\" or \"displacement\""
      : "choose another function, or another excitation";
  reader.error("file", fmt::format("{} is measured in {}", name_in_list(function), si_unit(*quantity)),
               fmt::format("the excitation is driven in {}", si_unit(wanted)), remedy);
  return false;
}

/// SI value of one unit of a density by the file; none if nothing states it or after an error.
std::optional<double> unit_of_density(TableReader& reader, const UniversalFunction& function,
                                      const ColumnQuantity& density) {
  std::vector<std::pair<double, std::string>> stated;
  const auto& numerator = function.numerator.stated;
  if (const auto label = density_in_label(function, density.quantity))
    stated.push_back({*label, "the label " + foundation::quoted(numerator.label)});
  else if (numerator.by_label)
    stated.push_back({*numerator.by_label * *numerator.by_label, "the label " + foundation::quoted(numerator.label)});
  if (numerator.by_set)
    stated.push_back({*numerator.by_set * *numerator.by_set,
                      fmt::format("set 164 (the numerator has {:.6g} in SI)", *numerator.by_set)});
  const auto agree = [](double a, double b) { return std::abs(a / b - 1) < rounded_densities; };
  const auto refuse = [&](std::string finding, std::string remedy) {
    reader.error("file", fmt::format("function {}: {}", name_in_list(function), finding), "the numbers have one unit",
                 std::move(remedy));
    return std::nullopt;
  };
  if (reader.has("unit")) {
    const bool met =
        stated.empty() || std::ranges::any_of(stated, [&](const auto& one) { return agree(one.first, density.bare); });
    if (!met)
      return refuse(fmt::format("unit = \"{}\" of the project against {}", density.unit(), stated.front().second),
                    "remove `unit`, or correct the file");
    return density.bare;
  }
  for (const auto& [factor, words] : stated)
    if (!agree(factor, stated.front().first))
      return refuse(fmt::format("{} against {}", stated.front().second, words), "state it: unit = \"g^2/Hz\"");
  if (stated.empty() && (!numerator.label.empty() || !quantity_of_numerator(function)))
    return refuse(numerator.label.empty() ? "neither an axis nor a label states its quantity"
                                          : "the label " + foundation::quoted(numerator.label) + " is not a known unit",
                  "state it: unit = \"g^2/Hz\"");
  return stated.empty() ? 1 : stated.front().first;
}

/// Rejects densities per something other than a hertz.
bool is_per_hertz(TableReader& reader, const UniversalFunction& function) {
  const auto& axis = function.denominator;
  const std::string& label = axis.stated.label;
  const bool of_motion = axis.quantity == UniversalQuantity::unknown || axis.quantity == function.numerator.quantity ||
      axis.quantity == UniversalQuantity::frequency;
  const bool known_label = label.empty() || label == "Hz" || label == function.numerator.stated.label;
  if (of_motion && known_label) return true;
  reader.error(
      "file",
      fmt::format("function {} has a denominator of type {}{}", name_in_list(function), static_cast<int>(axis.quantity),
                  label.empty() ? "" : " and the label " + foundation::quoted(label)),
      "a power spectral density is a mean square per hertz", "export it so, one-sided");
  return false;
}

Eigen::MatrixXd points_of(const NamedFunction& chosen, double factor, bool with_zero) {
  const std::vector<double> abscissa = exchange::abscissa_values(chosen.function);
  const auto first = with_zero ? abscissa.begin() : std::ranges::find_if(abscissa, [](double x) { return x != 0; });
  const std::size_t skipped = to_size(first - abscissa.begin());
  Eigen::MatrixXd points(to_index(abscissa.size() - skipped), 2);
  for (std::size_t i = skipped; i < abscissa.size(); ++i)
    points.row(to_index(i - skipped)) << abscissa[i], factor * chosen.function.values[i].real();
  return points;
}

}  // namespace

bool names_universal_file(TableReader& reader) {
  const Node* file = reader.content().find("file");
  return file && file->kind == Node::Kind::text && exchange::is_universal_file(named_file(*file));
}

std::optional<Eigen::MatrixXd> read_time_response(TableReader& reader, const ColumnQuantity& value) {
  const auto chosen = read_function_of_file(reader, time_responses);
  if (!chosen || !is_driven_quantity(reader, chosen->function, value.quantity)) return std::nullopt;
  GivenUnits given;
  if (reader.has("unit")) given.push_back({.quantity = value.quantity, .factor = value.bare, .text = value.unit()});
  const FunctionUnit known = MeasuredAxes(given, reader.text("file").value_or("")).unit_of(chosen->function);
  if (known.error) {
    foundation::Problems of_file;
    of_file.add(*known.error);
    return reader.add_of_file("file", of_file), std::nullopt;
  }
  if (known.unit && known.unit->quantity != value.quantity && !quantity_of_numerator(chosen->function)) {
    reader.error("file", fmt::format("{} is measured in {}", name_in_list(chosen->function), known.unit->text),
                 fmt::format("the excitation is driven in {}", si_unit(value.quantity)),
                 "choose another function, or correct the label");
    return std::nullopt;
  }
  if (!known.unit || known.unit->per_load) {
    reader.error("file", fmt::format("the unit of {} is not known, or is per force", name_in_list(chosen->function)),
                 "types of axes with set 164 or labels state it", "state it: unit = \"m/s2\"");
    return std::nullopt;
  }
  return points_of(*chosen, chosen->sign * known.unit->factor / value.bare, true);
}

std::optional<Eigen::MatrixXd> read_power_spectral_density(TableReader& reader, const ColumnQuantity& density) {
  const auto chosen = read_function_of_file(reader, densities);
  if (!chosen || !is_driven_quantity(reader, chosen->function, density.quantity) ||
      !is_per_hertz(reader, chosen->function))
    return std::nullopt;
  const auto unit = unit_of_density(reader, chosen->function, density);
  return unit ? std::optional(points_of(*chosen, *unit / density.bare, false)) : std::nullopt;
}

}  // namespace trivet::project
