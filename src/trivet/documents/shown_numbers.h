// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "trivet/foundation/unit_prefix.h"
#include "trivet/project/text/display_units.h"

/// Numbers as tables and pictures show them: in the units of [display], by default as computed.
namespace trivet::documents {

/// How SI numbers are shown: value × factor, with a label.
struct DisplayUnit {
  std::string unit;   ///< "in"
  std::string level;  ///< " 0-p", " p-p" or " rms" of a harmonic quantity; empty: it has none
  double factor = 1;
  bool si = true;  ///< the unit is that of the result, so it may get an SI prefix
  [[nodiscard]] std::string label() const { return unit + level; }
};

/// For values at rest, in time, root mean squares and dimensions.
[[nodiscard]] DisplayUnit display_unit(const project::DisplayUnits& display, const std::string& si_unit);
/// For amplitudes of harmonic quantities, and for limits on them. Ratios of two of them ("1", "m/N") have no level.
[[nodiscard]] DisplayUnit amplitude_unit(const project::DisplayUnits& display, const std::string& si_unit);
/// For root mean squares of random vibration, which have no other level.
[[nodiscard]] DisplayUnit root_mean_square_unit(const project::DisplayUnits& display, const std::string& si_unit);
/// For amplitudes in data, such as typed columns and sheets: zero-to-peak without a label, unless [display] has a
/// level.
[[nodiscard]] DisplayUnit amplitude_unit_of_data(const project::DisplayUnits& display, const std::string& si_unit);
/// "zero-to-peak", "peak-to-peak" or "rms".
[[nodiscard]] const char* level_words(project::Level level);
using foundation::unit_prefix;
using foundation::UnitPrefix;
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
/// Name of a column of data in this unit: only numbers in rad/s are an angular frequency, "damped_angular_frequency" in
/// Hz is "damped_frequency".
[[nodiscard]] std::string name_in_unit(std::string name, const std::string& unit);
/// "ω [rad/s]", "f [Hz]"
[[nodiscard]] std::string frequency_heading(const project::DisplayUnits& display, const std::string& usual = "Hz");

}  // namespace trivet::documents
