// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/condensation.h"

#include <fmt/format.h>

#include "trivet/elements/law.h"
#include "trivet/fem/mesh.h"
#include "trivet/fem/solid.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::fem {
namespace {

using spatial::Matrix12;

/// |a − b|_ij / √(a_ii a_jj).
Matrix12 scaled_difference(const Matrix12& a, const Matrix12& b) {
  const spatial::Vector12 scale = a.diagonal().cwiseAbs().cwiseSqrt();
  return (a - b).cwiseAbs().cwiseQuotient(scale * scale.transpose());
}

SolidStiffness condense_with(const Mesh& mesh, const std::vector<Material>& materials, const ElementFrame& frame,
                             TetPressure pressure, const CondensationOptions& options,
                             const foundation::Progress& progress) {
  Solid solid(mesh, materials, pressure);
  require_memory(solid, false, options);
  const Solid::Linearised result = solid.linearise(solid.rest(frame.point_n, frame.point_k), false,
                                                   foundation::thread_count(options.threads), progress);
  if (result.singular || result.negative_pivots != 0)
    throw foundation::NotComputable(
        "the solid is not held by its plates: a part of it can move freely, or elements have collapsed");
  const Matrix12 all_motions = in_element_axes(result.tangent, frame.axes);
  const Eigen::Vector3d arm = frame.axes.transpose() * (frame.point_k - frame.point_n);
  SolidStiffness stiffness{.unknowns = solid.unknowns().count, .elements = static_cast<int>(mesh.elements.cols())};
  const Matrix12 symmetric = 0.5 * (all_motions + all_motions.transpose());
  stiffness.stiffness = elements::from_moved_end(symmetric.bottomRightCorner<6, 6>(), arm);
  stiffness.rigid_residual = scaled_difference(stiffness.stiffness, all_motions).maxCoeff();
  return stiffness;
}

}  // namespace

Matrix12 in_element_axes(const Matrix12& c, const Eigen::Matrix3d& axes) {
  Matrix12 turn = Matrix12::Zero();
  turn.topLeftCorner<6, 6>() = turn.bottomRightCorner<6, 6>() = spatial::both_blocks(axes);
  return turn.transpose() * c * turn;
}

void require_memory(const Solid& solid, bool recoverable, const CondensationOptions& options) {
  const double bytes = solid.bytes(recoverable, foundation::thread_count(options.threads));
  if (bytes > options.memory_limit)
    throw foundation::InvalidInput(
        fmt::format("the mesh with {} unknowns needs about {:.1f} GB, the limit is {:.1f} GB: use a coarser mesh or "
                    "raise the limit",
                    solid.unknowns().count, bytes * 1e-9, options.memory_limit * 1e-9));
}

SolidStiffness condense(const Mesh& mesh, const std::vector<Material>& materials, const ElementFrame& frame,
                        const CondensationOptions& options, const foundation::Progress& progress) {
  require_sound(mesh, materials);
  SolidStiffness stiffness = condense_with(mesh, materials, frame, TetPressure::constant, options, progress);
  if (mesh.kind == Mesh::Kind::hex27) return stiffness;
  const SolidStiffness upper = condense_with(mesh, materials, frame, TetPressure::continuous, options, progress);
  const Matrix12 mean = 0.5 * (stiffness.stiffness + upper.stiffness);
  stiffness.relative_error = scaled_difference(mean, stiffness.stiffness);
  stiffness.stiffness = mean;
  stiffness.rigid_residual = std::max(stiffness.rigid_residual, upper.rigid_residual);
  stiffness.unknowns = upper.unknowns;
  return stiffness;
}

SolidStiffness condense(const Mesh& fine, const Mesh& coarse, double refinement, const std::vector<Material>& materials,
                        const ElementFrame& frame, const CondensationOptions& options,
                        const foundation::Progress& progress) {
  if (!(refinement > 1))
    throw foundation::InvalidInput(
        fmt::format("refinement {}; the fine mesh must have the smaller elements (ratio > 1)", refinement));
  const SolidStiffness rough = condense(coarse, materials, frame, options, progress);
  SolidStiffness stiffness = condense(fine, materials, frame, options, progress);
  stiffness.relative_error = scaled_difference(stiffness.stiffness, rough.stiffness) / (refinement - 1);
  return stiffness;
}

}  // namespace trivet::fem
