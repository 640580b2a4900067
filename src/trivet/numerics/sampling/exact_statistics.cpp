// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/exact_statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {

// Sums: of 127 bits of magnitude 64 are below the magnitude, 31 above it for single numbers, 32 for their count.

ExactSum::ExactSum(double magnitude) {
  constexpr int digits_below = 64;
  if (!(magnitude > 0 && std::isfinite(magnitude)))
    throw foundation::InvalidInput("an exact sum needs a finite magnitude above 0");
  unit_ = std::ilogb(magnitude) + 1 - digits_below;
}

void ExactSum::add(double number) {
  constexpr double most = 0x1p95;  // units
  double units = std::rint(std::ldexp(number, -unit_));
  if (std::abs(units) > most) {
    units = std::copysign(most, units);
    saturated_ = true;
  }
  sum_ += static_cast<Whole>(units);
}

void ExactSum::merge(const ExactSum& other) {
  if (unit_ != other.unit_) throw foundation::InvalidInput("exact sums of two units cannot be merged");
  sum_ += other.sum_;
  saturated_ = saturated_ || other.saturated_;
}

double ExactSum::value() const { return std::ldexp(static_cast<double>(sum_), unit_); }

// Histograms

namespace {

constexpr int dropped_bits = 52 - 9;

std::int64_t interval_of(double magnitude) {
  return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(magnitude) >> dropped_bits);
}

double middle_of(std::int64_t interval) {
  return std::bit_cast<double>((static_cast<std::uint64_t>(interval) << dropped_bits) |
                               (std::uint64_t{1} << (dropped_bits - 1)));
}

}  // namespace

void LogHistogram::Side::add(std::int64_t interval, std::uint64_t times) {
  if (counts.empty()) first = interval;
  if (interval < first) {
    counts.insert(counts.begin(), static_cast<std::size_t>(first - interval), 0);
    first = interval;
  }
  const auto place = static_cast<std::size_t>(interval - first);
  if (place >= counts.size()) counts.resize(place + 1);
  counts[place] += times;
  count += times;
}

void LogHistogram::Side::merge(const Side& other) {
  for (std::size_t i = 0; i < other.counts.size(); ++i)
    if (other.counts[i] > 0) add(other.first + static_cast<std::int64_t>(i), other.counts[i]);
  infinite += other.infinite;
}

double LogHistogram::Side::magnitude(std::uint64_t rank) const {
  if (rank > count) return std::numeric_limits<double>::infinity();
  std::uint64_t below = 0;
  std::size_t place = 0;
  while ((below += counts[place]) < rank) ++place;
  return middle_of(first + static_cast<std::int64_t>(place));
}

std::uint64_t LogHistogram::Side::at(std::int64_t interval) const {
  const std::int64_t place = interval - first;
  return place >= 0 && place < static_cast<std::int64_t>(counts.size()) ? counts[static_cast<std::size_t>(place)] : 0;
}

bool LogHistogram::Side::operator==(const Side& other) const {
  if (count != other.count || infinite != other.infinite) return false;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] != other.at(first + static_cast<std::int64_t>(i))) return false;
  return true;  // of as many numbers, so the other has no more
}

void LogHistogram::add(double number, std::uint64_t times) {
  if (number == 0) zeros_ += times;
  else if (Side& side = number > 0 ? positive_ : negative_; std::isinf(number)) side.infinite += times;
  else side.add(interval_of(std::abs(number)), times);
}

void LogHistogram::merge(const LogHistogram& other) {
  positive_.merge(other.positive_);
  negative_.merge(other.negative_);
  zeros_ += other.zeros_;
}

double LogHistogram::quantile(double share) const {
  const std::uint64_t all = count();
  if (all == 0) return std::numeric_limits<double>::quiet_NaN();
  const double exact = std::max(std::ceil(share * static_cast<double>(all)), 1.0);
  std::uint64_t rank = std::min(static_cast<std::uint64_t>(exact), all);
  if (rank <= negative_.all()) return -negative_.magnitude(negative_.all() + 1 - rank);
  rank -= negative_.all();
  return rank <= zeros_ ? 0 : positive_.magnitude(rank - zeros_);
}

void Extremes::add(double number, std::uint64_t index) { merge({number, number, index, index, true}); }

void Extremes::merge(const Extremes& other) {
  if (!other.any) return;
  if (!any || other.least < least || (other.least == least && other.least_at < least_at)) {
    least = other.least;
    least_at = other.least_at;
  }
  if (!any || other.largest > largest || (other.largest == largest && other.largest_at < largest_at)) {
    largest = other.largest;
    largest_at = other.largest_at;
  }
  any = true;
}

}  // namespace trivet::numerics
