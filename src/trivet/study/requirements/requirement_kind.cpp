// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_kind.h"

#include <array>

namespace trivet::study {

const RequirementRow& requirement_row(RequirementKind kind) {
  using Shown = ShownValue;
  using Slopes = MarginSlopes;
  using Packed = PackedPart;
  static constexpr std::array rows = {
      RequirementRow{"amplitude", Shown::amplitude, true, Slopes::curve, Packed::curve},
      RequirementRow{"no_peak", Shown::share, true, Slopes::curve, Packed::curve},
      RequirementRow{"limit_line", Shown::share_of_line, true, Slopes::curve, Packed::none},
      RequirementRow{"band_line", Shown::share_of_line, false, Slopes::differences, Packed::none},
      RequirementRow{"operation", Shown::at_its_level, false, Slopes::differences, Packed::orders},
      RequirementRow{"avoided_frequencies", Shown::frequency, true, Slopes::frequencies, Packed::frequencies},
      RequirementRow{"separation", Shown::number, true, Slopes::frequencies, Packed::frequencies},
      RequirementRow{"damping_ratio", Shown::number, true, Slopes::roots, Packed::none},
      RequirementRow{"decoupling", Shown::share, true, Slopes::shapes, Packed::bodies},
      RequirementRow{"isolation", Shown::isolation, true, Slopes::curve, Packed::curve},
      RequirementRow{"rms", Shown::rms, false, Slopes::variance, Packed::none},
      RequirementRow{"largest", Shown::largest, false, Slopes::differences, Packed::none},
      RequirementRow{"no_jump", Shown::count, false, Slopes::differences, Packed::none},
      RequirementRow{"no_contact", Shown::share, false, Slopes::differences, Packed::none},
      RequirementRow{"steady", Shown::largest, false, Slopes::differences, Packed::none},
      RequirementRow{"static", Shown::quantity, false, Slopes::rest, Packed::rest},
      RequirementRow{"mount_load", Shown::quantity, false, Slopes::rest, Packed::rest},
      RequirementRow{"mount_deflection", Shown::quantity, false, Slopes::rest, Packed::rest},
      RequirementRow{"mount_dynamic_deflection", Shown::amplitude, true, Slopes::curve, Packed::none},
      RequirementRow{"mount_shock_deflection", Shown::quantity, false, Slopes::differences, Packed::none},
      RequirementRow{"price", Shown::sum, false, Slopes::zero, Packed::none},
      RequirementRow{"mount_mass", Shown::sum, false, Slopes::zero, Packed::none},
      RequirementRow{"clearance", Shown::quantity, false, Slopes::differences, Packed::none},
  };
  static_assert(rows.size() == static_cast<std::size_t>(RequirementKind::clearance) + 1);
  return rows[static_cast<std::size_t>(kind)];
}

}  // namespace trivet::study
