// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/orders_in_time.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

constexpr std::int64_t largest_multiple = 2000;

struct Fraction {
  std::int64_t numerator = 0, denominator = 1;
};

/// The number as a fraction of small whole numbers, by its continued fraction; none if there is none to 1e-9.
std::optional<Fraction> small_fraction(double number) {
  constexpr double same = 1e-9;
  if (!(number <= static_cast<double>(largest_multiple))) return std::nullopt;
  Fraction before{1, 0}, now{static_cast<std::int64_t>(std::floor(number)), 1};
  double rest = number - std::floor(number);
  while (std::abs(static_cast<double>(now.numerator) / static_cast<double>(now.denominator) - number) > same * number) {
    if (!(rest * static_cast<double>(largest_multiple) > 1)) return std::nullopt;
    const double inverse = 1 / rest;
    const auto whole = static_cast<std::int64_t>(std::floor(inverse));
    rest = inverse - std::floor(inverse);
    const Fraction next{whole * now.numerator + before.numerator, whole * now.denominator + before.denominator};
    if (std::max(next.numerator, next.denominator) > largest_multiple) return std::nullopt;
    before = std::exchange(now, next);
  }
  return now.numerator > 0 && now.numerator <= largest_multiple ? std::optional(now) : std::nullopt;
}

/// Multiples of one frequency that have these ratios; none if one would be above `largest_multiple`.
std::optional<std::vector<double>> whole_multiples(const std::vector<Fraction>& ratios) {
  std::int64_t common = 1;
  for (const Fraction& ratio : ratios) {
    common = std::lcm(common, ratio.denominator);
    if (common > largest_multiple) return std::nullopt;
  }
  std::int64_t divisor = 0;
  for (const Fraction& ratio : ratios) divisor = std::gcd(divisor, ratio.numerator * (common / ratio.denominator));
  assert(divisor > 0 && "orders, and so their ratios, are above 0");
  std::vector<double> multiples;
  for (const Fraction& ratio : ratios) {
    const std::int64_t multiple = ratio.numerator * (common / ratio.denominator) / divisor;
    if (multiple > largest_multiple) return std::nullopt;
    multiples.push_back(static_cast<double>(multiple));
  }
  return multiples;
}

/// A sum of cosines, y(φ) = Re Σ c_j e^{i n_j φ}.
struct Cosines {
  std::vector<double> multiples;
  std::vector<std::complex<double>> amplitudes;

  [[nodiscard]] double at(double phase) const {
    double sum = 0;
    for (std::size_t j = 0; j < multiples.size(); ++j) {
      const double turned = multiples[j] * phase;
      sum += amplitudes[j].real() * std::cos(turned) - amplitudes[j].imag() * std::sin(turned);
    }
    return sum;
  }
  [[nodiscard]] double sum_of_amplitudes() const {
    double sum = 0;
    for (const std::complex<double>& one : amplitudes) sum += std::abs(one);
    return sum;
  }
  /// |y″| is nowhere larger.
  [[nodiscard]] double largest_curvature() const {
    double sum = 0;
    for (std::size_t j = 0; j < multiples.size(); ++j) sum += multiples[j] * multiples[j] * std::abs(amplitudes[j]);
    return sum;
  }
};

/// Largest value over the period. Between two phases a distance h apart y exceeds the larger end by h²/8 |y″| at most:
/// pieces that may exceed the largest value found are halved.
double largest_value(const Cosines& y) {
  struct Piece {
    double from, at_from, at_to;
  };
  constexpr int first = 32;
  constexpr double accuracy = 1e-11;
  const double enough = accuracy * y.sum_of_amplitudes(), curvature = y.largest_curvature();
  double step = foundation::two_pi / first;
  std::vector<Piece> pieces;
  for (int i = 0; i < first; ++i) pieces.push_back({i * step, y.at(i * step), y.at((i + 1) * step)});
  double best = std::ranges::max_element(pieces, {}, &Piece::at_from)->at_from;
  while (true) {
    const double above = step * step / 8 * curvature;  // NOLINT(readability-magic-numbers): h²/8 |y″|
    std::erase_if(pieces, [&](const Piece& one) { return std::max(one.at_from, one.at_to) + above <= best + enough; });
    if (pieces.empty() || above <= enough) return best;
    step /= 2;
    const std::size_t count = pieces.size();
    for (std::size_t i = 0; i < count; ++i) {
      Piece& left = pieces[i];
      const double middle = left.from + step, value = y.at(middle), at_to = left.at_to;
      best = std::max(best, value);
      left.at_to = value;
      pieces.push_back({middle, value, at_to});
    }
  }
}

RangeInTime range_of(Cosines y) {
  if (y.multiples.size() == 1) {
    const double size = std::abs(y.amplitudes.front());
    return {-size, size};
  }
  RangeInTime found;
  found.largest = largest_value(y);
  for (std::complex<double>& one : y.amplitudes) one = -one;
  found.least = -largest_value(y);
  return found;
}

}  // namespace

std::optional<OrdersInTime::Periodic> OrdersInTime::together(const Periodic& one, const Periodic& other,
                                                             const std::vector<double>& orders) {
  Periodic both{one.places, {}};
  both.places.insert(both.places.end(), other.places.begin(), other.places.end());
  std::vector<Fraction> ratios;  // to the first
  for (const Eigen::Index place : both.places) {
    const auto ratio = small_fraction(orders[to_size(place)] / orders[to_size(both.places.front())]);
    if (!ratio) return std::nullopt;
    ratios.push_back(*ratio);
  }
  auto multiples = whole_multiples(ratios);
  if (!multiples) return std::nullopt;
  both.multiples = std::move(*multiples);
  return both;
}

OrdersInTime::OrdersInTime(const std::vector<double>& orders) {
  if (orders.empty()) return;
  Periodic rest{{}, {}};
  for (std::size_t k = 1; k < orders.size(); ++k) rest.places.push_back(to_index(k));
  if (auto all = together({{0}, {1}}, rest, orders)) {
    periodic_.push_back(std::move(*all));
    return;
  }
  for (std::size_t k = 0; k < orders.size(); ++k) periodic_.push_back({{to_index(k)}, {1}});
  // The shortest common period first: those of the shaft are not torn apart by a gear.
  while (true) {
    std::optional<Periodic> shortest;
    std::size_t first = 0, second = 0;
    for (std::size_t a = 0; a < periodic_.size(); ++a)
      for (std::size_t b = a + 1; b < periodic_.size(); ++b) {
        auto both = together(periodic_[a], periodic_[b], orders);
        if (!both || (shortest && std::ranges::max(both->multiples) >= std::ranges::max(shortest->multiples))) continue;
        shortest = std::move(both);
        first = a;
        second = b;
      }
    if (!shortest) return;
    periodic_[first] = std::move(*shortest);
    periodic_.erase(periodic_.begin() + static_cast<std::ptrdiff_t>(second));
  }
}

RangeInTime OrdersInTime::range(const Eigen::VectorXcd& amplitudes) const {
  RangeInTime sum;
  if (!amplitudes.allFinite()) return {-foundation::infinity, foundation::infinity};
  int groups = 0;
  for (const Periodic& group : periodic_) {
    Cosines sum_of_group;
    for (std::size_t j = 0; j < group.places.size(); ++j) {
      if (amplitudes(group.places[j]) == 0.0) continue;
      sum_of_group.multiples.push_back(group.multiples[j]);
      sum_of_group.amplitudes.push_back(amplitudes(group.places[j]));
    }
    if (sum_of_group.multiples.empty()) continue;
    sum.is_bound = ++groups > 1;
    const RangeInTime one = range_of(std::move(sum_of_group));
    sum.least += one.least;
    sum.largest += one.largest;
  }
  return sum;
}

}  // namespace trivet::response
