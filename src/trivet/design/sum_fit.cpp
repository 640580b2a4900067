// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "trivet/design/sum_family.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"

namespace trivet::design {
namespace {

/// Smaller coefficients, as a share of the scale of their entry, are round-off.
constexpr double no_coefficient = 2e-14;

/// Points that fill a box of any dimension evenly: an additive recurrence with powers of the root of x^(d+1) = x + 1.
std::vector<Eigen::VectorXd> spread_points(Eigen::Index dimensions, int count) {
  double root = 2;
  for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1 / (static_cast<double>(dimensions) + 1));
  std::vector<Eigen::VectorXd> points;
  for (int k = 1; k <= count; ++k) {
    Eigen::VectorXd point(dimensions);
    for (Eigen::Index j = 0; j < dimensions; ++j)
      point(j) = std::fmod(0.5 + k * std::pow(root, -static_cast<double>(j + 1)), 1.0);
    points.push_back(std::move(point));
  }
  return points;
}

/// The ends of all ranges: of each number with the others in their middle, and of all together, in every combination of
/// up to six numbers. Of more numbers all lower ends, all upper ends, and 62 combinations spread over the others.
std::vector<Eigen::VectorXd> points_at_ends(Eigen::Index dimensions) {
  constexpr double middle = 0.5;
  constexpr Eigen::Index all_combined = 6;
  std::vector<Eigen::VectorXd> points;
  for (Eigen::Index j = 0; j < dimensions; ++j)
    for (const double end : {0.0, 1.0}) points.emplace_back(Eigen::VectorXd::Constant(dimensions, middle))(j) = end;
  if (dimensions <= all_combined) {
    for (int k = 0; k < 1 << dimensions; ++k) {
      Eigen::VectorXd& point = points.emplace_back(dimensions);
      for (Eigen::Index j = 0; j < dimensions; ++j) point(j) = k >> j & 1;
    }
    return points;
  }
  for (const double end : {0.0, 1.0}) points.emplace_back(Eigen::VectorXd::Constant(dimensions, end));
  for (Eigen::VectorXd& point : spread_points(dimensions, (1 << all_combined) - 2))
    points.push_back(point.array().round().matrix());
  return points;
}

double largest_difference(const Eigen::VectorXd& interpolated, const PackedDesign& exact) {
  double worst = 0;
  for (Eigen::Index e = 0; e < interpolated.size(); ++e) {
    if (interpolated(e) == exact.entries(e)) continue;
    const double one = std::abs(interpolated(e) - exact.entries(e)) / exact.scales(e);
    if (std::isnan(one)) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, one);
  }
  return worst;
}

}  // namespace

/// The search for the terms of a family.
class SumFit {
 public:
  SumFit(const SumFamily::Source& source, const std::vector<SumVariable>& variables, SumFamily::Compared compared)
      : source_(source), variables_(variables), compared_(compared) {}

  SumFamilyOrReason fit() {
    PackedOrReason centre = source_(values_at({}));
    if (!centre.design) return {{}, centre.reason};
    family_.assembled_ = 1;
    add_term({}, std::move(centre.design->entries));
    std::string reason = add_lines();
    for (int degree = 2; reason.empty() && has_terms_of_degree(degree - 1); ++degree) reason = add_products(degree);
    if (!reason.empty()) return {{}, reason};
    finish();
    reason = compare();
    if (!reason.empty()) return {{}, reason};
    return {std::move(family_), ""};
  }

 private:
  using Factor = SumFamily::Factor;
  using Exponents = SumFamily::Exponents;

  static int degree_of(const Exponents& exponents) {
    int degree = 0;
    for (const Factor& factor : exponents) degree += factor.degree;
    return degree;
  }

  /// The design in which these numbers are at the nodes of their degrees, and all others at their first ones.
  [[nodiscard]] Eigen::VectorXd values_at(const Exponents& exponents) const {
    const std::vector<double>& nodes = newton_nodes();
    Eigen::VectorXd values(to_index(variables_.size()));
    for (std::size_t j = 0; j < variables_.size(); ++j) values(to_index(j)) = along(j).value(nodes.front());
    for (const Factor& factor : exponents)
      values(to_index(factor.variable)) = along(factor.variable).value(nodes[static_cast<std::size_t>(factor.degree)]);
    return values;
  }

  [[nodiscard]] SumFamily::Along along(std::size_t j) const {
    if (j < family_.along_.size()) return family_.along_[j];
    return between(j, false);
  }

  /// The range of a number, from a place that differs from number to number: where all have the same share of their
  /// ranges, a symmetric machine has couplings that cancel, and terms would not be found.
  [[nodiscard]] SumFamily::Along between(std::size_t j, bool logarithmic) const {
    constexpr double largest = 0.1, factor = 7, first = 1.7;  // roots of these have no simple relations
    const SumFamily::Along whole{variables_[j].from, variables_[j].to, logarithmic, 0};
    const double root = std::sqrt(static_cast<double>(j) + first);
    const double share = variables_.size() > 1 ? largest * std::fmod(factor * root, 1.0) : 0;
    return {whole.value(share), variables_[j].to, logarithmic, 0};
  }

  void add_term(const Exponents& exponents, Eigen::VectorXd coefficients) {
    Exponents before = exponents;
    if (!before.empty()) before.pop_back();
    const std::size_t parent = before.empty() ? 0 : number_.at(before);
    number_[exponents] = family_.terms_.size();
    family_.terms_.push_back({exponents, parent});
    coefficients_.push_back(std::move(coefficients));
  }

  /// Coefficients below round-off become zero. @return true if any remains
  static bool keep_coefficients(Eigen::VectorXd& coefficients, const Eigen::VectorXd& scales) {
    bool any = false;
    for (Eigen::Index e = 0; e < coefficients.size(); ++e) {
      if (std::abs(coefficients(e)) <= no_coefficient * scales(e)) coefficients(e) = 0;
      any = any || coefficients(e) != 0;
    }
    return any;
  }

  struct Line {
    SumFamily::Along along;
    std::vector<Eigen::VectorXd> coefficients;  ///< of degrees 1 …
    std::size_t assembled = 0;
    std::string reason;
    bool ends = false;  ///< a polynomial reproduces it
  };

  /// One number from node to node, the others at their first ones.
  [[nodiscard]] Line line(std::size_t j, bool logarithmic) const {
    const std::vector<double>& nodes = newton_nodes();
    Line result{between(j, logarithmic), {}, 0, "", false};
    std::vector<Eigen::VectorXd> all;
    for (int degree = 0; degree <= most_degree; ++degree) {
      Eigen::VectorXd values = values_at({});
      values(to_index(j)) = result.along.value(nodes[degree]);
      PackedOrReason found = source_(values);
      ++result.assembled;
      if (!found.design || found.design->entries.size() != coefficients_.front().size()) {
        result.reason = found.design ? "designs with more entries than others" : found.reason;
        return result;
      }
      Eigen::VectorXd rest = std::move(found.design->entries);
      const auto polynomials = newton_polynomials(nodes[degree], degree, 1.0);
      for (std::size_t k = 0; k < all.size(); ++k) rest -= polynomials[k] * all[k];
      const bool counts = degree == 0 || keep_coefficients(rest, found.design->scales);
      result.ends = !counts;
      if (result.ends) break;
      all.push_back(std::move(rest));
      result.along.degree = degree;
    }
    assert(!all.empty() && all.size() == static_cast<std::size_t>(result.along.degree) + 1);
    result.coefficients.assign(all.begin() + 1, all.end());
    return result;
  }

  /// The shorter polynomial: in the number itself, or in its logarithm.
  [[nodiscard]] Line shorter_line(std::size_t j) const {
    Line plain = line(j, false);
    constexpr int short_enough = 4;
    if (!plain.reason.empty() || !(variables_[j].from > 0) || (plain.ends && plain.along.degree <= short_enough))
      return plain;
    Line logarithmic = line(j, true);
    const std::size_t assembled = plain.assembled + logarithmic.assembled;
    const bool better = logarithmic.ends && logarithmic.reason.empty() &&
        (!plain.ends || logarithmic.along.degree < plain.along.degree);
    Line& chosen = better ? logarithmic : plain;
    chosen.assembled = assembled;
    return chosen;
  }

  std::string add_lines() {
    std::vector<Line> lines(variables_.size());
    foundation::parallel_for(lines.size(), {}, [&](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) lines[j] = shorter_line(j);
    });
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (!lines[j].reason.empty()) return lines[j].reason;
      if (!lines[j].ends)
        return fmt::format("matrices that polynomials of degree {} do not reproduce along {}", most_degree,
                           variables_[j].name);
    }
    for (std::size_t j = 0; j < lines.size(); ++j) family_.assembled_ += lines[j].assembled;
    for (Line& one : lines) family_.along_.push_back(one.along);
    // A logarithm moves the first node of its number: the lines of the others are drawn through it.
    const bool moved = std::ranges::any_of(lines, [](const Line& one) { return one.along.logarithmic; });
    return moved ? add_moved_lines() : add_terms_of(lines);
  }

  std::string add_terms_of(std::vector<Line>& lines) {
    for (std::size_t j = 0; j < lines.size(); ++j)
      for (std::size_t k = 0; k < lines[j].coefficients.size(); ++k)
        add_term({{j, static_cast<int>(k) + 1}}, std::move(lines[j].coefficients[k]));
    return "";
  }

  std::string add_moved_lines() {
    PackedOrReason centre = source_(values_at({}));
    if (!centre.design) return centre.reason;
    coefficients_.front() = std::move(centre.design->entries);
    std::vector<Line> lines(variables_.size());
    foundation::parallel_for(lines.size(), {}, [&](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) lines[j] = line(j, family_.along_[j].logarithmic);
    });
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (!lines[j].reason.empty()) return lines[j].reason;
      family_.along_[j] = lines[j].along;
      family_.assembled_ += lines[j].assembled;
    }
    return add_terms_of(lines);
  }

  [[nodiscard]] bool has_terms_of_degree(int degree) const {
    return std::ranges::any_of(family_.terms_,
                               [&](const SumFamily::Term& term) { return degree_of(term.exponents) == degree; });
  }

  /// Does every product with one degree less have a term?
  [[nodiscard]] bool may_have_term(const Exponents& exponents) const {
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      Exponents less = exponents;
      if (--less[i].degree == 0) less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
      if (!number_.contains(less)) return false;
    }
    return true;
  }

  /// Products of at least two numbers with this sum of degrees.
  [[nodiscard]] std::vector<Exponents> candidates(int degree) const {
    std::vector<Exponents> result;
    for (const SumFamily::Term& term : family_.terms_) {
      if (degree_of(term.exponents) + 1 != degree || term.exponents.empty()) continue;
      Exponents more = term.exponents;
      ++more.back().degree;
      if (more.size() > 1 && more.back().degree <= along(more.back().variable).degree && may_have_term(more))
        result.push_back(more);
      for (std::size_t j = term.exponents.back().variable + 1; j < variables_.size(); ++j) {
        Exponents wider = term.exponents;
        wider.push_back({j, 1});
        if (may_have_term(wider)) result.push_back(wider);
      }
    }
    return result;
  }

  /// What the terms so far do not give at the node of a product.
  [[nodiscard]] PackedOrReason rest_at(const Exponents& exponents) const {
    PackedOrReason found = source_(values_at(exponents));
    if (!found.design) return found;
    const std::vector<double>& nodes = newton_nodes();
    const auto polynomial = [&](const Factor& factor) {
      for (const Factor& here : exponents)
        if (here.variable == factor.variable && here.degree >= factor.degree)
          return newton_polynomials(nodes[static_cast<std::size_t>(here.degree)], factor.degree, 1.0).back();
      return 0.0;  // at its first node, or before the node of this degree
    };
    std::vector<double> terms(family_.terms_.size(), 1);
    for (std::size_t i = 1; i < terms.size(); ++i) {
      const SumFamily::Term& term = family_.terms_[i];
      terms[i] = terms[term.parent];
      if (terms[i] != 0) terms[i] *= polynomial(term.exponents.back());
    }
    for (std::size_t i = 0; i < terms.size(); ++i)
      if (terms[i] != 0) found.design->entries -= terms[i] * coefficients_[i];
    return found;
  }

  std::string add_products(int degree) {
    const std::vector<Exponents> tried = candidates(degree);
    std::vector<PackedOrReason> found(tried.size());
    if (family_.assembled_ + tried.size() > SumFamily::most_terms)
      return fmt::format("more than {} terms", SumFamily::most_terms);
    constexpr std::size_t piece = 4;
    foundation::parallel_for(tried.size(), {.size = piece}, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) found[i] = rest_at(tried[i]);
    });
    family_.assembled_ += tried.size();
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (!found[i].design) return found[i].reason;
      if (keep_coefficients(found[i].design->entries, found[i].design->scales))
        add_term(tried[i], std::move(found[i].design->entries));
    }
    return "";
  }

  void finish() { family_.order_by_entries(coefficients_); }

  /// Shares of the ranges of the designs that are compared.
  [[nodiscard]] std::vector<Eigen::VectorXd> compared_points() const {
    constexpr int spread = 24, along_each = 5;
    const auto numbers = to_index(variables_.size());
    std::vector<Eigen::VectorXd> points = spread_points(numbers, spread);
    if (compared_ == SumFamily::Compared::spread) return points;
    if (compared_ == SumFamily::Compared::ends) {
      std::ranges::move(points_at_ends(numbers), std::back_inserter(points));
      return points;
    }
    int count = 1;
    for (Eigen::Index j = 0; j < numbers; ++j) count *= along_each;
    for (int k = 0; k < count; ++k) {
      Eigen::VectorXd& point = points.emplace_back(numbers);
      for (int rest = k, j = 0; j < numbers; ++j, rest /= along_each)
        point(j) = static_cast<double>(rest % along_each) / (along_each - 1);
    }
    return points;
  }

  /// Compares with assembled designs.
  std::string compare() {
    const std::vector<Eigen::VectorXd> shares = compared_points();
    std::vector<double> worst(shares.size(), -1);
    std::vector<std::string> reasons(shares.size());
    foundation::parallel_for(shares.size(), {}, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        Eigen::VectorXd values(to_index(variables_.size()));
        for (std::size_t j = 0; j < variables_.size(); ++j) {
          const SumVariable& one = variables_[j];
          values(to_index(j)) =
              SumFamily::Along{one.from, one.to, family_.along_[j].logarithmic, 0}.value(shares[i](to_index(j)));
        }
        const PackedOrReason exact = source_(values);
        if (exact.design) worst[i] = largest_difference(family_.at(values), *exact.design);
        else reasons[i] = exact.reason;
      }
    });
    family_.worst_ = std::ranges::max(worst);
    family_.compared_ = shares.size();
    const auto without = std::ranges::find_if(reasons, [](const std::string& reason) { return !reason.empty(); });
    if (compared_ != SumFamily::Compared::spread && without != reasons.end()) return *without;
    const auto valid = std::ranges::count_if(worst, [](double one) { return one >= 0; });
    if (2 * valid < std::ssize(shares)) return "few designs of the ranges are valid models";
    if (family_.worst_ > reproduced_within)
      return fmt::format("matrices that a sum of {} terms does not reproduce within {:.0e}: largest deviation {:.0e}",
                         family_.terms(), reproduced_within, family_.worst_);
    return "";
  }

  const SumFamily::Source& source_;
  const std::vector<SumVariable>& variables_;
  SumFamily::Compared compared_;
  SumFamily family_;
  std::map<Exponents, std::size_t> number_;  ///< of each term
  std::vector<Eigen::VectorXd> coefficients_;
};

SumFamilyOrReason SumFamily::fitted(const Source& source, const std::vector<SumVariable>& variables,
                                    Compared compared) {
  return SumFit(source, variables, compared).fit();
}

}  // namespace trivet::design
