// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/assembled.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "trivet/assembly/following.h"
#include "trivet/assembly/second_order.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

using spatial::Matrix6;

/// Adds six rows from `first_row` on to the column of one coordinate; each coordinate has one column.
void add_column(Eigen::MatrixXd& ends, std::vector<Eigen::Index>& rows, int first_row, Eigen::Index row,
                const spatial::Vector6& column) {
  const auto known = to_size(std::ranges::find(rows, row) - rows.begin());
  assert(row >= 0 && to_index(rows.size()) == ends.cols() &&
         "one column for each coordinate, in the order of the rows");
  if (known == rows.size()) {
    rows.push_back(row);
    ends.conservativeResize(Eigen::NoChange, ends.cols() + 1);
    ends.rightCols<1>().setZero();
  }
  ends.col(to_index(known)).segment<6>(first_row) += column;
}

/// First ground coordinates of the ends that are on the ground, and of the places with fixed directions.
struct GroundRows {
  std::vector<std::array<Eigen::Index, 2>>
      of_ends;                          ///< of end N and end K of each element; −1 if that end is not on the ground
  std::vector<Eigen::Index> of_places;  ///< of each foundation: those under its impedance; −1 for modes
};

GroundRows ground_rows(const model::Description& description, Ground& ground) {
  GroundRows rows;
  rows.of_places.assign(description.foundations.size(), -1);
  for (std::size_t e = 0; e < description.elements.size(); ++e) {
    const model::Element& element = description.elements[e];
    std::array<Eigen::Index, 2> first = {-1, -1};
    for (const auto& [end, row] : {std::pair{&element.n, &first[0]}, {&element.k, &first[1]}}) {
      if (!end->on_ground()) continue;
      *row = ground.followed_row();
      ground.ends.push_back({e, {end->at, end->axes}, *row});
    }
    if (model::joins_foundation_to_ground(element)) rows.of_places[element.k.foundation->foundation] = first[0];
    rows.of_ends.push_back(first);
  }
  return rows;
}

/// Adds the motion of an end with the rigid ground at its place, and with that place alone; `fixed`: the directions in
/// which it moves so.
void add_ground(const Matrix6& turn, const Matrix6& fixed, const Eigen::Vector3d& at, Eigen::Index own_row,
                int first_row, ElementMap& map) {
  const Matrix6 as_one = turn * fixed * spatial::rigid_motion(at), alone = turn * fixed;
  for (int j = 0; j < 6; ++j) add_column(map.ground_ends, map.ground_rows, first_row, j, as_one.col(j));
  for (int j = 0; j < 6; ++j) add_column(map.ground_ends, map.ground_rows, first_row, own_row + j, alone.col(j));
}

/// Adds the end's six displacements (rows from `first_row`) as functions of the coordinates of its body, its foundation
/// and the ground.
/// @param ground_row  first ground coordinate of this end, if it is on the ground
void add_end(const Layout& layout, const model::End& end, Eigen::Index ground_row, const GroundRows& ground,
             int first_row, ElementMap& map) {
  const Matrix6 turn = spatial::both_blocks(end.axes).transpose();
  if (end.body) {
    const Matrix6 motion = turn * spatial::rigid_motion(end.at);
    for (int j = 0; j < 6; ++j)
      if (layout.row(*end.body, j) >= 0)
        add_column(map.ends, map.rows, first_row, layout.row(*end.body, j), motion.col(j));
  } else if (end.foundation) {
    const model::OnFoundation& on = *end.foundation;
    for (Eigen::Index j = 0; j < on.shape.cols(); ++j)
      add_column(map.ends, map.rows, first_row, layout.foundation_row(on.foundation) + j, turn * on.shape.col(j));
    if (!on.fixed_directions.isZero(0)) {
      assert(ground.of_places[on.foundation] >= 6 &&
             "fixed directions need the ground coordinates under the impedance");
      add_ground(turn, on.fixed_directions, end.at, ground.of_places[on.foundation], first_row, map);
    }
  } else {
    assert(ground_row >= 6 && "an end on the ground has coordinates of its own behind those of the rigid foundation");
    add_ground(turn, Matrix6::Identity(), end.at, ground_row, first_row, map);
  }
}

ElementMap map_of(const Layout& layout, std::size_t index, const model::Element& element, const GroundRows& ground) {
  ElementMap map;
  map.matrices = elements::matrices(element.law);
  const Eigen::Index internal = map.matrices.stiffness.rows() - 12;
  assert(internal >= 0 && "two ends have twelve displacements");
  map.ends.resize(12 + internal, 0);
  map.ground_ends.resize(12 + internal, 0);
  add_end(layout, element.n, ground.of_ends[index][0], ground, 0, map);
  add_end(layout, element.k, ground.of_ends[index][1], ground, 6, map);
  map.end_columns = map.ends.cols();
  map.ends.conservativeResize(Eigen::NoChange, map.end_columns + internal);
  map.ends.rightCols(internal).setZero();
  map.ends.bottomRightCorner(internal, internal).setIdentity();
  for (Eigen::Index i = 0; i < internal; ++i) map.rows.push_back(layout.internal_row(index) + i);
  assert(to_index(map.rows.size()) == map.ends.cols() && to_index(map.ground_rows.size()) == map.ground_ends.cols());
  if (elements::is_frequency_dependent(element.law))
    map.dynamic_stiffness = [law = element.law, name = element.name](std::complex<double> omega,
                                                                     double near) -> elements::Matrix12c {
      try {
        return elements::dynamic_stiffness(law, omega, near);
      } catch (const foundation::NotComputable& reason) {
        throw foundation::NotComputable("element \"" + name + "\": " + reason.what());
      }
    };
  if (const auto& given = element.law.frequency_dependence) {
    map.defined_from = given->from;
    map.defined_to = given->to;
    map.knots = given->knots;
  }
  return map;
}

void scatter_block(const Eigen::MatrixXd& local, const std::vector<Eigen::Index>& rows,
                   const std::vector<Eigen::Index>& columns, double factor, Eigen::MatrixXd& global) {
  assert(to_index(rows.size()) == local.rows() && to_index(columns.size()) == local.cols());
  for (Eigen::Index i = 0; i < local.rows(); ++i)
    for (Eigen::Index j = 0; j < local.cols(); ++j) global(rows[i], columns[j]) += factor * local(i, j);
}

void scatter(const ElementMap& map, const Eigen::MatrixXd& matrix, double factor, Eigen::MatrixXd& global) {
  if (matrix.isZero(0)) return;
  scatter_block(map.ends.transpose() * matrix * map.ends, map.rows, map.rows, factor, global);
}

/// Coupling of the ground ends to the free rows, for the elements that `is_selected` accepts.
template <typename Predicate>
void couple_ground(const std::vector<ElementMap>& elements, Eigen::Index n, Ground& ground,
                   const Predicate& is_selected) {
  ground.A = ground.B = ground.K = ground.K_loss = Eigen::MatrixXd::Zero(n, ground.size());
  bool lossy = false;
  for (const ElementMap& map : elements) {
    if (map.ground_rows.empty() || !is_selected(map)) continue;
    const auto add = [&](const Eigen::MatrixXd& matrix, double factor, Eigen::MatrixXd& global) {
      if (matrix.isZero(0)) return;
      scatter_block(map.ends.transpose() * matrix * map.ground_ends, map.rows, map.ground_rows, factor, global);
    };
    add(map.matrices.stiffness, 1, ground.K);
    add(map.matrices.damping, 1, ground.B);
    add(map.matrices.mass, 1, ground.A);
    add(map.matrices.loss, 1, ground.K_loss);
    lossy = lossy || map.matrices.loss_factor > 0;
  }
  if (!lossy) ground.K_loss.resize(0, 0);
}

/// The damping of the whole system acts on the motion relative to the static motion of the massive coordinates with the
/// ground.
SystemDampingMatrices system_damping(const numerics::DynamicMatrices& m, const Eigen::MatrixXd& damping,
                                     const Eigen::MatrixXd& ground_stiffness) {
  const Eigen::VectorXd d = numerics::unit_scale(m);
  const Eigen::MatrixXd scaled = d.asDiagonal() * m.K * d.asDiagonal();
  const numerics::RankedSolution solution = numerics::ranked_solution(scaled, d.asDiagonal() * ground_stiffness);
  const Eigen::MatrixXd follow = d.asDiagonal() * solution.X;  // −(motion of the coordinates)
  return {damping, damping * follow, solution.rank == m.size()};
}

void add_body(const Layout& layout, std::size_t index, const model::Body& body, Eigen::MatrixXd& mass) {
  const Matrix6 a = spatial::mass_matrix(body.mass);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (layout.row(index, i) >= 0 && layout.row(index, j) >= 0)
        mass(layout.row(index, i), layout.row(index, j)) += a(i, j);
}

void add_foundation(const Layout& layout, std::size_t index, const model::Foundation& foundation,
                    numerics::DynamicMatrices& m) {
  const Eigen::Index first = layout.foundation_row(index), count = foundation.mass.rows();
  m.A.block(first, first, count, count) += foundation.mass;
  m.B.block(first, first, count, count) += foundation.damping;
  m.K.block(first, first, count, count) += foundation.stiffness;
}

/// Mean of m and mᵀ, tile by tile: the entries of two tiles stay in the cache.
void make_exactly_symmetric(Eigen::MatrixXd& m) {
  assert(m.rows() == m.cols());
  constexpr Eigen::Index tile = 32;
  const Eigen::Index n = m.rows();
  for (Eigen::Index left = 0; left < n; left += tile)
    for (Eigen::Index top = left; top < n; top += tile)
      for (Eigen::Index j = left; j < std::min(left + tile, n); ++j)
        for (Eigen::Index i = std::max(top, j + 1); i < std::min(top + tile, n); ++i)
          m(i, j) = m(j, i) = 0.5 * (m(i, j) + m(j, i));
  assert((m == m.transpose() || !m.allFinite()) && "the tiles cover every pair of entries");
}

/// Rayleigh and modal damping act on the coordinates with mass, with the stiffness after static condensation of the
/// massless ones.
void add_system_damping(const model::SystemDamping& damping, numerics::DynamicMatrices& m) {
  if (std::holds_alternative<std::monostate>(damping)) return;
  const numerics::MassiveSystem massive = numerics::massive_system(m);
  const std::vector<Eigen::Index> rows = numerics::massive_rows(m.A);
  if (const auto* rayleigh = std::get_if<model::RayleighDamping>(&damping))
    m.B(rows, rows) += rayleigh->mass * massive.A + rayleigh->stiffness * massive.K;
  if (const auto* given = std::get_if<model::ModalDamping>(&damping)) {
    const auto modes = numerics::generalized_modes(massive.K, massive.A, true);
    assert((given->ratios.size() == 1 || to_index(given->ratios.size()) == modes.lambda.size()) &&
           "checked models have one ratio, or one for each mode");
    Eigen::VectorXd twice(modes.lambda.size());
    for (Eigen::Index i = 0; i < twice.size(); ++i) {
      const double ratio = given->ratios.size() == 1 ? given->ratios[0] : given->ratios[i];
      twice(i) = 2 * ratio * std::sqrt(std::max(modes.lambda(i), 0.0));
    }
    const Eigen::MatrixXd a_phi = massive.A * modes.shapes;
    m.B(rows, rows) += a_phi * twice.asDiagonal() * a_phi.transpose();
  }
}

/// Sums bodies, foundations and the elements that `is_selected` accepts.
template <typename Predicate>
numerics::DynamicMatrices summed(const model::System& system, const Assembled& assembled, Eigen::Index n,
                                 const Predicate& is_selected) {
  numerics::DynamicMatrices m;
  m.A = m.B = m.K = m.K_loss = Eigen::MatrixXd::Zero(n, n);
  bool lossy = false;
  for (std::size_t i = 0; i < system.bodies().size(); ++i) add_body(assembled.layout, i, system.bodies()[i], m.A);
  for (std::size_t i = 0; i < system.description().foundations.size(); ++i)
    add_foundation(assembled.layout, i, system.description().foundations[i], m);
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    const ElementMap& map = assembled.elements[e];
    m.symmetric = m.symmetric && system.elements()[e].symmetric;
    if (!is_selected(map)) continue;
    scatter(map, map.matrices.stiffness, 1, m.K);
    scatter(map, map.matrices.damping, 1, m.B);
    scatter(map, map.matrices.mass, 1, m.A);
    scatter(map, map.matrices.loss, 1, m.K_loss);
    lossy = lossy || map.matrices.loss_factor > 0;
  }
  m.K += assembled.of_levers.topLeftCorner(n, n);
  if (m.symmetric)
    for (Eigen::MatrixXd* matrix : {&m.A, &m.B, &m.K, &m.K_loss}) make_exactly_symmetric(*matrix);
  if (!lossy) m.K_loss.resize(0, 0);
  for (const Eigen::Index first : assembled.layout.blocks())
    if (first < n) m.blocks.push_back(first);
  assert((n == 0 || (!m.blocks.empty() && m.blocks.front() == 0)) && std::ranges::is_sorted(m.blocks) &&
         "blocks of coordinates begin at the first row and follow each other");
  return m;
}

/// Sums the matrices of the elements, bodies and foundations, and what the ground moves.
void sum_up(const model::System& system, Assembled& result) {
  numerics::DynamicMatrices& m = result.matrices;
  const auto every = [](const ElementMap&) { return true; };
  const auto constant = [](const ElementMap& map) { return !map.frequency_dependent(); };
  m = summed(system, result, result.layout.size(), every);
  const Eigen::MatrixXd without = m.B;
  add_system_damping(system.description().damping, m);
  if (m.symmetric) make_exactly_symmetric(m.B);
  const bool damped_as_a_whole = !std::holds_alternative<std::monostate>(system.description().damping);
  SystemDampingMatrices of_system;
  if (damped_as_a_whole) {
    couple_ground(result.elements, m.size(), result.ground, every);
    of_system = system_damping(m, m.B - without, result.ground.K);
  }
  couple_ground(result.elements, m.size(), result.ground, constant);
  if (damped_as_a_whole) result.ground.B += of_system.on_ground;
  if (!std::ranges::all_of(result.elements, constant)) {
    const Eigen::Index n = result.layout.before_last();
    result.constant = summed(system, result, n, constant);
    result.constant.B += (m.B - without).topLeftCorner(n, n);
  }
  follow_ground(system, of_system, result);
}

/// Adds what the forces of an element at rest add to its stiffness.
void add_forces_at_rest(const elements::Matrix12& added, ElementMap& map) {
  if (added.isZero(0)) return;
  map.of_forces_at_rest = added;
  map.matrices.stiffness.topLeftCorner<12, 12>() += added;
  if (!map.dynamic_stiffness) return;
  map.dynamic_stiffness = [of_law = std::move(map.dynamic_stiffness), added](std::complex<double> omega,
                                                                             double near) -> elements::Matrix12c {
    return of_law(omega, near) + added.cast<std::complex<double>>();
  };
}

}  // namespace

Assembled assemble_first_order(const model::System& system) {
  std::vector<Eigen::Index> internal;
  std::vector<bool> last;
  for (const model::Element& element : system.elements()) {
    internal.push_back(elements::matrices(element.law).stiffness.rows() - 12);
    last.push_back(elements::is_frequency_dependent(element.law));
  }
  Assembled result{Layout(system.description(), internal, last), {}, {}, {}, {}, {}, {}, {}};
  const GroundRows rows = ground_rows(system.description(), result.ground);
  move_together(system, result.ground);
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    result.elements.push_back(map_of(result.layout, e, system.elements()[e], rows));
  result.of_levers = geometric_stiffness(system, result.layout);
  sum_up(system, result);
  return result;
}

Assembled assemble(const model::System& system) {
  Assembled first = assemble_first_order(system);
  if (!has_second_order(system)) return first;
  SecondOrder added = second_order(system, first);
  const bool nothing = added.of_levers == first.of_levers &&
      std::ranges::all_of(added.of_elements, [](const auto& one) { return one.isZero(0); });
  if (nothing) {
    first.without_rest = std::move(added.without_rest);
    return first;
  }
  Assembled result = first;
  result.without_second_order = std::make_shared<const Assembled>(std::move(first));
  result.without_rest = std::move(added.without_rest);
  result.hangs_aside = added.hangs_aside;
  result.of_levers = std::move(added.of_levers);
  for (std::size_t e = 0; e < result.elements.size(); ++e) add_forces_at_rest(added.of_elements[e], result.elements[e]);
  sum_up(system, result);
  return result;
}

void Assembled::add_frequency_dependent(std::complex<double> omega, double near, Eigen::MatrixXcd& z) const {
  assert(z.rows() == layout.before_last() && z.cols() == z.rows() && "Z(ω) has the first rows of the layout alone");
  for (const ElementMap& map : elements) {
    if (!map.frequency_dependent()) continue;
    const Eigen::MatrixXcd ends = map.ends.topLeftCorner(12, map.end_columns);
    const Eigen::MatrixXcd local = ends.transpose() * map.dynamic_stiffness(omega, near) * ends;
    for (Eigen::Index i = 0; i < local.rows(); ++i)
      for (Eigen::Index j = 0; j < local.cols(); ++j) z(map.rows[i], map.rows[j]) += local(i, j);
  }
}

Eigen::MatrixXcd Assembled::dynamic_stiffness(std::complex<double> omega, double near) const {
  const numerics::DynamicMatrices& m = frequency_dependent() ? constant : matrices;
  Eigen::MatrixXcd z = m.complex_stiffness() + std::complex<double>(0, 1) * omega * m.B - omega * omega * m.A;
  add_frequency_dependent(omega, near, z);
  return z;
}

}  // namespace trivet::assembly
