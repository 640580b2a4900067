// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/pole_expansion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/response/steady/channel_terms.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
constexpr std::size_t powers = highest_power - lowest_power + 1;

std::size_t index_of(int power) {
  assert(power >= lowest_power && power <= highest_power);
  return to_size(power - lowest_power);
}

/// A term of a polynomial in s and 1/s, and its magnitude before cancellation.
struct Term {
  int power;
  Complex value;
  double possible;
};

/// λ^m for m = lowest_power … highest_power, and |λ^m|.
struct PolePowers {
  std::array<Complex, powers> value;
  std::array<double, powers> size;
};

PolePowers powers_of(Complex lambda) {
  assert(lambda != 0.0 && "poles at rest give powers of s");
  PolePowers result;
  result.value[index_of(0)] = 1;
  for (int m = 1; m <= highest_power; ++m) result.value[index_of(m)] = result.value[index_of(m - 1)] * lambda;
  for (int m = -1; m >= lowest_power; --m) result.value[index_of(m)] = result.value[index_of(m + 1)] / lambda;
  for (std::size_t i = 0; i < powers; ++i) result.size[i] = std::abs(result.value[i]);
  return result;
}

/// Adds s^m/(s − λ) = λ^m/(s − λ) + Σ_{0 ≤ j < m} λ^{m−1−j} s^j, or − Σ_{m ≤ j < 0} λ^{m−1−j} s^j for m < 0.
void add_fraction(const Term& term, const PolePowers& of_pole, Eigen::Index c, Eigen::Index k, PoleExpansion& to) {
  const int m = term.power;
  to.residue(c, k) += term.value * of_pole.value[index_of(m)];
  to.possible_residue(c, k) += term.possible * of_pole.size[index_of(m)];
  for (int j = std::min(m, 0); j < std::max(m, 0); ++j) {
    to.power(c, j - lowest_power) += (m > 0 ? term.value : -term.value) * of_pole.value[index_of(m - 1 - j)];
    to.possible_power(c, j - lowest_power) += term.possible * of_pole.size[index_of(m - 1 - j)];
  }
}

void add_power(const Term& term, int shift, Eigen::Index c, PoleExpansion& to) {
  assert(term.power + shift >= lowest_power && term.power + shift <= highest_power);
  to.power(c, term.power + shift - lowest_power) += term.value;
  to.possible_power(c, term.power + shift - lowest_power) += term.possible;
}

/// One column of the matrix of right sides of all loads.
struct LoadColumn {
  std::size_t load;
  std::size_t group;  ///< of channels that use the same coordinates
  int power;
  double delay;
};

/// A load for one group of channels, see assembly::by_coordinates.
struct GroupedLoad {
  std::size_t load;
  std::size_t group;
  assembly::Loading loading;
};

/// Value of a channel for each column of a matrix of coordinates, separately for s⁰, s¹, s².
struct Projection {
  std::array<Eigen::RowVectorXcd, 3> value;
  std::array<Eigen::RowVectorXd, 3> possible;
};

/// Values of the coordinates (one per row of the given matrix) and their magnitudes, one coordinate per column.
struct Coordinates {
  explicit Coordinates(const Eigen::MatrixXcd& rows) : value(rows.transpose()), size(value.cwiseAbs()) {}
  Eigen::MatrixXcd value;
  Eigen::MatrixXd size;
};

Projection projected(const std::vector<ChannelTerm>& terms, const Coordinates& coordinates) {
  Projection result;
  const Eigen::Index count = coordinates.value.rows();
  for (std::size_t t = 0; t < 3; ++t) {
    result.value[t] = Eigen::RowVectorXcd::Zero(count);
    result.possible[t] = Eigen::RowVectorXd::Zero(count);
    if (count == 0) continue;
    for (const ChannelTerm& term : terms) {
      if (term.by_power[t] == 0.0) continue;
      result.value[t] += term.by_power[t] * coordinates.value.col(term.row).transpose();
      result.possible[t] += std::abs(term.by_power[t]) * coordinates.size.col(term.row).transpose();
    }
  }
  return result;
}

/// Calls `add` with each term of one channel for one pole or a rigid-body motion: projection × factor × s^(derivative +
/// power of the load + 0, 1, 2).
template <typename Add>
void for_each_term(const Projection& projection, Eigen::Index column, int power, Complex factor, double size,
                   const Add& add) {
  for (int t = 0; t < 3; ++t) {
    const double possible = projection.possible[t](column);
    if (possible > 0) add(Term{power + t, projection.value[t](column) * factor, possible * size});
  }
}

PoleExpansion& part(std::vector<PoleExpansion>& parts, std::size_t load, double delay, Eigen::Index channels,
                    Eigen::Index poles) {
  for (PoleExpansion& p : parts)
    if (p.load == load && p.delay == delay) return p;
  constexpr auto count = to_index(powers);
  parts.push_back({load, delay, Eigen::MatrixXcd::Zero(channels, poles), Eigen::MatrixXd::Zero(channels, poles),
                   Eigen::MatrixXcd::Zero(channels, count), Eigen::MatrixXd::Zero(channels, count)});
  return parts.back();
}

/// Sets poles that are 0 within round-off of the fastest (drift against a damper, without a restoring spring) to
/// exactly 0.
void settle_poles_at_rest(Eigen::VectorXcd& poles) {
  if (poles.size() == 0) return;
  const double round_off = 64 * std::numeric_limits<double>::epsilon() * poles.cwiseAbs().maxCoeff();
  for (Complex& pole : poles)
    if (std::abs(pole) <= round_off) pole = 0;
}

}  // namespace

PoleExpansions pole_expansions(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                               const std::vector<const assembly::Loading*>& loads) {
  std::vector<LoadColumn> columns;
  std::vector<Eigen::VectorXcd> sides;
  std::vector<GroupedLoad> grouped;
  std::vector<std::vector<std::size_t>> group_of(loads.size(),
                                                 std::vector<std::size_t>(channels.size(), 0));  // load, channel
  PoleExpansions result;
  result.real = !assembled.matrices.lossy();
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const std::vector<assembly::ChannelGroup> groups = assembly::by_coordinates(assembled.ground, channels, *loads[i]);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (const std::size_t c : groups[g].which) group_of[i][c] = g;
      const numerics::Load side = assembly::right_side(assembled, groups[g].loading);
      for (const numerics::LoadTerm& term : side.terms()) {
        columns.push_back({i, g, term.power, term.delay});
        sides.push_back(term.value);
        result.real = result.real && term.value.imag().isZero(0);
      }
      for (const numerics::LoadTerm& term : groups[g].loading.motion.terms())
        result.real = result.real && term.value.imag().isZero(0);
      grouped.push_back({i, g, groups[g].loading});
    }
  }
  Eigen::MatrixXcd right_sides(assembled.matrices.size(), to_index(sides.size()));
  for (std::size_t j = 0; j < sides.size(); ++j) right_sides.col(to_index(j)) = sides[j];
  numerics::PoleResidueForm form = numerics::pole_residue_form(assembled.matrices, right_sides);
  settle_poles_at_rest(form.poles);

  std::vector<Eigen::Index> moving;
  for (Eigen::Index k = 0; k < form.poles.size(); ++k)
    if (form.poles(k) != 0.0) moving.push_back(k);
  result.poles = form.poles(moving);
  std::vector<PolePowers> of_pole;
  for (const Complex& pole : result.poles) of_pole.push_back(powers_of(pole));
  const std::vector<ChannelTerms> terms = channel_terms(channels);
  const auto count = to_index(channels.size());
  const Coordinates of_shapes(form.shapes), of_drift(form.free_motion), of_statics(form.static_part);
  const Eigen::MatrixXd participation_size = form.participation.cwiseAbs();
  for (Eigen::Index c = 0; c < count; ++c) {
    const ChannelTerms& channel = terms[c];
    const Projection shapes = projected(channel.free, of_shapes), drifting = projected(channel.free, of_drift),
                     statics = projected(channel.free, of_statics);
    for (Eigen::Index j = 0; j < right_sides.cols(); ++j) {
      const LoadColumn& column = columns[j];
      if (column.group != group_of[column.load][c]) continue;
      PoleExpansion& to = part(result.parts, column.load, column.delay, count, result.poles.size());
      const int power = channel.derivative + column.power;
      for (Eigen::Index k = 0, m = 0; k < form.poles.size(); ++k) {
        const bool at_rest = form.poles(k) == 0.0;
        for_each_term(shapes, k, power, form.participation(k, j), participation_size(k, j), [&](const Term& term) {
          if (at_rest) add_power(term, -1, c, to);
          else add_fraction(term, of_pole[m], c, m, to);
        });
        if (!at_rest) ++m;
      }
      for_each_term(drifting, j, power, 1, 1, [&](const Term& term) { add_power(term, -2, c, to); });
      for_each_term(statics, j, power, 1, 1, [&](const Term& term) { add_power(term, 0, c, to); });
    }
    for (const GroupedLoad& each : grouped)
      for (const numerics::LoadTerm& term : each.loading.motion.terms())
        if (each.group == group_of[each.load][c]) {
          PoleExpansion& to = part(result.parts, each.load, term.delay, count, result.poles.size());
          for_each_term(projected(channel.ground, Coordinates(term.value)), 0, channel.derivative + term.power, 1, 1,
                        [&](const Term& of_ground) { add_power(of_ground, 0, c, to); });
        }
  }
  return result;
}

PoleExpansion differentiated(const PoleExpansion& part, const Eigen::VectorXcd& poles) {
  // Round-off of a sum of residues that must vanish: a displacement under a force starts like 1/s².
  constexpr double cancelled = 1e-12;
  PoleExpansion result = part;
  result.residue = part.residue * poles.asDiagonal();
  result.possible_residue = part.possible_residue * poles.cwiseAbs().asDiagonal();
  const Eigen::Index last = part.power.cols() - 1, at_0 = -lowest_power;
  // s Σ_k r_k/(s − λ_k) = Σ_k r_k λ_k/(s − λ_k) + Σ_k r_k, and every power of s rises by one.
  assert(part.power.col(last).isZero(0) && "powers of s have room for their derivative");
  result.power.rightCols(last) = part.power.leftCols(last);
  result.possible_power.rightCols(last) = part.possible_power.leftCols(last);
  result.power.col(0).setZero();
  result.possible_power.col(0).setZero();
  result.power.col(at_0) += part.residue.rowwise().sum();
  result.possible_power.col(at_0) += part.possible_residue.rowwise().sum();
  for (Eigen::Index c = 0; c < result.power.rows(); ++c)
    if (std::abs(result.power(c, at_0)) <= cancelled * result.possible_power(c, at_0)) result.power(c, at_0) = 0;
  return result;
}

}  // namespace trivet::response
