// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "trivet/study/requirements/verdict.h"

/// Which mounts of a catalogue at which places: `trivet select`. Mathematics: docs/design.md.
namespace trivet::study {

/// What the best combinations are ranked by. Others than the margin rank those that meet every requirement.
enum class MountOrder { margin, isolation, price, mass };
[[nodiscard]] const char* name(MountOrder order);  ///< "margin" …
/// @throws foundation::InvalidInput for another word
[[nodiscard]] MountOrder mount_order(const std::string& word);

/// A design with chosen mounts.
struct MountDesign {
  std::vector<std::size_t> mounts;  ///< number of the mount of each choice; empty for the given design
  double margin = 0;                ///< least of all requirements in all cases in which the design has to hold
  bool met = false;
  std::string governing;                   ///< the requirement with the least margin, in words, with its case
  std::string reason;                      ///< why a requirement is not judged, or the model is not valid
  std::optional<double> load;              ///< largest share of a load range that a static load takes; none: not known
  std::optional<double> deflection;        ///< largest static one of a mount along its axis [m]
  std::optional<double> lowest, highest;   ///< natural frequencies of the first case [rad/s]
  std::optional<double> transmissibility;  ///< largest of the first case where it runs (amplification.h)
  std::optional<double> isolation_share;   ///< largest transmissibility over the allowed one, of all required
  std::optional<model::Price> price;       ///< of all catalogue mounts; none if one has no price
  std::optional<double> mass;              ///< of all catalogue mounts [kg]
};

/// One mount of a choice, and the best design with it.
struct MountOption {
  std::size_t choice = 0, mount = 0;
  MountDesign best;
};

struct MountSelection {
  std::vector<project::MountChoice> choices;
  std::vector<std::string> cases;  ///< in which a design has to hold
  std::size_t combinations = 0;    ///< that were judged, completely or by a bound
  std::size_t all_combinations =
      0;  ///< more than these if mounts were exchanged: then nothing is proven about the others
  /// Combinations that fail a test, each counted at the first one.
  struct Failed {
    std::string test;
    std::size_t combinations = 0;
  };
  std::vector<Failed> failed;
  std::size_t curves = 0;      ///< combinations of which amplitudes and peaks were computed by a kernel
  std::string without_curves;  ///< why there is no kernel for these
  std::size_t judged = 0;      ///< combinations of which every requirement was computed
  std::string without_bounds;  ///< why all had to be; empty if a bound spared most of them
  MountDesign given;
  MountOrder by = MountOrder::margin;
  std::vector<MountDesign> best;     ///< in this order; by descending margin if none meets every requirement
  std::vector<MountOption> options;  ///< every mount, in the order of the choices, each by descending margin
  foundation::Problems warnings;     ///< of the first of the best
};

/// The combinations of mounts with the largest least margins, or the best in another order that hold. Up to a million
/// all are judged: completely, or by a bound below which they cannot be among the best. Of more, mounts are exchanged
/// (mount_exchange.h).
/// @param most  number of designs in `best`
/// @throws foundation::InvalidInput without choices or requirements, or if an order needs what is not given;
/// NotComputable if a requirement cannot be judged
[[nodiscard]] MountSelection mount_selection(const project::Project& project, std::size_t most,
                                             const foundation::Progress& progress = {},
                                             MountOrder by = MountOrder::margin);

/// The changes of the file that set the best combination.
[[nodiscard]] std::vector<project::Node> selection_changes(const MountSelection& found);

}  // namespace trivet::study
