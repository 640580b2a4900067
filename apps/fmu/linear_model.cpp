// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/linear_model.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace trivet::fmu {
namespace {

constexpr std::string_view white_space = " \t\r\n";
constexpr std::size_t largest_count = 100000;

[[noreturn]] void refuse(const std::string& reason) { throw std::runtime_error("system.txt: " + reason); }

/// The words of a text, one after the other.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// The next word; empty at the end.
  std::string_view next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(white_space), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(white_space));
    rest_.remove_prefix(word.size());
    return word;
  }

  void expect(std::string_view wanted) {
    const std::string_view word = next();
    if (word != wanted) refuse("\"" + std::string(wanted) + "\" expected, found \"" + shortened(word) + "\"");
  }

  std::size_t count(std::string_view name) {
    expect(name);
    const std::string_view word = next();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value > largest_count)
      refuse("the number of " + std::string(name) + " is \"" + shortened(word) + "\"");
    return value;
  }

  std::vector<double> numbers(const std::string& name, std::size_t count) {
    expect(name);
    if (count > rest_.size() / 2) refuse(name + " has too few numbers");  // before memory is taken
    std::vector<double> values(count);
    for (double& value : values) value = number(name);
    return values;
  }

  Matrix matrix(const std::string& name, std::size_t rows, std::size_t columns) {
    Matrix matrix;
    matrix.rows = rows;
    matrix.columns = columns;
    matrix.values = numbers(name, rows * columns);
    return matrix;
  }

 private:
  static std::string shortened(std::string_view word) { return std::string(word.substr(0, 40)); }

  double number(const std::string& name) {
    const std::string_view word = next();
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      refuse(name + " has \"" + shortened(word) + "\" where a finite number is expected");
    return value;
  }

  std::string_view rest_;
};

}  // namespace

LinearModel linear_model(std::string_view text) {
  Words words(text);
  words.expect("trivet-linear-system");
  words.expect("1");
  words.expect("token");
  LinearModel model;
  model.token = words.next();
  const std::size_t states = words.count("states"), inputs = words.count("inputs"), outputs = words.count("outputs");
  model.a = words.matrix("A", states, states);
  model.b = words.matrix("B", states, inputs);
  model.c = words.matrix("C", outputs, states);
  model.d = words.matrix("D", outputs, inputs);
  model.initial = words.numbers("initial", states);
  model.nominals = words.numbers("nominals", states);
  for (const double nominal : model.nominals)
    if (!(nominal > 0)) refuse("a nominal is not positive");
  words.expect("end");
  if (const std::string_view surplus = words.next(); !surplus.empty()) refuse("text follows after \"end\"");
  return model;
}

}  // namespace trivet::fmu
