// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/linear_model.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "fmu/resource_folder.h"
#include "fmu/variable.h"
#include "trivet/exports/linear_system.h"
#include "two_masses.h"

namespace fmu_linear_model_test {

using trivet::exports::system_text;
using trivet::fmu::linear_model;
using trivet::fmu::LinearModel;
using trivet::fmu::Variable;
using trivet::test::two_masses;

std::vector<double> by_rows(const Eigen::MatrixXd& matrix) {
  const Eigen::MatrixXd transposed = matrix.transpose();
  return {transposed.data(), transposed.data() + transposed.size()};
}

/// The message of the failure; empty if there is none.
std::string refusal(const std::string& text) {
  try {
    static_cast<void>(linear_model(text));
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(FmuLinearModel, IsWhatTheExporterWrote) {
  const auto system = two_masses();
  const LinearModel model = linear_model(system_text(system, "{token}"));
  EXPECT_EQ(model.token, "{token}");
  EXPECT_EQ(model.a.values, by_rows(system.A));
  EXPECT_EQ(model.b.values, by_rows(system.B));
  EXPECT_EQ(model.c.values, by_rows(system.C));
  EXPECT_EQ(model.d.values, by_rows(system.D));
  EXPECT_EQ(model.initial, by_rows(system.initial));
  EXPECT_THAT(model.nominals, testing::ElementsAre(1e-3, 1e-3, 0.1, 0.1));
}

TEST(FmuLinearModel, IsRejectedWithTheReason) {
  const std::string right = system_text(two_masses(), "{token}");
  ASSERT_EQ(refusal(right), "");
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"", "\"trivet-linear-system\" expected"},
      {with(right, "system 1", "system 2"), "\"1\" expected, found \"2\""},
      {with(right, "states 4", "states 5"), "A has \"B\" where a finite number"},
      {with(right, "states 4", "states 3"), "\"B\" expected"},
      {with(right, "states 4", "states 90000"), "A has too few numbers"},
      {with(right, "states 4", "states -4"), "the number of states is \"-4\""},
      {with(right, "states 4", "states 99999999999999999999"), "the number of states"},
      {with(right, "0.05", "nan"), "initial has \"nan\""},
      {with(right, "0.05", "1e999"), "initial has \"1e999\""},
      {with(right, "0.05", "0.05x"), "initial has \"0.05x\""},
      {with(right, "nominals\n0.001", "nominals\n0"), "a nominal is not positive"},
      {with(right, "end", ""), "\"end\" expected"},
      {right + "more", "text follows"}};
  for (const auto& [text, message] : wrong) EXPECT_THAT(refusal(text), testing::HasSubstr(message));
}

TEST(FmuLinearModel, IsRejectedIfItIsCutAnywhere) {
  const std::string right = system_text(two_masses(), "{token}");
  for (std::size_t size = 0; size + 1 < right.size(); ++size)
    EXPECT_NE(refusal(right.substr(0, size)) + (right.substr(0, size).ends_with("end") ? "complete" : ""), "") << size;
}

TEST(FmuVariable, HasTheReferenceOfTheDescription) {
  const LinearModel model = linear_model(system_text(two_masses(), "-"));
  for (trivet::fmu::ValueReference i = 0; i < 14; ++i) EXPECT_EQ(reference(model, variable(model, i)), i);
  EXPECT_EQ(name(variable(model, 0)), "time");
  EXPECT_EQ(name(variable(model, 3)), "input 3");
  EXPECT_EQ(name(variable(model, 4)), "output 1");
  EXPECT_EQ(name(variable(model, 6)), "state 1");
  EXPECT_EQ(name(variable(model, 13)), "derivative of state 4");
  EXPECT_THROW(static_cast<void>(variable(model, 14)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(variable(model, 4294967295u)), std::runtime_error);
}

TEST(FmuResourceFolder, IsAPathOrAUriOfThisComputer) {
  using trivet::fmu::path_of_uri;
  EXPECT_EQ(path_of_uri("file:///tmp/a%20b/r"), "/tmp/a b/r");
  EXPECT_EQ(path_of_uri("file:/tmp/r"), "/tmp/r");
  EXPECT_EQ(path_of_uri("file://localhost/tmp/r"), "/tmp/r");
  EXPECT_EQ(path_of_uri("/tmp/a%20b"), "/tmp/a%20b");
  for (const char* uri : {"file:///tmp/%2", "file:///tmp/%zz", "file://server/r", "http://server/r"})
    EXPECT_THROW(static_cast<void>(path_of_uri(uri)), std::runtime_error) << uri;
}

}  // namespace fmu_linear_model_test
