// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "trivet/study/sample/sample.h"

/// Words for shares of designs.
namespace trivet::results {

/// Decimals of a percentage that is known to this share: two digits of what is not known.
inline int decimals_of(double unsure) {
  constexpr int most = 9;
  if (!(unsure > 0)) return 1;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(100 * unsure))), 0, most);
}

enum class Rounded { near, down, up };

inline std::string rounded_percent(double share, int decimals, Rounded rounded = Rounded::near) {
  const double unit = std::pow(10.0, decimals), scaled = 100 * share * unit;
  const double whole = rounded == Rounded::down ? std::floor(scaled)
      : rounded == Rounded::up                  ? std::ceil(scaled)
                                                : std::round(scaled);
  return fmt::format("{:.{}f}", whole / unit, decimals);
}

inline int decimals_of(const numerics::ConfidenceInterval& of) {
  return decimals_of(std::max(of.to - of.estimate, of.estimate - of.from));
}

inline std::string percent_words(double share, int decimals, Rounded rounded = Rounded::near) {
  return rounded_percent(share, decimals, rounded) + " %";
}

/// "63.8 % … 64.7 %", rounded outwards: what the words exclude, the interval excludes.
inline std::string interval_words(const numerics::ConfidenceInterval& of, int decimals) {
  return percent_words(of.from, decimals, Rounded::down) + " … " + percent_words(of.to, decimals, Rounded::up);
}

inline std::string confidence_words() { return fmt::format("{:.0f} %", 100 * study::sample_confidence); }

/// "64.2 % (63.8 % … 64.6 %)", or that it cannot be told from zero.
inline std::string share_words(const numerics::ConfidenceInterval& share) {
  int decimals = decimals_of(std::max((share.to - share.from) / 2, 1e-4));
  if (share.from <= 0)
    return "cannot be told from 0, ≤ " + percent_words(std::max(share.to, 0.0), decimals, Rounded::up);
  constexpr int most = 9;  // a share below is one of round-off
  while (decimals < most && 100 * share.from * std::pow(10.0, decimals) < 1) ++decimals;  // the interval excludes 0
  return fmt::format("{} ({})", percent_words(share.estimate, decimals), interval_words(share, decimals));
}

}  // namespace trivet::results
