// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/preload.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "trivet/fem/mesh.h"
#include "trivet/fem/solid.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::fem {
namespace {

using spatial::Matrix6;
using spatial::Vector12;
using spatial::Vector6;

Eigen::Matrix3d rotation(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0 ? spatial::rotation_about(vector, angle) : Eigen::Matrix3d::Identity();
}

/// State of the solid and rotation of plate K, in the axes of the mesh.
struct Equilibrium {
  Solid::State state;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

/// One load step between two equilibrium states, by Newton's method on free nodes and plate together.
class Newton {
 public:
  Newton(const Mesh& mesh, Solid& solid, const ElementFrame& frame, const Preload& preload,
         const PreloadOptions& options, const foundation::Progress& progress, PreloadedStiffness& record)
      : mesh_(mesh),
        solid_(solid),
        frame_(frame),
        preload_(preload),
        options_(options),
        progress_(progress),
        record_(record) {}

  /// Advances from the equilibrium state `at` by the load fraction `part` to the fraction `target`; false if this
  /// fails.
  bool advance(Equilibrium& at, double part, double target, Solid::Linearised& linearised) {
    Equilibrium trial = at;
    Solid::Linearised now = linearised;
    Vector6 imposed = Vector6::Zero();
    for (int i = 0; i < 6; ++i)
      if (!preload_.is_load[i]) imposed(i) = part * preload_.value(i);
    // The factors in the solid may be those of a failed attempt: start from the equilibrium state.
    now = solid_.linearise(trial.state, true, foundation::thread_count(options_.condensation.threads), progress_);
    double before = 1e300;
    for (int iteration = 0; iteration < options_.most_iterations; ++iteration) {
      const Vector6 motion = plate_motion(now, imposed, target);
      if (!motion.allFinite()) return false;
      move(trial, motion);
      imposed.setZero();
      now = solid_.linearise(trial.state, true, foundation::thread_count(options_.condensation.threads), progress_);
      if (now.inverted || now.singular || !std::isfinite(now.unbalance)) return false;
      const double relative = unbalance(now, target);
      record_.unbalance.push_back(relative);
      if (relative < options_.tolerance) {
        at = trial;
        linearised = now;
        return true;
      }
      if (iteration > 3 && !(relative < before)) return false;
      before = relative;
    }
    return false;
  }

 private:
  [[nodiscard]] Vector6 load(double target) const {
    Vector6 wrench = Vector6::Zero();
    for (int i = 0; i < 6; ++i)
      if (preload_.is_load[i]) wrench(i) = target * preload_.value(i);
    return wrench;
  }

  /// Motion of K, in the axes of the element, that balances its loaded components to first order.
  [[nodiscard]] Vector6 plate_motion(const Solid::Linearised& now, const Vector6& imposed, double target) const {
    const Matrix6 axes = spatial::both_blocks(frame_.axes);
    Matrix6 k = axes.transpose() * now.tangent.bottomRightCorner<6, 6>() * axes;
    Vector6 lacking = load(target) - axes.transpose() * now.reaction.tail<6>();
    for (int i = 0; i < 6; ++i) {
      if (preload_.is_load[i]) continue;
      k.row(i).setZero();
      k(i, i) = 1;
      lacking(i) = imposed(i);
    }
    return numerics::completely_pivoted_solution(k, lacking);
  }

  void move(Equilibrium& e, const Vector6& motion_in_element) const {
    const Vector6 motion = spatial::both_blocks(frame_.axes) * motion_in_element;
    Vector12 both = Vector12::Zero();
    both.tail<6>() = motion;
    solid_.add_to_free(solid_.correction(both), e.state);
    e.turn = rotation(motion.tail<3>()) * e.turn;
    e.state.point_k += motion.head<3>();
    for (const int node : mesh_.plate_k) {
      const Eigen::Vector3d lever = mesh_.nodes.col(node) - frame_.point_k;
      e.state.displacement.col(node) = e.state.point_k - frame_.point_k + e.turn * lever - lever;
    }
  }

  /// Residual forces on free nodes and missing load of the plate, relative to the forces on the plates.
  [[nodiscard]] double unbalance(const Solid::Linearised& now, double target) const {
    const Vector6 lacking = load(target) - spatial::both_blocks(frame_.axes).transpose() * now.wrench.tail<6>();
    const double size = (mesh_.nodes.rowwise().maxCoeff() - mesh_.nodes.rowwise().minCoeff()).norm();
    double left = now.unbalance * now.unbalance;
    for (int i = 0; i < 6; ++i)
      if (preload_.is_load[i]) left += std::pow(lacking(i) / (i < 3 ? 1 : size), 2);
    const double scale =
        now.wrench.segment<3>(6).norm() + now.wrench.segment<3>(9).norm() / size + load(target).head<3>().norm();
    return left == 0 ? 0 : std::sqrt(left) / scale;
  }

  const Mesh& mesh_;
  Solid& solid_;
  const ElementFrame& frame_;
  const Preload& preload_;
  const PreloadOptions& options_;
  const foundation::Progress& progress_;
  PreloadedStiffness& record_;
};

void describe(const Equilibrium& at, const Solid::Linearised& linearised, const ElementFrame& frame,
              PreloadedStiffness& result) {
  const Matrix6 axes = spatial::both_blocks(frame.axes);
  result.stiffness = in_element_axes(linearised.tangent, frame.axes);
  result.preload << axes.transpose() * linearised.wrench.head<6>(), axes.transpose() * linearised.wrench.tail<6>();
  result.arm = frame.axes.transpose() * (at.state.point_k - at.state.point_n);
  const Eigen::AngleAxisd turned(at.turn);
  result.motion << frame.axes.transpose() * (at.state.point_k - frame.point_k),
      frame.axes.transpose() * (turned.angle() * turned.axis());
  result.negative_eigenvalues = linearised.negative_pivots;
}

}  // namespace

PreloadedStiffness preloaded_stiffness(const Mesh& mesh, const std::vector<Material>& materials,
                                       const ElementFrame& frame, const Preload& preload, const PreloadOptions& options,
                                       const foundation::Progress& progress) {
  constexpr double smallest_part = 1.0 / 256;
  require_sound(mesh, materials);
  if (!preload.value.allFinite() || options.steps < 1)
    throw foundation::InvalidInput(
        fmt::format("preload in {} steps: it must be finite and have at least one step", options.steps));
  Solid solid(mesh, materials, options.tet_pressure);
  require_memory(solid, true, options.condensation);

  PreloadedStiffness result;
  Equilibrium at{solid.rest(frame.point_n, frame.point_k)};
  Solid::Linearised linearised =
      solid.linearise(at.state, false, foundation::thread_count(options.condensation.threads), progress);
  if (linearised.singular || linearised.negative_pivots != 0)
    throw foundation::NotComputable(
        "the solid is not held by its plates: a part of it can move freely, or elements have collapsed");
  Newton newton(mesh, solid, frame, preload, options, progress, result);
  double part = 1.0 / options.steps;
  while (result.reached < 1 - 1e-12 && part >= smallest_part) {
    part = std::min(part, 1 - result.reached);
    if (newton.advance(at, part, result.reached + part, linearised)) result.reached += part;
    else part /= 2;
  }
  result.converged = result.reached >= 1 - 1e-12;
  if (!result.converged)
    result.failure_reason = fmt::format(
        "no equilibrium beyond {:.1f} % of the preload: the solid buckles, its elements invert, or the mesh is too "
        "coarse for the strains; use a smaller preload or a finer mesh",
        100 * result.reached);
  describe(at, linearised, frame, result);
  return result;
}

}  // namespace trivet::fem
