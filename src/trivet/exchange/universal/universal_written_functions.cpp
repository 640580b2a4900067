// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "trivet/exchange/universal/universal_function_head.h"
#include "trivet/exchange/universal/universal_lines.h"
#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/invalid_input.h"

static_assert(std::endian::native == std::endian::little, "the numbers are copied to the file as they are");

namespace trivet::exchange {
namespace {

/// Number of fields in a line of values.
constexpr std::size_t values_per_double_line = 4;

[[noreturn]] void reject(const UniversalFunction& function, const std::string& why) {
  throw foundation::InvalidInput(fmt::format("function \"{}\": {}", function.ids[0], why));
}

bool is_single(const UniversalFunction& function, bool binary) {
  return function.precision == UniversalPrecision::single_precision || (binary && !is_even(function));
}

int ordinate_type(const UniversalFunction& function, bool single) {
  if (function.is_complex) return single ? 5 : 6;
  return single ? 2 : 4;
}

std::string place_line(const UniversalFunction& function) {
  const auto point = [](const UniversalPoint& p) {
    return " " + text_field(p.entity, universal_entity_width) + whole_field(p.node, 10, "node") +
        whole_field(p.direction, 4, "direction");
  };
  return whole_field(static_cast<int>(function.type), 5, "function type") +
      whole_field(function.identifier, 10, "identifier") + whole_field(function.version, 5, "version") +
      whole_field(function.load_case, 10, "load case") + point(function.response) + point(function.reference) + "\n";
}

std::string form_line(const UniversalFunction& function, bool single) {
  const EvenAbscissa even = is_even(function) ? std::get<EvenAbscissa>(function.abscissa) : EvenAbscissa{0, 0};
  return fmt::format("{:10d}{:10d}{:10d}", ordinate_type(function, single), function.values.size(),
                     is_even(function) ? 1 : 0) +
      single_field(even.first) + single_field(even.step) + single_field(function.z_value) + "\n";
}

std::string axis_line(const UniversalAxis& axis) {
  return whole_field(static_cast<int>(axis.quantity), 10, "quantity") +
      whole_field(axis.exponents.length, 5, "power of length") +
      whole_field(axis.exponents.force, 5, "power of force") +
      whole_field(axis.exponents.temperature, 5, "power of temperature") + " " +
      text_field(axis.label, universal_label_width) + " " + text_field(axis.unit, universal_label_width) + "\n";
}

std::string head(const UniversalFunction& function, bool single) {
  std::string text;
  for (const std::string& id : function.ids) text += text_line(id);
  return text + place_line(function) + form_line(function, single) + axis_line(function.abscissa_axis) +
      axis_line(function.numerator) + axis_line(function.denominator) + axis_line(function.z_axis);
}

const std::vector<double>* uneven_abscissa(const UniversalFunction& function) {
  return std::get_if<std::vector<double>>(&function.abscissa);
}

std::string single_values(const UniversalFunction& function) {
  std::vector<double> numbers;
  const auto* abscissa = uneven_abscissa(function);
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    if (abscissa) numbers.push_back((*abscissa)[i]);
    numbers.push_back(function.values[i].real());
    if (function.is_complex) numbers.push_back(function.values[i].imag());
  }
  return single_lines(numbers);
}

/// 4E20.12 or, with an uneven abscissa, 2(E13.5,E20.12) and E13.5,2E20.12.
std::string double_values(const UniversalFunction& function) {
  const auto* abscissa = uneven_abscissa(function);
  const std::size_t fields_per_point = numbers_per_point(function);
  const std::size_t points_per_line = values_per_double_line / fields_per_point;
  std::string text;
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    if (abscissa) text += single_field((*abscissa)[i]);
    text += double_field(function.values[i].real());
    if (function.is_complex) text += double_field(function.values[i].imag());
    if ((i + 1) % points_per_line == 0 || i + 1 == function.values.size()) text += '\n';
  }
  return text;
}

template <typename Real>
void append(std::string& bytes, double number) {
  const Real value = static_cast<Real>(number);
  char copy[sizeof(Real)];
  std::memcpy(copy, &value, sizeof(Real));
  bytes.append(copy, sizeof(Real));
}

template <typename Real>
std::string binary_values(const UniversalFunction& function) {
  const auto* abscissa = uneven_abscissa(function);
  std::string bytes;
  bytes.reserve(function.values.size() * numbers_per_point(function) * sizeof(Real));
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    if (abscissa) append<Real>(bytes, (*abscissa)[i]);
    append<Real>(bytes, function.values[i].real());
    if (function.is_complex) append<Real>(bytes, function.values[i].imag());
  }
  return bytes;
}

void require_range(const UniversalFunction& function, double number, bool single) {
  if (!std::isfinite(number)) reject(function, "a number is not finite");
  if (single && std::abs(number) > std::numeric_limits<float>::max())
    reject(function, fmt::format("{:.9g} is too large for single precision", number));
}

bool must_increase(const UniversalFunction& function) {
  const UniversalQuantity quantity = function.abscissa_axis.quantity;
  return quantity == UniversalQuantity::time || quantity == UniversalQuantity::frequency;
}

/// The abscissa that the file holds: six digits in text, a number in single precision in binary form.
double held_abscissa(double value, bool binary) {
  return binary ? static_cast<double>(static_cast<float>(value)) : as_universal_abscissa(value);
}

void require_abscissa(const UniversalFunction& function, bool single, bool binary) {
  if (const auto* even = std::get_if<EvenAbscissa>(&function.abscissa)) {
    if (!std::isfinite(even->first) || !std::isfinite(even->step) || (function.values.size() > 1 && !(even->step > 0)))
      reject(function, fmt::format("step {:.9g}, must be > 0", even->step));
    return;
  }
  const std::vector<double>& abscissa = *uneven_abscissa(function);
  if (abscissa.size() != function.values.size())
    reject(function, fmt::format("{} abscissas and {} values, must be equal", abscissa.size(), function.values.size()));
  for (std::size_t i = 0; i < abscissa.size(); ++i) {
    require_range(function, abscissa[i], single);
    if (i > 0 && must_increase(function) &&
        held_abscissa(abscissa[i], binary) <= held_abscissa(abscissa[i - 1], binary))
      reject(function,
             fmt::format("{:.9g} after {:.9g}: times and frequencies must increase, also with {} digits", abscissa[i],
                         abscissa[i - 1], binary ? "seven" : "six"));
  }
}

}  // namespace

void require_writable(const UniversalFunction& function, bool binary) {
  const bool single = is_single(function, binary);
  if (function.in_file_units) reject(function, "its values are not in SI");
  if (function.values.empty()) reject(function, "it has no values");
  require_range(function, function.z_value, single);
  for (const std::complex<double>& value : function.values) {
    require_range(function, value.real(), single);
    require_range(function, value.imag(), single);
    if (!function.is_complex && value.imag() != 0) reject(function, "it is real and has an imaginary part");
  }
  require_abscissa(function, single, binary);
}

std::string function_set(const UniversalFunction& function, bool binary) {
  const bool single = is_single(function, binary);
  if (!binary)
    return opening_lines(58) + head(function, single) + (single ? single_values(function) : double_values(function)) +
        closing_line_of_set();
  const std::string values = single ? binary_values<float>(function) : binary_values<double>(function);
  // Little-endian, IEEE 754, eleven lines before the values.
  return fmt::format("{:6d}\n{:6d}b{:6d}{:6d}{:12d}{:12d}{:6d}{:6d}{:12d}{:12d}\n", -1, 58, 1, 2, 11, values.size(), 0,
                     0, 0, 0) +
      head(function, single) + values + closing_line_of_set();
}

}  // namespace trivet::exchange
