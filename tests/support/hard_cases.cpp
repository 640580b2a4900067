// SPDX-License-Identifier: BSD-3-Clause
#include "support/hard_cases.h"

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::test {
namespace {

/// A fixed orthogonal matrix: skew axes, no accidental zeros.
Eigen::MatrixXd mixing(Eigen::Index n) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd g(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) g(i, j) = normal(generator);
  return numerics::symmetric_eigen(Eigen::MatrixXd(g + g.transpose())).vectors;
}

DynamicMatrices mixed(const Eigen::VectorXd& a, const Eigen::MatrixXd& b, const Eigen::VectorXd& k) {
  const Eigen::MatrixXd q = mixing(a.size());
  const auto turn = [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
    const Eigen::MatrixXd y = q * x * q.transpose();
    return 0.5 * (y + y.transpose());
  };
  return {turn(a.asDiagonal()), turn(b), turn(k.asDiagonal()), {}, true};
}

Eigen::VectorXd six(double a, double b, double c, double d, double e, double f) {
  return (Eigen::VectorXd(6) << a, b, c, d, e, f).finished();
}

Eigen::MatrixXd spread(double size) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Identity(6, 6) * size;
  for (int i = 0; i < 5; ++i) b(i, i + 1) = b(i + 1, i) = 0.4 * size;
  return b;
}

/// Minimum of a function with one minimum, and its position.
template <typename Function>
std::pair<double, double> least(const Function& f, double low, double high) {
  for (int i = 0; i < 50; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (f(a) < f(b)) high = b;
    else low = a;
  }
  return {f(low), low};
}

/// Two oscillators, one damped, joined by a spring: for one damping and one detuning their roots and their vectors
/// coalesce.
DynamicMatrices exceptional_point() {
  const auto with = [](double damping, double detuning) {
    Eigen::MatrixXd B = Eigen::MatrixXd::Identity(6, 6),
                    K = Eigen::MatrixXd(six(100, 100 + detuning, 400, 900, 2500, 10000).asDiagonal());
    B(0, 0) = damping, B(1, 1) = 0;
    K(0, 1) = K(1, 0) = 5;
    return DynamicMatrices{Eigen::MatrixXd::Identity(6, 6), B, K, {}, true};
  };
  const auto distance = [&](double damping, double detuning) {
    const DynamicMatrices all = with(damping, detuning);
    const DynamicMatrices pair{
        all.A.topLeftCorner(2, 2), all.B.topLeftCorner(2, 2), all.K.topLeftCorner(2, 2), {}, true};
    std::vector<std::complex<double>> upper;
    for (const auto& lambda : numerics::roots_from_states(pair).lambda)
      if (lambda.imag() > 0) upper.push_back(lambda);
    return std::abs(upper.at(0) - upper.at(1));
  };
  const auto best_damping = [&](double detuning) {
    return least([&](double damping) { return distance(damping, detuning); }, 0.5, 2.0);
  };
  const double detuning = least([&](double d) { return best_damping(d).first; }, -3.0, 3.0).second;
  if (best_damping(detuning).first > 1e-3) throw std::logic_error("the roots do not coalesce");
  return with(best_damping(detuning).second, detuning);
}

}  // namespace

std::vector<HardCase> hard_cases() {
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(6), k = six(4, 9, 100, 400, 2500, 10000);
  const Eigen::VectorXd twice_root = 2 * k.cwiseSqrt();
  static const DynamicMatrices coalescing = exceptional_point();
  std::vector<HardCase> all;
  all.push_back({"general damping, ratio 1e-3", mixed(one, spread(4e-3), k)});
  all.push_back({"general damping, ratio 1e-6", mixed(one, spread(4e-6), k)});
  all.push_back({"proportional, 1e-6", mixed(one, Eigen::MatrixXd((1e-6 * k).asDiagonal()), k)});
  all.push_back({"mass ratio 1e-6", mixed(six(1, 1, 1, 1, 1, 1e-6), spread(0.1), k)});
  all.push_back({"coincident frequencies, general damping", mixed(one, spread(0.3), six(4, 4, 100, 100, 100, 900))});
  all.push_back({"coincident frequencies, proportional",
                 mixed(one, Eigen::MatrixXd((0.01 * six(4, 4, 100, 100, 100, 900)).asDiagonal()),
                       six(4, 4, 100, 100, 100, 900))});
  DynamicMatrices critical{one.asDiagonal(), twice_root.asDiagonal(), k.asDiagonal(), {}, true};
  all.push_back({"critical damping, exactly defective", critical});
  all.push_back({"critical damping, turned", mixed(one, Eigen::MatrixXd(twice_root.asDiagonal()), k)});
  all.push_back({"exceptional point", coalescing});
  Eigen::MatrixXd rank_one = Eigen::MatrixXd::Zero(6, 6);
  const Eigen::VectorXd line = six(0.3, -0.2, 0.5, 0.1, 0.4, 0.6);
  rank_one = line * line.transpose();
  all.push_back({"one damper, the rest undamped", mixed(one, rank_one, k)});
  all.push_back({"overdamped", mixed(one, spread(500), k)});
  all.push_back({"indefinite mass", mixed(six(1, 1, -0.3, 1, 1, 1), spread(0.2), k)});
  DynamicMatrices vanishing{Eigen::MatrixXd::Identity(6, 6), Eigen::MatrixXd::Zero(6, 6), spread(1) * 50, {}, true};
  vanishing.B(5, 5) = 1e-3;  // at ω² = 50 every leading pivot is zero
  all.push_back({"vanishing leading pivots", vanishing});
  DynamicMatrices lossy = mixed(one, Eigen::MatrixXd::Zero(6, 6), k);
  lossy.K_loss = 1e-4 * lossy.K;
  all.push_back({"loss factor 1e-4", lossy});
  DynamicMatrices unsymmetric = mixed(one, spread(0.1), k);
  unsymmetric.K(0, 1) += 0.7;
  unsymmetric.symmetric = false;
  all.push_back({"unsymmetric", unsymmetric});
  all.push_back({"stiffness over twelve decades", mixed(one, spread(1e-2), six(1e-4, 1, 1e2, 1e4, 1e6, 1e8))});
  return all;
}

Eigen::VectorXcd load() {
  Eigen::VectorXcd h(6);
  h << 1.0, std::complex<double>(0, 2), -0.5, 0.7, std::complex<double>(0.3, -1), 1.1;
  return h;
}

std::vector<double> awkward_frequencies(const DynamicMatrices& m) {
  std::vector<double> omega = {0.0, std::sqrt(50.0)};
  const numerics::QuadraticRoots roots = numerics::roots_from_states(m);
  for (Eigen::Index k = 0; k < roots.lambda.size(); ++k) {
    const double centre = std::abs(roots.lambda(k).imag());
    for (const double shift : {-1.0, -1e-3, -1e-12, 0.0, 1e-12, 1e-3, 1.0})
      omega.push_back(std::abs(centre + shift * std::abs(roots.lambda(k).real())));
  }
  for (int i = 1; i < 60; ++i) omega.push_back(2.3 * i);
  return omega;
}

}  // namespace trivet::test
