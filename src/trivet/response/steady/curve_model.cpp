// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/curve_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/known_poles.h"
#include "trivet/response/steady/channel_terms.h"
#include "trivet/response/steady/curve_frequencies.h"

namespace trivet::response {
namespace {

constexpr double fit_tolerance =
    1e-6;  // above the round-off of a solve at a resonance with damping ratios down to 1e-9
constexpr double floor_share =
    1e-10;  // of a curve's largest value, or of the largest of its unit at the same ω: below it errors are absolute
constexpr double near_zero_share = 1e-3;  // of the neighbours of a zero, where a curve's own value is not a scale
constexpr std::size_t solves_per_round = 8;
constexpr std::size_t most_corners = 42;
constexpr std::size_t most_samples = 100;  // of one piece: with those of its tests, 120 solves
constexpr double apart = 1e-10;            // of ω: closer frequencies are equal
constexpr Eigen::Index most_poles = 300;   // of 25 bodies; more are fitted, in parts of the band

/// The difference; infinite for NaN, which a pole of the fit at the frequency gives.
double as_error(double difference) {
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

using Samples = std::map<double, Eigen::VectorXcd>;  // ω → a value per delay and curve

class CurveModelBuilder {
 public:
  CurveModelBuilder(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                    const assembly::Loading& loading, const Peaks& peaks, const CurveModelOptions& options,
                    const foundation::Progress& progress, CurveModel& model)
      : assembled_(assembled), channels_(channels), options_(options), progress_(progress), model_(model) {
    for (const double delay : model.delays) loadings_.push_back(undelayed(loading, delay));
    extrema_ = extrema(peaks, model.band);
    lowest_power_ = loading.lowest_power();
    highest_power_ = loading.force.highest_power();
    if (!loading.motion.vanishes()) highest_power_ = std::max(highest_power_, loading.motion.highest_power() + 2);
    for (const Peak& peak : peaks.list)
      if (std::isinf(peak.amplitude) && peak.angular_frequency >= model.band.from &&
          peak.angular_frequency <= model.band.to)
        model.check.undefined_at.push_back(peak.angular_frequency);
    for (const assembly::ElementMap& map : assembled.elements)
      knots_.insert(knots_.end(), map.knots.begin(), map.knots.end());
    std::ranges::sort(knots_);
    for (const assembly::Channel& channel : channels)
      same_unit_.push_back(std::ranges::find(channels, channel.unit, &assembly::Channel::unit) - channels.begin());
    largest_ = Eigen::VectorXd::Zero(std::ssize(model.delays) * std::ssize(channels));
    idle_ = Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(std::ssize(channels), false);
    for (std::size_t c = 0; c < peaks.curves.size() && c < channels.size(); ++c)
      idle_(to_index(c)) = peaks.curves[c].vanishes;
  }

  void solve(std::vector<double> omega) {
    std::ranges::sort(omega);
    std::vector<double> fresh;
    for (const double w : omega)
      if (!is_known(w) && (fresh.empty() || w - fresh.back() > apart * w)) fresh.push_back(w);
    if (fresh.empty()) return;
    foundation::report_progress(progress_, "curves", static_cast<double>(model_.solves) / options_.most_solves);
    const Eigen::MatrixXcd all = solved(fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      Eigen::VectorXcd values = all.col(to_index(i));
      if (!values.allFinite()) {
        model_.check.undefined_at.push_back(fresh[i]);
        continue;  // an undamped resonance or a free motion
      }
      largest_ = largest_.cwiseMax(values.cwiseAbs());
      samples_.emplace(fresh[i], std::move(values));
    }
  }

  /// Adds the whole band as one piece without a fit, if all poles are known because the matrices are constant, most of
  /// them matter in the band, and tests confirm it.
  [[nodiscard]] bool add_piece_of_poles(const assembly::Band& band, const Eigen::VectorXcd& of_matrices) {
    constexpr double far = 1.5;  // of the end of the band: a fit of few poles needs fewer nodes
    const auto near = (of_matrices.array().abs() <= far * band.to).count();
    if (assembled_.frequency_dependent() || of_matrices.size() > most_poles || 2 * near < of_matrices.size())
      return false;
    const int at_rest = std::max(0, -lowest_power_);  // the load itself has these poles at 0
    const Eigen::VectorXcd of_curves = poles_of_curves(band, std::complex<double>(0, -1) * of_matrices);
    Eigen::VectorXcd poles = Eigen::VectorXcd::Zero(of_curves.size() + at_rest);
    poles.head(of_curves.size()) = of_curves;
    if (is_confirmed(band, poles, poles.size() + 3 + highest_power_))  // a result has up to ω²; one node more
      return true;
    samples_.clear();  // too many for a fit
    largest_.setZero();
    return false;
  }

  /// Adds the pieces between the corners of the tables, if they are few.
  void add_pieces_between_corners(const assembly::Band& band, const Eigen::VectorXcd& poles) {
    std::vector<double> corners = {band.from};
    for (const double knot : knots_)
      if (knot > corners.back() * (1 + apart) && knot < band.to * (1 - apart)) corners.push_back(knot);
    corners.push_back(band.to);
    solve(first_frequencies(poles, band, corners.size() == 2 || corners.size() > most_corners));
    if (corners.size() > most_corners) return add_pieces(band);
    std::vector<double> omega = corners;
    if (corners.size() > 2)
      for (std::size_t i = 0; i + 1 < corners.size(); ++i) omega.push_back(0.5 * (corners[i] + corners[i + 1]));
    solve(omega);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) add_pieces({corners[i], corners[i + 1]});
  }

  /// Fits a piece of the band, or its halves.
  void add_pieces(const assembly::Band& band) {
    const Samples::const_iterator from = samples_.lower_bound(band.from), to = samples_.upper_bound(band.to);
    std::size_t known = to_size(std::distance(from, to));
    Eigen::VectorXd nodes;  // of the last fit, for those that take long
    for (bool enough = known >= 2; enough;) {
      const numerics::RationalFit fit = fitted(band, nodes);
      if (largest_.size() >= numerics::many_functions) nodes = fit.nodes;
      const std::vector<double> wanted = doubtful(band, fit, known);
      double error = error_at_extrema(band, fit), error_at = doubted_extremum_;
      const std::size_t before = samples_.size();
      std::vector<double> all = wanted;
      if (error > options_.tolerance) all.push_back(error_at);
      const int tests_before = model_.solves;
      solve(all);
      for (const double w : wanted)
        if (const auto found = samples_.find(w); found != samples_.end())
          if (const double off = error_of(fit, w, found->second); off > error) error = off, error_at = w;
      const bool exhausted = model_.solves >= options_.most_solves,
                 settled = samples_.size() == before && error > options_.tolerance;
      if (error <= options_.tolerance || exhausted || settled) {
        model_.tests += tests_;
        model_.tests += model_.solves - tests_before;
        if (error > model_.worst_error) model_.worst_error = error, model_.worst_error_at = error_at;
        model_.pieces.push_back({band, fit});
        return;
      }
      known += samples_.size() - before;
      enough = known < most_samples;
    }
    if (known < 2) return;
    const double middle = cut_frequency(band);
    add_pieces({band.from, middle});
    add_pieces({middle, band.to});
  }

 private:
  /// A value per delay and curve at each frequency, which are columns.
  Eigen::MatrixXcd solved(const std::vector<double>& omega) {
    Eigen::MatrixXcd values(largest_.size(), to_index(omega.size()));
    Eigen::Index row = 0;
    for (const assembly::Loading& loading : loadings_) {
      const FrequencyResponse part = frequency_response(assembled_, channels_, loading, omega);
      add(part.check);
      for (const Curve& curve : part.curves) values.row(row++) = curve.value.transpose();
    }
    model_.solves += static_cast<int>(omega.size());
    return values;
  }

  /// Poles −iλ without those of undamped modes that no curve sees. At these a fit with them is 0/0.
  Eigen::VectorXcd poles_of_curves(const assembly::Band& band, const Eigen::VectorXcd& poles) {
    constexpr double undamped = 1e-10;    // of |λ|: above it a fit at the frequency of the mode keeps six digits
    constexpr double at_rest = 1e-5;      // of the end of the band: rigid-body modes, whose frequencies are round-off
    constexpr double aside = 1e-6;        // of ω
    constexpr double same_values = 1e-3;  // on both sides of a pole: it would be seen closer to it than 1e-9 of ω alone
    std::vector<double> unseen;
    for (const std::complex<double>& pole : poles) {
      const double w = pole.real(), below = w * (1 - aside), above = w * (1 + aside);
      if (!(below > band.from && above < band.to) || w < at_rest * band.to || std::abs(pole.imag()) > undamped * w)
        continue;
      // No samples: so near to a pole they would be the scale of all errors.
      const Eigen::MatrixXcd sides = solved({below, above});
      if (!sides.allFinite()) continue;
      const Eigen::VectorXd size = scale(sides.col(0)).cwiseMax(scale(sides.col(1)));
      if (((sides.col(0) - sides.col(1)).cwiseAbs().array() <= same_values * size.array()).all()) unseen.push_back(w);
    }
    std::vector<std::complex<double>> seen;
    for (const std::complex<double>& pole : poles)
      if (std::abs(pole.imag()) > undamped * std::abs(pole) ||
          std::ranges::none_of(unseen, [&](double w) { return std::abs(std::abs(pole.real()) - w) <= apart * w; }))
        seen.push_back(pole);
    return Eigen::Map<const Eigen::VectorXcd>(seen.data(), std::ssize(seen));
  }

  /// Adds the piece with these poles −iλ if it agrees with solves where its error would be largest, and with the peaks.
  bool is_confirmed(const assembly::Band& band, const Eigen::VectorXcd& poles, Eigen::Index nodes) {
    const std::complex<double> i(0, 1);
    std::vector<double> omega = numerics::leja_nodes(
        candidate_frequencies(i * poles, band, 4 * static_cast<int>(nodes)), poles, to_size(nodes) + solves_per_round);
    solve(omega);
    std::erase_if(omega, [&](double w) { return !samples_.contains(w); });
    if (std::ssize(omega) < nodes + 1) return false;
    const auto first_test = omega.begin() + nodes;
    std::sort(omega.begin(), first_test);
    numerics::RationalFit fit{Eigen::Map<const Eigen::VectorXd>(omega.data(), nodes), {}, {}, 0};
    fit.weights = numerics::weights_for_poles(fit.nodes, poles);
    fit.values.resize(largest_.size(), nodes);
    for (Eigen::Index k = 0; k < nodes; ++k) fit.values.col(k) = samples_.at(fit.nodes(k));
    double worst = error_at_extrema(band, fit), worst_at = doubted_extremum_;
    for (auto test = first_test; test != omega.end(); ++test)
      if (const double error = error_of(fit, *test, samples_.at(*test)); error > worst) worst = error, worst_at = *test;
    if (!(worst <= options_.tolerance)) return false;
    model_.tests += tests_ + static_cast<int>(omega.end() - first_test);
    model_.worst_error = worst;
    model_.worst_error_at = worst_at;
    model_.pieces.push_back({band, std::move(fit)});
    return true;
  }

  void add(const SolutionCheck& check) {
    model_.check.fallbacks += check.fallbacks;
    if (!(check.worst_backward_error > model_.check.worst_backward_error)) return;
    model_.check.worst_backward_error = check.worst_backward_error;
    model_.check.at_angular_frequency = check.at_angular_frequency;
  }

  [[nodiscard]] bool is_known(double w) const {
    const auto above = samples_.lower_bound(w * (1 - apart));
    return (above != samples_.end() && above->first <= w * (1 + apart)) ||
        std::ranges::any_of(model_.check.undefined_at, [&](double u) { return std::abs(u - w) <= apart * w; });
  }

  /// Frequency at which a piece is cut: the corner of a table nearest to the middle of its samples, or that middle.
  double cut_frequency(const assembly::Band& band) {
    std::vector<double> inside;
    for (auto s = samples_.lower_bound(band.from); s != samples_.end() && s->first <= band.to; ++s)
      inside.push_back(s->first);
    const double middle = inside[inside.size() / 2];
    double place = middle, distance = std::numeric_limits<double>::infinity();
    for (const double knot : knots_)
      if (knot > band.from && knot < band.to && std::abs(knot - middle) < distance)
        place = knot, distance = std::abs(knot - middle);
    solve({place});
    return place;
  }

  [[nodiscard]] numerics::RationalFit fitted(const assembly::Band& band, const Eigen::VectorXd& nodes) const {
    const auto from = samples_.lower_bound(band.from), to = samples_.upper_bound(band.to);
    const Eigen::Index count = std::distance(from, to);
    Eigen::VectorXd x(count);
    Eigen::MatrixXcd values(largest_.size(), count);
    Eigen::MatrixXd scales(largest_.size(), count);
    Eigen::Index k = 0;
    for (auto s = from; s != to; ++s, ++k) {
      x(k) = s->first;
      values.col(k) = s->second;
      scales.col(k) = scale(s->second);
    }
    return numerics::rational_fit(x, values, scales, fit_tolerance, nodes);
  }

  /// Round-off of each curve, or of each part of one delay.
  [[nodiscard]] Eigen::VectorXd floors(const Eigen::VectorXcd& values) const {
    const Eigen::Index curves = idle_.size();
    Eigen::VectorXd of_unit = Eigen::VectorXd::Zero(curves);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      double& most = of_unit(same_unit_[i % curves]);
      most = std::max(most, std::abs(values(i)));
    }
    Eigen::VectorXd floor = floor_share * largest_.head(values.size());
    for (Eigen::Index i = 0; i < values.size(); ++i)
      floor(i) = std::max(floor(i), floor_share * of_unit(same_unit_[i % curves]));
    return floor;
  }

  [[nodiscard]] Eigen::VectorXd scale(const Eigen::VectorXcd& values) const {
    Eigen::VectorXd scale = values.cwiseAbs().cwiseMax(floors(values));
    for (Eigen::Index i = 0; i < scale.size(); ++i)
      if (idle_(i % idle_.size()) || !(scale(i) > 0))
        scale(i) = std::numeric_limits<double>::max() / 4;  // only round-off
    return scale;
  }

  /// Real poles of the fit, and points in the gaps between samples where the fit changes most without its last node.
  [[nodiscard]] std::vector<double> doubtful(const assembly::Band& band, const numerics::RationalFit& fit,
                                             std::size_t known) const {
    std::vector<double> places, gaps;
    auto s = samples_.lower_bound(band.from);
    double before = band.from;
    for (; s != samples_.end() && s->first <= band.to; before = s->first, ++s)
      if (s->first - before > 4 * apart * s->first)
        for (const double share : {0.25, 0.5, 0.75}) places.push_back(before + share * (s->first - before));
    if (band.to - before > 4 * apart * band.to) places.push_back(0.5 * (before + band.to));
    std::vector<double> chosen = false_poles(band, fit);
    std::erase_if(places, [&](double w) { return is_known(w); });
    if (places.empty()) return chosen;
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(places.data(), std::ssize(places));
    const Eigen::MatrixXcd with = fit.at(x), without = fewer_nodes(fit).at(x);
    std::vector<std::pair<double, double>> doubts;  // largest first, one for each gap
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const double doubt = ((with.col(k) - without.col(k)).cwiseAbs().array() / scale(with.col(k)).array()).maxCoeff();
      doubts.emplace_back(std::isfinite(doubt) ? doubt : std::numeric_limits<double>::max(), x(k));
    }
    std::ranges::sort(doubts, std::greater<>());
    for (const auto& [doubt, w] : doubts) {
      if (chosen.size() >= std::clamp(known / 4, std::size_t{2}, most_per_round())) break;
      const double gap = samples_.lower_bound(w) == samples_.end() ? band.to : samples_.lower_bound(w)->first;
      if (std::ranges::find(gaps, gap) != gaps.end()) continue;
      gaps.push_back(gap);
      chosen.push_back(w);
    }
    return chosen;
  }

  /// A fit of many curves takes longer than many solves.
  [[nodiscard]] std::size_t most_per_round() const {
    return largest_.size() < numerics::many_functions ? solves_per_round : 3 * solves_per_round;
  }

  /// The fit without its last node: each weight is multiplied by the distance of its node from that node.
  [[nodiscard]] static numerics::RationalFit fewer_nodes(const numerics::RationalFit& fit) {
    const Eigen::Index n = fit.nodes.size() - 1;
    if (n < 1) return fit;
    numerics::RationalFit fewer{fit.nodes.head(n), fit.weights.head(n), fit.values.leftCols(n), 0};
    fewer.weights.array() *= (fit.nodes.head(n).array() - fit.nodes(n)).cast<std::complex<double>>();
    return fewer;
  }

  /// Poles so near the axis that they lie between samples: they may not be real.
  [[nodiscard]] std::vector<double> false_poles(const assembly::Band& band, const numerics::RationalFit& fit) const {
    std::vector<double> places;
    if (fit.nodes.size() < 2) return places;
    const Eigen::VectorXcd poles = fit.poles();
    for (Eigen::Index k = 0; k < poles.size() && places.size() < solves_per_round; ++k) {
      const double w = poles(k).real();
      if (!(w > band.from && w < band.to) || is_known(w)) continue;
      const auto above = samples_.lower_bound(w);
      double gap = std::numeric_limits<double>::infinity();
      if (above != samples_.end()) gap = above->first - w;
      if (above != samples_.begin()) gap = std::min(gap, w - std::prev(above)->first);
      if (std::abs(poles(k).imag()) < 0.5 * gap) places.push_back(w);
    }
    return places;
  }

  /// Smaller amplitude of each curve at the two neighbouring samples.
  [[nodiscard]] Eigen::VectorXd smaller_neighbour(double w) const {
    const auto amplitudes = [&](Samples::const_iterator s) {
      return Eigen::VectorXd(summed(s->second, model_.delays, s->first).cwiseAbs());
    };
    const auto above = samples_.upper_bound(w), at = samples_.lower_bound(w);
    if (above == samples_.end() || at == samples_.begin()) return Eigen::VectorXd::Zero(idle_.size());
    return amplitudes(above).cwiseMin(amplitudes(std::prev(at)));
  }

  /// Largest error of the curves, relative to their values or, near a zero, to their neighbours.
  [[nodiscard]] double error_of(const numerics::RationalFit& fit, double w, const Eigen::VectorXcd& truth) const {
    const Eigen::VectorXcd y = summed(truth, model_.delays, w),
                           model = summed(fit.at(Eigen::VectorXd::Constant(1, w)).col(0), model_.delays, w);
    const Eigen::VectorXd neighbours = smaller_neighbour(w);
    const Eigen::VectorXd floor = floors(y);
    double worst = 0;
    for (Eigen::Index c = 0; c < y.size(); ++c) {
      const double size = std::max({std::abs(y(c)), near_zero_share * neighbours(c), floor(c)});
      if (!idle_(c) && size > 0) worst = std::max(worst, as_error(std::abs(model(c) - y(c)) / size));
    }
    return worst;
  }

  /// One curve of a fit, the sum over the delays.
  [[nodiscard]] std::complex<double> curve_at(const numerics::RationalFit& fit, const Eigen::VectorXcd& shares,
                                              Eigen::Index curve, double w) const {
    const Eigen::Index curves = idle_.size(), parts = std::ssize(model_.delays);
    Eigen::VectorXcd values(parts);
    for (Eigen::Index d = 0; d < parts; ++d) values(d) = fit.values.row(d * curves + curve) * shares;
    return summed(values, model_.delays, w)(0);
  }

  /// Largest error at the extrema. They come from another method, so the comparison needs no solve.
  double error_at_extrema(const assembly::Band& band, const numerics::RationalFit& fit) {
    double worst = 0;
    tests_ = 0;
    for (std::size_t c = 0; c < extrema_.size(); ++c)
      for (const Extremum& extremum : extrema_[c]) {
        const double w = extremum.angular_frequency;
        const auto curve = to_index(c);
        if (!extremum.maximum || !(w >= band.from && w <= band.to) || idle_(curve)) continue;
        ++tests_;
        const Eigen::VectorXcd shares = fit.shares(Eigen::VectorXd::Constant(1, w)).col(0);
        const auto error = [&](double height, double size) {
          return as_error(std::abs(height - extremum.amplitude) / size);
        };
        // At most this, because the round-off of all curves together is not less than that of this one.
        if (error(std::abs(curve_at(fit, shares, curve, w)), extremum.amplitude) <= worst) continue;
        const Eigen::VectorXcd y = summed(fit.values * shares, model_.delays, w);
        const double off = error(std::abs(y(curve)), std::max(extremum.amplitude, floors(y)(curve)));
        if (off > worst) worst = off, doubted_extremum_ = w;
      }
    return worst;
  }

  const assembly::Assembled& assembled_;
  const std::vector<assembly::Channel>& channels_;
  const CurveModelOptions& options_;
  const foundation::Progress& progress_;
  CurveModel& model_;
  std::vector<assembly::Loading> loadings_;  // one per delay, with the delay removed
  std::vector<std::vector<Extremum>> extrema_;
  std::vector<double> knots_;
  std::vector<std::ptrdiff_t> same_unit_;  // of each curve: the first of its unit
  Samples samples_;
  Eigen::VectorXd largest_;
  Eigen::Array<bool, Eigen::Dynamic, 1> idle_;
  double doubted_extremum_ = 0;
  int lowest_power_ = 0, highest_power_ = 0;  // of ω in the load
  int tests_ = 0;
};

}  // namespace

CurveModel curve_model(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                       const assembly::Loading& loading, const Eigen::VectorXcd& poles, const Peaks& peaks,
                       const assembly::Band& band, const CurveModelOptions& options,
                       const foundation::Progress& progress) {
  CurveModel model;
  model.band = band;
  model.curves = std::ssize(channels);
  model.delays = delays_of(loading);
  if (channels.empty()) return model;
  CurveModelBuilder builder(assembled, channels, loading, peaks, options, progress, model);
  if (!builder.add_piece_of_poles(band, poles)) builder.add_pieces_between_corners(band, poles);
  return model;
}

}  // namespace trivet::response
