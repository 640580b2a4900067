// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/solid.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>

#include "trivet/foundation/index.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::fem {

namespace {

constexpr int retained = 13;  ///< six motions of N, six of K, and one for the unbalanced forces

Eigen::Matrix3Xd columns(const Eigen::Matrix3Xd& all, const Eigen::MatrixXi& elements, int element) {
  Eigen::Matrix3Xd own(3, elements.rows());
  for (Eigen::Index a = 0; a < elements.rows(); ++a) own.col(a) = all.col(elements(a, element));
  return own;
}

Eigen::Matrix3Xd centres(const Mesh& mesh) {
  Eigen::Matrix3Xd result(3, mesh.elements.cols());
  for (int e = 0; e < mesh.elements.cols(); ++e) result.col(e) = columns(mesh.nodes, mesh.elements, e).rowwise().mean();
  return result;
}

}  // namespace

/// Results of the elements for sums that must not depend on the order of the threads.
struct Solid::Gathered {
  Eigen::MatrixXd forces;  ///< one column per element
  std::vector<char> inverted;
};

Solid::Solid(const Mesh& mesh, const std::vector<Material>& materials, TetPressure tet_pressure)
    : mesh_(mesh), materials_(materials), tet_pressure_(tet_pressure), unknowns_(number_unknowns(mesh, tet_pressure)) {
  const int first = unknowns_.count;
  for (int e = 0; e < mesh.elements.cols(); ++e) {
    auto& own = element_unknowns_.emplace_back();
    bool at_n = false, at_k = false;
    for (int c = 0; c < 3; ++c)
      for (Eigen::Index a = 0; a < mesh.elements.rows(); ++a) {
        const int number = unknowns_.displacement[mesh.elements(a, e)];
        at_n = at_n || number == Unknowns::on_plate_n;
        at_k = at_k || number == Unknowns::on_plate_k;
        if (number >= 0) own.push_back(number + c);
      }
    if (!unknowns_.pressure.empty())
      for (const int number : unknowns_.pressure[e]) own.push_back(number);
    for (int i = 0; at_n && i < 6; ++i) own.push_back(first + i);
    for (int i = 0; at_k && i < 6; ++i) own.push_back(first + 6 + i);
    own.push_back(first + 12);
  }
  substructuring_ = std::make_unique<Substructuring>(element_unknowns_, centres(mesh), first, retained);
}

Solid::State Solid::rest(const Eigen::Vector3d& point_n, const Eigen::Vector3d& point_k) const {
  return {Eigen::Matrix3Xd::Zero(3, mesh_.nodes.cols()), Eigen::VectorXd::Zero(unknowns_.count), point_n, point_k};
}

Eigen::MatrixXd Solid::element_matrix(int element, const State& state, Gathered& gathered) const {
  const Eigen::Index nodes = mesh_.elements.rows(), all = 3 * nodes + (unknowns_.pressure.empty() ? 0 : 4);
  const Eigen::Matrix3Xd x = columns(mesh_.nodes, mesh_.elements, element),
                         u = columns(state.displacement, mesh_.elements, element);
  Eigen::Vector4d pressure = Eigen::Vector4d::Zero();
  for (std::size_t c = 0; c < 4 && !unknowns_.pressure.empty(); ++c)
    pressure(to_index(c)) = state.unknown_pressures(unknowns_.pressure[element][c]);
  const Material& material = materials_[mesh_.material[element]];
  const ElementSystem system =
      element_system(mesh_.kind, tet_pressure_, x, material, u.isZero(0) ? nullptr : &u, &pressure);
  gathered.forces.col(element) = system.force;
  gathered.inverted[element] = system.inverted;

  // Local unknowns: free ones stay, those on a plate become six motions of its reference point.
  std::vector<Eigen::Index> free, bonded;
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(all, 12);
  for (Eigen::Index i = 0; i < all; ++i) {
    const Eigen::Index a = i % nodes;
    const int number = i < 3 * nodes ? unknowns_.displacement[mesh_.elements(a, element)] : 0;
    (number >= 0 ? free : bonded).push_back(i);
    if (number >= 0) continue;
    const bool at_n = number == Unknowns::on_plate_n;
    const Eigen::Vector3d lever = x.col(a) + u.col(a) - (at_n ? state.point_n : state.point_k);
    motion.block<1, 6>(i, at_n ? 0 : 6) = spatial::rigid_motion(lever).row(i / nodes);
  }
  const auto& own = element_unknowns_[element];
  const Eigen::Index f = to_index(free.size()), p = to_index(own.size()) - f - 1;
  const Eigen::Index first_motion = p > 0 && own[f] == unknowns_.count ? 0 : 6;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(f + p + 1, f + p + 1);
  result.topLeftCorner(f, f) = system.tangent(free, free);
  result.row(f + p).head(f) = system.force(free).transpose();
  if (p > 0) {
    const Eigen::MatrixXd levers = motion(bonded, Eigen::seqN(first_motion, p));
    result.block(f, 0, p, f).noalias() = levers.transpose() * system.tangent(bonded, free);
    result.block(f, f, p, p).noalias() = levers.transpose() * system.tangent(bonded, bonded) * levers;
    result.row(f + p).segment(f, p) = (levers.transpose() * system.force(bonded)).transpose();
  }
  result.triangularView<Eigen::StrictlyUpper>() = result.transpose();
  return result;
}

Solid::Linearised Solid::linearise(const State& state, bool recoverable, int threads,
                                   const foundation::Progress& progress) {
  const Eigen::Index nodes = mesh_.elements.rows();
  Gathered gathered{Eigen::MatrixXd::Zero(3 * nodes + (unknowns_.pressure.empty() ? 0 : 4), mesh_.elements.cols()),
                    std::vector<char>(element_unknowns_.size(), 0)};
  const auto condensed = substructuring_->condense([&](int e) { return element_matrix(e, state, gathered); },
                                                   recoverable, threads, progress);

  Linearised result{.tangent = condensed.matrix.topLeftCorner<12, 12>(),
                    .reaction = condensed.matrix.col(12).head<12>(),
                    .wrench = spatial::Vector12::Zero(),
                    .negative_pivots = condensed.negative_pivots - unknowns_.pressure_count,
                    .singular = condensed.singular};
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, mesh_.nodes.cols());
  for (int e = 0; e < mesh_.elements.cols(); ++e) {
    result.inverted = result.inverted || gathered.inverted[e];
    for (Eigen::Index a = 0; a < nodes; ++a)
      for (int c = 0; c < 3; ++c) forces(c, mesh_.elements(a, e)) += gathered.forces(c * nodes + a, e);
  }
  for (Eigen::Index node = 0; node < mesh_.nodes.cols(); ++node) {
    const Eigen::Vector3d force = forces.col(node);
    const int number = unknowns_.displacement[node];
    if (number >= 0) {
      result.unbalance += force.squaredNorm();
      continue;
    }
    const int at = number == Unknowns::on_plate_n ? 0 : 6;
    const Eigen::Vector3d lever =
        mesh_.nodes.col(node) + state.displacement.col(node) - (at == 0 ? state.point_n : state.point_k);
    result.wrench.segment<3>(at) += force;
    result.wrench.segment<3>(at + 3) += lever.cross(force);
    // Second-order term of a rotation φ: f · ½ φ × (φ × r). Without it a rotated preload appears as false moments.
    result.tangent.block<3, 3>(at + 3, at + 3) +=
        0.5 * (force * lever.transpose() + lever * force.transpose()) - force.dot(lever) * Eigen::Matrix3d::Identity();
  }
  result.unbalance = std::sqrt(result.unbalance);
  return result;
}

Eigen::VectorXd Solid::correction(const spatial::Vector12& plate_motion) const {
  Eigen::VectorXd moved(retained);
  moved << plate_motion, 1;
  return substructuring_->recover(moved).head(unknowns_.count);
}

void Solid::add_to_free(const Eigen::VectorXd& correction, State& state) const {
  state.unknown_pressures += correction;  // only the entries of pressures are read
  for (Eigen::Index node = 0; node < mesh_.nodes.cols(); ++node) {
    const int number = unknowns_.displacement[node];
    if (number >= 0) state.displacement.col(node) += correction.segment<3>(number);
  }
}

Unknowns number_unknowns(const Mesh& mesh, TetPressure tet_pressure) {
  Unknowns unknowns;
  unknowns.displacement.assign(to_size(mesh.nodes.cols()), 0);
  for (const int node : mesh.plate_n) unknowns.displacement[node] = Unknowns::on_plate_n;
  for (const int node : mesh.plate_k) unknowns.displacement[node] = Unknowns::on_plate_k;
  for (int& number : unknowns.displacement)
    if (number == 0) {
      number = unknowns.count;
      unknowns.count += 3;
    }
  if (mesh.kind != Mesh::Kind::tet10 || tet_pressure != TetPressure::continuous) return unknowns;
  std::map<std::pair<int, int>, int> numbers;  // by node and material
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    auto& corners = unknowns.pressure.emplace_back();
    for (int c = 0; c < 4; ++c) {
      const auto [place, is_new] = numbers.try_emplace({mesh.elements(c, e), mesh.material[e]}, unknowns.count);
      unknowns.count += is_new;
      corners[c] = place->second;
    }
  }
  unknowns.pressure_count = static_cast<int>(numbers.size());
  return unknowns;
}

}  // namespace trivet::fem
