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

inline std::string confidence_words() { return fmt::format("{:.0f} %", 100 * study::sample_confidence); }

inline std::string in_case_words(const study::SampledCaseResult& one) {
  return one.case_name.empty() ? "" : " in case " + one.case_name;
}

/// "64.2 % (63.8 % … 64.6 %)", or that it cannot be told from zero.
inline std::string share_words(const numerics::ConfidenceInterval& share) {
  const int decimals = decimals_of(std::max((share.to - share.from) / 2, 1e-4));
  if (share.from <= 0)
    return fmt::format("cannot be told from 0, ≤ {} %",
                       rounded_percent(std::max(share.to, 0.0), decimals, Rounded::up));
  return fmt::format("{} % ({} % … {} %)", rounded_percent(share.estimate, decimals),
                     rounded_percent(share.from, decimals), rounded_percent(share.to, decimals));
}

}  // namespace trivet::results
