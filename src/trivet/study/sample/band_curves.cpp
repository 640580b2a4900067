// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/band_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/response/steady/frequency_grid.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/packed_amplitudes.h"

namespace trivet::study {
namespace {

/// Of a band from 0 the lowest frequency: this share of the highest.
constexpr double least_share = 0.01;

/// Half of the points equally spaced, as resonances at high frequencies need, half in equal ratios, as those at low
/// frequencies do; or all as the response has them.
std::vector<double> spaced(const project::ResponseRequest& response, const assembly::Band& band, int points) {
  const assembly::Band above{band.from > 0 ? band.from : least_share * band.to, band.to};
  if (response.spacing == project::Spacing::linear) return response::linear_grid(above, points);
  if (response.spacing == project::Spacing::logarithmic) return response::logarithmic_grid(above, points);
  std::vector<double> grid = response::linear_grid(above, points - points / 2);
  const std::vector<double> ratios = response::logarithmic_grid(above, points / 2 + 2);
  grid.insert(grid.end(), ratios.begin() + 1, ratios.end() - 1);  // both have the ends
  return grid;
}

/// The points with the peaks of the given design, ascending.
std::vector<double> frequencies(const CaseContext& context, const project::ResponseRequest& response,
                                const std::vector<assembly::Channel>& channels, int points) {
  std::vector<double> grid = response.at;
  if (grid.empty()) {
    const assembly::Band band = response.band ? *response.band : default_band(context);
    if (!(band.from < band.to))
      throw foundation::NotComputable(
          "sample: the tables of the elements and the natural frequencies have no band in common; give the response "
          "a band");
    grid = spaced(response, band, points);
    const assembly::Loading load =
        assembly::harmonic_loading(context.system, context.assembled, response.selection.excitations);
    for (const response::Peak& peak :
         response::peaks(context.assembled, channels, load, context.modes, context.roots(), {.search_to = band.to})
             .list)
      if (peak.angular_frequency >= band.from && peak.angular_frequency <= band.to)
        grid.push_back(peak.angular_frequency);
  }
  std::ranges::sort(grid);
  constexpr double same = 1e-9;
  grid.erase(std::unique(grid.begin(), grid.end(), [](double a, double b) { return b - a <= same * b; }), grid.end());
  return grid;
}

}  // namespace

std::size_t SampledBand::worst() const {
  const auto at = std::ranges::max_element(spread, {}, &Spread::high);
  return to_size(at - spread.begin());
}

BandCurves::BandCurves(const project::Case& variant, const project::SampleRequest& request)
    : case_(variant), response_(*variant.analyses.response) {
  const CaseContext context(variant.system, {});
  std::vector<assembly::Channel> channels;
  for (assembly::Channel& one :
       assembly::channels(context.system, context.assembled, request.bands, response_.selection.quantity))
    if (std::ranges::find(channels, one.name, &assembly::Channel::name) == channels.end())
      channels.push_back(std::move(one));
  frequencies_ = frequencies(context, response_, channels, request.band_points);
  for (const assembly::Channel& channel : channels) {
    RequirementResult& curve = curves_.emplace_back();
    curve.subject = channel.name;
    curve.unit = channel.unit;
    curve.quantity = response_.selection.quantity;
    curve.excitations = response_.selection.excitations;
    curve.band = {frequencies_.front(), frequencies_.back()};
  }
  given_ = amplitudes(variant.system);
}

std::vector<SampledBand> BandCurves::empty(const std::vector<RequirementResult>& given) const {
  std::vector<SampledBand> bands;
  const auto count = to_index(frequencies_.size());
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const RequirementResult& curve = curves_[c];
    SampledBand& band = bands.emplace_back();
    band.name = curve.subject;
    band.unit = curve.unit;
    band.angular_frequency = frequencies_;
    const auto own = given_.segment(to_index(c) * count, count);
    band.given.assign(own.begin(), own.end());
    band.is_logarithmic = response_.spacing == project::Spacing::logarithmic;
    band.no_kernels = no_kernels_;
    for (const RequirementResult& one : given)
      // Forces have no velocity: by the unit a limit is one of the same curve, whatever the quantity of motions is.
      if (one.kind == RequirementKind::amplitude && one.subject == curve.subject && one.unit == curve.unit &&
          one.excitations == curve.excitations && one.order == 0 && !one.transmitted)
        band.limits.push_back({one.band, one.allowed});
  }
  return bands;
}

void BandCurves::fit(const DesignNumbers& numbers) {
  if (frequencies_.front() == 0) {
    no_kernels_ = "kernels have no limit at rest";
    return;
  }
  batch_.emplace(numbers, case_, case_.analyses, curves_);
  no_kernels_ = batch_->reason();
  if (no_kernels_.empty() && !batch_->packed().covers(0)) no_kernels_ = "the curves have no kernel";
}

Eigen::ArrayXXd BandCurves::amplitudes(const Eigen::MatrixXd& numbers) const {
  const CaseVector& packed = batch_->packed();
  const CaseVector::Unpacked designs = batch_->designs(numbers);
  const numerics::DrivenDesigns driven = packed.searched(designs, packed.searches().front());
  Eigen::ArrayXXd all(values(), numbers.rows());
  for (Eigen::Index d = 0; d < numbers.rows(); ++d)
    if (designs.falls[d]) all.col(d).setConstant(std::numeric_limits<double>::quiet_NaN());
    else all.col(d) = packed_amplitudes(driven, d, frequencies_).reshaped();
  return all;
}

Eigen::ArrayXd BandCurves::amplitudes(const model::System& system) const {
  const assembly::Assembled assembled = assembly::assemble(system);
  std::vector<assembly::Channel> channels;
  for (const RequirementResult& curve : curves_)
    channels.push_back(assembly::channels(system, assembled, {curve.subject}, curve.quantity).front());
  const response::FrequencyResponse found = response::frequency_response(
      assembled, channels, assembly::harmonic_loading(system, assembled, response_.selection.excitations),
      frequencies_);
  Eigen::ArrayXd all(values());
  const auto count = to_index(frequencies_.size());
  for (std::size_t c = 0; c < found.curves.size(); ++c)
    for (Eigen::Index f = 0; f < count; ++f) {
      const double amplitude = std::abs(found.curves[c].value(f));
      all(to_index(c) * count + f) = std::isfinite(amplitude) ? amplitude : foundation::infinity;
    }
  return all;
}

}  // namespace trivet::study
