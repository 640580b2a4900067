// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "trivet/study/requirements/verdict.h"
#include "trivet/study/select/mount_curves.h"

namespace trivet::study {

// Which mounts of a catalogue at which places: `trivet select`. Mathematics: docs/design.md.

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
  std::string governing_for_people;        ///< the same with its bound at the level that people read
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
  std::string transmissibility;    ///< which one MountDesign::transmissibility is, in words
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
/// (mount_selection.h).
/// @param most  number of designs in `best`
/// @throws foundation::InvalidInput without choices or requirements, or if an order needs what is not given;
/// NotComputable if a requirement cannot be judged
[[nodiscard]] MountSelection mount_selection(const project::Project& project, std::size_t most,
                                             const foundation::Progress& progress = {},
                                             MountOrder by = MountOrder::margin);

/// The changes of the file that set the best combination.
[[nodiscard]] std::vector<project::Node> selection_changes(const MountSelection& found);

/// What a ranking makes small in the designs that hold: price, mass [kg], or the largest transmissibility as a share of
/// the allowed one. 0 for a ranking by margin.
[[nodiscard]] double order_key(MountOrder order, const MountDesign& design);

/// The same for combinations before they are judged; 0 where it is not known without this.
/// @throws foundation::InvalidInput if a mount has no price or mass, prices differ in currency, or no isolation is
/// required
[[nodiscard]] std::vector<double> order_keys(MountOrder order, const MountCombinations& all, const MountCurves& curves,
                                             const std::vector<std::size_t>& combinations,
                                             const foundation::Progress& progress);

/// Margins within this of each other are equal: round-off does not choose, the order of the catalogue does.
inline constexpr double same_margin = 1e-9;

/// Finds the best of sets of combinations: bounds from sums first, then exact amplitudes and peaks of those that may be
/// among the best, and all requirements last. No combination is judged twice.
class MountRanking {
 public:
  /// All requirements of one combination.
  using Judge = std::function<MountDesign(std::size_t)>;

  /// Computes the curves of those combinations that meet the other tests.
  /// @param all, curves, progress  used by the result
  MountRanking(const MountCombinations& all, const MountCurves& curves, std::vector<std::size_t> combinations,
               Judge judge, const foundation::Progress& progress);

  /// The best `most` of the combinations, by descending margin.
  [[nodiscard]] std::vector<MountDesign> best(std::size_t most) { return best_of(order_, most); }
  /// The first `most` of those that meet every requirement, in another order than by margin: fewer if fewer do.
  [[nodiscard]] std::vector<MountDesign> first_that_hold(MountOrder by, std::size_t most);
  /// The best combination with each mount of a choice.
  [[nodiscard]] std::vector<MountDesign> best_with_each(std::size_t choice);

  [[nodiscard]] std::size_t judged_count() const { return judged_.size(); }
  /// Combinations of which the curves were computed.
  [[nodiscard]] std::size_t curve_count() const { return curve_count_; }
  /// Combinations that fail each test first.
  [[nodiscard]] const std::array<std::size_t, mount_tests>& failed() const { return failed_; }

 private:
  using Combinations = std::vector<std::size_t>;  ///< places in `list_`

  /// @param ordered  by descending bound from the sums
  [[nodiscard]] std::vector<MountDesign> best_of(const Combinations& ordered, std::size_t most);
  /// Lowers bounds to the margins of the curves.
  void lower(const Combinations& batch);
  void judge(const Combinations& batch);

  const MountCombinations& all_;
  const MountCurves& curves_;
  std::vector<std::size_t> list_;
  Judge judge_;
  const foundation::Progress& progress_;
  std::vector<MountCombinations::Bound> sums_;  ///< bounds from the sums
  std::vector<double> bounds_;                  ///< the same, lowered by the curves where these are known
  std::vector<bool> has_curves_;
  Combinations order_;
  std::unordered_map<std::size_t, MountDesign> judged_;
  std::array<std::size_t, mount_tests> failed_ = {};
  std::size_t curve_count_ = 0;
};

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
