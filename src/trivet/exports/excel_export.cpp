// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "trivet/exports/completeness.h"
#include "trivet/exports/format_table.h"
#include "trivet/exports/workbook_sheets.h"

/// Excel: the input, the requirements with their margins, a sheet for each list of rows, and native charts of curves.
namespace trivet::exports {
namespace {

constexpr std::size_t most_rows = 1'048'575, most_columns = 16'384;

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
  if (columns < sheet.columns.size())
    lost.push_back(fmt::format("{}: columns after {} do not fit", sheet.name, most_columns));
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

bool all_positive(const Sheet& sheet, const std::vector<std::size_t>& columns) {
  return std::ranges::all_of(columns, [&](std::size_t c) {
    return std::ranges::all_of(sheet.columns[c].numbers, [](double number) { return !(number <= 0); });
  });
}

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
    chart_axis_set_name(chart->y_axis,
                        fmt::format("{} [{}]", sheet.name == "response" ? "amplitude" : "value", unit).c_str());
    if (harmonic && all_positive(sheet, columns)) chart_axis_set_log_base(chart->y_axis, 10);
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

std::vector<std::string> write_excel(const Content& content, const Target& target,
                                     const foundation::Progress& progress) {
  std::vector<std::string> lost;
  const std::vector<Sheet> sheets = workbook_sheets(content, progress, lost);
  const std::string path = target.path().string();
  std::string folder = target.path().parent_path().string();
  lxw_workbook_options options = {};
  options.tmpdir = folder.data();  // for parts of the file, not /tmp
  lxw_workbook* const book = workbook_new_opt(path.c_str(), &options);
  if (!book) throw std::runtime_error(fmt::format("cannot write {}", path));
  const CellFormats formats{workbook_add_format(book), workbook_add_format(book)};
  format_set_bold(formats.heading);
  format_set_bottom(formats.heading, LXW_BORDER_THIN);
  format_set_num_format(formats.number, "General");
  for (const Sheet& sheet : sheets) write_sheet(book, sheet, formats, lost);
  if (std::ranges::any_of(sheets, &Sheet::charted)) {
    lxw_worksheet* const page = workbook_add_worksheet(book, sheet_of_charts);
    worksheet_set_landscape(page);
    worksheet_fit_to_pages(page, 1, 0);
    int row = 1;
    for (const Sheet& sheet : sheets)
      if (sheet.charted) add_charts(book, page, sheet, row);
  }
  if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR)
    throw std::runtime_error(fmt::format("cannot write {}: {}", path, lxw_strerror(error)));
  require_complete_workbook(target.path());
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
