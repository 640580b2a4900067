// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace trivet::study {

enum class RequirementKind {
  amplitude,
  no_peak,
  limit_line,
  band_line,  ///< a limit line over frequency bands, of random vibration or of the orders at a speed
  operation,  ///< an amplitude at a speed of the machine, or over a range of them
  avoided_frequencies,
  separation,
  damping_ratio,
  decoupling,
  isolation,
  rms,
  largest,
  no_jump,
  no_contact,
  steady,
  static_value,
  mount_load,
  mount_deflection,
  mount_dynamic_deflection,
  mount_shock_deflection,
  price,
  mount_mass,
  clearance
};

/// How the value of a requirement is shown.
enum class ShownValue : std::uint8_t {
  quantity,      ///< in its unit
  amplitude,     ///< in its unit at the level of amplitudes, 0-p
  largest,       ///< in its unit, the largest magnitude of a motion from rest, 0-p
  at_its_level,  ///< in its unit at the level of the limit
  rms,           ///< in its unit, root mean square
  frequency,
  share,          ///< in %
  share_of_line,  ///< with the value and the limit of the line
  isolation,
  number,
  count,
  sum  ///< with all its digits
};

/// Where the slopes of its margin come from.
enum class MarginSlopes : std::uint8_t {
  curve,        ///< at the frequencies of its candidates
  frequencies,  ///< of natural frequencies
  roots,
  shapes,  ///< of the modes of a body
  rest,
  variance,
  differences,  ///< of its values in neighbouring designs
  zero          ///< no parameter moves it
};

/// Which part of a packed case judges it for many designs at once (study/family/case_vector.h).
enum class PackedPart : std::uint8_t {
  none,
  curve,
  orders,  ///< curves under the orders at a speed, whose squares add, or under one order over a range of speeds
  frequencies,
  rest,
  bodies
};

/// What holds for all requirements of a kind.
struct RequirementRow {
  const char* name;  ///< in JSON: "amplitude", "no_peak" …
  ShownValue shown;
  bool has_candidates;  ///< several places may decide, each a value of a search; else its value alone
  MarginSlopes slopes;
  PackedPart packed;
};
[[nodiscard]] const RequirementRow& requirement_row(RequirementKind kind);
[[nodiscard]] inline const char* name(RequirementKind kind) { return requirement_row(kind).name; }

}  // namespace trivet::study
