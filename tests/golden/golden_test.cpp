// SPDX-License-Identifier: BSD-3-Clause
// Compares the paper's results with earlier results of this program: shows only that nothing changed.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "trivet/judging/read_project.h"
#include "trivet/study/analyses/case_results.h"

namespace golden_test {

using namespace trivet;

struct Pinned {
  std::string name;
  double omega, amplitude;
};

TEST(Golden, PeaksOfThePaperInAllCases) {
  constexpr double round_off = 1e-9;  // of another compiler or instruction set; the file has 13 digits
  const auto project = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/corrected.toml").value();
  std::vector<Pinned> found;
  for (const auto& variant : project.cases) {
    const auto results = study::case_results(variant, variant.analyses);
    for (const auto& peak : results.peaks->peaks.list)
      found.push_back(
          {variant.name + "/" + results.peaks->peaks.curves[peak.curve].name, peak.angular_frequency, peak.amplitude});
  }
  const std::string path = std::string(TRIVET_SOURCE_DIR) + "/tests/golden/paper_peaks.csv";
  if (std::getenv("TRIVET_REWRITE_GOLDEN")) {
    std::ofstream out(path);
    out.precision(13);
    for (const auto& p : found) out << p.name << "," << p.omega << "," << p.amplitude << "\n";
  }
  std::ifstream in(path);
  std::size_t i = 0;
  for (std::string name, omega, amplitude;
       std::getline(in, name, ',') && std::getline(in, omega, ',') && std::getline(in, amplitude); ++i) {
    ASSERT_LT(i, found.size());
    EXPECT_EQ(found[i].name, name);
    EXPECT_NEAR(found[i].omega, std::stod(omega), round_off * found[i].omega);
    EXPECT_NEAR(found[i].amplitude, std::stod(amplitude), round_off * found[i].amplitude);
  }
  EXPECT_EQ(i, found.size());
}

}  // namespace golden_test
