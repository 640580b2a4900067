// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/limit_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/search/zeros_and_minima.h"
#include "trivet/response/steady/frequency_response.h"

namespace trivet::response {
namespace {

using foundation::infinity;

/// One straight piece of the line on logarithmic axes; limits zero-to-peak.
struct Piece {
  assembly::Band band;
  double from_limit = 0, to_limit = 0;
  double at(double omega) const {
    return from_limit * std::pow(omega / band.from, std::log(to_limit / from_limit) / std::log(band.to / band.from));
  }
};

std::vector<Piece> pieces(const assembly::LimitLine& line) {
  const double factor = line.rms ? std::numbers::sqrt2 : 1;
  std::vector<Piece> result;
  for (std::size_t i = 0; i + 1 < line.limit.size(); ++i)
    if (line.angular_frequency[i] < line.angular_frequency[i + 1])
      result.push_back({{line.angular_frequency[i], line.angular_frequency[i + 1]},
                        factor * line.limit[i],
                        factor * line.limit[i + 1]});
  return result;
}

/// Level over limit at one ω.
struct Node {
  double omega = 0;
  double ratio = 0;
};

/// The level over one piece of the line.
class Comparison {
 public:
  Comparison(const assembly::Assembled& assembled, const assembly::Channel& channel, const assembly::Loading& loading,
             const Piece& piece)
      : assembled_(assembled), channel_(channel), loading_(loading), piece_(piece) {}

  std::vector<Node> nodes(const std::vector<double>& omega) const {
    const FrequencyResponse response = frequency_response(assembled_, {channel_}, loading_, omega);
    std::vector<Node> result;
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const double size = std::abs(response.curves[0].value(to_index(i)));
      result.push_back(
          {omega[i], std::isnan(size) ? infinity : size / piece_.at(omega[i])});  // no value: an undamped resonance
    }
    return result;
  }
  Node node(double omega) const { return nodes({omega}).front(); }

  /// Highest ratio between two frequencies with one maximum between them.
  Node highest_between(double from, double to) const {
    const numerics::Minimum found =
        numerics::minimum_between(from, to, [&](double omega) { return -node(omega).ratio; });
    return {found.at, -found.value};
  }

  /// Frequency at which the ratio crosses 1 between two neighbours on either side of 1.
  double crossing(const Node& a, const Node& b) const {
    const auto excess = [&](double omega) {
      const double ratio = omega == a.omega ? a.ratio : omega == b.omega ? b.ratio : node(omega).ratio;
      return 1 - 2 / (1 + ratio);  // 1 if it is infinite
    };
    return numerics::zero_between(a.omega, b.omega, excess);
  }

 private:
  const assembly::Assembled& assembled_;
  const assembly::Channel& channel_;
  const assembly::Loading& loading_;
  const Piece& piece_;
};

/// Adds the true maxima next to grid points that may hide one above 1 or above all others; the grid follows the curve
/// to better than `hidden`.
void add_maxima(const Comparison& comparison, const foundation::Progress& progress, std::vector<Node>& nodes) {
  constexpr double hidden = 0.03;
  double highest = 0;
  for (const Node& node : nodes)
    if (std::isfinite(node.ratio)) highest = std::max(highest, node.ratio);
  std::vector<Node> maxima;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool rises = i == 0 || nodes[i].ratio >= nodes[i - 1].ratio,
               falls = i + 1 == nodes.size() || nodes[i].ratio >= nodes[i + 1].ratio;
    const double ratio = nodes[i].ratio;
    foundation::report_progress(progress, "limit line", static_cast<double>(i) / static_cast<double>(nodes.size()));
    if (!rises || !falls || !std::isfinite(ratio)) continue;
    if (ratio < (1 - hidden) * highest && !(ratio > 1 - hidden && ratio <= 1)) continue;
    const Node maximum =
        comparison.highest_between(nodes[i == 0 ? 0 : i - 1].omega, nodes[std::min(i + 1, nodes.size() - 1)].omega);
    if (maximum.ratio > ratio) maxima.push_back(maximum);
  }
  nodes.insert(nodes.end(), maxima.begin(), maxima.end());
  std::ranges::sort(nodes, {}, &Node::omega);
}

void add_exceeded(const Comparison& comparison, const foundation::Progress& progress, const std::vector<Node>& nodes,
                  std::vector<assembly::Band>& exceeded) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    foundation::report_progress(progress, "limit line", static_cast<double>(i) / static_cast<double>(nodes.size()));
    const bool above = nodes[i].ratio > 1, before = i > 0 && nodes[i - 1].ratio > 1;
    if (above && !before) {
      const double from = i == 0 ? nodes[i].omega : comparison.crossing(nodes[i - 1], nodes[i]);
      if (i == 0 && !exceeded.empty() && exceeded.back().to == from)
        exceeded.back().to = nodes[i].omega;  // continues the previous piece
      else exceeded.push_back({from, nodes[i].omega});
    }
    if (before) exceeded.back().to = above ? nodes[i].omega : comparison.crossing(nodes[i - 1], nodes[i]);
  }
}

}  // namespace

double zero_to_peak_limit(const assembly::LimitLine& line, double angular_frequency) {
  double lowest = infinity;
  for (const Piece& piece : pieces(line))
    if (angular_frequency >= piece.band.from && angular_frequency <= piece.band.to)
      lowest = std::min(lowest, piece.at(angular_frequency));
  if (std::isinf(lowest))
    throw foundation::InvalidInput(fmt::format("limit line \"{}\" is not defined at {}", line.name,
                                               foundation::hertz_words(angular_frequency, 6)));
  return lowest;
}

LimitComparison compared_with_limit(const assembly::Assembled& assembled, const assembly::Channel& channel,
                                    const assembly::Loading& loading, const Eigen::VectorXcd& poles, const Peaks& peaks,
                                    const assembly::LimitLine& line, const assembly::Band& band,
                                    const foundation::Progress& progress) {
  foundation::refuse_errors(check(line, "limit line"));
  if (line.unit != channel.unit)
    throw foundation::InvalidInput(fmt::format("limit line \"{}\" is in {}, {} in {}; the units must agree", line.name,
                                               line.unit, channel.name, channel.unit));
  LimitComparison result;
  result.compared = {std::max(band.from, line.angular_frequency.front()),
                     std::min(band.to, line.angular_frequency.back())};
  if (!(result.compared.to > result.compared.from))
    throw foundation::NotComputable(fmt::format(
        "limit line \"{}\" runs from {:g} to {:g} Hz, the band from {:g} to {:g} Hz: they do not overlap", line.name,
        line.angular_frequency.front() / foundation::two_pi, line.angular_frequency.back() / foundation::two_pi,
        band.from / foundation::two_pi, band.to / foundation::two_pi));
  const std::vector<double> grid =
      automatic_grid(assembled, {channel}, loading, poles, peaks, result.compared, progress);
  std::vector<Node> all;
  for (const Piece& piece : pieces(line)) {
    const assembly::Band part{std::max(piece.band.from, result.compared.from),
                              std::min(piece.band.to, result.compared.to)};
    if (!(part.to > part.from)) continue;
    std::vector<double> omega = {part.from};
    std::ranges::copy_if(grid, std::back_inserter(omega), [&](double w) { return w > part.from && w < part.to; });
    omega.push_back(part.to);
    const Comparison comparison(assembled, channel, loading, piece);
    std::vector<Node> nodes = comparison.nodes(omega);
    for (const Peak& peak : peaks.list)
      if (std::isinf(peak.amplitude) && peak.angular_frequency > part.from && peak.angular_frequency < part.to)
        nodes.push_back({peak.angular_frequency, infinity});
    std::ranges::sort(nodes, {}, &Node::omega);
    add_maxima(comparison, progress, nodes);
    add_exceeded(comparison, progress, nodes, result.exceeded);
    all.insert(all.end(), nodes.begin(), nodes.end());
  }
  result.margin.resize(to_index(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double margin = 1 / all[i].ratio;
    result.angular_frequency.push_back(all[i].omega);
    result.margin(to_index(i)) = margin;
    if (!(margin < result.least_margin)) continue;
    result.least_margin = margin;
    result.least_margin_at = all[i].omega;
  }
  return result;
}

double margin_level(double margin) { return margin == 0 ? -infinity : 20 * std::log10(margin); }

}  // namespace trivet::response
