// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/model_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "trivet/exports/unit_variables.h"
#include "trivet/foundation/version.h"

namespace trivet::exports {

namespace {

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    switch (character) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

}  // namespace

std::string attribute(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, xml_escaped(value));
}

std::string attribute(const char* name, std::size_t value) { return fmt::format(" {}=\"{}\"", name, value); }

std::string attribute(const char* name, const std::optional<double>& value) {
  return value ? fmt::format(" {}=\"{}\"", name, *value) : "";
}

namespace {

constexpr const char* abilities_2 =
    " canNotUseMemoryManagementFunctions=\"true\" canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\""
    " providesDirectionalDerivative=\"true\"";
constexpr const char* abilities_3 =
    " canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" providesDirectionalDerivatives=\"true\""
    " providesAdjointDerivatives=\"true\"";
constexpr const char* steps = " canHandleVariableCommunicationStepSize=\"true\" maxOutputDerivativeOrder=\"1\"";

std::string heading(const LinearSystem& system, FmiVersion version, const std::string& token) {
  const bool two = version == FmiVersion::two;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription" +
      attribute("fmiVersion", std::string(two ? "2.0" : "3.0")) +
      attribute("modelName", system.title.empty() ? model_identifier(system) : system.title) +
      attribute(two ? "guid" : "instantiationToken", token) +
      attribute("generationTool", fmt::format("Trivet {}", foundation::version())) +
      " variableNamingConvention=\"flat\"" + (two ? " numberOfEventIndicators=\"0\"" : "") + ">\n";
}

std::string kinds(const LinearSystem& system, FmiVersion version) {
  const std::string identifier = attribute("modelIdentifier", model_identifier(system));
  if (version == FmiVersion::three)
    return fmt::format("  <ModelExchange{0}{1}/>\n  <CoSimulation{0}{1}{2}/>\n", identifier, abilities_3, steps);
  return fmt::format(
      "  <ModelExchange{0} completedIntegratorStepNotNeeded=\"true\"{1}/>\n"
      "  <CoSimulation{0}{2} canInterpolateInputs=\"true\"{1}/>\n",
      identifier, abilities_2, steps);
}

std::string exponents(const BaseUnit& unit) {
  std::string text;
  const auto add = [&](const char* name, int exponent) {
    if (exponent != 0) text += fmt::format(" {}=\"{}\"", name, exponent);
  };
  add("kg", unit.kg);
  add("m", unit.m);
  add("s", unit.s);
  add("A", unit.A);
  add("K", unit.K);
  add("mol", unit.mol);
  add("cd", unit.cd);
  add("rad", unit.rad);
  return text;
}

std::string unit_definitions(const std::vector<UnitVariable>& variables) {
  std::set<std::string> units;
  for (const UnitVariable& variable : variables)
    if (!variable.unit.empty()) units.insert(variable.unit);
  std::string text = "  <UnitDefinitions>\n";
  for (const std::string& unit : units)
    text += "    <Unit" + attribute("name", unit) + "><BaseUnit" + exponents(base_unit(unit)) + "/></Unit>\n";
  return text + "  </UnitDefinitions>\n";
}

std::string log_categories() {
  return "  <LogCategories>\n"
         "    <Category name=\"logEvents\" description=\"instantiation and new sizes of steps\"/>\n"
         "    <Category name=\"logStatusWarning\" description=\"calls without effect\"/>\n"
         "    <Category name=\"logStatusError\" description=\"calls that failed\"/>\n"
         "  </LogCategories>\n";
}

/// @param shift  added to positions: 1 where the interface counts variables from 1
std::string listed_variable(const UnitVariable& variable, std::size_t position, FmiVersion version, std::size_t shift) {
  const std::string common = attribute("name", variable.name) + attribute("valueReference", position) +
      attribute("description", variable.description) + attribute("causality", variable.causality) +
      " variability=\"continuous\"" + attribute("initial", variable.initial);
  const std::string numbers = attribute("unit", variable.unit) + attribute("nominal", variable.nominal) +
      attribute("start", variable.start) +
      (variable.derivative_of ? attribute("derivative", *variable.derivative_of + shift) : "");
  if (version == FmiVersion::three) return "    <Float64" + common + numbers + "/>\n";
  return "    <ScalarVariable" + common + "><Real" + numbers + "/></ScalarVariable>\n";
}

std::string model_variables(const std::vector<UnitVariable>& variables, FmiVersion version, std::size_t shift) {
  std::string text = "  <ModelVariables>\n";
  for (std::size_t i = 0; i < variables.size(); ++i) text += listed_variable(variables[i], i, version, shift);
  return text + "  </ModelVariables>\n";
}

/// The variables at these positions, each as an element with what it depends on. All factors are constant.
std::string dependency_list(const std::vector<UnitVariable>& variables, const std::vector<std::size_t>& positions,
                            const char* element, const char* key, std::size_t shift) {
  std::string text;
  for (const std::size_t position : positions) {
    std::string causes, words;
    for (const std::size_t cause : *variables[position].dependencies) {
      causes += fmt::format("{}{}", causes.empty() ? "" : " ", cause + shift);
      words += words.empty() ? "constant" : " constant";
    }
    // An empty list means that the variable depends on nothing; without a list it would depend on everything.
    text += fmt::format("    <{}{} dependencies=\"{}\" dependenciesKind=\"{}\"/>\n", element,
                        attribute(key, position + shift), causes, words);
  }
  return text;
}

std::string model_structure(const LinearSystem& system, const std::vector<UnitVariable>& variables, FmiVersion version,
                            std::size_t shift) {
  const auto [outputs, derivatives] = computed_variables(system);
  const auto list = [&](const std::vector<std::size_t>& positions, const char* element, const char* key) {
    return dependency_list(variables, positions, element, key, shift);
  };
  std::vector<std::size_t> unknowns = outputs;
  unknowns.insert(unknowns.end(), derivatives.begin(), derivatives.end());
  std::string text = "  <ModelStructure>\n";
  if (version == FmiVersion::three) {
    constexpr const char* key = "valueReference";
    text += list(outputs, "Output", key) + list(derivatives, "ContinuousStateDerivative", key) +
        list(unknowns, "InitialUnknown", key);
  } else {
    const auto group = [&](const char* name, const std::vector<std::size_t>& positions) {
      return positions.empty() ? "" : fmt::format("  <{0}>\n{1}  </{0}>\n", name, list(positions, "Unknown", "index"));
    };
    text += group("Outputs", outputs) + group("Derivatives", derivatives) + group("InitialUnknowns", unknowns);
  }
  return text + "  </ModelStructure>\n";
}

}  // namespace

std::string model_identifier(const LinearSystem& system) {
  constexpr std::size_t longest = 60;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string identifier;
  for (const char character : system.title.substr(0, longest)) {
    if (is_letter(character) || is_digit(character)) identifier += character;
    else if (!identifier.empty() && identifier.back() != '_') identifier += '_';
  }
  if (identifier.ends_with('_')) identifier.pop_back();
  if (identifier.empty()) return "trivet_system";
  return is_letter(identifier.front()) ? identifier : "trivet_" + identifier;
}

std::string model_description(const LinearSystem& system, FmiVersion version, const std::string& token) {
  check(system);
  const std::vector<UnitVariable> variables = unit_variables(system);
  const std::size_t shift = version == FmiVersion::two ? 1 : 0;  // version 2.0 counts the variables from 1
  return heading(system, version, token) + kinds(system, version) + unit_definitions(variables) + log_categories() +
      model_variables(variables, version, shift) + model_structure(system, variables, version, shift) +
      "</fmiModelDescription>\n";
}

}  // namespace trivet::exports
