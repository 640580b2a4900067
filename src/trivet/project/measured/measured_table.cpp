// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured/measured_file.h"
#include "trivet/project/text/csv_table.h"

namespace trivet::project {
namespace {

constexpr const char* measured_columns =
    "columns are frequency [Hz] or angular_frequency [rad/s], then NAME re [unit] and NAME im [unit], or NAME "
    "amplitude [unit] and NAME phase [deg], and perhaps NAME coherence";
constexpr std::array<const char*, 5> column_parts = {"re", "im", "amplitude", "phase", "coherence"};

/// "machine.z re [m/N]" in its parts.
struct Heading {
  std::string name, part, unit;
};

Heading heading_of(std::string column) {
  Heading heading;
  if (const std::size_t open = column.rfind('['); open != std::string::npos && column.ends_with("]")) {
    heading.unit = column.substr(open + 1, column.size() - open - 2);
    column.resize(open);
  }
  while (!column.empty() && column.back() == ' ') column.pop_back();
  const std::size_t blank = column.rfind(' ');
  if (blank == std::string::npos) return heading.name = column, heading;
  heading.name = column.substr(0, blank);
  heading.part = column.substr(blank + 1);
  return heading;
}

/// Columns of one function; −1: it has no such column.
struct FunctionColumns {
  std::string name, unit;
  std::array<Eigen::Index, column_parts.size()> parts;

  [[nodiscard]] bool is_cartesian() const { return parts[0] >= 0; }
  [[nodiscard]] bool is_complete() const {
    return (parts[0] >= 0 && parts[1] >= 0) || (parts[2] >= 0 && parts[3] >= 0);
  }
};

/// Factor of the first column to rad/s; none if it is not a frequency.
std::optional<double> frequency_factor(const std::string& column) {
  const Heading heading = heading_of(column);
  if (column == "frequency_hz") return to_si("1 Hz", Quantity::angular_frequency).value();
  if (heading.name != "frequency" && heading.name != "angular_frequency") return std::nullopt;
  const auto factor = to_si("1 " + heading.unit, Quantity::angular_frequency);
  return factor ? std::optional(*factor) : std::nullopt;
}

std::vector<FunctionColumns> function_columns(const CsvTable& table, foundation::Problems& found) {
  std::vector<FunctionColumns> all;
  for (std::size_t c = 1; c < table.columns.size(); ++c) {
    const Heading heading = heading_of(table.columns[c]);
    const auto part = std::ranges::find(column_parts, heading.part);
    if (part == column_parts.end()) {
      found.error("", "column " + foundation::quoted(table.columns[c]), measured_columns, "rename or remove it");
      continue;
    }
    auto known = std::ranges::find_if(all, [&](const auto& one) { return one.name == heading.name; });
    if (known == all.end()) {
      FunctionColumns added{heading.name, "", {}};
      added.parts.fill(-1);
      known = all.insert(all.end(), added);
    }
    known->parts[part - column_parts.begin()] = to_index(c);
    if (heading.part == "re" || heading.part == "amplitude") known->unit = heading.unit;
    if (heading.part == "im" && heading.unit != known->unit)
      found.error("", fmt::format("column {}: its unit is \"{}\"", foundation::quoted(table.columns[c]), heading.unit),
                  fmt::format("real and imaginary part have one unit, here \"{}\"", known->unit),
                  "put \"re\" first and convert the numbers of \"im\"");
  }
  for (const FunctionColumns& one : all)
    if (!one.is_complete())
      found.error("", "columns of " + foundation::quoted(one.name), measured_columns,
                  "add the part that is missing: an amplitude without a phase is not enough");
  return all;
}

void check_frequencies(const CsvTable& table, foundation::Problems& found) {
  for (Eigen::Index i = 0; i < table.values.rows(); ++i) {
    const double frequency = table.values(i, 0);
    if (frequency >= 0 && (i == 0 || frequency > table.values(i - 1, 0))) continue;
    found
        .error("", fmt::format("{} = {:.6g}", table.columns.front(), frequency),
               "frequencies are ≥ 0 and increase from row to row", "sort or correct the rows")
        .origin = {table.source, table.lines[i]};
    return;
  }
}

std::complex<double> value_in_row(const CsvTable& table, const FunctionColumns& columns, double angle,
                                  Eigen::Index row) {
  const auto cell = [&](std::size_t part) { return table.values(row, columns.parts[part]); };
  if (columns.is_cartesian()) return {cell(0), cell(1)};
  const double phase = angle * cell(3);
  return {cell(2) * std::cos(phase), cell(2) * std::sin(phase)};
}

/// Factor of the phase to radians.
double phase_factor(const CsvTable& table, const FunctionColumns& columns, foundation::Problems& found) {
  if (columns.is_cartesian()) return 1;
  const std::string& column = table.columns[columns.parts[3]];
  const auto factor = to_si("1 " + heading_of(column).unit, Quantity::angle);
  if (!factor)
    found.error("", "column " + foundation::quoted(column), "a phase has the unit deg or rad",
                "write it in brackets: " + columns.name + " phase [deg]");
  return factor.value_or(1);
}

void check_coherences(const CsvTable& table, const FunctionColumns& columns, foundation::Problems& found) {
  for (Eigen::Index i = 0; i < table.values.rows(); ++i) {
    const double value = table.values(i, columns.parts[4]);
    if (std::isnan(value) || is_coherence(value)) continue;
    found
        .error("", fmt::format("{} = {:.6g}", table.columns[columns.parts[4]], value), "a coherence is between 0 and 1",
               "correct it; divide a coherence in percent by 100")
        .origin = {table.source, table.lines[i]};
    return;
  }
}

/// Unit of the columns of a function: that of the heading, or that of the project; none with an error.
std::optional<MeasuredUnit> unit_of_columns(const FunctionColumns& columns, const GivenUnits& given,
                                            foundation::Problems& found) {
  const std::string name = foundation::quoted(columns.name);
  if (!columns.unit.empty()) {
    const auto unit = measured_unit(columns.unit);
    if (!unit)
      found.error("", fmt::format("column of {}: \"{}\"", name, columns.unit),
                  "this is no unit of a motion or a force, perhaps per force; levels such as rms and dB are no units",
                  "write zero-to-peak amplitudes and for instance [mm/N]");
    return unit;
  }
  if (given.size() < 2) return given.empty() ? std::nullopt : std::optional(given.front());
  found.error("", fmt::format("column of {} has no unit, and the project several", name),
              "several units are for universal files, whose axes state the quantity",
              "write the unit in the heading: NAME re [unit]");
  return std::nullopt;
}

/// `unit` of the project is for columns without one.
void judge_idle_unit(const std::vector<FunctionColumns>& columns, const GivenUnits& given,
                     foundation::Problems& found) {
  if (given.empty() || columns.empty()) return;
  if (std::ranges::any_of(columns, [](const FunctionColumns& one) { return one.unit.empty(); })) return;
  found.warning("", fmt::format("column of {}: [{}]", foundation::quoted(columns.front().name), columns.front().unit),
                "the unit in the heading holds, `unit` of the measurement is for columns without one",
                "remove one of them");
}

MeasuredFunction function_of(const CsvTable& table, const FunctionColumns& columns, double to_radians_per_second,
                             const GivenUnits& given, bool with_coherence, foundation::Problems& found) {
  MeasuredFunction result;
  const bool coherent = with_coherence && columns.parts[4] >= 0;
  if (coherent) check_coherences(table, columns, found);
  result.name = columns.name;
  result.texts = {columns.name};
  result.unit = unit_of_columns(columns, given, found);
  const double factor = result.unit ? result.unit->factor : 1, angle = phase_factor(table, columns, found);
  std::vector<std::complex<double>> values;
  std::vector<double> coherence;
  for (Eigen::Index i = 0; i < table.values.rows(); ++i) {
    const std::complex<double> value = factor * value_in_row(table, columns, angle, i);
    if (!(table.values(i, 0) > 0) || !std::isfinite(std::abs(value))) continue;
    if (coherent && std::isnan(table.values(i, columns.parts[4]))) continue;
    result.angular_frequency.push_back(to_radians_per_second * table.values(i, 0));
    values.push_back(value);
    if (coherent) coherence.push_back(table.values(i, columns.parts[4]));
  }
  result.value = Eigen::Map<const Eigen::VectorXcd>(values.data(), to_index(values.size()));
  result.coherence = Eigen::Map<const Eigen::VectorXd>(coherence.data(), to_index(coherence.size()));
  return result;
}

}  // namespace

foundation::Expected<MeasuredFile> read_measured_table(const std::filesystem::path& path, const GivenUnits& units,
                                                       bool with_coherence) {
  const auto table = read_csv_table(path);
  if (!table) return tl::make_unexpected(table.error());
  foundation::Problems found;
  const auto factor = frequency_factor(table->columns.front());
  if (!factor)
    found.error("", "first column " + foundation::quoted(table->columns.front()), measured_columns,
                "begin the heading with frequency [Hz]");
  else check_frequencies(*table, found);
  const std::vector<FunctionColumns> columns = function_columns(*table, found);
  if (found.has_errors()) return tl::make_unexpected(std::move(found));
  MeasuredFile result;
  result.warnings = table->warnings;
  for (const FunctionColumns& one : columns)
    result.functions.push_back(function_of(*table, one, *factor, units, with_coherence, found));
  if (found.has_errors()) return tl::make_unexpected(std::move(found));
  judge_idle_unit(columns, units, result.warnings);
  return result;
}

bool is_coherence(double value) {
  constexpr double rounding = 1e-5;  // of six digits in a text
  return value >= -rounding && value <= 1 + rounding;
}

foundation::Expected<MeasuredFile> read_measured_file(const std::filesystem::path& path, const GivenUnits& units,
                                                      bool with_coherence) {
  auto file = path.extension() == ".csv" ? read_measured_table(path, units, with_coherence)
                                         : read_measured_universal(path, units, with_coherence);
  if (!file || !with_coherence) return file;
  if (std::ranges::none_of(file->functions,
                           [](const MeasuredFunction& function) { return function.coherence.size() > 0; })) {
    foundation::Problems found;
    found.error("", "no coherence",
                "coherence = true needs functions of type 6 at the points of the others, or columns "
                "NAME coherence",
                "remove the key, or add them to the file");
    return tl::make_unexpected(std::move(found));
  }
  return file;
}

}  // namespace trivet::project
