// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstring>
#include <string>
#include <vector>

#include "support/matrix_files.h"
#include "trivet/exchange/universal/universal_reading.h"

/// Universal files put together by the tests.
namespace trivet::test {

/// Lines of set 58 before its values, and its values; the defaults are a receptance with two points.
struct FunctionText {
  std::string type = "    58";
  std::string ids = "Receptance\nNONE\nNONE\nNONE\nNONE\n";
  std::string place = "    4         1    0         0 ENGINE            12  -3 NONE               7   3";
  std::string form = "         5         2         1  5.00000E+00  5.00000E-01  0.00000E+00";
  std::string abscissa = "        18    0    0    0 Frequency            Hz                  ";
  std::string numerator = "         8    0    0    0 Displacement         NONE                ";
  std::string denominator = "        13    0    0    0 Force                NONE                ";
  std::string z_axis = "         0    0    0    0 NONE                 NONE                ";
  std::string values = "  1.00000E-06 -2.00000E-06  3.00000E-06  4.00000E-06\n";
  std::string end = "    -1\n";
};

inline std::string universal(const FunctionText& t) {
  return "    -1\n" + t.type + "\n" + t.ids + t.place + "\n" + t.form + "\n" + t.abscissa + "\n" + t.numerator + "\n" +
      t.denominator + "\n" + t.z_axis + "\n" + t.values + t.end;
}

inline std::string universal_set(int type, const std::string& lines) {
  return fmt::format("    -1\n{:6d}\n{}    -1\n", type, lines);
}

/// Set 164 with these units per metre and newton.
inline std::string units_set(int code, double length, double force) {
  return universal_set(164,
                       fmt::format("{:10d}{:<20}{:10d}\n{:25.17E}{:25.17E}{:25.17E}\n{:25.17E}\n", code, "units", 2,
                                   length, force, 1.0, 273.15));
}

inline foundation::Expected<exchange::UniversalRead> read_text(const std::string& text) {
  return exchange::read_universal_text(text, "f");
}

/// The content of a text that has no error.
inline exchange::UniversalFile content(const std::string& text) {
  const auto read = read_text(text);
  EXPECT_TRUE(read) << complaint(read);
  return read ? read->file : exchange::UniversalFile{};
}

inline exchange::UniversalFunction function_of(const std::string& text) {
  const exchange::UniversalFile file = content(text);
  EXPECT_EQ(file.functions.size(), 1u);
  return file.functions.empty() ? exchange::UniversalFunction{} : file.functions.front();
}

/// All warnings, without the one about a missing set 164.
inline std::string warnings(const std::string& text) {
  const auto read = read_text(text);
  EXPECT_TRUE(read) << complaint(read);
  std::string lines;
  if (!read) return lines;
  for (const foundation::Problem& problem : read->warnings.list())
    if (problem.finding != "no set 164") lines += message(problem) + "\n";
  return lines;
}

/// The bytes of numbers, in the order of this computer or reversed.
template <typename Real>
std::string bytes_of(const std::vector<double>& numbers, bool reversed = false) {
  std::string bytes;
  for (const double number : numbers) {
    const Real value = static_cast<Real>(number);
    std::string copy(sizeof(Real), '\0');
    std::memcpy(copy.data(), &value, sizeof(Real));
    bytes += reversed ? std::string(copy.rbegin(), copy.rend()) : copy;
  }
  return bytes;
}

/// Type line of set 58b.
inline std::string binary_type(int order, int format, std::size_t bytes) {
  return fmt::format("    58b{:6d}{:6d}{:12d}{:12d}{:6d}{:6d}{:12d}{:12d}", order, format, 11, bytes, 0, 0, 0, 0);
}

}  // namespace trivet::test
