// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/mount_loads.h"

namespace trivet::study {

/// Which test of a combination of mounts fails first, in the order in which they are made.
enum class MountTest : std::uint8_t { none, price, mass, load, deflection, natural_frequencies, decoupling, curves };
inline constexpr std::size_t mount_tests = 8;

/// More combinations than this are not all judged.
inline constexpr std::size_t most_judged_combinations = 1000000;

/// All combinations of the mounts of a project's choices, with a bound of the least margin of each that takes
/// microseconds.
///
/// Stiffness, static load and mass of a combination are sums over the choices: M = M₀ + Σ (M_i − M₀), with M_i the
/// model in which only one choice differs from the given design; so is what the forces at rest add to the stiffness as
/// a function of the displacements at rest. This gives price, mass, static loads and deflections of the mounts, natural
/// frequencies and the decoupling of bodies. The least margin of these requirements is that of all requirements, or
/// above it. The sum is compared with assembled models of some combinations; where it is not exact (mounts with mass
/// that preloads stiffen, for example), there is no bound.
class MountCombinations {
 public:
  /// @param cases  in which the design has to hold
  /// @throws foundation::InvalidInput if a mount cannot be used at its places, or lacks data that a requirement needs
  MountCombinations(const project::Project& project, std::vector<const project::Case*> cases);

  [[nodiscard]] const std::vector<project::MountChoice>& choices() const { return choices_; }
  [[nodiscard]] const std::vector<const project::Case*>& cases() const { return cases_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Number of the mount of one choice.
  [[nodiscard]] std::size_t mount(std::size_t combination, std::size_t choice) const {
    return combination / strides_[choice] % choices_[choice].mounts.size();
  }
  /// Of each choice.
  [[nodiscard]] std::vector<std::size_t> mounts(std::size_t combination) const;
  /// The combination with another mount of one choice.
  [[nodiscard]] std::size_t with(std::size_t combination, std::size_t choice, std::size_t mount) const {
    return combination + strides_[choice] * mount - strides_[choice] * this->mount(combination, choice);
  }
  /// The model of a case with one mount of one choice, otherwise as given.
  /// @throws foundation::NotComputable if it is not valid
  [[nodiscard]] model::System system_with(const project::Case& variant, std::size_t choice, std::size_t mount) const;
  /// The project with a combination at its places: the base model and the cases in which the design has to hold.
  /// @param given  to which cases() belong
  /// @throws foundation::NotComputable if a case is not valid then
  [[nodiscard]] project::Project project(const project::Project& given, std::size_t combination) const;
  /// The model of a case. @throws foundation::NotComputable if it is not valid
  [[nodiscard]] model::System system(const project::Case& variant, std::size_t combination) const;

  /// Upper bound of the least margin; `failed` is the first test with a margin below 1.
  struct Bound {
    double margin = 0;
    MountTest failed = MountTest::none;
    /// Σ 1/margin¹⁶ of all tests: less if margins that are not the least are larger.
    double crowding = 0;
  };
  [[nodiscard]] std::vector<Bound> bounds(const std::vector<std::size_t>& combinations,
                                          const foundation::Progress& progress) const;
  /// A few from the first to the last one, in which sums are compared with assembled models.
  [[nodiscard]] std::vector<std::size_t> spread_combinations() const;
  /// About so many, evenly over all of them, ascending.
  [[nodiscard]] std::vector<std::size_t> scattered(std::size_t wanted) const;
  /// The numbers of all. @throws foundation::InvalidInput if there are more than `most_judged_combinations`
  [[nodiscard]] std::vector<std::size_t> all() const;
  /// Why there are no bounds; empty if there are.
  [[nodiscard]] const std::string& without_bounds() const { return without_bounds_; }

 private:
  struct Mount {
    model::Rating rating;
    MountRows rows;  ///< on the coordinates of the case, see Sums
  };
  /// One mount of a choice: what it adds to the given design.
  struct Option {
    Eigen::MatrixXd stiffness;       ///< of vibration, first order
    Eigen::MatrixXd rest_stiffness;  ///< of static results, first order
    Eigen::MatrixXd forces_at_rest;  ///< what they add to both, see Sums
    Eigen::VectorXd load;
    std::vector<Mount> mounts;
    double price = 0, mass = 0;
  };
  /// A body that has to be decoupled, on its elements with all other bodies held: coordinates r, p = `basis` r, in
  /// which its inertia matrix is the unit matrix.
  struct Decoupled {
    double least = 0;
    bool whole = false;                ///< no other body: r = p, and `basis` is empty
    Eigen::MatrixXd basis;             ///< coordinates p × r
    Eigen::MatrixXd motion, momentum;  ///< of the centre of mass: 6 × r
  };
  /// A case in coordinates p, q = Φ p, in which its inertia matrix is the unit matrix.
  struct Sums {
    Eigen::MatrixXd shapes;          ///< Φ: undamped modes of the given design
    Eigen::MatrixXd stiffness;       ///< of vibration, first order
    Eigen::MatrixXd rest_stiffness;  ///< of static results, first order
    /// What the forces at rest add to both, n² × (1 + n): without displacements, and per displacement at rest; empty if
    /// the weight acts to first order only.
    Eigen::MatrixXd forces_at_rest;
    Eigen::VectorXd load;
    Eigen::VectorXd beside;     ///< its part that meets these forces: constant forces; empty if there is none
    std::vector<Mount> mounts;  ///< at places without a choice
    std::vector<Decoupled> decoupled;
    double price = 0, mass = 0;
    bool loaded = false;  ///< by gravity or constant forces
    project::Requirements required;
    std::vector<std::vector<Option>> options;  ///< per choice and mount
  };
  [[nodiscard]] Sums sums_of(const project::Case& variant) const;
  static void add_decoupled(const CaseContext& given, Sums& sums);
  void compare_with_assembled();
  /// A combination, with its forces at rest.
  struct Added {
    Eigen::MatrixXd stiffness;       ///< of vibration
    Eigen::MatrixXd rest_stiffness;  ///< of static results, first order
    Eigen::MatrixXd standing;        ///< and with the forces at rest
    Eigen::VectorXd load;
    bool has_rest = true;  ///< false: not to first order; both stiffnesses lack the forces at rest
  };
  [[nodiscard]] static Added added(const Sums& sums, const std::vector<std::size_t>& mounts);
  [[nodiscard]] std::vector<project::Node> changes(std::size_t combination) const;
  [[nodiscard]] Bound bound(const Sums& sums, const std::vector<std::size_t>& mounts) const;

  std::vector<project::MountChoice> choices_;
  std::vector<const project::Case*> cases_;
  std::size_t count_ = 1;
  std::vector<std::size_t> strides_;  ///< per choice: combinations from one of its mounts to the next
  std::vector<Sums> sums_;            ///< per case
  std::string without_bounds_;
};

/// Cases in which a design has to hold. @throws foundation::InvalidInput if none of them has anything to judge
[[nodiscard]] std::vector<const project::Case*> deciding_cases(const project::Project& project);

}  // namespace trivet::study
