// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/load.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace trivet::numerics {
namespace {

/// (iω)^power with exact zeros for real ω.
std::complex<double> power_of_i_omega(std::complex<double> omega, int power) {
  const std::complex<double> of_omega = integer_power(omega, power);
  switch ((power % 4 + 4) % 4) {
    case 0:
      return of_omega;
    case 1:
      return {-of_omega.imag(), of_omega.real()};
    case 2:
      return -of_omega;
    default:
      return {of_omega.imag(), -of_omega.real()};
  }
}

}  // namespace

std::complex<double> LoadTerm::factor(std::complex<double> omega) const {
  const std::complex<double> of_power = power_of_i_omega(omega, power);
  return delay == 0 ? of_power : of_power * std::exp(std::complex<double>(0, -delay) * omega);
}

void Load::add(LoadTerm term) {
  if (term.value.size() == 0 || term.value.isZero(0)) return;
  assert(term.value.size() == size_);
  const auto same =
      std::ranges::find_if(terms_, [&](const LoadTerm& t) { return t.power == term.power && t.delay == term.delay; });
  if (same == terms_.end()) terms_.push_back(std::move(term));
  else {
    same->value += term.value;
    if (same->value.isZero(0)) terms_.erase(same);
  }
}

double Load::longest_delay() const {
  double longest = 0;
  for (const LoadTerm& term : terms_) longest = std::max(longest, std::abs(term.delay));
  return longest;
}

int Load::lowest_power() const {
  int lowest = terms_.empty() ? 0 : terms_.front().power;
  for (const LoadTerm& term : terms_) lowest = std::min(lowest, term.power);
  return lowest;
}

int Load::highest_power() const {
  int highest = terms_.empty() ? 0 : terms_.front().power;
  for (const LoadTerm& term : terms_) highest = std::max(highest, term.power);
  return highest;
}

Eigen::VectorXcd Load::at(std::complex<double> omega) const {
  Eigen::VectorXcd h = Eigen::VectorXcd::Zero(size_);
  for (const LoadTerm& term : terms_) h += term.factor(omega) * term.value;
  return h;
}

Eigen::MatrixXcd Load::at(const std::vector<double>& omega) const {
  Eigen::MatrixXcd h(size_, vanishes() ? 0 : std::ssize(omega));
  for (Eigen::Index i = 0; i < h.cols(); ++i) h.col(i) = at(omega[i]);
  return h;
}

Eigen::VectorXd Load::possible(double omega) const {
  Eigen::VectorXd h = Eigen::VectorXd::Zero(size_);
  for (const LoadTerm& term : terms_) h += std::pow(omega, term.power) * term.value.cwiseAbs();
  return h;
}

Load Load::head(Eigen::Index rows) const {
  assert(rows <= size_);
  Load result(rows);
  for (const LoadTerm& term : terms_) result.add({term.power, term.delay, term.value.head(rows)});
  return result;
}

Load Load::scaled(const Eigen::VectorXd& by) const {
  Load result(size_);
  for (const LoadTerm& term : terms_) result.add({term.power, term.delay, by.asDiagonal() * term.value});
  return result;
}

Load Load::in_basis(const Eigen::MatrixXd& basis) const {
  assert(basis.rows() == size_);
  Load result(basis.cols());
  for (const LoadTerm& term : terms_) result.add({term.power, term.delay, basis.transpose() * term.value});
  return result;
}

}  // namespace trivet::numerics
