// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace trivet::numerics {

/// One term of a right side: s^power e^{−s delay} value, s = iω.
struct LoadTerm {
  int power = 0;     ///< 2: an unbalance; −2: a motion given by its acceleration
  double delay = 0;  ///< [s]
  Eigen::VectorXcd value;

  /// s^power e^{−s delay}; for real ω, zero parts are exactly zero.
  [[nodiscard]] std::complex<double> factor(std::complex<double> omega) const;
};

/// The right side h(s) of Z(s) q = h as a sum of powers of s = iω, with or without delays.
class Load {
 public:
  /// A constant right side.
  template <typename Vector>
  Load(const Eigen::MatrixBase<Vector>& constant) : size_(constant.size()) {
    add({0, 0, constant});
  }  // NOLINT: a vector is a load
  explicit Load(Eigen::Index size) : size_(size) {}

  /// Adds to the term of the same power and delay. Zero values leave no term.
  void add(LoadTerm term);

  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] const std::vector<LoadTerm>& terms() const { return terms_; }
  [[nodiscard]] bool vanishes() const { return terms_.empty(); }
  /// Only one term, of power 0, without delay (or none).
  [[nodiscard]] bool is_constant() const {
    return terms_.empty() || (terms_.size() == 1 && terms_[0].power == 0 && terms_[0].delay == 0);
  }
  [[nodiscard]] double longest_delay() const;
  [[nodiscard]] int lowest_power() const;   ///< 0 without terms
  [[nodiscard]] int highest_power() const;  ///< 0 without terms

  /// h(iω), also for complex ω; at ω = 0 the negative powers must be absent.
  [[nodiscard]] Eigen::VectorXcd at(std::complex<double> omega) const;
  /// Sum of the magnitudes of all terms: the largest possible |h|.
  [[nodiscard]] Eigen::VectorXd possible(double omega) const;
  /// h(iω) at several ω, one column each; no columns if the load vanishes.
  [[nodiscard]] Eigen::MatrixXcd at(const std::vector<double>& omega) const;
  /// The load of the first `rows` rows, or with scaled rows.
  [[nodiscard]] Load head(Eigen::Index rows) const;
  [[nodiscard]] Load scaled(const Eigen::VectorXd& by) const;
  /// The load on coordinates q', q = basis · q'.
  [[nodiscard]] Load in_basis(const Eigen::MatrixXd& basis) const;

 private:
  Eigen::Index size_ = 0;
  std::vector<LoadTerm> terms_;
};

/// s^power by multiplication, so that zero parts are exact; s ≠ 0 if power < 0.
template <typename Scalar>
[[nodiscard]] std::complex<Scalar> integer_power(const std::complex<Scalar>& s, int power) {
  std::complex<Scalar> result(1);
  for (int k = 0; k < std::abs(power); ++k) result *= s;
  return power < 0 ? std::complex<Scalar>(1) / result : result;
}

}  // namespace trivet::numerics
