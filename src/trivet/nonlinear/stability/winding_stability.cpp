// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/stability/periodic_stability.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/laws/bristle_loop.h"
#include "trivet/nonlinear/laws/law_set.h"
#include "trivet/nonlinear/laws/rubbing_loop.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"
#include "trivet/numerics/periodic/gauss_nodes.h"

namespace trivet::nonlinear {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using foundation::two_pi;

/// The force by tangents of these spectra over a variation e^{i(μ + l)φ}, at the frequencies μ + k.
MatrixXcd variation(const VectorXd& by_deflection, const VectorXd& by_rate, double mu, double omega, Index harmonics) {
  const Index count = 2 * harmonics + 1;
  MatrixXcd found(count, count);
  for (Index k = 0; k < count; ++k)
    for (Index l = 0; l < count; ++l) {
      found(k, l) = numerics::exponential_coefficient(by_deflection, k - l);
      if (by_rate.size() > 0)
        found(k, l) += Complex(0, omega * (mu + static_cast<double>(l - harmonics))) *
            numerics::exponential_coefficient(by_rate, k - l);
    }
  return found;
}

/// The force that a variation e^{i(μ + l)φ} of one deflection causes, at the frequencies μ + k, k = −K … K.
class LawVariation {
 public:
  LawVariation(const DeviationLaw& law, const VectorXd& deflection, double omega, Index harmonics, double round_off)
      : harmonics_(harmonics), omega_(omega) {
    const LawHarmonics wide(law, harmonics, (deflection.size() - 1) / 2);
    VectorXd padded = VectorXd::Zero(numerics::coefficient_count(harmonics));
    padded.head(deflection.size()) = deflection;
    tangents_ = wide.tangents_at(padded, omega, round_off);
    const LawOverPeriod course = wide.course(padded, omega, round_off);
    for (const BristleLoop& loop : course.bristles()) bristles_.emplace_back(loop, omega, harmonics);
    const double longest = two_pi / static_cast<double>(4 * harmonics);
    for (const HystereticLoop& loop : course.loops()) {
      if (loop.sticks()) continue;
      Memory memory;
      const auto& branches = loop.branches();
      for (std::size_t b = 0; b < branches.size(); ++b) {
        const HystereticLoop::Branch& branch = branches[b];
        const auto add = [&](double phase, double length) {
          const elements::ForceOnTravel found = loop.at(branch, course.deflection_at(phase));
          memory.nodes.push_back({phase, length / two_pi, found.by_travel, found.by_start, b});
        };
        const double middle = branch.kink.value_or(branch.to);
        numerics::each_gauss_node(branch.from, middle, longest, add);
        if (branch.kink) numerics::each_gauss_node(middle, branch.to, longest, add);
        memory.from.push_back(branch.from);
        memory.ends.push_back(loop.at(branch, branches[(b + 1) % branches.size()].deflection));
      }
      memory.jumps = loop.jumps(padded);
      memories_.push_back(std::move(memory));
    }
  }

  [[nodiscard]] MatrixXcd at(double mu) const {
    MatrixXcd found = variation(tangents_.by_deflection, tangents_.by_rate, mu, omega_, harmonics_);
    for (const Memory& memory : memories_) add_memory(memory, mu, found);
    for (const BristleVariation& one : bristles_) found += one.at(mu);
    return found;
  }

 private:
  struct Node {
    double phase, weight, by_travel, by_start;
    std::size_t branch;
  };
  /// What a loop owes to its last turning point.
  struct Memory {
    std::vector<Node> nodes;
    std::vector<double> from;                   ///< phases of the turning points
    std::vector<elements::ForceOnTravel> ends;  ///< of the branches
    std::vector<HystereticLoop::Jump> jumps;
  };

  void add_memory(const Memory& memory, double mu, MatrixXcd& sum) const {
    const Index count = sum.rows();
    const std::size_t turns = memory.from.size();
    assert(memory.ends.size() == turns);
    // Deflection and force at the turning points, turning points × variations.
    MatrixXcd deflection(to_index(turns), count), force(to_index(turns), count);
    const Complex period = std::polar(1.0, two_pi * mu);
    for (Index l = 0; l < count; ++l) {
      const double order = mu + static_cast<double>(l - harmonics_);
      for (std::size_t b = 0; b < turns; ++b) deflection(to_index(b), l) = std::polar(1.0, order * memory.from[b]);
      Complex rest = 0;
      double by_start = 1;
      const auto next = [&](std::size_t b, Complex before) {
        const Complex end = b + 1 < turns ? deflection(to_index(b) + 1, l) : period * deflection(0, l);
        return memory.ends[b].by_travel * (end - deflection(to_index(b), l)) + memory.ends[b].by_start * before;
      };
      for (std::size_t b = 0; b < turns; ++b) {
        rest = next(b, rest);
        by_start *= memory.ends[b].by_start;
      }
      force(0, l) = rest / (period - by_start);
      for (std::size_t b = 0; b + 1 < turns; ++b) force(to_index(b) + 1, l) = next(b, force(to_index(b), l));
    }
    MatrixXcd by_travel = MatrixXcd::Zero(count, to_index(turns)), by_start = by_travel;
    for (const Node& node : memory.nodes)
      for (Index k = 0; k < count; ++k) {
        const Complex wave = std::polar(node.weight, -(mu + static_cast<double>(k - harmonics_)) * node.phase);
        by_travel(k, to_index(node.branch)) += wave * node.by_travel;
        by_start(k, to_index(node.branch)) += wave * node.by_start;
      }
    sum += by_start * force - by_travel * deflection;
    for (const HystereticLoop::Jump& jump : memory.jumps) add_jump(jump, mu, deflection, force, sum);
  }

  /// @param deflection, force  at the turning points
  void add_jump(const HystereticLoop::Jump& jump, double mu, const MatrixXcd& deflection, const MatrixXcd& force,
                MatrixXcd& sum) const {
    const Index count = sum.rows(), turn = to_index(jump.branch);
    assert(turn < deflection.rows() && force.rows() == deflection.rows());
    Eigen::RowVectorXcd moved(count);
    VectorXcd waves(count);
    for (Index l = 0; l < count; ++l) {
      const double order = mu + static_cast<double>(l - harmonics_);
      const Complex here = std::polar(1.0, order * jump.phase);
      waves(l) = std::conj(here) / two_pi;
      moved(l) = jump.by_deflection * (here - deflection(turn, l)) + jump.by_slope * Complex(0, order) * here +
          jump.by_start * force(turn, l);
    }
    sum -= jump.force * waves * moved;
  }

  Index harmonics_;
  double omega_;
  LawHarmonics::TangentHarmonics tangents_;
  std::vector<Memory> memories_;
  std::vector<BristleVariation> bristles_;
};

/// D(iν).
class HillDeterminant {
 public:
  HillDeterminant(const CondensedMachine& machine, const std::vector<Deflection>& deflections, const MatrixXd& motion,
                  double omega, Index harmonics)
      : machine_(machine), omega_(omega), harmonics_(harmonics) {
    const Index C = motion.rows();
    const MatrixXd& spread = machine.basis().spread;
    const LawSet laws(deflections, {deflections, spread.transpose() * machine.static_receptance() * spread}, harmonics,
                      (C - 1) / 2);
    MatrixXd padded = MatrixXd::Zero(numerics::coefficient_count(harmonics), motion.cols());
    padded.topRows(C) = motion;
    for (const LawSet::Rubbing& one : laws.rubbings()) rubbings_.push_back({one.on, laws.loop(one, padded, omega)});
    const VectorXd rests_below = laws.round_off(motion);
    for (Index j = 0; j < motion.cols(); ++j) {
      const Deflection& deflection = deflections[j];
      laws_.emplace_back(deflection.law, motion.col(j), omega, harmonics, rests_below(j));
      if (!deflection.distance) continue;
      distances_.emplace_back(
          j, DistanceHarmonics(*deflection.distance, harmonics).tangents_at(padded.middleCols(j, 3), omega));
    }
  }

  [[nodiscard]] Complex at(double nu) const {
    assert(nu >= 0 && nu <= omega_ / 2 && "D(i(ν + ω)) = D(iν), and D(−iν) is conjugate");
    const Index m = machine_.size(), count = 2 * harmonics_ + 1;
    MatrixXcd whole = MatrixXcd::Identity(m * count, m * count), receptance;
    struct Tangent {
      Index of, by;
      MatrixXcd matrix;
    };
    std::vector<Tangent> tangents;
    const double mu = nu / omega_;
    for (Index j = 0; j < to_index(laws_.size()); ++j) tangents.push_back({j, j, laws_[j].at(mu)});
    for (const auto& [first, spectra] : distances_)
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
          tangents.push_back({first + to_index(a), first + to_index(b),
                              variation(spectra.by_deflection[a][b], spectra.by_rate[a][b], mu, omega_, harmonics_)});
    for (const Rubbing& one : rubbings_) {
      RubbingVariation found = rubbing_variation(one.loop, omega_, mu, harmonics_);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
          if (found[a][b].size() > 0) tangents.push_back({one.on[a], one.on[b], std::move(found[a][b])});
    }
    for (Index k = 0; k < count; ++k) {
      const double frequency = nu + static_cast<double>(k - harmonics_) * omega_;
      if (frequency == 0) receptance = machine_.static_receptance().cast<Complex>();
      else machine_.set_receptance(std::abs(frequency), receptance);
      if (frequency < 0) receptance = receptance.conjugate().eval();
      const MatrixXcd by_force = receptance * machine_.basis().spread;  // of all deflections
      for (const Tangent& tangent : tangents)
        for (Index b = 0; b < m; ++b) {
          const double share = machine_.basis().spread(b, tangent.by);
          if (share == 0) continue;
          for (Index i = 0; i < m; ++i)
            whole.block(i * count + k, b * count, 1, count) +=
                (share * by_force(i, tangent.of)) * tangent.matrix.row(k);
        }
    }
    return numerics::PivotedLu<Complex>(whole).determinant();
  }

 private:
  const CondensedMachine& machine_;
  double omega_;
  Index harmonics_;
  std::vector<LawVariation> laws_;
  std::vector<std::pair<Index, DistanceHarmonics::Spectra>> distances_;
  struct Rubbing {
    std::array<Index, 3> on;
    RubbingLoop loop;
  };
  std::vector<Rubbing> rubbings_;
};

/// Places at which D may turn quickly: beside the poles of the receptance, folded into [0, ω/2].
std::vector<double> first_places(const CondensedMachine& machine, double omega) {
  std::vector<double> places = {0, omega / 2};
  constexpr int pieces = 12;
  for (int i = 1; i < pieces; ++i) places.push_back(omega / 2 * i / pieces);
  for (const Complex& pole : machine.poles()) {
    if (pole.imag() < 0) continue;
    const double folded = std::abs(std::remainder(pole.imag(), omega));
    for (const double widths : {-6.0, -2.0, -0.7, 0.0, 0.7, 2.0, 6.0})
      if (const double place = folded + widths * std::abs(pole.real()); place > 0 && place < omega / 2)
        places.push_back(place);
  }
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  return places;
}

/// Change of the argument of D from one place to another; empty if it jumps however close the places are.
std::optional<double> turn(const HillDeterminant& determinant, double from, Complex there, double to, Complex end,
                           int halvings) {
  constexpr double gentle = 0.9;  // [rad]
  if (halvings == 0) return std::nullopt;
  const double middle = (from + to) / 2;
  const Complex between = determinant.at(middle);
  const double first = std::arg(between / there), second = std::arg(end / between);
  if (std::abs(first) < gentle && std::abs(second) < gentle) return first + second;
  const std::optional<double> before = turn(determinant, from, there, middle, between, halvings - 1);
  if (!before) return std::nullopt;
  const std::optional<double> after = turn(determinant, middle, between, to, end, halvings - 1);
  return after ? std::optional(*before + *after) : std::nullopt;
}

}  // namespace

std::optional<int> WindingStability::unstable_exponents(const MatrixXd& motion, double omega) const {
  const Index given = (motion.rows() - 1) / 2;
  const Index harmonics = std::max<Index>(given + 4, 3 * given / 2);
  const HillDeterminant determinant(machine_, deflections_, motion, omega, harmonics);
  const std::vector<double> places = first_places(machine_, omega);
  double turned = 0;
  Complex before = determinant.at(places.front());
  constexpr int halvings = 24;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Complex next = determinant.at(places[i + 1]);
    const std::optional<double> step = turn(determinant, places[i], before, places[i + 1], next, halvings);
    if (!step) return std::nullopt;
    turned += *step;
    before = next;
  }
  const auto open = std::ranges::count_if(machine_.poles(), [](const Complex& pole) { return pole.real() > 0; });
  const double half_turns = -turned / (two_pi / 2), nearest = std::round(half_turns);
  constexpr double whole = 0.2;
  if (!(std::abs(half_turns - nearest) < whole)) return std::nullopt;
  const int unstable = static_cast<int>(nearest) + static_cast<int>(open);
  return unstable >= 0 ? std::optional(unstable) : std::nullopt;
}

}  // namespace trivet::nonlinear
