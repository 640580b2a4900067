// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/random_methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/random/basis_integrals.h"
#include "trivet/response/steady/channel_terms.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// Relative distance at which panels end before an undamped pole.
constexpr double gap = 1e-8;
/// Relative distance to which the first panels are graded toward approximate poles.
constexpr double near_pole = 1e-2;
/// Frequency, as a share of the slowest pole, at which growth toward ω = 0 is tested: high enough for direct solutions
/// to keep digits.
constexpr double near_rest = 1e-3;

struct Panel {
  double from = 0, to = 0;
  Eigen::MatrixXd mean_square;  ///< channels × moments
  Eigen::MatrixXd difference;   ///< difference of the two rules
  Eigen::MatrixXd share;        ///< channels × inputs
};

/// Integrates panels; counts solutions and sums the possible mean squares.
class Solver {
 public:
  Solver(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
         const RandomLoading& loading, const std::vector<RandomMoment>& moments)
      : assembled_(assembled),
        channels_(channels),
        loading_(loading),
        moments_(moments),
        possible_(Eigen::VectorXd::Zero(to_index(channels.size()))) {}

  [[nodiscard]] int solutions() const { return solutions_; }
  /// Bound of the mean squares: all terms of a result added by magnitude.
  [[nodiscard]] const Eigen::VectorXd& possible() const { return possible_; }

  void integrate(Panel& panel) {
    // ∫ |W|² ω^(2 derivative) Σ_jk H_j S_kj H̄_k dω over the panel, by the 15 points of Kronrod; S_kj = S̄_jk, so pairs
    // j ≠ k count twice with their real part.
    assert(panel.from >= 0 && panel.to > panel.from);
    const double centre = 0.5 * (panel.from + panel.to), h = 0.5 * (panel.to - panel.from);
    const Eigen::VectorXd omega = centre + h * rule_.node;
    const std::vector<double> points(omega.begin(), omega.end());
    std::vector<ChannelSamples> samples;
    for (const RandomInput& input : loading_.inputs)
      samples.push_back(channel_samples(assembled_, channels_, input.loading, points));
    solutions_ += static_cast<int>(points.size() * loading_.inputs.size());
    const auto count = to_index(channels_.size()), inputs = to_index(samples.size());
    panel.mean_square = panel.difference = Eigen::MatrixXd::Zero(count, to_index(moments_.size()));
    panel.share = Eigen::MatrixXd::Zero(count, inputs);
    Eigen::MatrixXd density = Eigen::MatrixXd::Zero(count, 15);
    for (std::size_t j = 0; j < samples.size(); ++j)
      for (std::size_t k = 0; k <= j; ++k) {
        const Eigen::VectorXcd cross = cross_density(loading_, k, j, omega);
        if (cross.size() == 0) continue;
        Eigen::MatrixXd part =
            (samples[j].value.cwiseProduct(samples[k].value.conjugate()) * cross.asDiagonal()).real();
        density += j == k ? part : Eigen::MatrixXd(2 * part);
        const Eigen::VectorXd integral = part * Eigen::VectorXd(h * rule_.kronrod);
        panel.share.col(to_index(j)) += integral;
        if (j != k) panel.share.col(to_index(k)) += integral;
        if (j == k)
          possible_ += samples[j].possible.cwiseAbs2() * cross.real().cwiseProduct(Eigen::VectorXd(h * rule_.kronrod));
      }
    for (std::size_t m = 0; m < moments_.size(); ++m) {
      const Eigen::VectorXd factor = h * omega.unaryExpr([&](double w) { return multiplier(moments_[m], w); });
      const Eigen::VectorXd kronrod = factor.cwiseProduct(Eigen::VectorXd(rule_.kronrod)),
                            gauss = factor.cwiseProduct(Eigen::VectorXd(rule_.gauss));
      for (const Eigen::Index c : moments_[m].channels) {
        const auto i = to_index(m);
        panel.mean_square(c, i) = density.row(c).dot(kronrod);
        panel.difference(c, i) = std::abs(panel.mean_square(c, i) - density.row(c).dot(gauss));
      }
    }
  }

 private:
  const assembly::Assembled& assembled_;
  const std::vector<assembly::Channel>& channels_;
  const RandomLoading& loading_;
  const std::vector<RandomMoment>& moments_;
  const KronrodRule rule_ = kronrod_rule();
  Eigen::VectorXd possible_;
  int solutions_ = 0;
};

/// Computes |H| of each channel at two frequencies and sets `reason` for all moments that are `infinite` by these
/// values.
template <typename Infinite>
void mark_growth(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                 const RandomInput& input, double nearer, double farther, const std::string& reason,
                 const Infinite& infinite, RandomVariances& result) {
  assert(nearer > 0 && nearer != farther && "growth is the ratio of two distances");
  const ChannelSamples samples = channel_samples(assembled, channels, input.loading, {nearer, farther});
  for (Eigen::Index c = 0; c < samples.value.rows(); ++c) {
    const double a = std::abs(samples.value(c, 0)), b = std::abs(samples.value(c, 1));
    if (!(b > vanishing_channel * samples.possible(c, 1))) continue;
    auto& reasons = result.reason[c];
    for (std::size_t m = 0; m < reasons.size(); ++m)
      if (reasons[m].empty() && infinite(a, b, m)) reasons[m] = reason;
  }
}

void mark_infinite(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                   const RandomLoading& loading, const std::vector<RandomMoment>& moments,
                   const Eigen::VectorXcd& poles, RandomVariances& result) {
  for (const Eigen::Index k : undamped_poles_in_band(poles, loading))
    for (const RandomInput& input : loading.inputs)
      mark_growth(
          assembled, channels, input, poles(k).imag() * (1 + gap), poles(k).imag() * (1 + 1e3 * gap),
          "an undamped natural frequency is in the band of \"" + input.name + "\"",
          [](double nearer, double farther, std::size_t) { return nearer > 100 * farther; }, result);
  double slowest = std::numeric_limits<double>::infinity();
  for (const Complex& pole : poles)
    if (std::abs(pole) > 1e-9 * poles.cwiseAbs().maxCoeff()) slowest = std::min(slowest, std::abs(pole));
  for (const RandomInput& input : loading.inputs) {
    const std::optional<int> of_spectrum = order_at_rest(input.spectrum);
    if (!of_spectrum) continue;
    const double at = near_rest * std::min(slowest, input.spectrum.to());
    mark_growth(
        assembled, channels, input, at, 2 * at,
        "the spectrum of \"" + input.name + "\" begins at 0 Hz, where the result is unbounded",
        [&](double nearer, double farther, std::size_t m) {
          return nearer > 0 &&
              2 * std::round(std::log2(farther / nearer)) + *of_spectrum + order_at_rest(moments[m]) <= -1;
        },
        result);
  }
}

/// First panels: graded toward the damped poles, with a boundary at every knot of a table, and a gap around every
/// undamped pole of constant matrices.
std::vector<Panel> first_panels(const assembly::Assembled& assembled, const RandomLoading& loading,
                                const std::vector<RandomMoment>& moments, const Eigen::VectorXcd& poles) {
  const bool exact = !assembled.frequency_dependent();
  const std::vector<Eigen::Index> undamped =
      exact ? undamped_poles_in_band(poles, loading) : std::vector<Eigen::Index>{};
  Eigen::VectorXcd graded = poles;
  for (Complex& pole : graded)
    if (!exact) pole = Complex(-std::max(std::abs(pole.real()), near_pole * std::abs(pole)), pole.imag());
  for (const Eigen::Index k : undamped) graded(k) = Complex(-gap * poles(k).imag(), poles(k).imag());
  const double fastest = poles.size() ? poles.cwiseAbs().maxCoeff() : 0;
  for (Complex& pole : graded)
    if (std::abs(pole) <= 1e-9 * fastest)
      pole = fastest > 0 ? -near_rest * fastest : -1;  // at ω = 0: tested by `mark_infinite`
  std::vector<double> ends = panel_ends(graded, loading, moments);
  const auto inside = [&](double omega) { return !ends.empty() && omega > ends.front() && omega < ends.back(); };
  std::vector<double> more;
  for (const assembly::ElementMap& element : assembled.elements)
    for (const double knot : element.knots)
      if (inside(knot)) more.push_back(knot);
  std::vector<std::pair<double, double>> gaps;
  for (const Eigen::Index k : undamped) {
    const double w = poles(k).imag();
    gaps.emplace_back(w * (1 - gap), w * (1 + gap));
    for (const double end : {gaps.back().first, gaps.back().second})
      if (inside(end)) more.push_back(end);
  }
  ends.insert(ends.end(), more.begin(), more.end());
  std::ranges::sort(ends);
  ends.erase(std::ranges::unique(ends).begin(), ends.end());
  std::vector<Panel> panels;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double centre = 0.5 * (ends[i - 1] + ends[i]);
    const bool left_out =
        std::ranges::any_of(gaps, [&](const auto& g) { return centre > g.first && centre < g.second; });
    if (!left_out) panels.push_back({ends[i - 1], ends[i], {}, {}, {}});
  }
  return panels;
}

}  // namespace

RandomVariances variances_by_quadrature(const assembly::Assembled& assembled,
                                        const std::vector<assembly::Channel>& channels, const RandomLoading& loading,
                                        const std::vector<RandomMoment>& moments, const Eigen::VectorXcd& poles,
                                        const RandomOptions& options, const foundation::Progress& progress) {
  const auto count = to_index(channels.size());
  RandomVariances result = no_variances(count, moments.size(), loading.inputs.size());
  mark_infinite(assembled, channels, loading, moments, poles, result);
  Solver solver(assembled, channels, loading, moments);
  std::vector<Panel> open = first_panels(assembled, loading, moments, poles), settled;
  const double needed = 15.0 * static_cast<double>(open.size() * loading.inputs.size());
  if (needed > options.most_solutions)
    throw foundation::NotComputable(
        fmt::format("random response: the first panels alone need {:.0f} solutions, {} are allowed; delays of {:.3g} s "
                    "turn the phase too often within the band",
                    needed, options.most_solutions, longest_delay(loading)));
  Eigen::MatrixXd difference = result.mean_square;
  while (!open.empty()) {
    for (Panel& panel : open) {
      foundation::report_progress(progress, "random response by quadrature",
                                  std::min(1.0, static_cast<double>(solver.solutions()) / options.most_solutions));
      solver.integrate(panel);
    }
    result.mean_square.setZero();
    for (const auto* panels : {&settled, &open})
      for (const Panel& panel : *panels) result.mean_square += panel.mean_square;
    const auto all = static_cast<double>(settled.size() + open.size());
    std::vector<Panel> halves;
    for (Panel& panel : open) {
      bool rough = false;
      for (Eigen::Index c = 0; c < count && !rough; ++c)
        for (std::size_t m = 0; m < moments.size() && !rough; ++m) {
          const auto i = to_index(m);
          const double noise =
              std::pow(vanishing_channel, 2) * solver.possible()(c) * std::pow(panel.to, 2 * moments[m].derivative);
          rough = result.reason[c][m].empty() &&
              panel.difference(c, i) > options.accuracy * result.mean_square(c, i) / all + noise;
        }
      const double middle = 0.5 * (panel.from + panel.to);
      if (rough && solver.solutions() < options.most_solutions && panel.from < middle && middle < panel.to) {
        halves.push_back({panel.from, middle, {}, {}, {}});
        halves.push_back({middle, panel.to, {}, {}, {}});
      } else {
        difference += panel.difference;
        result.share += panel.share;
        settled.push_back(std::move(panel));
      }
    }
    open = std::move(halves);
  }
  result.solutions = solver.solutions();
  result.mean_square.setZero();
  for (const Panel& panel : settled) result.mean_square += panel.mean_square;
  for (Eigen::Index c = 0; c < count; ++c) {
    const bool vanishes = !(result.mean_square(c, 0) > std::pow(vanishing_channel, 2) * solver.possible()(c));
    result.vanishes[c] = vanishes;
    if (vanishes) continue;
    for (std::size_t m = 0; m < moments.size(); ++m) {
      const auto i = to_index(m);
      if (!result.reason[c][m].empty() || result.mean_square(c, i) == 0) continue;
      result.error(c) = std::max(result.error(c), difference(c, i) / result.mean_square(c, i));
    }
  }
  return result;
}

}  // namespace trivet::response
