// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/csv_parts.h"
#include "trivet/documents/document.h"

/// The tables and curves of a document as CSV.
namespace trivet::documents {
namespace {

void append_cell(std::string& text, const Json& value) {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (!std::isnan(number)) text += ShortestDigits(number).view();
  } else if (value.is_string()) {
    text += csv_field(value.get_ref<const std::string&>());
  } else if (value.is_boolean()) {
    text += value.get<bool>() ? "yes" : "no";
  } else if (!value.is_null()) {
    text += value.dump();
  }
}

void append_list(std::string& text, const Numbers& numbers, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) {
    if (i > 0) text += ',';
    const double number = i < numbers.size() ? numbers[i].real() : std::nan("");
    if (!std::isnan(number)) text += ShortestDigits(number).view();
  }
}

std::string csv_rows(const Table& table) {
  std::string text;
  const std::vector<UsedColumn> columns = used_columns(table, table.csv, in_csv);
  const auto heading = [&](const std::string& name) { (text += text.empty() ? "" : ",") += csv_field(name); };
  for (const UsedColumn& used : columns) {
    if (!used.column->list) heading(used.name);
    for (const std::string& entry : used.column->entries) heading(fmt::format(fmt::runtime(used.name), entry));
  }
  text += '\n';
  for (std::size_t i = 0; i < table.rows; ++i) {
    bool first = true;
    for (const UsedColumn& used : columns) {
      if (used.column->list && used.column->entries.empty()) continue;
      if (!first) text += ',';
      first = false;
      if (used.column->list) append_list(text, used.column->list(i), used.column->entries.size());
      else append_cell(text, value_of(used, i));
    }
    text += '\n';
  }
  return text;
}

double real_part(const std::complex<double>& value) { return value.real(); }
double size(const std::complex<double>& value) { return std::abs(value); }

std::string csv_curves(const Curves& curves) {
  struct Printed {
    const Numbers* values;
    double (*part)(const std::complex<double>& value);
  };
  std::string text;
  std::vector<Printed> columns;
  std::vector<std::string> units;
  const auto heading = [&](const std::string& name) { (text += text.empty() ? "" : ",") += csv_field(name); };
  for (const std::string& name : curves.axis_columns) {
    heading(name);
    units.push_back(parts_of(name).unit);
  }
  for (const Curve& curve : curves.list) {
    if (!(curve.forms & in_csv)) continue;
    for (const CurveColumn& column : curve.csv) {
      heading(column.heading);
      columns.push_back({&curve.values, column.part});
    }
    if (!curve.csv.empty()) continue;
    heading(fmt::format("{} [{}]", curve.name, curve.unit));
    columns.push_back({&curve.values, curve.values.is_complex() ? size : real_part});
  }
  text += '\n';
  for (std::size_t k = 0; k < curves.points.size(); ++k) {
    const std::size_t start = text.size();
    for (const std::string& unit : units)
      append_csv_number(text, converted(curves.points[k].real(), curves.unit, unit));
    for (const Printed& column : columns) append_csv_number(text, column.part((*column.values)[k]));
    text.erase(start, 1);  // the comma before the first
    text += '\n';
  }
  return text;
}

}  // namespace

std::string as_csv(const Document& document, const std::string& file) {
  const Part& part = part_with_file(document, file);
  if (const auto* table = std::get_if<Table>(&part.content)) return csv_rows(*table);
  return csv_curves(std::get<Curves>(part.content));
}

}  // namespace trivet::documents
