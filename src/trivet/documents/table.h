// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "trivet/documents/json_text.h"
#include "trivet/documents/labelled_arrays.h"
#include "trivet/documents/numbers.h"

namespace trivet::documents {

using json::Json;

/// Forms in which a document is written, to be combined with |.
enum Form : unsigned { in_json = 1, in_csv = 2, in_arrays = 4, on_screen = 8, on_page = 16, in_summary = 32 };
inline constexpr unsigned for_people = on_screen | on_page | in_summary, for_programs = in_json | in_csv | in_arrays,
                          everywhere = for_people | for_programs;

/// What the entries of a column are, and so how people see them. Files have SI numbers.
enum class Kind {
  words,
  number,     ///< its unit is in the heading, as [display] has it
  yes_no,     ///< true or false
  share,      ///< in percent
  frequency,  ///< ω [rad/s], shown in the unit of [display], by default Hz
  speed,      ///< Ω [rad/s], shown in rpm
  quantity,   ///< with an SI prefix, or in the unit of [display]; in the heading if all have the same unit
  amplitude,  ///< the same of a harmonic quantity: it also has a level
};

/// A column of a table, described once for all forms.
struct Column {
  std::string name;  ///< key of JSON, name of the array
  Kind kind = Kind::words;
  std::string heading;                                ///< for people, without a unit; empty: not for people
  std::function<Json(std::size_t row)> value = {};    ///< null: there is none; a number may be ∞
  std::function<Numbers(std::size_t row)> list = {};  ///< in place of `value`: one number for each of `entries`
  std::vector<std::string> entries = {};              ///< their names; not needed if only JSON and arrays have the list
  std::string entries_axis = {};
  std::string unit = {};  ///< SI; "1" for pure numbers; `unit_of_the_row`: that of the column "unit"; "@NAME": of NAME
  std::function<Kind(std::size_t row)> kind_in_row = {};  ///< of numbers whose rows are of different kinds
  int digits = 6;                                         ///< significant ones for people
  unsigned forms = everywhere;
};

struct ColumnOptions {
  std::string unit = {};
  int digits = 6;
  unsigned forms = everywhere;
};

/// A column in one form, if it has another name or unit there: {"frequency [Hz]", "angular_frequency [Hz]"}. The
/// second text is the name of the column, and for a number in rad/s another unit, Hz or rpm. A single text is both:
/// "speed [rpm]". The name of a list contains {} for its entries: {"shape {}", "shape"}.
struct Use {
  std::string name, column;
  Use(const char* both) : name(both), column(both) {}
  Use(std::string name_there, std::string of_column) : name(std::move(name_there)), column(std::move(of_column)) {}
};

inline constexpr const char* whole_json = "*";

/// Emphasis of a row for people: something is wrong, less important, or not judged.
enum class Mark { plain, bad, minor, doubt };

/// Rows and columns. The lists `json` … `people` name the columns of a form and their order; if one is empty, the form
/// has all columns that list it among their forms. Columns of different forms may have the same name.
struct Table {
  std::string key = {};      ///< of the list in JSON; empty: not in JSON
  std::string axis = {};     ///< of the arrays; empty: no arrays
  bool plain_names = false;  ///< arrays are called "amplitude", not "peak.amplitude": the first table of a result
  bool counted = true;       ///< the axis has the coordinates 1, 2, …, unless an array has its name
  std::string file = {};     ///< of CSV: "peaks.csv"; empty: no CSV
  std::string title = {};    ///< for people
  std::size_t rows = 0;
  std::vector<Column> columns;
  std::vector<Use> json = {}, csv = {}, arrays = {}, people = {};
  std::optional<std::vector<std::size_t>> people_rows = {};         ///< and their order, if not all
  std::size_t most_rows = std::numeric_limits<std::size_t>::max();  ///< on the screen
  std::function<double(std::size_t row)> height = {};  ///< of more rows it shows the highest; without it the first
  const char* what_is_high = "highest";                ///< in words: "nearest" if rows are near to something
  std::size_t together = 1;  ///< columns after the first that the screen does not separate: 2 for amplitude and phase
  std::function<Mark(std::size_t row)> mark = {};
  std::string without_rows = {};  ///< words for people in place of an empty table, which has no title then
  bool folded = false;            ///< the page shows it after a click
  bool records = false;           ///< on narrow screens the page shows a row as a record: each cell with its heading
  bool one_prefix = false;        ///< columns of quantities with the same unit have the same SI prefix
  unsigned forms = everywhere;
};

template <typename T>
[[nodiscard]] Json cell(const T& value) {
  if constexpr (std::is_same_v<T, std::complex<double>>) return json::complex_number(value);
  else return value;
}
template <typename T>
[[nodiscard]] Json cell(const std::optional<T>& value) {
  return value ? cell(*value) : Json(nullptr);
}

/// Makes columns of a list of rows: a column is a member of a row, or computed of it or of its index. The list is part
/// of the result, which outlives the columns, or kept by them.
template <typename Row>
class Rows {
 public:
  explicit Rows(const std::vector<Row>& rows) : rows_(std::shared_ptr<const void>(), &rows) {}
  explicit Rows(const std::vector<Row>&& rows) = delete;  // a temporary that cannot be kept
  explicit Rows(std::vector<Row>&& rows) : rows_(std::make_shared<const std::vector<Row>>(std::move(rows))) {}

  [[nodiscard]] std::size_t size() const { return rows_->size(); }

  template <typename Value>
  // NOLINTNEXTLINE(performance-unnecessary-value-param): moved from; unused templates hide it
  Column operator()(std::string name, Kind kind, std::string heading, Value value, ColumnOptions options = {}) const {
    const auto get = [rows = rows_, value](std::size_t i) -> Json { return cell(of(value, *rows, i)); };
    return {.name = std::move(name),
            .kind = kind,
            .heading = std::move(heading),
            .value = get,
            .unit = options.unit.empty() ? usual_unit(kind) : std::move(options.unit),
            .digits = options.digits,
            .forms = options.forms};
  }
  /// A column of lists of numbers. @param entries  names of the numbers of a list
  template <typename List>
  // NOLINTNEXTLINE(performance-unnecessary-value-param): moved from; unused templates hide it
  Column lists(std::string name, std::string heading, std::string axis, std::vector<std::string> entries, List list,
               ColumnOptions options = {}) const {
    const auto get = [rows = rows_, list](std::size_t i) -> Numbers { return of(list, *rows, i); };
    return {.name = std::move(name),
            .kind = Kind::number,
            .heading = std::move(heading),
            .list = get,
            .entries = std::move(entries),
            .entries_axis = std::move(axis),
            .unit = options.unit.empty() ? "1" : std::move(options.unit),
            .digits = options.digits,
            .forms = options.forms};
  }

 private:
  static std::string usual_unit(Kind kind) {
    if (kind == Kind::words) return "";
    if (kind == Kind::quantity || kind == Kind::amplitude) return unit_of_the_row;
    return kind == Kind::number || kind == Kind::yes_no || kind == Kind::share ? "1" : "rad/s";
  }

  template <typename Value>
  static decltype(auto) of(const Value& value, const std::vector<Row>& rows, std::size_t i) {
    if constexpr (std::is_invocable_v<const Value&, const Row&>) return std::invoke(value, rows[i]);
    else return value(i);
  }

  std::shared_ptr<const std::vector<Row>> rows_;
};

/// The columns of a table in one form, in its order.
struct UsedColumn {
  std::string name;
  const Column* column = nullptr;
  std::string unit;  ///< of its numbers there: that of the column, or "Hz" or "rpm"
};
/// @throws foundation::InvalidInput if the table has no such column
[[nodiscard]] std::vector<UsedColumn> used_columns(const Table& table, const std::vector<Use>& uses, unsigned form);
/// A number of a column in the unit of its use; other values stay.
[[nodiscard]] Json value_of(const UsedColumn& used, std::size_t row);
/// A number in rad/s as Hz or rpm; in other units it stays.
[[nodiscard]] double converted(double value, const std::string& from, const std::string& to);

/// At most so many of the rows, evenly spread from the first to the last.
[[nodiscard]] std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t most);

/// SI unit of the numbers in a row.
[[nodiscard]] std::string unit_in_row(const Table& table, const Column& column, std::size_t row);

}  // namespace trivet::documents
