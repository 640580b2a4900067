// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <complex>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// The numbers of results as arrays with names, units and axes: for Python and for files of other programs. Names are
/// those of the CSV tables and of docs/json.md:
/// - A curve has the name of its result ("machine.z"); further curves of it have a word after a blank ("machine.z
///   phase", "machine.z density", "machine.z order 2"), as has what the user names freely ("LINE margin").
/// - The first table of a result has plain names ("amplitude"). Those of a further one begin with its axis:
///   "result.highest" over the axis "result". Neither has a blank or is ever the name of a result, which ends in ".x",
///   ".rz" or another component.
/// - Yes and no are 1 and 0. NaN: there is no such number.
/// - Not SI: frequencies in Hz, levels in dB, and the parameters of designs, which have the unit of the file.
namespace trivet::documents {

/// Unit of numbers whose units differ along one of their axes; an array of texts on that axis, "unit" or "AXIS.unit",
/// contains them.
inline constexpr const char* unit_of_the_row = "unit of the row";

/// An array of SI numbers, or of texts. An array of one axis with the name of that axis contains its coordinates.
struct LabelledArray {
  std::string name;                     ///< "machine.z", "angular_frequency"
  std::string unit;                     ///< SI; "1" for pure numbers, empty for texts
  std::vector<std::string> axes;        ///< name of each axis; none: a single value
  std::vector<std::size_t> shape;       ///< one size per axis
  std::vector<std::ptrdiff_t> strides;  ///< one per axis, in numbers
  std::variant<const double*, const std::complex<double>*, std::vector<std::string>> values;
  std::shared_ptr<const void> owner = {};  ///< of the numbers; empty: the result, which must outlive the array
  bool harmonic = false;                   ///< amplitudes of harmonic quantities, which have a level; or their units

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool is_complex() const { return std::holds_alternative<const std::complex<double>*>(values); }
  [[nodiscard]] bool is_text() const { return std::holds_alternative<std::vector<std::string>>(values); }
  /// The numbers in the order of the last axis fastest. @throws std::bad_variant_access for other kinds
  [[nodiscard]] std::vector<double> real_numbers() const;
  [[nodiscard]] std::vector<std::complex<double>> complex_numbers() const;
  [[nodiscard]] const std::vector<std::string>& texts() const { return std::get<std::vector<std::string>>(values); }
};

/// Arrays in the order in which they are added. `view` and `field` refer to numbers of the result and copy nothing.
class LabelledArrays {
 public:
  [[nodiscard]] const std::vector<LabelledArray>& list() const { return list_; }
  [[nodiscard]] const LabelledArray* find(const std::string& name) const;

  void view(std::string name, std::string unit, std::string axis, const std::vector<double>& numbers);
  void view(std::string name, std::string unit, std::string axis, const Eigen::VectorXd& numbers);
  void view(std::string name, std::string unit, std::string axis, const Eigen::VectorXcd& numbers);
  void view(std::string name, std::string unit, std::pair<std::string, std::string> axes,
            const Eigen::MatrixXd& numbers);
  void view(std::string name, std::string unit, std::pair<std::string, std::string> axes,
            const Eigen::MatrixXcd& numbers);

  /// One member of every row of a list.
  template <typename Row>
  void field(std::string name, std::string unit, std::string axis, const std::vector<Row>& rows, double Row::* member) {
    static_assert(sizeof(Row) % sizeof(double) == 0);
    add({std::move(name),
         std::move(unit),
         {std::move(axis)},
         {rows.size()},
         {static_cast<std::ptrdiff_t>(sizeof(Row) / sizeof(double))},
         rows.empty() ? nullptr : &(rows.front().*member)});
  }

  /// One value per row: a member, or computed; NaN where there is none.
  template <typename Row, typename Value>
  void column(std::string name, std::string unit, std::string axis, const std::vector<Row>& rows, const Value& value) {
    std::vector<double> numbers;
    numbers.reserve(rows.size());
    for (const Row& row : rows) numbers.push_back(number(std::invoke(value, row)));
    copy(std::move(name), std::move(unit), std::move(axis), std::move(numbers));
  }
  /// A list of real or complex numbers per row, `width` of them; NaN where a list is shorter.
  template <typename Row, typename Value>
  void lists(std::string name, std::string unit, std::pair<std::string, std::string> axes, std::size_t width,
             const std::vector<Row>& rows, const Value& value) {
    using Number = std::decay_t<decltype(*std::begin(std::invoke(value, rows.front())))>;
    std::vector<Number> numbers(rows.size() * width, std::numeric_limits<double>::quiet_NaN());
    auto row_begin = numbers.begin();
    for (const Row& row : rows) {
      const auto& list = std::invoke(value, row);
      assert(std::distance(std::begin(list), std::end(list)) <= static_cast<std::ptrdiff_t>(width));
      std::copy(std::begin(list), std::end(list), row_begin);
      row_begin += static_cast<std::ptrdiff_t>(width);
    }
    copy(std::move(name), std::move(unit), {std::move(axes.first), std::move(axes.second)}, {rows.size(), width},
         std::move(numbers));
  }
  template <typename Row, typename Text>
  void texts(std::string name, std::string axis, const std::vector<Row>& rows, const Text& text) {
    std::vector<std::string> list;
    list.reserve(rows.size());
    for (const Row& row : rows) list.emplace_back(std::invoke(text, row));
    texts(std::move(name), std::move(axis), std::move(list));
  }
  void texts(std::string name, std::string axis, std::vector<std::string> list);

  void copy(std::string name, std::string unit, std::string axis, std::vector<double> numbers);
  void copy(std::string name, std::string unit, std::string axis, Eigen::VectorXcd numbers);
  void copy(std::string name, std::string unit, std::pair<std::string, std::string> axes, Eigen::MatrixXd numbers);
  void copy(std::string name, std::string unit, std::pair<std::string, std::string> axes, Eigen::MatrixXcd numbers);
  /// A single number.
  void value(std::string name, std::string unit, double number);
  /// Numbers of any number of axes, the last axis fastest.
  void copy(std::string name, std::string unit, std::vector<std::string> axes, std::vector<std::size_t> shape,
            std::vector<double> numbers);
  void copy(std::string name, std::string unit, std::vector<std::string> axes, std::vector<std::size_t> shape,
            std::vector<std::complex<double>> numbers);

  /// Says that these arrays of the list are harmonic.
  void mark_harmonic(const std::vector<std::string>& names);
  /// 1, 2, … count as the coordinates of an axis.
  void count(std::string axis, std::size_t count);
  void add(LabelledArray array) { list_.push_back(std::move(array)); }

 private:
  template <typename T>
  static double number(const T& value) {
    return static_cast<double>(value);
  }
  template <typename T>
  static double number(const std::optional<T>& value) {
    return value ? static_cast<double>(*value) : std::numeric_limits<double>::quiet_NaN();
  }

  std::vector<LabelledArray> list_;
};

}  // namespace trivet::documents
