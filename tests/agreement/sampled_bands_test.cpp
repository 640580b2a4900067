// SPDX-License-Identifier: BSD-3-Clause
// Bands of a small sample against the full response of each of its designs, read from the file with its numbers set.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/projects.h"
#include "trivet/project/model_number.h"
#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/sample.h"
#include "trivet/study/whole_study.h"

namespace trivet {
namespace sampled_bands_test {

const std::string usual_response = "{band = [\"2 Hz\", \"25 Hz\"]}";

/// A machine on four mounts. @param excitation  of type and force  @param damping  of the mounts
std::string machine(const std::string& excitation, const std::string& damping, const std::string& more) {
  std::string text = fmt::format(R"(
trivet = 1
gravity = [0, 0, -9.80665]
[bodies.machine]
mass = 410
center_of_mass = [0.02, -0.03, 0.3]
inertia = {{about = "center_of_mass", xx = 14, yy = 22, zz = 27}}
points = {{seat = [0.2, 0.3, 0.9]}}
[excitations.drive]
on = "machine"
at = [0.1, 0, 0.4]
{}
[analyses]
sample = {{designs = 100, seed = 7, bands = ["machine.seat.z", "machine.rx", "a.force.z"], band_points = 40}}
response = {}
[requirements]
{}
)",
                                 excitation, usual_response, more);
  for (const auto& [name, x, y] : {std::tuple("a", 0.4, 0.3), {"b", 0.41, -0.3}, {"c", -0.4, 0.28}, {"d", -0.4, -0.3}})
    text += fmt::format(R"([elements.{}]
type = "bushing"
on = "machine"
at = [{}, {}, 0]
translation = [150000, 180000, 450000]
rotation = [0, 0, 0]
damping = {}
)",
                        name, x, y, damping);
  return text + R"(
[tolerances.rubber]
path = ["elements.a.scale", "elements.b.scale", "elements.c.scale", "elements.d.scale"]
half_width = "15 %"
[tolerances.casting]
path = "bodies.machine.mass"
standard_deviation = "3 %"
)";
}

/// Amplitudes of each design at the frequencies of the bands: designs × (band, frequency).
std::vector<std::vector<double>> computed_one_by_one(const std::string& text, const study::Sample& sample) {
  const project::Project given = test::project(text);
  const std::vector<project::Tolerance>& tolerances = given.base().analyses.tolerances;
  const study::DrawnDesigns drawn(tolerances, *given.base().analyses.sample);
  const Eigen::MatrixXd draws = drawn.draw(0, sample.request.designs);
  std::string at, of;
  for (const double omega : sample.cases[0].bands[0].angular_frequency)
    at += fmt::format("{}{:.17g}", at.empty() ? "" : ", ", omega);
  for (const study::SampledBand& band : sample.cases[0].bands)
    of += fmt::format("{}\"{}\"", of.empty() ? "" : ", ", band.name);
  std::string at_frequencies = text;
  at_frequencies.replace(text.find(usual_response), usual_response.size(),
                         fmt::format("{{of = [{}], at = [{}]}}", of, at));
  const std::string points = ", band_points = 40";  // there is no band then
  at_frequencies.erase(at_frequencies.find(points), points.size());
  std::vector<std::vector<double>> all;
  for (Eigen::Index d = 0; d < draws.rows(); ++d) {
    std::vector<std::string> settings;
    for (std::size_t t = 0; t < tolerances.size(); ++t)
      for (std::size_t p = 0; p < tolerances[t].places.size(); ++p) {
        const std::string& path = tolerances[t].places[p].path;
        const double number = *project::ModelNumber(path, "").read(given.base());
        settings.push_back(
            fmt::format("{}={:.17g}", path,
                        tolerances[t].number(p, number, draws(d, static_cast<Eigen::Index>(drawn.draw_of(t, p))))));
      }
    const study::CaseResults results = study::run(test::project(at_frequencies, settings)).front();
    std::vector<double>& amplitudes = all.emplace_back();
    for (const response::Curve& curve : results.response->curves.curves)
      for (const std::complex<double>& value : curve.value) amplitudes.push_back(std::abs(value));
  }
  return all;
}

/// The number of rank ⌈share · n⌉.
double quantile(std::vector<double> numbers, double share) {
  std::ranges::sort(numbers);
  return numbers[static_cast<std::size_t>(std::ceil(share * static_cast<double>(numbers.size()))) - 1];
}

void expect_bands_of_single_responses(const std::string& text, bool kernels) {
  const study::Sample sample = study::sample(test::project(text));
  ASSERT_EQ(sample.failed, 0);
  const std::vector<study::SampledBand>& bands = sample.cases[0].bands;
  ASSERT_EQ(bands.size(), 3);
  EXPECT_EQ(bands[0].no_kernels.empty(), kernels) << bands[0].no_kernels;
  EXPECT_GE(bands[0].angular_frequency.size(), 40);
  const std::vector<std::vector<double>> single = computed_one_by_one(text, sample);
  ASSERT_EQ(single.size(), 100);
  // A sum of the family has twelve digits or more; near a lightly damped resonance some are lost.
  constexpr double digits = 1e-8;
  std::size_t value = 0;
  for (const study::SampledBand& band : bands)
    for (const study::Spread& spread : band.spread) {
      std::vector<double> of_designs;
      for (const std::vector<double>& design : single) of_designs.push_back(design[value]);
      ++value;
      const auto [least, largest] = std::ranges::minmax_element(of_designs);
      EXPECT_NEAR(spread.extremes.least / *least, 1, digits) << band.name;
      EXPECT_NEAR(spread.extremes.largest / *largest, 1, digits) << band.name;
      EXPECT_EQ(spread.extremes.largest_at, static_cast<std::uint64_t>(largest - of_designs.begin())) << band.name;
      const double within = numerics::LogHistogram::relative_error;
      EXPECT_NEAR(spread.low / quantile(of_designs, 0.05), 1, within) << band.name;
      EXPECT_NEAR(spread.median / quantile(of_designs, 0.5), 1, within) << band.name;
      EXPECT_NEAR(spread.high / quantile(of_designs, 0.95), 1, within) << band.name;
    }
}

const std::string harmonic = "type = \"harmonic\"\nforce = [20, 10, 150]";
const std::string unbalance = "type = \"unbalance\"\naxis = \"x\"\nmass_eccentricity = \"20 g m\"";
const std::string limit = "limits = {\"machine.seat.z\" = \"2 mm\"}";

TEST(SampledBands, AreThoseOfSingleResponsesWithLossFactors) {
  expect_bands_of_single_responses(machine(harmonic, "{loss_factor = 0.1}", limit), true);
}

TEST(SampledBands, AreThoseOfSingleResponsesUnderAnUnbalance) {
  expect_bands_of_single_responses(machine(unbalance, "{translation = [400, 400, 900]}", limit), true);
}

// A damping ratio has no kernel: all designs are assembled.
TEST(SampledBands, AreThoseOfSingleResponsesFromModels) {
  expect_bands_of_single_responses(machine(harmonic, "{loss_factor = 0.1}", limit + "\ndamping_ratio = 0.01"), false);
}

}  // namespace sampled_bands_test
}  // namespace trivet
