// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

#include "trivet/fem/condensation.h"
#include "trivet/fem/element_kernel.h"
#include "trivet/fem/substructuring.h"
#include "trivet/spatial/types.h"

namespace trivet::fem {

/// Numbers of the unknowns of a mesh between rigid plates: three displacements of each free node and, if pressures
/// are continuous, one pressure per corner node and material (the pressure jumps where materials meet).
struct Unknowns {
  static constexpr int on_plate_n = -1, on_plate_k = -2;
  int count = 0;
  int pressure_count = 0;
  std::vector<int> displacement;  ///< per node: number of u_x (u_y, u_z follow), or the plate it is bonded to
  std::vector<std::array<int, 4>> pressure;  ///< per element: numbers of its corner pressures; empty without them
};
[[nodiscard]] Unknowns number_unknowns(const Mesh& mesh, TetPressure tet_pressure);

/// A meshed solid with its materials and plates, ready to be linearised about any state. The plates move by (u_N, θ_N,
/// u_K, θ_K) of their current reference points, in the axes of the mesh.
class Solid {
 public:
  Solid(const Mesh& mesh, const std::vector<Material>& materials, TetPressure tet_pressure);

  /// Deformed state: displacement of every node [m], pressure unknowns [Pa], current reference points of the plates
  /// [m].
  struct State {
    Eigen::Matrix3Xd displacement;
    Eigen::VectorXd unknown_pressures;  ///< by number of unknown; displacement entries unused
    Eigen::Vector3d point_n, point_k;
  };
  [[nodiscard]] State rest(const Eigen::Vector3d& point_n, const Eigen::Vector3d& point_k) const;

  /// Tangent and internal forces of a state, condensed to the plates.
  struct Linearised {
    spatial::Matrix12 tangent;  ///< second-order rotation terms of the plates included
    spatial::Vector12
        reaction;  ///< wrench of the plates on the solid, with the free nodes in equilibrium after one Newton step
    spatial::Vector12 wrench;  ///< wrench of the plates on the solid in this state
    double unbalance = 0;      ///< norm of the residual forces on free nodes [N]
    int negative_pivots = 0;   ///< not counting those of the pressures
    bool inverted = false, singular = false;
  };
  [[nodiscard]] Linearised linearise(const State& state, bool recoverable, int threads,
                                     const foundation::Progress& progress);

  /// Newton correction of the free unknowns for a small motion of the plates; needs a recoverable linearisation.
  [[nodiscard]] Eigen::VectorXd correction(const spatial::Vector12& plate_motion) const;
  void add_to_free(const Eigen::VectorXd& correction, State& state) const;

  [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }
  [[nodiscard]] double bytes(bool recoverable, int threads) const {
    return substructuring_->bytes(recoverable, threads);
  }

 private:
  struct Gathered;
  Eigen::MatrixXd element_matrix(int element, const State& state, Gathered& gathered) const;

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  TetPressure tet_pressure_;
  Unknowns unknowns_;
  std::vector<std::vector<int>> element_unknowns_;
  std::unique_ptr<Substructuring> substructuring_;
};

/// A 12×12 matrix in the axes of the mesh, transformed to those of the element (columns of `axes`).
[[nodiscard]] spatial::Matrix12 in_element_axes(const spatial::Matrix12& matrix, const Eigen::Matrix3d& axes);

/// @throws InvalidInput if the condensation of the solid needs more memory than the options allow
void require_memory(const Solid& solid, bool recoverable, const CondensationOptions& options);

}  // namespace trivet::fem
