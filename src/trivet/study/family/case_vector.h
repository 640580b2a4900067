// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "trivet/design/driven_design.h"
#include "trivet/design/sum_family.h"
#include "trivet/numerics/roots/designs.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// One case of a project as a list of numbers, from which kernels over many designs judge its requirements: A, B, K and
/// the loss of K, loads and rows of results, the static load and what is computed from it, mass properties of bodies.
/// A family of designs interpolates these lists.
///
/// Requirements with kernels: amplitudes, peaks and transmissibilities of constant symmetric matrices, amplitudes at
/// the speeds of the machine (not the peak of several orders, nor a range of speeds under several), avoided natural
/// frequencies and their separation, decoupling, values at rest, loads and deflections of mounts. The others, and all
/// of them if the case has no such form, are judged one design at a time.
class CaseVector {
 public:
  /// @param request  requirements of the case  @param results  what they are and how they are judged as given
  /// @param any_size  more than twelve coordinates too, for which a design takes milliseconds instead of microseconds
  /// @param with_orders  also amplitudes at the speeds of the machine
  CaseVector(const project::Case& variant, const project::Analyses& request,
             const std::vector<RequirementResult>& results, bool any_size = false, bool with_orders = true);

  /// Why there is no such form; empty if there is.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// True if a requirement is judged by a kernel.
  [[nodiscard]] bool covers(std::size_t result) const { return covered_[result]; }
  /// Why it is not, where a kernel for its kind has refused; else empty.
  [[nodiscard]] const std::string& not_covered(std::size_t result) const { return not_covered_[result]; }
  /// True if a requirement has slopes without models: those that are covered and not differenced, and damping ratios.
  [[nodiscard]] bool gives_slopes(std::size_t result) const {
    const MarginSlopes slopes = requirement_row(results_[result].kind).slopes;
    return (covered_[result] && slopes != MarginSlopes::differences) ||
        (reason_.empty() && slopes == MarginSlopes::roots);
  }
  [[nodiscard]] bool has_orders() const { return std::ranges::any_of(searches_, &Search::order); }
  [[nodiscard]] const std::vector<RequirementResult>& results() const { return results_; }

  /// The numbers of a changed model, or why it has another form.
  [[nodiscard]] design::PackedOrReason pack(const model::System& system) const;

  /// Results that are searched together: amplitudes and peaks under one loading.
  struct Search {
    assembly::Band band;       ///< of the amplitudes; from = to: one frequency
    double order = 0;          ///< whose load at the speeds of the machine; 0: the loading of requirement_curve
    std::size_t orders = 0;    ///< that have a load there, in all designs
    bool count_peaks = false;  ///< of some results, at all frequencies
    double min_prominence = 1e-6;
    std::vector<std::size_t> results;  ///< one at a speed is in the searches of all orders, whose squares add
    std::vector<Eigen::Index> curves;  ///< of each result
    design::DrivenDesign first;        ///< of the given model
    Eigen::Index at = 0;               ///< where its loads and rows begin in a list
    Eigen::Index size = 0;
  };
  /// A linear function of the static displacements.
  struct RestValue {
    std::size_t result = 0;
    std::optional<Eigen::Vector2d> range;  ///< of a load of a mount [N]
  };
  /// Rows of a body's coordinates, which must decouple with all other bodies fixed.
  struct Decoupled {
    std::size_t result = 0, body = 0;
    std::vector<Eigen::Index> rows;
    std::vector<int> coordinates;  ///< 0 … 5 of each row
  };
  [[nodiscard]] const std::vector<Search>& searches() const { return searches_; }
  [[nodiscard]] const std::vector<RestValue>& at_rest() const { return at_rest_; }
  [[nodiscard]] const std::vector<Decoupled>& decoupled() const { return decoupled_; }
  [[nodiscard]] const std::vector<assembly::Band>& avoided() const { return avoided_; }

  /// One or more lists as designs, one design per row.
  struct Unpacked {
    Eigen::MatrixXd entries;                      ///< K is that of vibration
    Eigen::ArrayXXd rest_stiffness;               ///< K₀ of static results, packed; empty without loads at rest
    Eigen::ArrayXXd standing;                     ///< the same with what forces at rest add
    Eigen::MatrixXd constant;                     ///< what these add without displacements
    std::vector<Eigen::MatrixXd> per_coordinate;  ///< and per displacement at rest
    std::vector<bool> falls;                      ///< designs whose weight makes them unstable; K is without it
    Eigen::MatrixXd load;                         ///< designs × n, at rest
    Eigen::MatrixXd beside;                       ///< its part that meets `standing`; empty if there is none
    std::vector<Eigen::MatrixXd> rows;            ///< per value at rest: designs × (n + 1), with its constant
    std::vector<Eigen::MatrixXd> bodies;          ///< per decoupled body: designs × 10, see mass_numbers
    [[nodiscard]] Eigen::Index count() const { return entries.rows(); }
  };
  [[nodiscard]] Unpacked unpacked(Eigen::MatrixXd entries) const;
  /// Changes of one design, from changes of its list, one per row.
  [[nodiscard]] Unpacked changes(const Unpacked& here, Eigen::MatrixXd slopes) const;
  /// A, B and K of designs, without a load.
  [[nodiscard]] numerics::Designs free(const Unpacked& designs) const;
  /// D of designs, packed.
  [[nodiscard]] Eigen::ArrayXXd loss(const Unpacked& designs) const;
  /// Designs with the loads and rows of a search.
  [[nodiscard]] numerics::DrivenDesigns searched(const Unpacked& designs, const Search& search) const;
  [[nodiscard]] Eigen::Index coordinates() const { return n_; }

  /// Displacements of one design at rest, as response::StaticSolution has them; NaN if it has none.
  struct Rest {
    Eigen::VectorXd by_weight, by_loads;
  };
  [[nodiscard]] static Rest rest_of(const Unpacked& designs, Eigen::Index design);

 private:
  /// With the stiffness of the first order.
  [[nodiscard]] Unpacked parted(Eigen::MatrixXd entries) const;
  /// Columns of K in a list.
  [[nodiscard]] auto stiffness_in(Eigen::MatrixXd& entries) const {
    const Eigen::Index triangle = n_ * (n_ + 1) / 2;
    return entries.middleCols(2 * triangle, triangle);
  }
  /// Do designs contain their loads at rest?
  [[nodiscard]] bool loads() const { return second_order_ || !at_rest_.empty(); }
  void plan_searches(const project::Analyses& request, const model::System& system,
                     const assembly::Assembled& assembled);
  void plan_operation(const model::System& system, const assembly::Assembled& assembled);
  /// Searches of peaks take over the amplitudes under the same loading if all their curves have one form.
  void unite_searches(const model::System& system, const assembly::Assembled& assembled);
  void set_curves(Search& search) const;
  [[nodiscard]] design::DesignOrReason<design::DrivenDesign> design_of(const Search& search,
                                                                       const model::System& system,
                                                                       const assembly::Assembled& assembled) const;
  /// Under the orders that a search has for one result.
  [[nodiscard]] assembly::Loading order_loading(const Search& search, const model::System& system,
                                                const assembly::Assembled& assembled) const;
  void plan_rest(const model::System& system, const assembly::Assembled& assembled);
  void plan_decoupling(const model::System& system, const assembly::Assembled& assembled);
  [[nodiscard]] std::string form(const model::System& system, const assembly::Assembled& assembled,
                                 std::vector<design::DrivenDesign>& designs) const;

  std::vector<RequirementResult> results_;
  std::vector<bool> covered_;
  std::vector<std::string> not_covered_;
  std::vector<Search> searches_;
  std::vector<RestValue> at_rest_;
  std::vector<Decoupled> decoupled_;
  std::vector<assembly::Band> avoided_;
  std::string reason_;
  bool has_static_stiffness_ = false;  ///< of rubber: it is another one than that of vibration
  bool has_loads_ = false;             ///< constant forces on a machine whose forces at rest are part of K
  bool second_order_ = false;          ///< the forces at rest are part of K
  Eigen::Index n_ = 0;
};

/// Mass [kg], centre of mass [m], inertia about it (xx, yy, zz, xy, xz, yz) [kg m²] of one body as ten numbers.
using MassNumbers = Eigen::Matrix<double, 10, 1>;
[[nodiscard]] MassNumbers mass_numbers(const spatial::MassProperties& mass);
[[nodiscard]] spatial::MassProperties mass_of(const MassNumbers& numbers);

}  // namespace trivet::study
