// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "trivet/exports/format_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/toml_value.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"
#include "trivet/results/verdict_words.h"
#include "trivet/study/verdict.h"

/// Excel: the input, the requirements with their margins, a sheet for each list of rows, and native charts of curves.
namespace trivet::exports {
namespace {

using results::DisplayUnit;
using results::LabelledArray;
using results::LabelledArrays;

constexpr std::size_t most_rows = 1'048'575, most_columns = 16'384;

struct SheetColumn {
  std::string heading;
  std::string unit;
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< instead of numbers
};

/// A sheet with columns of one length.
struct Sheet {
  std::string name;
  std::vector<SheetColumn> columns;
  bool charted = false;  ///< amplitudes over a frequency, or results over time or speed
};

/// A name that Excel accepts: at most 31 characters without []:*?/\, unique.
std::string sheet_name(std::string name, std::set<std::string>& used) {
  constexpr std::size_t longest = 28;
  for (char& c : name)
    if (std::string("[]:*?/\\'").find(c) != std::string::npos) c = ' ';
  if (name.size() > longest) name.resize(longest);
  std::string unique = name;
  for (int i = 2; !used.insert(unique).second; ++i) unique = fmt::format("{} {}", name, i);
  return unique;
}

/// The units of the rows of an axis, if they differ.
const LabelledArray* units_of_rows(const LabelledArrays& all, const std::string& axis) {
  const LabelledArray* own = all.find(axis + ".unit");
  if (own) return own;
  const LabelledArray* plain = all.find("unit");
  return plain && plain->is_text() && plain->axes.front() == axis ? plain : nullptr;
}

/// Are the numbers with the unit of their row amplitudes of harmonic quantities?
bool is_harmonic(const Group& group, const std::string& axis) {
  return group.name == "peaks" || (group.name == "measurements" && axis == "peak") || axis == "limit" ||
      axis == "critical_speed";
}

DisplayUnit unit_of_row(const Group& group, const std::string& axis, const std::string& si_unit,
                        const project::ShownUnits& display) {
  return is_harmonic(group, axis) ? results::amplitude_unit(display, si_unit) : results::display_unit(display, si_unit);
}

/// Unit of a whole column of real numbers. A number in rad/s is a frequency, except in time and over shaft speed.
DisplayUnit unit_of_column(const LabelledArray& array, const project::ShownUnits& display) {
  if (array.unit != "rad/s" || array.axes.front() == "time" || (array.axes.front() == "speed" && array.name != "speed"))
    return results::display_unit(display, array.unit);
  if (array.name == "angular_frequency") return {array.unit};
  return {results::frequency_unit(display, "rad/s"), "", results::shown_frequency(display, 1, "rad/s")};
}

std::vector<std::string> shown_texts(const LabelledArray& array, const Group& group,
                                     const project::ShownUnits& display) {
  std::vector<std::string> texts = array.texts();
  if (&array == units_of_rows(group.arrays, array.axes.front()))
    for (std::string& unit : texts) unit = unit_of_row(group, array.axes.front(), unit, display).label();
  return texts;
}

void add_real_column(const LabelledArray& array, const Group& group, const project::ShownUnits& display, Sheet& sheet) {
  const DisplayUnit whole = unit_of_column(array, display);
  const LabelledArray* units =
      array.unit.starts_with(results::unit_of_the_row) ? units_of_rows(group.arrays, array.axes.front()) : nullptr;
  std::vector<double> numbers = array.real_numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] *= units ? unit_of_row(group, array.axes.front(), units->texts()[i], display).factor : whole.factor;
  sheet.columns.push_back({array.name, whole.label(), std::move(numbers), {}});
  if (array.name != "angular_frequency") return;
  std::vector<double> frequencies;
  for (const double omega : array.real_numbers()) frequencies.push_back(results::shown_frequency(display, omega));
  sheet.columns.push_back({"frequency", results::frequency_unit(display), std::move(frequencies), {}});
}

void add_column(const LabelledArray& array, const Group& group, const project::ShownUnits& display, Sheet& sheet) {
  if (array.is_text()) {
    sheet.columns.push_back({array.name, "", {}, shown_texts(array, group, display)});
    return;
  }
  if (!array.is_complex()) {
    add_real_column(array, group, display, sheet);
    return;
  }
  const DisplayUnit unit = results::amplitude_unit(display, array.unit);
  SheetColumn amplitude{array.name + " amplitude", unit.label(), {}, {}}, phase{array.name + " phase", "°", {}, {}};
  for (const std::complex<double>& value : array.complex_numbers()) {
    amplitude.numbers.push_back(std::abs(value) * unit.factor);
    phase.numbers.push_back(std::arg(value) * 360 / foundation::two_pi);
  }
  sheet.columns.push_back(std::move(amplitude));
  sheet.columns.push_back(std::move(phase));
}

/// A column for each entry of the second axis: "shape machine.x".
void add_matrix(const LabelledArray& array, const LabelledArrays& all, Sheet& sheet) {
  const LabelledArray* labels = all.find(array.axes[1]);
  const std::vector<double> numbers = array.real_numbers();
  const std::size_t columns = array.shape[1];
  for (std::size_t j = 0; j < columns; ++j) {
    const std::string label = labels && labels->is_text() ? labels->texts()[j] : fmt::format("{}", j + 1);
    SheetColumn column{array.name + " " + label, array.unit, {}, {}};
    for (std::size_t i = 0; i < array.shape[0]; ++i) column.numbers.push_back(numbers[i * columns + j]);
    sheet.columns.push_back(std::move(column));
  }
}

bool is_charted(const std::string& axis) { return axis == "angular_frequency" || axis == "time" || axis == "speed"; }

/// One sheet for each axis of a group; phases of a response are beside its amplitudes.
void add_sheets(const Group& group, const project::ShownUnits& display, std::set<std::string>& used,
                std::vector<Sheet>& sheets, std::vector<std::string>& lost) {
  std::vector<std::pair<std::string, Sheet>> by_axis;
  for (const LabelledArray& array : group.arrays.list()) {
    if (array.axes.empty() || array.axes.size() > 2 || (array.axes.size() == 2 && array.is_complex())) {
      if (array.axes.size() > 1)
        lost.push_back(fmt::format("{}: {} has too many axes for a sheet", group.name, array.name));
      continue;
    }
    const bool of_curve = array.name.ends_with(" phase") &&
        group.arrays.find(array.name.substr(0, array.name.size() - std::string(" phase").size()));
    if (of_curve) continue;
    auto found =
        std::find_if(by_axis.begin(), by_axis.end(), [&](const auto& one) { return one.first == array.axes[0]; });
    if (found == by_axis.end()) {
      by_axis.push_back({array.axes[0], {}});
      found = by_axis.end() - 1;
    }
    if (array.axes.size() == 1) add_column(array, group, display, found->second);
    else add_matrix(array, group.arrays, found->second);
  }
  for (auto& [axis, sheet] : by_axis) {
    const bool only_names = sheet.columns.size() == 1 && by_axis.size() > 1;
    if (only_names) continue;
    sheet.name =
        sheet_name(by_axis.size() == 1 || &axis == &by_axis.front().first ? group.name : group.name + " " + axis, used);
    sheet.charted = is_charted(axis);
    sheets.push_back(std::move(sheet));
  }
}

Sheet input_sheet(const Content& content, std::set<std::string>& used) {
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

/// The requirements of the project with their margins, if it has some.
void add_verdict(const Content& content, std::set<std::string>& used, std::vector<Sheet>& sheets) {
  study::Verdict verdict;
  try {
    verdict = study::verdict(content.project);
  } catch (const foundation::InvalidInput&) {
    return;  // the project requires nothing
  }
  Sheet sheet{sheet_name("requirements", used),
              {{"case", "", {}, {}},
               {"requirement", "", {}, {}},
               {"unit", "", {}, {}},
               {"allowed", "", {}, {}},
               {"value", "", {}, {}},
               {"margin", "", {}, {}},
               {"verdict", "", {}, {}}},
              false};
  for (const study::CaseVerdict& judged : verdict.cases)
    for (const study::RequirementResult& result : judged.results) {
      sheet.columns[0].texts.push_back(judged.case_name.empty() ? "base model" : judged.case_name);
      const DisplayUnit unit = results::requirement_unit(result, judged.display);
      sheet.columns[1].texts.push_back(results::requirement_words(result, judged.display));
      sheet.columns[2].texts.push_back(unit.label());
      sheet.columns[3].numbers.push_back(result.allowed * unit.factor);
      sheet.columns[4].numbers.push_back(result.value.value_or(results::nothing) * unit.factor);
      sheet.columns[5].numbers.push_back(result.margin);
      sheet.columns[6].texts.emplace_back(result.met() ? "met" : "NOT MET");
    }
  sheets.push_back(std::move(sheet));
}

struct CellFormats {
  lxw_format* heading;
  lxw_format* number;
};

std::size_t length(const SheetColumn& column) {
  return column.texts.empty() ? column.numbers.size() : column.texts.size();
}

void write_sheet(lxw_workbook* book, const Sheet& sheet, const CellFormats& formats, std::vector<std::string>& lost) {
  lxw_worksheet* const page = workbook_add_worksheet(book, sheet.name.c_str());
  const std::size_t columns = std::min(sheet.columns.size(), most_columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const SheetColumn& column = sheet.columns[c];
    const auto at = static_cast<lxw_col_t>(c);
    const std::string heading = column.heading + (column.unit.empty() ? "" : " [" + column.unit + "]");
    worksheet_write_string(page, 0, at, heading.c_str(), formats.heading);
    const std::size_t rows = std::min(length(column), most_rows);
    if (rows < length(column)) lost.push_back(fmt::format("{}: rows after {} do not fit", sheet.name, most_rows));
    for (std::size_t r = 0; r < rows; ++r) {
      const auto row = static_cast<lxw_row_t>(r + 1);
      if (!column.texts.empty()) worksheet_write_string(page, row, at, column.texts[r].c_str(), nullptr);
      else if (std::isfinite(column.numbers[r]))
        worksheet_write_number(page, row, at, column.numbers[r], formats.number);
      else if (std::isinf(column.numbers[r])) worksheet_write_string(page, row, at, "infinite", nullptr);
    }
    std::size_t width = heading.size();
    for (const std::string& text : column.texts) width = std::max(width, std::min<std::size_t>(text.size(), 60));
    worksheet_set_column(page, at, at, static_cast<double>(std::max<std::size_t>(width + 1, 11)), nullptr);
  }
  worksheet_freeze_panes(page, 1, 1);
}

constexpr std::array<int, 6> colours = {0x0072B2, 0xD55E00, 0x009E73,
                                        0xCC79A7, 0x000000, 0xE69F00};  // as in the report

/// Charts of the curves of a sheet, one for each unit.
void add_charts(lxw_workbook* book, lxw_worksheet* page, const Sheet& sheet, int& row) {
  const bool harmonic = sheet.columns.size() > 1 && sheet.columns[1].heading == "frequency";
  const std::size_t x = harmonic ? 1 : 0;
  std::map<std::string, std::vector<std::size_t>> by_unit;
  for (std::size_t c = x + 1; c < std::min(sheet.columns.size(), most_columns); ++c)
    if (sheet.columns[c].texts.empty() && sheet.columns[c].unit != "°" &&
        length(sheet.columns[c]) == length(sheet.columns[x]))
      by_unit[sheet.columns[c].unit].push_back(c);
  const auto last = static_cast<lxw_row_t>(std::min(length(sheet.columns[x]), most_rows));
  for (const auto& [unit, columns] : by_unit) {
    lxw_chart* const chart = workbook_add_chart(book, LXW_CHART_SCATTER_STRAIGHT);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      lxw_chart_series* const series = chart_add_series(chart, nullptr, nullptr);
      const auto column = static_cast<lxw_col_t>(columns[k]), of_x = static_cast<lxw_col_t>(x);
      chart_series_set_categories(series, sheet.name.c_str(), 1, of_x, last, of_x);
      chart_series_set_values(series, sheet.name.c_str(), 1, column, last, column);
      chart_series_set_name(series, sheet.columns[columns[k]].heading.c_str());
      lxw_chart_line line = {};
      line.color = static_cast<lxw_color_t>(colours[k % colours.size()]);
      line.width = 1.5F;
      line.dash_type = static_cast<std::uint8_t>(k / colours.size() % 4);
      chart_series_set_line(series, &line);
    }
    const SheetColumn& axis = sheet.columns[x];
    chart_title_set_name(chart, fmt::format("{} [{}]", sheet.name, unit).c_str());
    chart_axis_set_name(chart->x_axis, fmt::format("{} [{}]", axis.heading, axis.unit).c_str());
    chart_axis_set_name(chart->y_axis, fmt::format("{} [{}]", harmonic ? "amplitude" : "value", unit).c_str());
    if (harmonic) chart_axis_set_log_base(chart->y_axis, 10);
    if (harmonic) chart_axis_set_label_position(chart->x_axis, LXW_CHART_AXIS_LABEL_POSITION_LOW);
    constexpr double near_zero = 0.05;  // of the whole axis: it then begins at 0, with round numbers
    const double first = axis.numbers.empty() ? 0 : axis.numbers.front();
    chart_axis_set_min(chart->x_axis, axis.numbers.empty() || first < near_zero * axis.numbers.back() ? 0 : first);
    chart_axis_set_max(chart->x_axis, axis.numbers.empty() ? 1 : axis.numbers.back());
    chart_legend_set_position(chart, LXW_CHART_LEGEND_RIGHT);
    lxw_chart_options size = {};
    size.x_scale = 1.7;
    size.y_scale = 1.3;
    worksheet_insert_chart_opt(page, static_cast<lxw_row_t>(row), 1, chart, &size);
    constexpr int rows_of_chart = 21;
    row += rows_of_chart;
  }
}

std::vector<std::string> write_excel(const Content& content, const Target& target) {
  std::set<std::string> used = {"charts"};
  std::vector<Sheet> sheets = {input_sheet(content, used)};
  std::vector<std::string> lost;
  add_verdict(content, used, sheets);
  for (const Group& group : content.groups)
    add_sheets(group, group.name == "matrices" ? project::ShownUnits() : content.variant.display, used, sheets, lost);
  const std::string path = target.path().string();
  lxw_workbook* const book = workbook_new(path.c_str());
  if (!book) throw std::runtime_error(fmt::format("cannot write {}", path));
  const CellFormats formats{workbook_add_format(book), workbook_add_format(book)};
  format_set_bold(formats.heading);
  format_set_bottom(formats.heading, LXW_BORDER_THIN);
  format_set_num_format(formats.number, "General");
  for (const Sheet& sheet : sheets) write_sheet(book, sheet, formats, lost);
  if (std::any_of(sheets.begin(), sheets.end(), [](const Sheet& sheet) { return sheet.charted; })) {
    lxw_worksheet* const page = workbook_add_worksheet(book, "charts");
    worksheet_set_landscape(page);
    worksheet_fit_to_pages(page, 1, 0);
    int row = 1;
    for (const Sheet& sheet : sheets)
      if (sheet.charted) add_charts(book, page, sheet, row);
  }
  if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR)
    throw std::runtime_error(fmt::format("cannot write {}: {}", path, lxw_strerror(error)));
  return lost;
}

}  // namespace

const Format excel_format = {"excel",
                             "Excel workbook (.xlsx): input, requirements, tables, curves with charts",
                             Target::Kind::file,
                             {},
                             false,
                             write_excel};

}  // namespace trivet::exports
