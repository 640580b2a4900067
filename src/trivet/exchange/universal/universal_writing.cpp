// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_writing.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_lines.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::exchange {
namespace {

constexpr int label_width = 10, date_field_width = 10, color_of_all = 1;
constexpr std::size_t labels_per_line = 8, largest_line_nodes = 250;

/// "28-Jan-21 14:01:42" in two fields of ten characters; NONE for an empty one: some programs cannot read blank dates.
std::string date_fields(std::string_view date_and_time) {
  const auto parts = blank_separated(date_and_time);
  const auto part = [&](std::size_t i) -> std::string_view {
    if (parts.empty() && i == 0) return "NONE";
    return i < parts.size() ? parts[i].substr(0, date_field_width) : "";
  };
  return fmt::format("{:<{}}{:<{}}", part(0), date_field_width, part(1), date_field_width);
}

std::string header_set(const UniversalHeader& header) {
  return opening_lines(151) + text_line(header.model) + text_line(header.description) +
      text_line(header.database_program) + date_fields(header.created) + fmt::format("{:10d}{:10d}{:10d}\n", 0, 0, 0) +
      date_fields(header.saved) + "\n" + text_line(header.program) + date_fields(header.written) + "\n" +
      closing_line_of_set();
}

/// Unit factors of SI, and the offset between kelvin and degrees Celsius.
std::string si_units_set() {
  return opening_lines(164) + fmt::format("{:10d}{:<20}{:10d}\n", 1, "Meter (newton)", 2) +
      "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
      "  2.73150000000000000D+02\n" +
      closing_line_of_set();
}

std::string node_set(const std::vector<UniversalNode>& nodes) {
  std::string text = opening_lines(15);
  for (const UniversalNode& node : nodes) {
    text += whole_field(node.label, label_width, "node") +
        whole_field(node.definition_system, label_width, "coordinate system") +
        whole_field(node.displacement_system, label_width, "coordinate system") + fmt::format("{:10d}", color_of_all);
    for (int i = 0; i < 3; ++i) {
      require_finite(node.position[i], "a coordinate of a node");
      text += single_field(node.position[i]);
    }
    text += '\n';
  }
  return text + closing_line_of_set();
}

std::string line_set(const UniversalLine& line) {
  if (line.nodes.size() > largest_line_nodes)
    throw foundation::InvalidInput(fmt::format("line {} has {} nodes, at most {} are possible", line.number,
                                               line.nodes.size(), largest_line_nodes));
  std::string text = opening_lines(82) + whole_field(line.number, label_width, "line") +
      fmt::format("{:10d}{:10d}\n", line.nodes.size(), color_of_all) + text_line(line.name);
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    text += whole_field(line.nodes[i], label_width, "node");
    if ((i + 1) % labels_per_line == 0 || i + 1 == line.nodes.size()) text += '\n';
  }
  return text + closing_line_of_set();
}

/// Analysis type and parameters of records 6, 7 and 8.
struct WrittenParameters {
  int analysis = 2;
  std::vector<double> numbers;
};

WrittenParameters written_parameters(const UniversalMode& mode) {
  if (const auto* normal = std::get_if<UniversalNormalMode>(&mode.parameters))
    return {2, {normal->frequency_hz, normal->modal_mass, normal->damping_ratio, normal->hysteretic_damping}};
  const auto& complex = std::get<UniversalComplexMode>(mode.parameters);
  return {complex.second_order ? 7 : 3,
          {complex.eigenvalue.real(), complex.eigenvalue.imag(), complex.modal_a.real(), complex.modal_a.imag(),
           complex.modal_b.real(), complex.modal_b.imag()}};
}

std::string node_motion(const UniversalNodeMotion& motion, const UniversalMode& mode) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < (mode.has_rotations ? 6 : 3); ++i) {
    numbers.push_back(motion.components[i].real());
    if (mode.is_complex) numbers.push_back(motion.components[i].imag());
  }
  for (const double number : numbers) require_finite(number, "a mode shape");
  return whole_field(motion.node, label_width, "node") + "\n" + single_lines(numbers);
}

std::string mode_set(const UniversalMode& mode) {
  if (mode.in_file_units) throw foundation::InvalidInput(fmt::format("mode {} is not in SI", mode.number));
  std::string text = opening_lines(55);
  for (const std::string& id : mode.ids) text += text_line(id);
  const WrittenParameters parameters = written_parameters(mode);
  for (const double number : parameters.numbers) require_finite(number, "a parameter of a mode");
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n", 1, parameters.analysis, mode.has_rotations ? 3 : 2,
                      static_cast<int>(mode.quantity), mode.is_complex ? 5 : 2, mode.has_rotations ? 6 : 3);
  text += fmt::format("{:10d}{:10d}", 2, parameters.numbers.size()) +
      whole_field(mode.load_case, label_width, "load case") + whole_field(mode.number, label_width, "mode") + "\n";
  text += single_lines(parameters.numbers);
  for (const UniversalNodeMotion& motion : mode.nodes) text += node_motion(motion, mode);
  return text + closing_line_of_set();
}

}  // namespace

std::string universal_text(const UniversalFile& file, FunctionForm form) {
  std::string text = header_set(file.header) + si_units_set();
  if (!file.nodes.empty()) text += node_set(file.nodes);
  for (const UniversalLine& line : file.lines) text += line_set(line);
  for (const UniversalMode& mode : file.modes) text += mode_set(mode);
  for (const UniversalFunction& function : file.functions) {
    const bool binary = form == FunctionForm::binary;
    require_writable(function, binary);
    text += function_set(function, binary);
  }
  return text;
}

}  // namespace trivet::exchange
