// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/select/mount_ranking.h"

namespace trivet::study {

/// A good combination where there are too many to judge all: mounts of a few choices at a time are exchanged, with all
/// combinations of these judged, until no exchange gains anything. Starts are the best of the same
/// mount everywhere, and of combinations scattered over all.
class MountExchange {
 public:
  /// @param most  number of designs in the table; all, curves, progress  used by the result
  MountExchange(const MountCombinations& all, const MountCurves& curves, MountRanking::Judge judge, std::size_t most,
                const foundation::Progress& progress);

  /// The best designs of all exchanges, and each mount with the others of the best design.
  [[nodiscard]] MountSelection run();

 private:
  [[nodiscard]] MountRanking ranking(std::vector<std::size_t> combinations);
  void forget_repeated_ones();
  [[nodiscard]] std::vector<MountDesign> best_of(std::vector<std::size_t> combinations, std::size_t most);
  [[nodiscard]] double most_at_once() const;
  [[nodiscard]] std::vector<std::size_t> starts();
  [[nodiscard]] std::vector<std::vector<std::size_t>> blocks() const;
  [[nodiscard]] std::vector<std::size_t> exchanges(std::size_t combination,
                                                   const std::vector<std::size_t>& block) const;
  void climb(std::size_t combination);
  [[nodiscard]] std::size_t roomiest(const std::vector<std::size_t>& combinations, std::size_t reached, double margin);
  void keep(const std::vector<MountDesign>& designs);
  [[nodiscard]] std::size_t number(const MountDesign& design) const;
  void add_options(MountSelection& result);

  const MountCombinations& all_;
  const MountCurves& curves_;
  MountRanking::Judge judge_;
  std::size_t most_;
  const foundation::Progress& progress_;
  std::vector<MountDesign> best_;  ///< by descending margin
  std::vector<std::size_t> seen_;  ///< numbers of combinations, some of them several times
  std::size_t judged_ = 0, curve_count_ = 0;
};

}  // namespace trivet::study
