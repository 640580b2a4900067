// SPDX-License-Identifier: BSD-3-Clause
// Evaluation of a curve model.
#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/response/steady/channel_terms.h"
#include "trivet/response/steady/curve_model.h"

namespace trivet::response {

Eigen::MatrixXcd CurveModel::at(const std::vector<double>& omega) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Constant(curves, std::ssize(omega), std::complex<double>(nan, nan));
  for (const ModelPiece& piece : pieces) {
    std::vector<double> inside;
    std::vector<Eigen::Index> columns;
    for (std::size_t i = 0; i < omega.size(); ++i) {
      if (!(omega[i] >= piece.band.from && omega[i] <= piece.band.to)) continue;
      if (std::ranges::find(check.undefined_at, omega[i]) != check.undefined_at.end()) continue;
      inside.push_back(omega[i]);
      columns.push_back(to_index(i));
    }
    if (inside.empty()) continue;
    const Eigen::MatrixXcd parts = piece.fit.at(Eigen::Map<const Eigen::VectorXd>(inside.data(), std::ssize(inside)));
    for (std::size_t k = 0; k < inside.size(); ++k)
      result.col(columns[k]) = summed(parts.col(to_index(k)), delays, inside[k]);
  }
  return result;
}

std::vector<std::vector<Extremum>> extrema(const Peaks& peaks, const assembly::Band& band) {
  std::vector<std::vector<Extremum>> result(peaks.turnings.size());
  const auto inside = [&](double w, double amplitude) {
    return w >= band.from && w <= band.to && std::isfinite(amplitude);
  };
  for (std::size_t c = 0; c < peaks.turnings.size(); ++c)
    for (const Extremum& t : peaks.turnings[c]) {
      Extremum extremum = t;
      for (const Peak& peak : peaks.list)
        if (peak.curve == c && t.maximum && std::abs(peak.angular_frequency - t.angular_frequency) <= t.reach &&
            std::isfinite(peak.amplitude) && std::abs(peak.amplitude - t.amplitude) <= 1e-6 * t.amplitude)
          extremum = {peak.angular_frequency, peak.amplitude, true, t.reach, peak.frequency_uncertainty};
      if (inside(extremum.angular_frequency, extremum.amplitude)) result[c].push_back(extremum);
    }
  return result;
}

FrequencyResponse interpolated(const CurveModel& model, const std::vector<assembly::Channel>& channels,
                               const Peaks& peaks, const std::vector<double>& angular_frequency) {
  const Eigen::MatrixXcd values = model.at(angular_frequency);
  const std::vector<std::vector<Extremum>> exact = extrema(peaks, model.band);
  FrequencyResponse result{angular_frequency, {}, model.check, model.solves, model.worst_error};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    Curve& curve =
        result.curves.emplace_back(Curve{channels[c].name, channels[c].unit, values.row(to_index(c)).transpose()});
    for (std::size_t k = 0; c < exact.size() && k < exact[c].size(); ++k) {
      const auto at = std::ranges::lower_bound(angular_frequency, exact[c][k].angular_frequency);
      if (!exact[c][k].maximum || at == angular_frequency.end() || *at != exact[c][k].angular_frequency) continue;
      std::complex<double>& value = curve.value(at - angular_frequency.begin());
      if (std::abs(value) > 0) value *= exact[c][k].amplitude / std::abs(value);
    }
  }
  return result;
}

}  // namespace trivet::response
