// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/random_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pole_residue.h"
#include "trivet/response/random/pole_expansion.h"
#include "trivet/response/random/random_methods.h"
#include "trivet/response/random/random_variance.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::response {

namespace {

/// Largest estimated error at which a number is reported.
constexpr double hopeless = 1e-2;

void refuse_errors(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                   const RandomLoading& loading, const RandomOptions& options) {
  foundation::refuse_errors(check(loading, "random response"));
  for (const RandomInput& input : loading.inputs)
    if (input.loading.force.size() != assembled.layout.size())
      throw foundation::InvalidInput(fmt::format("random input \"{}\": its load belongs to another model", input.name));
  for (const WeightedChannel& weighted : options.weighted) {
    if (weighted.channel >= channels.size())
      throw foundation::InvalidInput(
          fmt::format("weighted channel {}: there are {} channels", weighted.channel, channels.size()));
    const std::string& unit = channels[weighted.channel].unit;
    if (!unit.starts_with("m") && !unit.starts_with("rad"))
      throw foundation::InvalidInput(fmt::format("\"{}\" [{}]: human-vibration weighting applies to motions only",
                                                 channels[weighted.channel].name, unit));
  }
  if (!(options.accuracy >= 1e-13 && options.accuracy <= 1e-2))
    throw foundation::InvalidInput(fmt::format("accuracy {}: it must be within 1e-13 … 1e-2", options.accuracy));
}

/// True if a free motion grows: then no stationary vibration exists. With loss factors only poles with ω > 0 have a
/// meaning.
bool grows(const assembly::Assembled& assembled, const Eigen::VectorXcd& poles) {
  const double fastest = poles.size() ? poles.cwiseAbs().maxCoeff() : 0;
  return std::ranges::any_of(poles, [&](const std::complex<double>& pole) {
    return pole.real() > 1e-12 * fastest && (!assembled.matrices.lossy() || pole.imag() > 0);
  });
}

RandomChannel channel_result(const assembly::Channel& channel, const RandomVariances& found,
                             const std::vector<RandomMoment>& moments, Eigen::Index c) {
  RandomChannel result;
  result.name = channel.name;
  result.unit = channel.unit;
  result.estimated_error = found.error(c);
  result.vanishes = found.vanishes[c];
  const std::vector<std::string>& reason = found.reason[c];
  // The first missing moment gives the reason.
  for (const std::string& r : reason)
    if (result.reason.empty()) result.reason = r;
  if (!(result.estimated_error <= hopeless)) {
    result.reason = fmt::format("the integral did not converge: its estimated error is {:.2g} of its value",
                                result.estimated_error);
    return result;
  }
  const auto root = [&](std::size_t moment) -> std::optional<double> {
    if (!reason[moment].empty()) return std::nullopt;
    return result.vanishes ? 0 : std::sqrt(std::max(0.0, found.mean_square(c, to_index(moment))));
  };
  result.rms = root(0);
  result.rms_of_derivative = root(1);
  result.infinite_rms = !result.rms;  // a moment with a reason is unbounded
  result.infinite_rms_of_derivative = !result.rms_of_derivative;
  for (std::size_t m = 2; m < moments.size(); ++m)
    if (moments[m].channels.front() == c) {
      result.weighted_rms = root(m);
      result.infinite_weighted_rms = !result.weighted_rms;
    }
  if (!result.rms && !result.rms_of_derivative && !result.weighted_rms)
    result.estimated_error = std::numeric_limits<double>::quiet_NaN();
  if (!result.rms) return result;
  result.three_sigma = 3 * *result.rms;
  if (*result.rms == 0) return result;
  if (result.rms_of_derivative)
    result.zero_crossings = *result.rms_of_derivative / (2 * std::numbers::pi * *result.rms);
  const double variance = found.mean_square(c, 0);
  for (Eigen::Index i = 0; i < found.share.cols(); ++i) result.variance_share.push_back(found.share(c, i) / variance);
  // Shares of correlated inputs may be negative: round-off of their sum is that of their magnitudes.
  assert(std::abs(found.share.row(c).sum() - variance) <= 1e-9 * found.share.row(c).cwiseAbs().sum() &&
         "each pair of inputs belongs half to either");
  return result;
}

bool poles_hold(const RandomVariances& found, double accuracy) {
  return found.misfit.size() == 0 || found.misfit.maxCoeff() <= accuracy;
}

}  // namespace

const char* name(RandomMethod method) { return method == RandomMethod::poles ? "poles" : "quadrature"; }

foundation::Problems check(const RandomLoading& loading, const std::string& subject) {
  foundation::Problems problems;
  if (loading.inputs.empty())
    problems.error(subject, "no random excitation", "the system needs an excitation",
                   "add an excitation of type \"random\"");
  excitation::RandomInputs inputs{{}, loading.pairs};
  for (const RandomInput& input : loading.inputs) {
    inputs.spectra.push_back(input.spectrum);
    const std::string of_input = subject + "." + input.name;
    if (input.loading.vanishes())
      problems.error(of_input, "acts on no free coordinate", "an excitation must act on a free coordinate",
                     "give it a direction that is free");
    if (input.spectrum.pieces.empty())
      problems.error(of_input, "no spectrum", "a random excitation has a power spectral density", "add psd");
    for (const excitation::SpectrumPiece& p : input.spectrum.pieces)
      if (!(p.from >= 0 && p.from < p.to && p.density_from >= 0 && p.density_to >= 0) ||
          !std::isfinite(p.to + p.density_from + p.density_to))
        problems.error(of_input,
                       fmt::format("density {:.6g} … {:.6g} in {}", p.density_from, p.density_to,
                                   foundation::hertz_range(p.from, p.to, 6)),
                       "frequencies ascend, and densities are finite and not negative", "correct the table");
  }
  if (!problems.has_errors()) problems.add(excitation::check(inputs, subject));
  return problems;
}

RandomResponse random_response(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                               const RandomLoading& loading, const RandomOptions& options,
                               const foundation::Progress& progress) {
  refuse_errors(assembled, channels, loading, options);
  const std::vector<RandomMoment> moments = random_moments(channels, options);
  std::vector<const assembly::Loading*> loads;
  for (const RandomInput& input : loading.inputs) loads.push_back(&input.loading);
  const PoleExpansions expansions = pole_expansions(assembled, channels, loads);

  RandomResponse result;
  result.from = std::numeric_limits<double>::infinity();
  for (const RandomInput& input : loading.inputs) {
    result.from = std::min(result.from, input.spectrum.from());
    result.to = std::max(result.to, input.spectrum.to());
  }
  if (grows(assembled, expansions.poles)) {
    for (const assembly::Channel& channel : channels) {
      RandomChannel none;
      none.name = channel.name;
      none.unit = channel.unit;
      none.reason = "the free motion grows: no stationary vibration exists";
      result.channels.push_back(std::move(none));
    }
    return result;
  }
  RandomVariances found;
  if (assembled.frequency_dependent()) {
    result.remark = "elements are frequency-dependent";
  } else {
    found = variances_by_poles(assembled, channels, loading, moments, expansions, progress);
    result.solutions = found.solutions;
    const double misfit = 0.5 * found.misfit.maxCoeff();
    if (!poles_hold(found, options.accuracy))
      result.remark = std::isfinite(misfit)
          ? fmt::format(
                "two poles nearly coincide and share one shape, as at critical damping: "
                "their partial fractions miss the response by {:.1g} of it",
                misfit)
          : "the poles lie too far apart for partial fractions";
  }
  if (!result.remark.empty()) {
    result.method = RandomMethod::quadrature;
    found = variances_by_quadrature(assembled, channels, loading, moments, expansions.poles, options, progress);
    result.solutions += found.solutions;
  }
  for (std::size_t c = 0; c < channels.size(); ++c)
    result.channels.push_back(channel_result(channels[c], found, moments, to_index(c)));
  return result;
}

RandomLoading random_loading(const model::System& system, const assembly::Assembled& assembled,
                             const std::vector<std::string>& selected) {
  const auto& excitations = system.description().excitations;
  for (const std::string& name : selected)
    if (std::ranges::none_of(excitations, [&](const model::Excitation& excitation) {
          return excitation.name == name && std::holds_alternative<model::Random>(excitation.course);
        }))
      throw foundation::InvalidInput("\"" + name + "\" is not a random excitation of this model");
  RandomLoading result;
  std::vector<const model::Random*> courses;
  for (const model::Excitation& excitation : excitations) {
    const auto* random = std::get_if<model::Random>(&excitation.course);
    if (!random || !model::is_selected(excitation, selected)) continue;
    result.inputs.push_back({excitation.name, assembly::loading(assembled, excitation.action), random->spectrum});
    courses.push_back(random);
  }
  for (std::size_t i = 0; i < courses.size(); ++i)
    for (const model::Random::Partner& partner : courses[i]->partners)
      for (std::size_t k = 0; k < result.inputs.size(); ++k) {
        const bool known =
            std::ranges::any_of(result.pairs, [&](const auto& pair) { return pair.first == k && pair.second == i; });
        if (result.inputs[k].name == partner.other && !known) result.pairs.push_back({i, k, partner.coherence, 0});
      }
  return result;
}

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
  foundation::refuse_errors(check(loading, "random response"));
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
