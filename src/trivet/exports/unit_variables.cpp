// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/unit_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exports {

namespace {

struct UnitSymbol {
  std::string_view symbol;
  BaseUnit unit;
};

constexpr std::array<UnitSymbol, 21> unit_symbols = {{
    {"1", {}},
    {"kg", {.kg = 1}},
    {"m", {.m = 1}},
    {"s", {.s = 1}},
    {"A", {.A = 1}},
    {"K", {.K = 1}},
    {"mol", {.mol = 1}},
    {"cd", {.cd = 1}},
    {"rad", {.rad = 1}},
    {"N", {.kg = 1, .m = 1, .s = -2}},
    {"Pa", {.kg = 1, .m = -1, .s = -2}},
    {"J", {.kg = 1, .m = 2, .s = -2}},
    {"W", {.kg = 1, .m = 2, .s = -3}},
    {"V", {.kg = 1, .m = 2, .s = -3, .A = -1}},
    {"C", {.s = 1, .A = 1}},
    {"T", {.kg = 1, .s = -2, .A = -1}},
    {"H", {.kg = 1, .m = 2, .s = -2, .A = -2}},
    {"Wb", {.kg = 1, .m = 2, .s = -2, .A = -1}},
    {"F", {.kg = -1, .m = -2, .s = 4, .A = 2}},
    {"Ohm", {.kg = 1, .m = 2, .s = -3, .A = -2}},
    {"S", {.kg = -1, .m = -2, .s = 3, .A = 2}},
}};

[[noreturn]] void refuse_unit(const std::string& unit) {
  throw foundation::InvalidInput(
      fmt::format("the unit {} is not known; use coherent SI units such as \"N m\", \"m/s2\" or \"rad\"",
                  foundation::quoted(unit)));
}

/// The unit with ² and ³ as digits and every sign of multiplication as a space.
std::string in_ascii(std::string unit) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> replacements = {
      {{"²", "2"}, {"³", "3"}, {"·", " "}, {"*", " "}, {".", " "}, {"^", ""}}};
  for (const auto& [from, to] : replacements)
    for (std::size_t at = unit.find(from); at != std::string::npos; at = unit.find(from, at))
      unit.replace(at, from.size(), to);
  return unit;
}

/// The exponent after a symbol; 1 if there is none.
int exponent_of(std::string_view digits, const std::string& unit) {
  if (digits.empty()) return 1;
  int exponent = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (error != std::errc() || end != digits.data() + digits.size() || exponent == 0 || std::abs(exponent) > 9)
    refuse_unit(unit);
  return exponent;
}

void multiply(BaseUnit& product, const BaseUnit& factor, int exponent) {
  for (int BaseUnit::* part : {&BaseUnit::kg, &BaseUnit::m, &BaseUnit::s, &BaseUnit::A, &BaseUnit::K, &BaseUnit::mol,
                               &BaseUnit::cd, &BaseUnit::rad})
    product.*part += exponent * factor.*part;
}

}  // namespace

BaseUnit base_unit(const std::string& unit) {
  const std::string text = in_ascii(unit);
  BaseUnit product;
  bool divides = false, has_divided = false;
  std::size_t at = 0;
  const auto skip_spaces = [&] { at = std::min(text.find_first_not_of(' ', at), text.size()); };
  skip_spaces();
  if (at == text.size()) refuse_unit(unit);
  while (at < text.size()) {
    const std::size_t end = std::min(text.find_first_of(" /", at), text.size());
    const std::string_view factor = std::string_view(text).substr(at, end - at);
    const std::size_t digits = factor == "1" ? 1 : std::min(factor.find_first_of("-0123456789"), factor.size());
    const auto* symbol = std::ranges::find(unit_symbols, factor.substr(0, digits), &UnitSymbol::symbol);
    if (symbol == unit_symbols.end() || (has_divided && !divides)) refuse_unit(unit);
    multiply(product, symbol->unit, exponent_of(factor.substr(digits), unit) * (divides ? -1 : 1));
    has_divided = has_divided || divides;
    at = end;
    skip_spaces();
    divides = at < text.size() && text[at] == '/';
    if (!divides) continue;
    ++at;
    skip_spaces();
    if (at == text.size()) refuse_unit(unit);
  }
  return product;
}

std::string per_second(const std::string& unit) {
  if (unit.empty()) return "1/s";
  if (unit.ends_with("/s")) return unit + "2";
  for (const std::string_view square : {"/s2", "/s²", "/s^2"})
    if (unit.ends_with(square)) return unit.substr(0, unit.size() - square.size()) + "/s3";
  return unit + "/s";
}

namespace {

/// Position of the first variable of each kind.
struct FirstPositions {
  explicit FirstPositions(const LinearSystem& system)
      : outputs(inputs + system.inputs.size()),
        states(outputs + system.outputs.size()),
        derivatives(states + system.states.size()) {}
  std::size_t inputs = 1, outputs, states, derivatives;
};

std::vector<std::size_t> positions(std::size_t first, std::size_t count) {
  std::vector<std::size_t> list(count);
  std::iota(list.begin(), list.end(), first);
  return list;
}

/// Positions of the inputs and states with factors that are not zero.
std::vector<std::size_t> dependencies(const FirstPositions& first, const Eigen::MatrixXd& of_states,
                                      const Eigen::MatrixXd& of_inputs, Eigen::Index row) {
  std::vector<std::size_t> list;
  for (Eigen::Index j = 0; j < of_inputs.cols(); ++j)
    if (of_inputs(row, j) != 0) list.push_back(first.inputs + to_size(j));
  for (Eigen::Index j = 0; j < of_states.cols(); ++j)
    if (of_states(row, j) != 0) list.push_back(first.states + to_size(j));
  return list;
}

UnitVariable variable(const Signal& signal, const std::string& causality) {
  return {.name = signal.name, .unit = signal.unit, .description = signal.description, .causality = causality};
}

UnitVariable derivative(const Signal& state) {
  return {.name = fmt::format("der({})", state.name),
          .unit = per_second(state.unit),
          .description = fmt::format("time derivative of {}", state.name),
          .causality = "local",
          .initial = "calculated"};
}

void check_names(const std::vector<UnitVariable>& variables) {
  std::set<std::string> names;
  for (const UnitVariable& variable : variables)
    if (!names.insert(variable.name).second)
      throw foundation::InvalidInput(fmt::format(
          "linear system: the name {} is needed for time or for the derivative of a state; choose another name",
          foundation::quoted(variable.name)));
}

}  // namespace

std::vector<UnitVariable> unit_variables(const LinearSystem& system) {
  const FirstPositions first(system);
  const Eigen::VectorXd initial = initial_states(system);
  std::vector<UnitVariable> variables = {{.name = "time", .unit = "s", .causality = "independent"}};
  for (const Signal& input : system.inputs) {
    variables.push_back(variable(input, "input"));
    variables.back().start = 0;
  }
  for (std::size_t i = 0; i < system.outputs.size(); ++i) {
    variables.push_back(variable(system.outputs[i], "output"));
    variables.back().initial = "calculated";
    variables.back().dependencies = dependencies(first, system.C, system.D, to_index(i));
  }
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    variables.push_back(variable(system.states[i], "local"));
    variables.back().initial = "exact";
    variables.back().start = initial(to_index(i));
    variables.back().nominal = system.states[i].nominal;
  }
  for (std::size_t i = 0; i < system.states.size(); ++i) {
    variables.push_back(derivative(system.states[i]));
    variables.back().derivative_of = first.states + i;
    variables.back().dependencies = dependencies(first, system.A, system.B, to_index(i));
  }
  check_names(variables);
  return variables;
}

ComputedVariables computed_variables(const LinearSystem& system) {
  const FirstPositions first(system);
  return {.outputs = positions(first.outputs, system.outputs.size()),
          .derivatives = positions(first.derivatives, system.states.size())};
}

}  // namespace trivet::exports
