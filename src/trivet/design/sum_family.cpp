// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/sum_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::design {
namespace {

constexpr int lanes = 8;  // designs side by side
using Lanes = Eigen::Array<double, lanes, 1>;
}  // namespace

double SumFamily::Along::t(double value) const {
  return logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
}

double SumFamily::Along::value(double share) const {
  if (share == 0) return from;
  if (share == 1) return to;
  return logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
}

double SumFamily::Along::slope(double value) const {
  return logarithmic ? 1 / (value * std::log(to / from)) : 1 / (to - from);
}

template <typename Number, typename Polynomial>
void SumFamily::set_terms(std::vector<Number>& values, const Polynomial& polynomial) const {
  for (std::size_t i = 1; i < terms_.size(); ++i) {
    assert(terms_[i].parent < i && "a product follows the product of all but its last factor");
    values[i] = values[terms_[i].parent] * polynomial(terms_[i].exponents.back());
  }
}

Eigen::VectorXd SumFamily::at(const Eigen::VectorXd& values) const {
  assert(values.size() == to_index(along_.size()));
  std::vector<std::vector<double>> polynomials;
  for (std::size_t j = 0; j < along_.size(); ++j)
    polynomials.push_back(newton_polynomials(along_[j].t(values(to_index(j))), along_[j].degree, 1.0));
  std::vector<double> terms(terms_.size(), 1);
  set_terms(terms, [&](const Factor& factor) {
    return polynomials[factor.variable][static_cast<std::size_t>(factor.degree)];
  });
  Eigen::VectorXd result(entry_count_);
  for (Eigen::Index e = 0; e < entry_count_; ++e) {
    double sum = 0;
    for (std::size_t c = first_[e]; c < first_[e + 1]; ++c)
      sum += coefficients_[c].second * terms[coefficients_[c].first];
    result(e) = sum;
  }
  return result;
}

Eigen::MatrixXd SumFamily::slopes(const Eigen::VectorXd& values) const {
  std::vector<std::vector<double>> polynomials, polynomial_slopes;
  for (std::size_t j = 0; j < along_.size(); ++j) {
    const double t = along_[j].t(values(to_index(j)));
    polynomials.push_back(newton_polynomials(t, along_[j].degree, 1.0));
    polynomial_slopes.push_back(newton_slopes(t, along_[j].degree));
  }
  const auto polynomial = [&](const Factor& factor) {
    return polynomials[factor.variable][static_cast<std::size_t>(factor.degree)];
  };
  std::vector<double> terms(terms_.size(), 1);
  set_terms(terms, polynomial);
  Eigen::MatrixXd result(entry_count_, to_index(along_.size()));
  std::vector<double> moved(terms_.size(), 0);  // d term / dt of one number
  for (std::size_t j = 0; j < along_.size(); ++j) {
    for (std::size_t i = 1; i < terms_.size(); ++i) {
      const Factor& last = terms_[i].exponents.back();
      moved[i] = moved[terms_[i].parent] * polynomial(last);
      if (last.variable == j)
        moved[i] = terms[terms_[i].parent] * polynomial_slopes[j][static_cast<std::size_t>(last.degree)];
    }
    const double dt = along_[j].slope(values(to_index(j)));
    for (Eigen::Index e = 0; e < entry_count_; ++e) {
      double sum = 0;
      for (std::size_t c = first_[e]; c < first_[e + 1]; ++c)
        sum += coefficients_[c].second * moved[coefficients_[c].first];
      result(e, to_index(j)) = sum * dt;
    }
  }
  return result;
}

Eigen::MatrixXd SumFamily::designs(const Eigen::MatrixXd& points) const {
  assert(points.cols() == to_index(along_.size()) && to_index(first_.size()) == entry_count_ + 1);
  Eigen::MatrixXd result(points.rows(), entry_count_);
  for (Eigen::Index e = 0; e < entry_count_; ++e)
    if (is_constant(e)) result.col(e).setConstant(first_[e] < first_[e + 1] ? coefficients_[first_[e]].second : 0);
  std::vector<std::vector<Lanes>> polynomials(along_.size());
  std::vector<Lanes> terms(terms_.size(), Lanes::Ones());
  for (Eigen::Index first = 0; first < points.rows(); first += lanes) {
    const Eigen::Index taken = std::min<Eigen::Index>(lanes, points.rows() - first);
    for (std::size_t j = 0; j < along_.size(); ++j) {
      Lanes t;
      for (Eigen::Index i = 0; i < lanes; ++i) {
        const Eigen::Index row = first + i;  // the lanes beyond the last design repeat it
        const bool same =
            i >= taken || (i > 0 && points(row, to_index(j)) == points(row - 1, to_index(j)));  // along a line of a map
        t(i) = same ? t(i - 1) : along_[j].t(points(row, to_index(j)));
      }
      polynomials[j] = newton_polynomials<Lanes>(t, along_[j].degree, Lanes::Ones());
    }
    set_terms(terms, [&](const Factor& factor) -> const Lanes& {
      return polynomials[factor.variable][static_cast<std::size_t>(factor.degree)];
    });
    for (Eigen::Index e = 0; e < entry_count_; ++e) {
      if (is_constant(e)) continue;
      Lanes sum = Lanes::Zero();
      for (std::size_t c = first_[e]; c < first_[e + 1]; ++c)
        sum += coefficients_[c].second * terms[coefficients_[c].first];
      if (taken == lanes) result.col(e).segment<lanes>(first) = sum.matrix();
      else result.col(e).segment(first, taken) = sum.head(taken).matrix();
    }
  }
  return result;
}

std::string SumFamily::words() const {
  constexpr double least_shown = 1e-16;
  return fmt::format("a sum of {} terms from {} assembled designs, compared with {} others: largest deviation {:.0e}",
                     terms(), assembled_, compared_, std::max(worst_, least_shown));
}

void SumFamily::order_by_entries(const std::vector<Eigen::VectorXd>& coefficients) {
  assert(coefficients.size() == terms_.size());
  entry_count_ = coefficients.front().size();
  first_ = {0};
  for (Eigen::Index e = 0; e < entry_count_; ++e) {
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (coefficients[i](e) != 0) coefficients_.emplace_back(i, coefficients[i](e));
    first_.push_back(coefficients_.size());
  }
}

}  // namespace trivet::design
