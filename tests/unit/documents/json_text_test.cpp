// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

/// The writer of JSON is compared with nlohmann's parser, which shares nothing with it.
namespace trivet::documents::json {
namespace json_text_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(JsonText, ReadsBackEveryRealNumberBitForBit) {
  std::mt19937_64 random(11);
  std::vector<double> numbers = {0.0, -0.0, 1, -1, 0.1, 1e16, 123456789012345678.0, 5e-324, 1.7976931348623157e308};
  for (int i = 0; i < 2000; ++i) {
    const auto bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) numbers.push_back(value);
  }
  const Json read = Json::parse(text(list(numbers)));
  ASSERT_EQ(read.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_TRUE(read[i].is_number_float()) << numbers[i];
    EXPECT_EQ(read[i].get<double>(), numbers[i]);
    EXPECT_EQ(Json::parse(text(Json(numbers[i]))).get<double>(), numbers[i]);
  }
}

TEST(JsonText, WritesNullForNumbersThatAreNotFinite) {
  EXPECT_EQ(text(list(std::vector<double>{infinity, 2, std::nan("")})), "[null,2.0,null]");
  EXPECT_EQ(text(list(std::vector<std::complex<double>>{{1, 0.5}, {infinity, 1}, {0, -2}})),
            "[[1.0,0.5],null,[0.0,-2.0]]");
  EXPECT_EQ(text(list(std::vector<double>{})), "[]");
  EXPECT_EQ(text(Json(infinity)), "null");
}

TEST(JsonText, IsTheTextOfTheParserForEverythingButLists) {
  const Json json = {{"a \"quoted\" key\n", {{"text", "µm \\ tab\t"}, {"nothing", nullptr}, {"flag", true}}},
                     {"empty", Json::array()},
                     {"none", Json::object()},
                     {"values", {1, -2, 3.5, "four", {{"five", 5u}}}}};
  for (const int indent : {-1, 1, 2}) EXPECT_EQ(text(json, indent), json.dump(indent));
}

TEST(JsonText, ReplacesBytesThatAreNotUtf8) { EXPECT_EQ(text(Json("a\xff")), "\"a\xEF\xBF\xBD\""); }

TEST(JsonText, KeepsAListOnOneLine) {
  const Json json = {{"shape", list(Eigen::Vector3d(1, 2, 3))},
                     {"rows", rows(Eigen::Matrix2d(Eigen::Matrix2d::Identity()))}};
  EXPECT_EQ(text(json, 1), "{\n \"shape\": [1.0,2.0,3.0],\n \"rows\": [\n  [1.0,0.0],\n  [0.0,1.0]\n ]\n}");
}

}  // namespace json_text_test
}  // namespace trivet::documents::json
