// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "trivet/foundation/stored_words.h"

/// Statistics of many numbers that do not depend on the order in which these are added, nor on the parts in which they
/// are counted and merged: all of them are whole numbers. `store` writes them, `restored` reads the same statistics
/// again and throws foundation::DamagedText where they cannot be such.
namespace trivet::numerics {

/// A sum in fixed point: a whole number of 128 bits in a unit that is a power of two. Each number is rounded to the
/// unit, 2⁻⁶⁴ of the magnitude for which the sum is made, so the sum of n numbers has an error of at most n/2 units. A
/// number beyond 2³¹ times that magnitude counts as much as that, and the sum is `saturated`; so 2³² numbers fit.
class ExactSum {
 public:
  /// @param magnitude  of the largest numbers, finite and > 0; of sums to be merged the same
  explicit ExactSum(double magnitude = 1);

  /// @param number  not NaN
  void add(double number);
  /// @throws foundation::InvalidInput for another unit
  void merge(const ExactSum& other);

  [[nodiscard]] double value() const;
  [[nodiscard]] bool saturated() const { return saturated_; }
  bool operator==(const ExactSum&) const = default;

  void store(foundation::StoredWords& words) const;
  [[nodiscard]] static ExactSum restored(foundation::WordReader& words);

 private:
  __extension__ using Whole = __int128;
  int unit_ = 0;  ///< log₂
  Whole sum_ = 0;
  bool saturated_ = false;
};

/// How often numbers occur, in logarithmic intervals of their magnitude: 512 in each octave, so that a quantile is
/// within 1e-3 of a number that occurs. Zero and the infinities have intervals of their own.
class LogHistogram {
 public:
  static constexpr double relative_error = 1e-3;

  /// @param number  not NaN
  void add(double number, std::uint64_t times = 1);
  void merge(const LogHistogram& other);

  [[nodiscard]] std::uint64_t count() const { return positive_.all() + negative_.all() + zeros_; }
  /// The number that a share of all does not exceed: that of rank ⌈share · count⌉, at least 1. NaN if there is none.
  /// @param share  0 … 1
  [[nodiscard]] double quantile(double share) const;
  bool operator==(const LogHistogram&) const = default;

  void store(foundation::StoredWords& words) const;
  [[nodiscard]] static LogHistogram restored(foundation::WordReader& words);

 private:
  /// Numbers of one sign by their intervals: the bits of a double without all but nine of its fraction.
  struct Side {
    std::vector<std::uint64_t> counts;  ///< of the intervals from `first` on
    std::int64_t first = 0;
    std::uint64_t count = 0;
    std::uint64_t infinite = 0;

    void add(std::int64_t interval, std::uint64_t times);
    void merge(const Side& other);
    [[nodiscard]] std::uint64_t all() const { return count + infinite; }
    /// Magnitude of the number of this rank by magnitude, from 1.
    [[nodiscard]] double magnitude(std::uint64_t rank) const;
    [[nodiscard]] std::uint64_t at(std::int64_t interval) const;
    void store(foundation::StoredWords& words) const;
    [[nodiscard]] static Side restored(foundation::WordReader& words);
    bool operator==(const Side& other) const;
  };

  Side positive_, negative_;
  std::uint64_t zeros_ = 0;
};

/// The least and the largest number, each with the index of the first design that has it.
struct Extremes {
  double least = std::numeric_limits<double>::infinity(), largest = -std::numeric_limits<double>::infinity();
  std::uint64_t least_at = 0, largest_at = 0;
  bool any = false;

  /// @param number  not NaN
  void add(double number, std::uint64_t index);
  void merge(const Extremes& other);
  bool operator==(const Extremes&) const = default;

  void store(foundation::StoredWords& words) const;
  [[nodiscard]] static Extremes restored(foundation::WordReader& words);
};

}  // namespace trivet::numerics
