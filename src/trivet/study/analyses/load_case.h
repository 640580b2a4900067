// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/display_units.h"
#include "trivet/response/steady/static_response.h"

/// Static results of cases as load cases: gravity and constant forces of each, and the envelope over all.
namespace trivet::study {

/// A mount under the static load of a case. Mounts: elements from the ground or a foundation, and those of a catalogue.
/// The axis of a stop points towards it: a positive deflection closes it.
struct MountAtRest {
  std::string name;                        ///< of the element
  double compression = 0;                  ///< along its axis from end N to end K; negative: tension; of a stop ≥ 0 [N]
  double across = 0;                       ///< magnitude of the force across the axis [N]
  double deflection = 0;                   ///< of end K against end N along the axis; negative: towards N [m]
  std::optional<double> utilisation = {};  ///< largest share of a load range of its maker; none without a range

  bool operator==(const MountAtRest&) const = default;
};

/// Values below 1e-12 of the largest of their kind are 0.
/// @throws foundation::NotComputable for the reasons of static_response
[[nodiscard]] std::vector<MountAtRest> mounts_at_rest(const model::System& system,
                                                      const assembly::Assembled& assembled);

/// Values of one case, with the names that they have in the envelope.
struct LoadCase {
  std::string case_name;
  std::vector<response::StaticValue> values;  ///< static results that the file requests; forces and deflections of
                                              ///< mounts; rest of each clearance
  std::string reason;                         ///< why there are none
};

/// Static results and mounts of a case, without its clearances.
[[nodiscard]] LoadCase load_case(const std::string& name, const model::System& system,
                                 const assembly::Assembled& assembled, const project::Analyses& analyses);

/// One quantity over all load cases.
struct EnvelopeRow {
  std::string name, unit;
  double least = 0, largest = 0;
  std::string least_in, largest_in;  ///< names of the first such cases
};

struct Envelope {
  project::DisplayUnits display;                              ///< of its table
  std::vector<EnvelopeRow> rows;                              ///< empty if the cases do not differ at rest
  std::vector<std::pair<std::string, std::string>> left_out;  ///< cases without static results, with the reason
};

/// Quantities that are zero in all cases are left out.
[[nodiscard]] Envelope envelope(const std::vector<const LoadCase*>& cases);

}  // namespace trivet::study
