// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "trivet/documents/document.h"
#include "trivet/documents/text_table.h"

/// The numbers of a document as arrays with names, units and axes.
namespace trivet::documents {
namespace {

double real_number(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  return value.is_number() ? value.get<double>() : nothing;
}

/// Lists of numbers, the last axis fastest; NaN where a list is shorter.
template <typename Number>
void add_lists(const Table& table, const UsedColumn& used, std::string name, LabelledArrays& list) {
  std::size_t width = used.column->entries.size();
  for (std::size_t i = 0; i < table.rows; ++i) width = std::max(width, used.column->list(i).size());
  std::vector<Number> numbers(table.rows * width, nothing);
  for (std::size_t i = 0; i < table.rows; ++i) {
    const Numbers row = used.column->list(i);
    for (std::size_t j = 0; j < std::min(width, row.size()); ++j)
      if constexpr (std::is_same_v<Number, double>) numbers[i * width + j] = row[j].real();
      else numbers[i * width + j] = row[j];
  }
  list.copy(std::move(name), used.unit, {table.axis, used.column->entries_axis}, {table.rows, width},
            std::move(numbers));
}

void add_values(const Table& table, const UsedColumn& used, std::string name, LabelledArrays& list) {
  std::vector<Json> values;
  for (std::size_t i = 0; i < table.rows; ++i) values.push_back(value_of(used, i));
  if (used.column->kind == Kind::words) {
    std::vector<std::string> words;
    for (const Json& value : values) words.push_back(value.is_null() ? "" : value.get<std::string>());
    list.texts(std::move(name), table.axis, std::move(words));
    return;
  }
  if (std::ranges::any_of(values, [](const Json& value) { return value.is_array(); })) {
    Eigen::VectorXcd numbers(static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
      numbers(static_cast<Eigen::Index>(i)) = {real_number(values[i].at(0)), real_number(values[i].at(1))};
    list.copy(std::move(name), used.unit, table.axis, std::move(numbers));
    return;
  }
  std::vector<double> numbers;
  for (const Json& value : values) numbers.push_back(real_number(value));
  list.copy(std::move(name), used.unit, table.axis, std::move(numbers));
}

/// Has the array amplitudes of harmonic quantities, or their units?
bool is_harmonic(const Table& table, const Column& column) {
  const auto in_row = [](const Column& c) { return c.kind == Kind::amplitude && c.unit == unit_of_the_row; };
  return column.kind == Kind::amplitude || (column.name == "unit" && std::ranges::any_of(table.columns, in_row));
}

struct AddingArrays {
  LabelledArrays& list;

  void operator()(const Table& table) const {
    if (table.axis.empty() || !(table.forms & in_arrays)) return;
    const std::vector<UsedColumn> columns = used_columns(table, table.arrays, in_arrays);
    if (table.counted && std::ranges::find(columns, table.axis, &UsedColumn::name) == columns.end())
      list.count(table.axis, table.rows);
    for (const UsedColumn& used : columns) {
      const std::string name = table.plain_names || used.name == table.axis ? used.name : table.axis + "." + used.name;
      if (!used.column->list) add_values(table, used, name, list);
      else if (table.rows > 0 && used.column->list(0).is_complex())
        add_lists<std::complex<double>>(table, used, name, list);
      else add_lists<double>(table, used, name, list);
      if (is_harmonic(table, *used.column)) list.mark_harmonic({name});
    }
  }
  void operator()(const Curves& curves) const {
    const auto add = [&](const std::string& name, const std::string& unit, const Numbers& numbers, bool harmonic) {
      list.add({.name = name,
                .unit = unit,
                .axes = {curves.axis},
                .shape = {numbers.size()},
                .strides = {numbers.stride()},
                .values = numbers.is_complex() ? decltype(LabelledArray::values)(std::get<1>(numbers.first()))
                                               : std::get<0>(numbers.first()),
                .owner = numbers.owner(),
                .harmonic = harmonic});
    };
    if (curves.forms & in_arrays) add(curves.axis, curves.unit, curves.points, false);
    for (const Curve& curve : curves.list)
      if (curve.forms & in_arrays) add(curve.name, curve.unit, curve.values, curve.harmonic);
  }
  void operator()(const Single& single) const {
    if (single.forms & in_arrays) list.value(single.name, single.unit, real_number(single.value));
  }
  void operator()(const Words& words) const {
    if (!words.axis.empty()) list.texts(words.name.empty() ? words.axis : words.name, words.axis, words.list);
  }
  void operator()(const Sentence&) const {}
  void operator()(const LabelledArrays& others) const {
    for (const LabelledArray& array : others.list()) list.add(array);
  }
  void operator()(const Group& group) const {
    for (const Part& part : group.parts) std::visit(*this, part.content);
  }
};

}  // namespace

void add_arrays(const Document& document, LabelledArrays& list) {
  for (const Part& part : document.parts) std::visit(AddingArrays{list}, part.content);
}

}  // namespace trivet::documents
