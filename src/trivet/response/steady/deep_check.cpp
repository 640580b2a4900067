// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/deep_check.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/response/steady/steady_motion.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::response {
namespace {

using Extended = long double;
using ExtendedComplex = std::complex<Extended>;
using numerics::ExtendedMatrix;
using numerics::ExtendedVector;

/// System damping in the free rows from the motion of the ground; it has no second derivation here.
Eigen::MatrixXd system_damping_on_ground(const assembly::Assembled& assembled, Eigen::Index n) {
  Eigen::MatrixXd rest = assembled.ground.B.topRows(n);
  for (const assembly::ElementMap& map : assembled.elements) {
    if (map.frequency_dependent() || map.ground_rows.empty()) continue;
    rest(map.rows, map.ground_rows) -= map.ends.transpose() * map.matrices.damping * map.ground_ends;
  }
  return rest;
}

ExtendedMatrix lossy_stiffness(const elements::Matrices& m) {
  return m.stiffness.cast<ExtendedComplex>() + ExtendedComplex(0, 1) * m.loss.cast<ExtendedComplex>();
}

/// Rows of T (n × (12 + internal)) of one element that are not zero: each column is the generalised force of a unit
/// force on an end or an internal coordinate, directly from the convention.
struct Carrier {
  std::vector<Eigen::Index> rows;
  ExtendedMatrix t;

  /// T M Tᵀ, in these rows and columns.
  [[nodiscard]] ExtendedMatrix of(const ExtendedMatrix& m) const { return t * m * t.transpose(); }
};

/// Constant parts of one entry of Z.
struct ConstantParts {
  ExtendedComplex stiffness, damping, mass;
};
/// One entry of Z at one ω, with the magnitudes of the terms that it is a sum of.
struct Sum {
  ExtendedComplex value;
  Extended terms = 0;
};
/// Entries by column and row.
template <typename Entry>
using Entries = std::map<std::pair<Eigen::Index, Eigen::Index>, Entry>;

/// Adds what is not zero of a matrix to one part of entries.
template <typename Matrix>
void add(const std::vector<Eigen::Index>& rows, const Matrix& m, ExtendedComplex ConstantParts::* part,
         Entries<ConstantParts>& entries) {
  for (Eigen::Index j = 0; j < m.cols(); ++j)
    for (Eigen::Index i = 0; i < m.rows(); ++i)
      if (const ExtendedComplex value = m(i, j); value != ExtendedComplex()) entries[{rows[j], rows[i]}].*part += value;
}

/// Rows first … first + count − 1.
std::vector<Eigen::Index> rows_from(Eigen::Index first, Eigen::Index count) {
  std::vector<Eigen::Index> rows(to_size(count));
  std::iota(rows.begin(), rows.end(), first);
  return rows;
}

Carrier carrier(const assembly::Layout& layout, std::size_t index, const model::Element& element,
                Eigen::Index internal) {
  assert(internal >= 0);
  Carrier result;
  std::vector<ExtendedMatrix> parts;  // of the rows
  const auto add_row = [&](Eigen::Index row, Eigen::Index first, const auto& values) {
    if (row < 0) return;
    const auto at = std::ranges::find(result.rows, row) - result.rows.begin();
    if (to_size(at) == result.rows.size()) {
      result.rows.push_back(row);
      parts.emplace_back(ExtendedMatrix::Zero(1, 12 + internal));
    }
    parts[at].block(0, first, 1, values.size()) += values;
  };
  const ExtendedMatrix one = ExtendedMatrix::Ones(1, 1);
  for (Eigen::Index i = 0; i < internal; ++i) add_row(layout.internal_row(index) + i, 12 + i, one);
  int first = 0;
  for (const model::End* end : {&element.n, &element.k}) {
    const ExtendedMatrix axes = spatial::both_blocks(end->axes).cast<ExtendedComplex>();
    if (end->body) {
      const ExtendedMatrix x = spatial::rigid_motion(end->at).cast<ExtendedComplex>(), t = x.transpose() * axes;
      for (int j = 0; j < 6; ++j) add_row(layout.row(*end->body, j), first, t.row(j));
    }
    if (end->foundation) {
      const ExtendedMatrix t = end->foundation->shape.transpose().cast<ExtendedComplex>() * axes;
      for (Eigen::Index j = 0; j < t.rows(); ++j)
        add_row(layout.foundation_row(end->foundation->foundation) + j, first, t.row(j));
    }
    first += 6;
  }
  result.t.resize(to_index(parts.size()), 12 + internal);
  assert(parts.size() == result.rows.size() && "one row of T for each coordinate");
  for (std::size_t i = 0; i < parts.size(); ++i) result.t.row(to_index(i)) = parts[i];
  return result;
}

/// Largest column sum.
template <typename Magnitude>
Extended one_norm(Eigen::Index n, const Entries<Sum>& entries, const Magnitude& magnitude) {
  Eigen::Matrix<Extended, Eigen::Dynamic, 1> columns(n);
  columns.setZero();
  for (const auto& [place, sum] : entries) columns(place.first) += magnitude(sum);
  return columns.maxCoeff();
}

std::vector<numerics::ExtendedEntry> nonzero(const Entries<Sum>& z) {
  std::vector<numerics::ExtendedEntry> entries;
  for (const auto& [place, sum] : z)
    if (sum.value != ExtendedComplex()) entries.push_back({place.second, place.first, sum.value});
  return entries;
}

/// Relative difference that round-off explains: that of the terms of Z and of the load per unit motion, times the size
/// of Z⁻¹. An entry of Z sums the 12×12 of elements, so at least twelve terms contribute to it however few coordinates
/// are free. K, iωB and −ω²A may cancel: the condition of Z does not show these lost digits (that of a single
/// coordinate is always 1).
double allowed_difference(Eigen::Index n, double condition, Extended terms, Extended load, Extended sum) {
  constexpr Eigen::Index least_terms = 12;
  constexpr double per_term = 16;
  const double lost = sum > 0 ? static_cast<double>(std::max(terms, load) / sum) : 1;
  return per_term * static_cast<double>(std::max(n, least_terms)) * std::numeric_limits<double>::epsilon() * condition *
      std::max(lost, 1.0);
}

/// The system in extended precision, summed from its description without the assembly.
class SecondSystem {
 public:
  SecondSystem(const model::System& system, const assembly::Assembled& assembled, const assembly::Loading& loading,
               const std::vector<std::string>& excitations)
      : system_(system), loading_(loading), ends_(system, excitations), elements_(assembled.elements) {
    const numerics::DynamicMatrices& constant =
        assembled.frequency_dependent() ? assembled.constant : assembled.matrices;
    n_ = constant.size();
    add_elements(assembled.layout);
    add_foundations(assembled.layout);
    // System damping (Rayleigh, modal ratios) and the forces at rest have no second derivation here.
    if (!std::holds_alternative<std::monostate>(system.description().damping)) {
      Eigen::MatrixXd of_system = constant.B;
      for (const auto& [place, parts] : entries_)
        of_system(place.second, place.first) -= static_cast<double>(parts.damping.real());
      add(rows_from(0, n_), of_system, &ConstantParts::damping, entries_);
      driven_damping_ = system_damping_on_ground(assembled, n_).cast<ExtendedComplex>();
    }
    add_bodies(assembled.layout);
    add(rows_from(0, n_), assembled.of_levers.topLeftCorner(n_, n_), &ConstantParts::stiffness, entries_);
  }

  [[nodiscard]] Eigen::Index size() const { return n_; }

  /// Z q = h at one ω with the magnitudes of the terms that they are sums of.
  struct Equations {
    Entries<Sum> z;
    ExtendedVector h, h_terms;
  };
  [[nodiscard]] Equations at(double omega) const {
    const Extended w = omega;
    Equations e;
    for (const auto& [place, p] : entries_)
      e.z.emplace_hint(e.z.end(), place,
                       Sum{p.stiffness + ExtendedComplex(0, w) * p.damping - w * w * p.mass,
                           std::abs(p.stiffness) + w * std::abs(p.damping) + w * w * std::abs(p.mass)});
    e.h = loading_.force.head(n_).at(omega).cast<ExtendedComplex>();
    e.h_terms = e.h.cwiseAbs().cast<ExtendedComplex>();
    const auto drive = [&](const std::vector<Eigen::Index>& rows, const ExtendedVector& load) {
      e.h(rows) -= load;
      e.h_terms(rows) += load.cwiseAbs().cast<ExtendedComplex>();
    };
    for (const auto& [element, carried] : dependent_) {
      const ExtendedMatrix exact =
          elements::dynamic_stiffness(system_.elements()[element].law, omega).cast<ExtendedComplex>() +
          elements_[element].of_forces_at_rest.cast<ExtendedComplex>();
      const ExtendedMatrix transformed = carried.of(exact);
      for (Eigen::Index j = 0; j < transformed.cols(); ++j)
        for (Eigen::Index i = 0; i < transformed.rows(); ++i) {
          Sum& sum = e.z[{carried.rows[j], carried.rows[i]}];
          sum.value += transformed(i, j);
          sum.terms += std::abs(transformed(i, j));
        }
      drive(carried.rows, carried.t * (exact * ends_.at(element, omega)));
    }
    for (const auto& [element, carried, m] : driven_) {
      const ExtendedMatrix dynamic = lossy_stiffness(m).leftCols(12) +
          ExtendedComplex(0, w) * m.damping.leftCols(12).cast<ExtendedComplex>() -
          w * w * m.mass.leftCols(12).cast<ExtendedComplex>();
      drive(carried.rows, carried.t * (dynamic * ends_.at(element, omega)));
    }
    if (driven_damping_.size() > 0 && !loading_.motion.vanishes()) {
      drive(rows_from(0, n_),
            ExtendedComplex(0, w) * driven_damping_ * loading_.motion.at(omega).cast<ExtendedComplex>());
    }
    return e;
  }

 private:
  void add_elements(const assembly::Layout& layout) {
    for (std::size_t e = 0; e < system_.elements().size(); ++e) {
      const model::Element& element = system_.elements()[e];
      if (elements::is_frequency_dependent(element.law)) {
        dependent_.push_back({e, carrier(layout, e, element, 0)});
        continue;
      }
      elements::Matrices m = elements::matrices(element.law);
      m.stiffness.topLeftCorner<12, 12>() += elements_[e].of_forces_at_rest;
      const Carrier t = carrier(layout, e, element, m.stiffness.rows() - 12);
      add(t.rows, t.of(lossy_stiffness(m)), &ConstantParts::stiffness, entries_);
      add(t.rows, t.of(m.mass.cast<ExtendedComplex>()), &ConstantParts::mass, entries_);
      add(t.rows, t.of(m.damping.cast<ExtendedComplex>()), &ConstantParts::damping, entries_);
      if (ends_.can_move(e)) driven_.push_back({e, t, m});
    }
  }

  void add_foundations(const assembly::Layout& layout) {
    for (std::size_t f = 0; f < system_.description().foundations.size(); ++f) {
      const model::Foundation& foundation = system_.description().foundations[f];
      const std::vector<Eigen::Index> rows = rows_from(layout.foundation_row(f), foundation.mass.rows());
      add(rows, foundation.stiffness, &ConstantParts::stiffness, entries_);
      add(rows, foundation.damping, &ConstantParts::damping, entries_);
      add(rows, foundation.mass, &ConstantParts::mass, entries_);
    }
  }

  void add_bodies(const assembly::Layout& layout) {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const spatial::Matrix6 a = spatial::mass_matrix(system_.bodies()[b].mass);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          if (a(i, j) != 0 && layout.row(b, i) >= 0 && layout.row(b, j) >= 0)
            entries_[{layout.row(b, j), layout.row(b, i)}].mass += a(i, j);
    }
  }

  struct Dependent {
    std::size_t element;
    Carrier carried;
  };
  struct Driven {
    std::size_t element;
    Carrier carried;
    elements::Matrices matrices;
  };

  const model::System& system_;
  const assembly::Loading& loading_;
  PrescribedEnds ends_;
  const std::vector<assembly::ElementMap>& elements_;
  Eigen::Index n_ = 0;
  Entries<ConstantParts> entries_;
  ExtendedMatrix driven_damping_;
  std::vector<Dependent> dependent_;
  std::vector<Driven> driven_;
};

}  // namespace

DeepCheck deep_check(const model::System& system, const assembly::Assembled& assembled,
                     const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                     const std::vector<std::string>& excitations) {
  const SecondSystem second(system, assembled, loading, excitations);
  const Eigen::VectorXd d =
      numerics::unit_scale(assembled.frequency_dependent() ? assembled.constant : assembled.matrices);
  const Eigen::MatrixXcd fast = steady_solution(assembled, loading, angular_frequency).response;
  assert(fast.rows() == second.size() && "both systems have the first rows of the layout");
  const ExtendedVector scale = d.cast<ExtendedComplex>();
  DeepCheck check;
  double worst_ratio = -1;
  for (std::size_t i = 0; i < angular_frequency.size(); ++i) {
    const auto column = to_index(i);
    if (!fast.col(column).allFinite()) continue;  // singular, and reported as such
    SecondSystem::Equations e = second.at(angular_frequency[i]);
    for (auto& [place, sum] : e.z) {
      sum.value *= scale(place.first) * scale(place.second);
      sum.terms *= (scale(place.first) * scale(place.second)).real();
    }
    const numerics::RefinedSolver direct(second.size(), nonzero(e.z));
    const ExtendedVector q = direct.solve(ExtendedVector(scale.cwiseProduct(e.h)));
    const ExtendedVector difference = (d.cwiseInverse().asDiagonal() * fast.col(column)).cast<ExtendedComplex>() - q;
    const Extended size = q.cwiseAbs().maxCoeff();
    const double relative = size > 0 ? static_cast<double>(difference.cwiseAbs().maxCoeff() / size) : 0;
    const Extended of_load = size > 0 ? scale.cwiseProduct(e.h_terms).cwiseAbs().sum() / size : 0;
    const Extended terms = one_norm(second.size(), e.z, [](const Sum& sum) { return sum.terms; }),
                   size_of_z = one_norm(second.size(), e.z, [](const Sum& sum) { return std::abs(sum.value); });
    const double allowed = allowed_difference(second.size(), direct.condition(), terms, of_load, size_of_z);
    if (!(allowed < 1e-3)) {
      ++check.incomparable;
      continue;
    }
    ++check.frequencies;
    if (!(relative <= allowed)) check.passed = false;
    if (relative / allowed > worst_ratio) {
      worst_ratio = relative / allowed;
      check.worst_difference = relative;
      check.allowed = allowed;
      check.at_angular_frequency = angular_frequency[i];
    }
  }
  return check;
}

std::vector<double> check_frequencies(const Eigen::VectorXcd& poles, double from, double to, int count) {
  // Of |λ|: complex solvers give an overdamped root an imaginary part of round-off, even 1e-150.
  constexpr double oscillating = 1e-9;
  assert(from >= 0 && to > from && count > 0);
  std::vector<double> result;
  for (Eigen::Index k = 0; k < poles.size() && static_cast<int>(result.size()) < count / 2; ++k)
    if (const double at = poles(k).imag(); at > from && at < to && at > oscillating * std::abs(poles(k)))
      result.push_back(at);
  const int spread = count - static_cast<int>(result.size());
  for (int i = 0; i < spread; ++i) result.push_back(from + (to - from) * (i + 0.5) / spread);
  std::ranges::sort(result);
  return result;
}

}  // namespace trivet::response
