// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pole_residue.h"
#include "trivet/response/random/random_variance.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::response {
namespace {

/// Grid with linear and logarithmic spacing over the band, dense around every pole, with points on both sides of every
/// breakpoint.
std::vector<double> dense_grid(const Eigen::VectorXcd& poles, const RandomLoading& loading) {
  constexpr double beside = 1e-9;
  std::vector<double> points;
  for (const RandomInput& input : loading.inputs)
    for (const double w : excitation::breakpoints(input.spectrum))
      points.insert(points.end(), {w * (1 - beside), w, w * (1 + beside)});
  double from = std::numeric_limits<double>::infinity(), to = 0;
  for (const RandomInput& input : loading.inputs)
    from = std::min(from, input.spectrum.from()), to = std::max(to, input.spectrum.to());
  const assembly::Band band{from, to};
  for (const double w : linear_grid(band, 301)) points.push_back(w);
  for (const double w : logarithmic_grid({from > 0 ? from : 1e-4 * to, to}, 301)) points.push_back(w);
  for (Eigen::Index k = 0; k < poles.size(); ++k) {
    const double centre = poles(k).imag(), width = std::max(std::abs(poles(k).real()), 1e-6 * centre);
    // Equal steps of phase φ: at ω = centre + width tan φ a resonance has the square cos² φ.
    for (int degrees = -88; degrees <= 88 && centre > 0; degrees += 4)
      points.push_back(centre + width * std::tan(degrees * std::numbers::pi / 180));
  }
  const bool undefined_at_rest =
      std::ranges::any_of(loading.inputs, [](const RandomInput& input) { return input.loading.lowest_power() < 0; });
  std::erase_if(points, [&](double w) { return !(w >= from && w <= to) || (w == 0 && undefined_at_rest); });
  std::ranges::sort(points);
  points.erase(std::ranges::unique(points).begin(), points.end());
  return points;
}

}  // namespace

RandomCurves random_curves(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                           const RandomLoading& loading, std::vector<double> angular_frequency,
                           const foundation::Progress& progress) {
  const foundation::Problems problems = check(loading, "random response");
  for (const foundation::Problem& problem : problems.list())
    if (problem.severity == foundation::Severity::error) throw foundation::InvalidInput(foundation::message(problem));
  RandomCurves result;
  result.angular_frequency = std::move(angular_frequency);
  if (result.angular_frequency.empty())
    result.angular_frequency = dense_grid(
        numerics::pole_residue_form(assembled.matrices, Eigen::MatrixXcd(assembled.matrices.size(), 0)).poles, loading);
  std::vector<FrequencyResponse> responses;
  for (const RandomInput& input : loading.inputs) {
    foundation::report_progress(progress, "spectra",
                                static_cast<double>(responses.size()) / static_cast<double>(loading.inputs.size()));
    responses.push_back(frequency_response(assembled, channels, input.loading, result.angular_frequency));
  }
  const Eigen::VectorXd omega =
      Eigen::Map<const Eigen::VectorXd>(result.angular_frequency.data(), to_index(result.angular_frequency.size()));
  result.density.assign(channels.size(), std::vector<double>(result.angular_frequency.size(), 0));
  for (std::size_t j = 0; j < responses.size(); ++j)
    for (std::size_t k = 0; k <= j; ++k) {
      const Eigen::VectorXcd cross = cross_density(loading, k, j, omega);
      for (std::size_t c = 0; c < channels.size() && cross.size() > 0; ++c)
        for (Eigen::Index i = 0; i < omega.size(); ++i) {
          const double part =
              (responses[j].curves[c].value(i) * std::conj(responses[k].curves[c].value(i)) * cross(i)).real();
          result.density[c][i] += j == k ? part : 2 * part;
        }
    }
  return result;
}

}  // namespace trivet::response
