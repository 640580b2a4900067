// SPDX-License-Identifier: BSD-3-Clause
// Universal files that we write: their columns, their digits, and that they are read without a change.
#include "trivet/exchange/universal/universal_writing.h"

#include <gtest/gtest.h>

#include <limits>

#include "trivet/foundation/invalid_input.h"
#include "unit/exchange/universal_texts.h"

namespace trivet::test {
namespace universal_writing_test {

using exchange::EvenAbscissa;
using exchange::FunctionForm;
using exchange::UniversalComplexMode;
using exchange::UniversalFile;
using exchange::UniversalFunction;
using exchange::UniversalFunctionType;
using exchange::UniversalMode;
using exchange::UniversalNormalMode;
using exchange::UniversalPrecision;
using exchange::UniversalQuantity;
using testing::ElementsAre;
using testing::HasSubstr;
using Complex = std::complex<double>;

/// Half a unit of the last digit, relative to the number: six and thirteen digits, 24 bits.
constexpr double six_digits = 5e-6, thirteen_digits = 5e-13, single_precision = 6e-8;

UniversalFunction receptance() {
  UniversalFunction function;
  function.ids = {"Receptance", "run 3", "25-Nov-25 10:00:00", "", ""};
  function.type = UniversalFunctionType::frequency_response;
  function.identifier = 5;
  function.response = {"ENGINE", 12, -3};
  function.reference = {"", 7, 3};
  function.abscissa_axis = {UniversalQuantity::frequency, {}, "Frequency", "Hz"};
  function.numerator = {UniversalQuantity::displacement, {1, 0, 0}, "Displacement", "m"};
  function.denominator = {UniversalQuantity::excitation_force, {0, 1, 0}, "Force", "N"};
  function.abscissa = EvenAbscissa{5, 0.5};
  function.values = {{1.0 / 3, -2e-6}, {-1e-101, 3.3333333333333e250}, {0, -7}, {1, 1}, {-2.5e-5, 4}};
  return function;
}

UniversalFunction uneven_receptance() {
  UniversalFunction function = receptance();
  function.abscissa = std::vector<double>{1, 2.5, 10.1, 33.3333, 99999.5};
  function.values[1] = {-1e-30, 3.3333333333333e30};  // within single precision
  return function;
}

UniversalFile with(const UniversalFunction& function) {
  UniversalFile file;
  file.functions = {function};
  return file;
}

UniversalFunction reread(const UniversalFunction& function, FunctionForm form) {
  const auto read = read_text(universal_text(with(function), form));
  EXPECT_TRUE(read) << complaint(read);
  if (!read || read->file.functions.size() != 1) return {};
  EXPECT_TRUE(read->warnings.list().empty() || form == FunctionForm::ascii) << message(read->warnings.list()[0]);
  return read->file.functions[0];
}

void expect_values(const UniversalFunction& found, const UniversalFunction& wanted, double tolerance) {
  EXPECT_EQ(found.ids, wanted.ids);
  EXPECT_EQ(found.type, wanted.type);
  EXPECT_EQ(found.identifier, wanted.identifier);
  EXPECT_EQ(found.response.entity, wanted.response.entity);
  EXPECT_EQ(found.response.node, wanted.response.node);
  EXPECT_EQ(found.response.direction, wanted.response.direction);
  EXPECT_EQ(found.reference.direction, wanted.reference.direction);
  EXPECT_EQ(found.numerator.quantity, wanted.numerator.quantity);
  EXPECT_EQ(found.numerator.exponents, wanted.numerator.exponents);
  EXPECT_EQ(found.denominator.label, wanted.denominator.label);
  EXPECT_EQ(found.denominator.unit, wanted.denominator.unit);
  EXPECT_EQ(found.is_complex, wanted.is_complex);
  ASSERT_EQ(found.values.size(), wanted.values.size());
  const auto expect_near = [](double one, double other, double relative) {
    EXPECT_LE(std::abs(one - other), relative * std::abs(other));
  };
  const bool single_abscissa = tolerance == single_precision;
  for (std::size_t i = 0; i < found.values.size(); ++i)
    expect_near(abscissa_values(found)[i], abscissa_values(wanted)[i], single_abscissa ? single_precision : 0);
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    expect_near(found.values[i].real(), wanted.values[i].real(), tolerance);
    expect_near(found.values[i].imag(), wanted.values[i].imag(), tolerance);
  }
}

UniversalFunction real(UniversalFunction function) {
  function.is_complex = false;
  for (Complex& value : function.values) value = value.real();
  return function;
}

TEST(UniversalText, IsReadWithAllItsDigits) {
  for (UniversalFunction function : {receptance(), real(receptance()), uneven_receptance(), real(uneven_receptance())})
    expect_values(reread(function, FunctionForm::ascii), function, thirteen_digits);
  for (UniversalFunction function : {uneven_receptance(), real(uneven_receptance())}) {
    function.precision = UniversalPrecision::single_precision;
    expect_values(reread(function, FunctionForm::ascii), function, six_digits);
    EXPECT_EQ(reread(function, FunctionForm::ascii).precision, UniversalPrecision::single_precision);
    function.abscissa = EvenAbscissa{5, 0.5};
    expect_values(reread(function, FunctionForm::ascii), function, six_digits);
  }
}

TEST(UniversalBinary, IsReadExactly) {
  for (const UniversalFunction& function : {receptance(), real(receptance())})
    expect_values(reread(function, FunctionForm::binary), function, 0);
  for (UniversalFunction function : {uneven_receptance(), real(uneven_receptance())}) {
    expect_values(reread(function, FunctionForm::binary), function, single_precision);
    EXPECT_EQ(reread(function, FunctionForm::binary).precision, UniversalPrecision::single_precision);
    function.precision = UniversalPrecision::single_precision;
    function.abscissa = EvenAbscissa{5, 0.5};
    expect_values(reread(function, FunctionForm::binary), function, single_precision);
  }
}

TEST(UniversalBinary, HoldsAnUnevenAbscissaInSinglePrecision) {
  UniversalFunction function = uneven_receptance();
  function.abscissa = std::vector<double>{1, 2, 10.123456789, 100000.1, 100000.2};
  EXPECT_THAT(abscissa_values(reread(function, FunctionForm::binary)),
              ElementsAre(1, 2, 10.123456789f, 100000.1f, 100000.2f));
}

TEST(UniversalText, HasTheColumnsOfTheStandard) {
  const std::string text = universal_text(with(receptance()), FunctionForm::ascii);
  EXPECT_THAT(text,
              HasSubstr("    -1\n   164\n         1Meter (newton)               2\n"
                        "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
                        "  2.73150000000000000D+02\n    -1\n"));
  EXPECT_THAT(text,
              HasSubstr("    -1\n    58\nReceptance\nrun 3\n25-Nov-25 10:00:00\nNONE\nNONE\n"
                        "    4         5    0         0 ENGINE            12  -3 NONE               7   3\n"
                        "         6         5         1  5.00000E+00  5.00000E-01  0.00000E+00\n"
                        "        18    0    0    0 Frequency            Hz                  \n"
                        "         8    1    0    0 Displacement         m                   \n"
                        "        13    0    1    0 Force                N                   \n"
                        "         0    0    0    0 NONE                 NONE                \n"
                        "  3.333333333333E-01 -2.000000000000E-06-1.000000000000E-101 3.333333333333E+250\n"));
  EXPECT_THAT(universal_text(with(uneven_receptance()), FunctionForm::ascii),
              HasSubstr("\n  1.00000E+00  3.333333333333E-01 -2.000000000000E-06\n  2.50000E+00"));
  EXPECT_THAT(universal_text(with(real(uneven_receptance())), FunctionForm::ascii),
              HasSubstr("\n  1.00000E+00  3.333333333333E-01  2.50000E+00 -1.000000000000E-30\n  1.01000E+01"));
  EXPECT_THAT(
      universal_text(with(receptance()), FunctionForm::binary),
      HasSubstr("    -1\n    58b     1     2          11          80     0     0           0           0\nRecept"));
}

TEST(UniversalText, KeepsHeaderGeometryAndModes) {
  UniversalFile file;
  file.header = {.model = "machine", .created = "25-Nov-25 10:00:00", .program = "program", .written = "26-Nov-25"};
  file.nodes = {{7, {0, -0.125, 1e-7}}, {12, {1, 2, 3}, 4, 5}};
  file.lines = {{3, "wire", {1, 2, 3, 4, 5, 6, 7, 8, 9, 0}}, {4, "", {}}};
  UniversalMode normal;
  normal.ids[0] = "mode";
  normal.number = 2;
  normal.parameters = UniversalNormalMode{12.5, 3, 0.01, 0.02};
  normal.nodes = {{7, {1, 2, 3, 4, 5, -6}}};
  UniversalMode complex;
  complex.parameters = UniversalComplexMode{{-1, 30}, {1, 2}, {3, 4}, false};
  complex.is_complex = true;
  complex.nodes = {{7, {Complex(1, 2), 0, 0, 0, 0, Complex(0, -3)}}};
  UniversalMode translations = complex;
  translations.has_rotations = false;
  translations.nodes = {{12, {Complex(1, 2), 0, -1}}};
  file.modes = {normal, complex, translations};
  const UniversalFile found = content(universal_text(file, FunctionForm::ascii));
  EXPECT_EQ(found.header.model, "machine");
  EXPECT_EQ(found.header.created, "25-Nov-25 10:00:00");
  EXPECT_EQ(found.header.written, "26-Nov-25");
  ASSERT_EQ(found.nodes.size(), 2u);
  EXPECT_EQ(found.nodes[0].position, file.nodes[0].position);
  EXPECT_EQ(found.nodes[1].definition_system, 4);
  ASSERT_EQ(found.lines.size(), 2u);
  EXPECT_EQ(found.lines[0].nodes, file.lines[0].nodes);
  EXPECT_EQ(found.lines[1].number, 4);
  ASSERT_EQ(found.modes.size(), 3u);
  EXPECT_EQ(std::get<UniversalNormalMode>(found.modes[0].parameters).hysteretic_damping, 0.02);
  EXPECT_EQ(std::get<UniversalComplexMode>(found.modes[1].parameters).modal_b, Complex(3, 4));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(found.modes[i].nodes.at(0).components, file.modes[i].nodes[0].components) << i;
  EXPECT_EQ(found.modes[0].ids[0], "mode");
}

TEST(UniversalText, IsWrittenAgainWithoutAChange) {
  const std::string text = universal_text(with(receptance()), FunctionForm::ascii);
  EXPECT_EQ(universal_text(content(text), FunctionForm::ascii), text);
}

TEST(UniversalAbscissa, HasSixDigits) {
  EXPECT_EQ(exchange::as_universal_abscissa(10.1), 10.1);
  EXPECT_EQ(exchange::as_universal_abscissa(1234.5678), 1234.57);
  EXPECT_EQ(exchange::as_universal_abscissa(1.0 / 3), 0.333333);
  EXPECT_EQ(exchange::as_universal_abscissa(0), 0);
  EXPECT_THROW(static_cast<void>(exchange::as_universal_abscissa(std::numeric_limits<double>::infinity())),
               foundation::InvalidInput);
}

TEST(UniversalTexts, FitOrAreCut) {
  EXPECT_TRUE(exchange::fits_universal_line("Опора 3"));
  EXPECT_TRUE(exchange::fits_universal_line(std::string(80, 'x')));
  for (const std::string& text : {std::string(81, 'x'), std::string("-1"), std::string("none"), std::string("a\nb"),
                                  std::string(" a"), std::string("\xFF")})
    EXPECT_FALSE(exchange::fits_universal_line(text)) << text;
  EXPECT_TRUE(exchange::fits_universal_field("ENGINE", exchange::universal_entity_width));
  EXPECT_FALSE(exchange::fits_universal_field("ENGINE BLOCK", exchange::universal_entity_width));
  EXPECT_FALSE(exchange::fits_universal_field("m/s²", exchange::universal_label_width));
  UniversalFunction function = receptance();
  function.ids = {std::string(78, 'x') + "Опора", "-1", "a\nb", " ", "none"};
  function.response.entity = "ENGINE BLOCK";
  function.numerator.unit = "m/s²";
  const UniversalFunction found = reread(function, FunctionForm::ascii);
  EXPECT_THAT(found.ids, ElementsAre(std::string(78, 'x') + "О", "\"-1\"", "a\\nb", "", ""));
  EXPECT_EQ(found.response.entity, "ENGINE BLO");
  EXPECT_EQ(found.numerator.unit, "m/s?");
}

/// The message of the exception, or an empty text.
std::string rejected(const UniversalFunction& function, FunctionForm form = FunctionForm::ascii) {
  try {
    static_cast<void>(universal_text(with(function), form));
  } catch (const foundation::InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(UniversalText, RejectsWhatTheFileCannotHold) {
  const auto changed = [](auto change) {
    UniversalFunction function = uneven_receptance();
    change(function);
    return function;
  };
  EXPECT_THAT(rejected(changed([](auto& f) { f.values.clear(); })), HasSubstr("it has no values"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.values[0] = std::nan(""); })), HasSubstr("not finite"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.values.pop_back(); })), HasSubstr("5 abscissas and 4 values"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.is_complex = false; })), HasSubstr("it is real"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.in_file_units = true; })), HasSubstr("not in SI"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.version = 1234567; })), HasSubstr("version 1234567"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.abscissa = EvenAbscissa{0, 0}; })), HasSubstr("step 0, must be > 0"));
  EXPECT_THAT(rejected(changed([](auto& f) { f.abscissa = std::vector<double>{1, 2, 3, 100000.1, 100000.2}; })),
              HasSubstr("with six digits"));
  const UniversalFunction large = changed([](auto& f) { f.values[0] = 1e39; });
  EXPECT_EQ(rejected(large), "");
  EXPECT_THAT(rejected(large, FunctionForm::binary), HasSubstr("too large for single precision"));
}

}  // namespace universal_writing_test
}  // namespace trivet::test
