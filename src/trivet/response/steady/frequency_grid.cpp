// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/frequency_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

constexpr std::size_t most_points = 20000;
constexpr int most_rounds = 40;
constexpr double amplitude_tolerance = 7e-4;
constexpr std::array parts = {0.25, 0.5, 0.75};  // of an interval: where a curve is compared with its straight line
constexpr double phase_step = std::numbers::pi / 9;
constexpr double invisible = 1e-6;         // of a curve's largest amplitude: not visible in a plot
constexpr double model_round_off = 1e-10;  // of the largest curve of its unit: below it a model contains only round-off
constexpr double least_step = 1e-9;

void keep_inside(std::vector<double>& grid, const assembly::Band& band) {
  std::erase_if(grid, [&](double w) { return !(w >= band.from && w <= band.to); });
  std::ranges::sort(grid);
  grid.erase(std::ranges::unique(grid).begin(), grid.end());
}

std::vector<double> first_guess(const assembly::Band& band, const Peaks& peaks, const std::vector<double>& more = {}) {
  std::vector<double> grid = linear_grid(band, 65);
  if (band.from > 0) {
    const std::vector<double> decades = logarithmic_grid(band, 33);
    grid.insert(grid.end(), decades.begin(), decades.end());
  }
  grid.insert(grid.end(), more.begin(), more.end());
  for (const auto& of_curve : extrema(peaks, band))
    for (const Extremum& extremum : of_curve) grid.push_back(extremum.angular_frequency);
  keep_inside(grid, band);
  return grid;
}

/// Values of all curves at frequencies, curves × frequencies; NaN where undefined.
using Values = std::function<Eigen::MatrixXcd(const std::vector<double>& angular_frequency)>;

/// Largest finite amplitude of each curve; infinite for one that is only round-off (all of it is ignored), and 0 for
/// one that rises to infinity (none of it is ignored).
Eigen::VectorXd largest(const Eigen::MatrixXcd& values, const Peaks& peaks) {
  Eigen::VectorXd top =
      values.cwiseAbs().unaryExpr([](double a) { return std::isfinite(a) ? a : 0.0; }).rowwise().maxCoeff();
  const Eigen::VectorXd heights = top;
  assert(to_index(peaks.curves.size()) <= top.size());
  for (std::size_t c = 0; c < peaks.curves.size(); ++c)
    for (std::size_t other = 0; other < peaks.curves.size(); ++other)
      if (peaks.curves[other].unit == peaks.curves[c].unit &&
          heights(to_index(c)) < model_round_off * heights(to_index(other)))
        top(to_index(c)) = std::numeric_limits<double>::infinity();
  for (const Peak& peak : peaks.list)
    if (std::isinf(peak.amplitude)) top(to_index(peak.curve)) = 0;
  for (std::size_t c = 0; c < peaks.curves.size() && c < to_size(top.size()); ++c)
    if (peaks.curves[c].vanishes) top(to_index(c)) = std::numeric_limits<double>::infinity();
  return top;
}

using Column = Eigen::Ref<const Eigen::VectorXcd>;

/// True if any curve deviates from the straight line from a to b at the share `part` of its length, or changes its
/// phase too fast.
bool bends(const Column& from, const Column& between, const Column& to, double part, const Eigen::VectorXd& top) {
  for (Eigen::Index c = 0; c < top.size(); ++c) {
    const std::complex<double> a = from(c), m = between(c), b = to(c);
    const double size = std::max({std::abs(a), std::abs(b), std::abs(m)});
    if (!std::isfinite(size) || size <= invisible * top(c)) continue;
    if (std::abs(std::abs(m) - (1 - part) * std::abs(a) - part * std::abs(b)) >
        amplitude_tolerance * std::max(std::abs(m), 1e-3 * size))
      return true;
    if (std::abs(std::arg(m * std::conj(a))) > phase_step || std::abs(std::arg(b * std::conj(m))) > phase_step)
      return true;
  }
  return false;
}

/// An interval of the grid that may need another point.
struct Interval {
  double from = 0, to = 0;
  Eigen::VectorXcd at_from, at_to;
};

}  // namespace

std::vector<double> linear_grid(const assembly::Band& band, int points) {
  assert(points >= 2 && band.to >= band.from);
  std::vector<double> grid;
  for (int i = 0; i < points; ++i)
    grid.push_back(i + 1 == points ? band.to : band.from + (band.to - band.from) * i / (points - 1));
  return grid;
}

std::vector<double> logarithmic_grid(const assembly::Band& band, int points) {
  assert(points >= 2 && band.from > 0 && "equal ratios need a beginning above 0");
  std::vector<double> grid;
  for (int i = 0; i < points; ++i)
    grid.push_back(i + 1 == points ? band.to
                                   : band.from * std::pow(band.to / band.from, static_cast<double>(i) / (points - 1)));
  return grid;
}

namespace {

/// Halves the intervals of a first guess until straight lines follow every curve.
std::vector<double> halved(std::vector<double> grid, const Values& values_at, const Peaks& peaks) {
  if (grid.size() < 2) return grid;
  assert(std::ranges::is_sorted(grid) && "intervals are between neighbours");
  const Eigen::MatrixXcd values = values_at(grid);
  const Eigen::VectorXd top = largest(values, peaks);
  std::vector<Interval> open;
  for (std::size_t i = 0; i + 1 < grid.size(); ++i)
    open.push_back({grid[i], grid[i + 1], values.col(to_index(i)), values.col(to_index(i) + 1)});
  for (int round = 0; round < most_rounds && !open.empty() && grid.size() < most_points; ++round) {
    std::vector<double> inner;
    for (const Interval& interval : open)
      for (const double part : parts) inner.push_back(interval.from + part * (interval.to - interval.from));
    const Eigen::MatrixXcd found = values_at(inner);
    std::vector<Interval> halves;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Eigen::MatrixXcd inside = found.middleCols(to_index(parts.size() * i), std::ssize(parts));
      bool straight = true;
      for (std::size_t k = 0; k < parts.size(); ++k)
        straight = straight && !bends(open[i].at_from, inside.col(to_index(k)), open[i].at_to, parts[k], top);
      if (straight || open[i].to - open[i].from <= least_step * open[i].to) continue;
      const double middle = inner[parts.size() * i + 1];
      grid.push_back(middle);
      halves.push_back({open[i].from, middle, open[i].at_from, inside.col(1)});
      halves.push_back({middle, open[i].to, inside.col(1), open[i].at_to});
    }
    open = std::move(halves);
  }
  std::ranges::sort(grid);
  return grid;
}

}  // namespace

std::vector<double> drawing_grid(const CurveModel& model, const Peaks& peaks) {
  std::vector<double> more = model.check.undefined_at;
  for (const ModelPiece& piece : model.pieces) {
    more.insert(more.end(), {piece.band.from, piece.band.to});
    more.insert(more.end(), piece.fit.nodes.begin(), piece.fit.nodes.end());
  }
  std::vector<double> grid = first_guess(model.band, peaks, more);
  if (model.curves == 0) return grid;
  return halved(std::move(grid), [&](const std::vector<double>& at) { return model.at(at); }, peaks);
}

std::vector<double> automatic_grid(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                   const assembly::Loading& loading, const Eigen::VectorXcd& poles, const Peaks& peaks,
                                   const assembly::Band& band, const foundation::Progress& progress) {
  // With constant matrices, solving takes less time than fitting a model and evaluating it.
  if (!assembled.frequency_dependent())
    return halved(
        first_guess(band, peaks),
        [&](const std::vector<double>& at) {
          const FrequencyResponse solved = frequency_response(assembled, channels, loading, at);
          Eigen::MatrixXcd values(to_index(channels.size()), to_index(at.size()));
          for (std::size_t c = 0; c < channels.size(); ++c)
            values.row(to_index(c)) = solved.curves[c].value.transpose();
          return values;
        },
        peaks);
  return drawing_grid(curve_model(assembled, channels, loading, poles, peaks, band, {}, progress), peaks);
}

}  // namespace trivet::response
