// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/sampling/exact_statistics.h"

namespace trivet::numerics {

using foundation::StoredWords;
using foundation::WordReader;

void ExactSum::store(StoredWords& words) const {
  __extension__ using Bits = unsigned __int128;
  const auto bits = static_cast<Bits>(sum_);
  words.whole(static_cast<std::uint64_t>(unit_));
  words.whole(static_cast<std::uint64_t>(bits >> 64));
  words.whole(static_cast<std::uint64_t>(bits));
  words.whole(saturated_ ? 1 : 0);
}

ExactSum ExactSum::restored(WordReader& words) {
  __extension__ using Bits = unsigned __int128;
  ExactSum sum;
  sum.unit_ = static_cast<int>(static_cast<std::int64_t>(words.whole()));
  const Bits high = words.whole();
  sum.sum_ = static_cast<Whole>(high << 64 | words.whole());
  sum.saturated_ = words.at_most(1) == 1;
  return sum;
}

namespace {

/// Intervals of the magnitudes of all doubles, see LogHistogram.
constexpr std::uint64_t intervals_of_doubles = std::uint64_t{1} << 20;

}  // namespace

void LogHistogram::Side::store(StoredWords& words) const {
  words.whole(infinite);
  words.whole(static_cast<std::uint64_t>(first));
  words.whole(counts.size());
  for (const std::uint64_t one : counts) words.whole(one);
}

LogHistogram::Side LogHistogram::Side::restored(WordReader& words) {
  Side side;
  side.infinite = words.whole();
  side.first = static_cast<std::int64_t>(words.at_most(intervals_of_doubles));
  side.counts.resize(words.at_most(intervals_of_doubles - static_cast<std::uint64_t>(side.first)));
  for (std::uint64_t& one : side.counts) side.count += one = words.whole();
  return side;
}

void LogHistogram::store(StoredWords& words) const {
  positive_.store(words);
  negative_.store(words);
  words.whole(zeros_);
}

LogHistogram LogHistogram::restored(WordReader& words) {
  LogHistogram histogram;
  histogram.positive_ = Side::restored(words);
  histogram.negative_ = Side::restored(words);
  histogram.zeros_ = words.whole();
  return histogram;
}

void Extremes::store(StoredWords& words) const {
  words.whole(any ? 1 : 0);
  words.exact(least);
  words.exact(largest);
  words.whole(least_at);
  words.whole(largest_at);
}

Extremes Extremes::restored(WordReader& words) {
  Extremes extremes;
  extremes.any = words.at_most(1) == 1;
  extremes.least = words.exact();
  extremes.largest = words.exact();
  extremes.least_at = words.whole();
  extremes.largest_at = words.whole();
  return extremes;
}

}  // namespace trivet::numerics
