// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/workbook_sheets.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/exports/unique_names.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/document.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::exports {
namespace {

using results::DisplayUnit;
using results::LabelledArray;
using results::LabelledArrays;

/// A name that Excel accepts: at most 31 characters without []:*?/\, unique.
std::string sheet_name(std::string name, UniqueNames& used) {
  constexpr std::size_t longest = 28;
  for (char& c : name)
    if (std::string("[]:*?/\\'").find(c) != std::string::npos) c = ' ';
  return used.unique(foundation::shortened(name, longest));
}

/// The units of the rows of an axis, if they differ.
const LabelledArray* units_of_rows(const LabelledArrays& all, const std::string& axis) {
  const LabelledArray* own = all.find(axis + ".unit");
  if (own) return own;
  const LabelledArray* plain = all.find("unit");
  return plain && plain->is_text() && plain->axes.front() == axis ? plain : nullptr;
}

DisplayUnit shown_unit_of(const LabelledArray& array, const std::string& si_unit,
                          const project::DisplayUnits& display) {
  return array.harmonic ? results::amplitude_unit_of_data(display, si_unit) : results::display_unit(display, si_unit);
}

/// Unit of a whole column of real numbers, or of a single one. A number in rad/s is a frequency, except in time and
/// over shaft speed.
DisplayUnit unit_of_column(const LabelledArray& array, const project::DisplayUnits& display) {
  const std::string axis = array.axes.empty() ? "" : array.axes.front();
  if (array.unit != "rad/s" || array.harmonic || axis == "time" || (axis == "speed" && array.name != "speed"))
    return shown_unit_of(array, array.unit, display);
  if (array.name == "angular_frequency") return {array.unit};
  return {results::frequency_unit(display, "rad/s"), "", results::shown_frequency(display, 1, "rad/s")};
}

std::vector<std::string> shown_texts(const LabelledArray& array, const LabelledArrays& all,
                                     const project::DisplayUnits& display) {
  std::vector<std::string> texts = array.texts();
  if (&array == units_of_rows(all, array.axes.front()))
    for (std::string& unit : texts) unit = shown_unit_of(array, unit, display).label();
  return texts;
}

void add_real_column(const LabelledArray& array, const LabelledArrays& all, const project::DisplayUnits& display,
                     Sheet& sheet) {
  const DisplayUnit whole = unit_of_column(array, display);
  const LabelledArray* units =
      array.unit.starts_with(results::unit_of_the_row) ? units_of_rows(all, array.axes.front()) : nullptr;
  std::vector<double> numbers = array.real_numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] *= units ? shown_unit_of(array, units->texts()[i], display).factor : whole.factor;
  const std::string name = array.unit == "rad/s" ? results::name_in_unit(array.name, whole.label()) : array.name;
  sheet.columns.push_back({name, units ? array.unit : whole.label(), std::move(numbers), {}});
  if (array.name != "angular_frequency") return;
  std::vector<double> frequencies;
  for (const double omega : array.real_numbers()) frequencies.push_back(results::shown_frequency(display, omega));
  sheet.columns.push_back({"frequency", results::frequency_unit(display), std::move(frequencies), {}});
}

void add_column(const LabelledArray& array, const LabelledArrays& all, const project::DisplayUnits& display,
                Sheet& sheet) {
  if (array.is_text()) {
    sheet.columns.push_back({array.name, "", {}, shown_texts(array, all, display)});
    return;
  }
  if (!array.is_complex()) {
    add_real_column(array, all, display, sheet);
    return;
  }
  const DisplayUnit unit = shown_unit_of(array, array.unit, display);
  SheetColumn amplitude{array.name + " amplitude", unit.label(), {}, {}}, phase{array.name + " phase", "°", {}, {}};
  for (const std::complex<double>& value : array.complex_numbers()) {
    amplitude.numbers.push_back(std::abs(value) * unit.factor);
    phase.numbers.push_back(std::arg(value) * 360 / foundation::two_pi);
  }
  sheet.columns.push_back(std::move(amplitude));
  sheet.columns.push_back(std::move(phase));
}

bool is_charted(const std::string& axis) { return axis == "angular_frequency" || axis == "time" || axis == "speed"; }

/// The axis of the rows: that of a curve if there is one, else the first.
std::size_t axis_of_rows(const LabelledArray& array) { return array.axes.size() == 2 && is_charted(array.axes[1]); }

/// What distinguishes the columns of a matrix: names or numbers of their axis.
std::string column_label(const LabelledArray* coordinates, std::size_t j) {
  if (!coordinates) return fmt::format("{}", j + 1);
  if (coordinates->is_text()) return coordinates->texts()[j];
  return fmt::format("{:.6g} {}", coordinates->real_numbers()[j], coordinates->unit);
}

/// A part of a matrix as an array of one axis; it holds its numbers.
template <typename Number>
LabelledArray part(const LabelledArray& array, const std::vector<Number>& numbers, std::size_t rows, std::size_t j) {
  auto held = std::make_shared<std::vector<Number>>();
  for (std::size_t i = 0; i < array.shape[rows]; ++i)
    held->push_back(numbers[rows == 0 ? i * array.shape[1] + j : j * array.shape[1] + i]);
  return {array.name, array.unit, {array.axes[rows]}, {held->size()}, {1}, held->data(), held};
}

/// A column, or two if it is complex, for each entry of the other axis: "shape machine.x".
void add_matrix(const LabelledArray& array, const LabelledArrays& all, const project::DisplayUnits& display,
                Sheet& sheet) {
  const std::size_t rows = axis_of_rows(array), columns = 1 - rows;
  const LabelledArray* labels = all.find(array.axes[columns]);
  const LabelledArray* units =
      array.unit.starts_with(results::unit_of_the_row) ? units_of_rows(all, array.axes[columns]) : nullptr;
  const std::vector<double> real = array.is_complex() ? std::vector<double>() : array.real_numbers();
  const std::vector<std::complex<double>> both =
      array.is_complex() ? array.complex_numbers() : std::vector<std::complex<double>>();
  for (std::size_t j = 0; j < array.shape[columns]; ++j) {
    LabelledArray column = array.is_complex() ? part(array, both, rows, j) : part(array, real, rows, j);
    column.name += " " + column_label(labels, j);
    column.harmonic = array.harmonic;
    if (units) column.unit = units->texts()[j];
    add_column(column, all, display, sheet);
  }
}

/// Numbers and words without an axis.
Sheet sheet_of_values(const Group& group, const project::DisplayUnits& display) {
  Sheet sheet{"", {{"name", "", {}, {}}, {"value", "", {}, {}}, {"unit", "", {}, {}}}, false};
  for (const LabelledArray& array : group.arrays.list()) {
    if (!array.axes.empty() || array.is_text() || array.is_complex()) continue;
    const DisplayUnit unit = unit_of_column(array, display);
    sheet.columns[0].texts.push_back(array.name);
    sheet.columns[1].numbers.push_back(array.real_numbers().front() * unit.factor);
    sheet.columns[2].texts.push_back(unit.label());
  }
  return sheet;
}

/// Is it shown by the column that "angular_frequency" has beside it, in the unit of the display?
bool is_frequency_again(const LabelledArray& array, const LabelledArrays& all) {
  const LabelledArray* omega = all.find("angular_frequency");
  return array.name == "frequency" && omega && omega->axes == array.axes;
}

/// One sheet for each axis of a group; phases of a response are beside its amplitudes.
void add_sheets(const Group& group, const project::DisplayUnits& display, UniqueNames& used, std::vector<Sheet>& sheets,
                std::vector<std::string>& lost) {
  std::vector<std::pair<std::string, Sheet>> by_axis;
  for (const LabelledArray& array : group.arrays.list()) {
    if (array.axes.empty() || is_frequency_again(array, group.arrays)) continue;
    if (array.axes.size() > 2 || (array.axes.size() == 2 && array.is_text())) {
      lost.push_back(fmt::format("{}: {} is left out: no sheet holds {}", group.name, array.name,
                                 array.is_text() ? "a table of words" : "more than two axes"));
      continue;
    }
    const bool of_curve = array.name.ends_with(" phase") &&
        group.arrays.find(array.name.substr(0, array.name.size() - std::string(" phase").size()));
    if (of_curve) continue;
    const std::string& axis = array.axes[axis_of_rows(array)];
    auto found = std::ranges::find_if(by_axis, [&](const auto& one) { return one.first == axis; });
    if (found == by_axis.end()) {
      by_axis.push_back({axis, {}});
      found = by_axis.end() - 1;
    }
    if (array.axes.size() == 1) add_column(array, group.arrays, display, found->second);
    else add_matrix(array, group.arrays, display, found->second);
  }
  bool first = true;
  for (auto& [axis, sheet] : by_axis) {
    const bool only_names = sheet.columns.size() == 1 && by_axis.size() > 1;
    if (only_names) continue;
    sheet.name = sheet_name(std::exchange(first, false) ? group.name : group.name + " " + axis, used);
    sheet.charted = is_charted(axis);
    sheets.push_back(std::move(sheet));
  }
  Sheet values = sheet_of_values(group, display);
  if (values.columns[0].texts.empty()) return;
  values.name = sheet_name(group.name + " values", used);
  sheets.push_back(std::move(values));
}

Sheet input_sheet(const Content& content, UniqueNames& used) {
  Sheet sheet{sheet_name("input", used), {{"key", "", {}, {}}, {"value", "", {}, {}}}, false};
  sheet.columns[0].texts = {"source"};
  sheet.columns[1].texts = {content.words()};
  for (const std::string& setting : project::setting_words({content.variant.written})) {
    const std::size_t equals = setting.find(" = ");
    sheet.columns[0].texts.push_back(setting.substr(0, equals));
    sheet.columns[1].texts.push_back(setting.substr(equals + 3));
  }
  return sheet;
}

/// The requirements of the case with their margins, if it has some.
void add_verdict(const Content& content, const foundation::Progress& progress, UniqueNames& used,
                 std::vector<Sheet>& sheets) {
  const study::CaseVerdict judged =
      study::case_verdict(content.variant, study::cases_to_hold(content.project), progress);
  if (judged.results.empty()) return;
  Sheet sheet{sheet_name("requirements", used),
              {{"requirement", "", {}, {}},
               {"unit", "", {}, {}},
               {"allowed", "", {}, {}},
               {"value", "", {}, {}},
               {"margin", "", {}, {}},
               {"verdict", "", {}, {}},
               {"reason", "", {}, {}}},
              false};
  for (const study::RequirementResult& result : judged.results) {
    const DisplayUnit unit = results::requirement_unit(result, judged.display);
    sheet.columns[0].texts.push_back(results::requirement_words(result, judged.display));
    sheet.columns[1].texts.push_back(unit.label());
    sheet.columns[2].numbers.push_back(result.allowed * unit.factor);
    sheet.columns[3].numbers.push_back(result.value.value_or(results::nothing) * unit.factor);
    sheet.columns[4].numbers.push_back(result.value ? result.margin : results::nothing);
    sheet.columns[5].texts.push_back(results::verdict_word(result));
    sheet.columns[6].texts.push_back(result.reason);
  }
  sheets.push_back(std::move(sheet));
}

}  // namespace

std::vector<Sheet> workbook_sheets(const Content& content, const foundation::Progress& progress,
                                   std::vector<std::string>& lost) {
  UniqueNames used(" ");
  used.unique(sheet_of_charts);
  std::vector<Sheet> sheets = {input_sheet(content, used)};
  add_verdict(content, progress, used, sheets);
  for (const Group& group : content.groups)
    add_sheets(group, group.name == "matrices" ? project::DisplayUnits() : content.variant.display, used, sheets, lost);
  return sheets;
}

}  // namespace trivet::exports
