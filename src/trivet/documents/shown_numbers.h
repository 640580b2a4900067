// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trivet/project/text/display_units.h"

/// Numbers as tables and pictures show them: in the units of [display], by default as computed.
namespace trivet::documents {

/// How SI numbers are shown: value × factor, with a label.
struct DisplayUnit {
  std::string unit;   ///< "in"
  std::string level;  ///< " p-p" or " rms" of a harmonic quantity; empty: zero-to-peak, or not harmonic
  double factor = 1;
  bool si = true;  ///< the unit is that of the result, so it may get an SI prefix
  [[nodiscard]] std::string label() const { return unit + level; }
};

/// For values at rest, in time, root mean squares and dimensions.
[[nodiscard]] DisplayUnit display_unit(const project::DisplayUnits& display, const std::string& si_unit);
/// For amplitudes of harmonic quantities, and for limits on them. Ratios (unit "1") stay.
[[nodiscard]] DisplayUnit amplitude_unit(const project::DisplayUnits& display, const std::string& si_unit);
/// "zero-to-peak", "peak-to-peak" or "rms".
[[nodiscard]] const char* level_words(project::Level level);
/// Note on sentences that have amplitudes in SI, with a blank before it; empty if these are zero-to-peak as the rest.
[[nodiscard]] std::string sentence_note(const project::DisplayUnits& display);
/// A factor 10^(3n) that brings `largest` near 1 … 1000, and the resulting unit: 0.01 m → 1000, "mm". Only newtons and
/// watts get larger units.
struct UnitPrefix {
  double factor = 1;
  std::string unit;
};
[[nodiscard]] UnitPrefix unit_prefix(double largest, const std::string& unit);
/// From SI numbers to shown ones; only SI units get a prefix.
[[nodiscard]] UnitPrefix unit_prefix(double largest, const DisplayUnit& unit);
/// An SI value with its shown unit; SI units get prefixes: "0.5 mm", "0.02 in p-p".
[[nodiscard]] std::string value_text(double value, const DisplayUnit& shown);

/// The largest number of each kind in one result, with which round-off is told from data: a number below 1e-12 of the
/// largest is shown as 0, without a prefix. Rotations and moments are also compared with translations and forces at a
/// lever of 1 m, because a machine may have no other rotation than round-off.
class LargestOfKind {
 public:
  void add(const std::string& si_unit, double value);
  /// The value, or 0 if it is round-off.
  [[nodiscard]] double shown(const std::string& si_unit, double value) const;

 private:
  std::map<std::string, double> largest_;
};

/// Unit of a frequency. @param usual  without one in [display]: "Hz" for people, "rad/s" in columns of data
[[nodiscard]] std::string frequency_unit(const project::DisplayUnits& display, const std::string& usual = "Hz");
/// A frequency in that unit. @param omega  [rad/s]
[[nodiscard]] double shown_frequency(const project::DisplayUnits& display, double omega,
                                     const std::string& usual = "Hz");
/// The unit of the columns of a table that has frequencies: that of [display], by default Hz.
[[nodiscard]] std::vector<std::string> frequency_units(const project::DisplayUnits& display);
/// "ω [rad/s]", "f [Hz]"
[[nodiscard]] std::string frequency_heading(const project::DisplayUnits& display, const std::string& usual = "Hz");

}  // namespace trivet::documents
