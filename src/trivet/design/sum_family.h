// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <compare>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trivet::design {

// Newton's interpolation of a function of one number over 0 … 1.

inline constexpr int most_degree = 16;

/// Nodes of one number, as shares of its range: a share at which no factor of a model is likely to vanish, but near the
/// lower end, so that small factors keep their digits, both ends, and then each as far as possible from all before it
/// (Leja's nodes).
[[nodiscard]] const std::vector<double>& newton_nodes();

/// Newton's polynomials 0 … degree at t.
template <typename Number>
[[nodiscard]] std::vector<Number> newton_polynomials(const Number& t, int degree, const Number& one) {
  const std::vector<double>& nodes = newton_nodes();
  std::vector<Number> values = {one};
  for (int k = 1; k <= degree; ++k) {
    Number product = one;
    for (int l = 0; l < k; ++l) product *= (t - nodes[l]) / (nodes[k] - nodes[l]);
    values.push_back(product);
  }
  return values;
}

/// Their derivatives.
[[nodiscard]] std::vector<double> newton_slopes(double t, int degree);

/// One of the numbers of a family.
struct SumVariable {
  double from = 0, to = 1;
  std::string name;  ///< for the text of the reason
};

/// All numbers of one design, such as the packed entries of its matrices, and the reference magnitude of each.
struct PackedDesign {
  Eigen::VectorXd entries, scales;
};

/// A design, or the reason why there is none.
struct PackedOrReason {
  std::optional<PackedDesign> design;
  std::string reason;
};

/// Entries of K differ from those of a separately assembled design by at most this share of √(K_ii K_jj); the same
/// holds for the other matrices, the loads and the rows of results, each with its own scale.
inline constexpr double reproduced_within = 1e-12;

struct SumFamilyOrReason;

/// Designs as functions of many numbers, each of which acts on few entries and together with few others: a sum of
/// terms, each a product of polynomials of few numbers. A stiffness factor of an element and its place are a term;
/// those of two elements are not.
///
/// The terms are found, not given. From a design inside all ranges one number after another is moved until a polynomial
/// reproduces the line, in the number or in its logarithm; then pairs are moved, and sets of more numbers where every
/// smaller set of these has a term (Newton's interpolation on a set of exponents that is closed downwards, as of sparse
/// grids [Chkifa2014]). Designs at points spread over all ranges are then compared with assembled ones.
class SumFamily {
 public:
  /// Which designs are compared with assembled ones.
  enum class Compared {
    spread,  ///< 24 spread over the ranges; those without a form do not count unless they are the most
    ends,    ///< and both ends of every range, alone and together with others; each must have a form
    grid     ///< and five up to the ends of every range with all others (of few numbers); each must have a form
  };

  /// The design at these values, or why it has none; called on several threads.
  using Source = std::function<PackedOrReason(const Eigen::VectorXd& values)>;

  /// Returns a reason instead of a family if a number is not smooth, if there are more than `most_terms` terms, or if a
  /// compared entry differs by more than `reproduced_within` of its scale.
  [[nodiscard]] static SumFamilyOrReason fitted(const Source& source, const std::vector<SumVariable>& variables,
                                                Compared compared = Compared::spread);
  static constexpr std::size_t most_terms = 2000;

  [[nodiscard]] Eigen::Index entries() const { return entry_count_; }
  /// Entries of one design.
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& values) const;
  /// Their derivatives: entries × numbers.
  [[nodiscard]] Eigen::MatrixXd slopes(const Eigen::VectorXd& values) const;
  /// Designs × entries, for the kernels of many designs. @param points  designs × numbers
  [[nodiscard]] Eigen::MatrixXd designs(const Eigen::MatrixXd& points) const;

  [[nodiscard]] std::size_t terms() const { return terms_.size(); }
  [[nodiscard]] std::size_t assembled() const { return assembled_; }  ///< designs that were assembled for the fit
  [[nodiscard]] double worst_difference() const { return worst_; }    ///< over the compared designs
  /// "a sum of 40 terms from 61 assembled designs, compared with 24 others: largest deviation 3e-15"
  [[nodiscard]] std::string words() const;

 private:
  friend class SumFit;
  SumFamily() = default;

  /// Newton's polynomial of one number: the product of (t − node) over the first `degree` nodes, 1 at the next node.
  struct Factor {
    std::size_t variable = 0;
    int degree = 1;
    auto operator<=>(const Factor&) const = default;
  };
  using Exponents = std::vector<Factor>;  ///< by ascending variable; empty: the constant term
  struct Along {
    double from = 0, to = 1;
    bool logarithmic = false;
    int degree = 0;
    [[nodiscard]] double t(double value) const;      ///< 0 … 1 over the range
    [[nodiscard]] double value(double share) const;  ///< exact at the ends
    [[nodiscard]] double slope(double value) const;  ///< dt/dvalue
  };
  struct Term {
    Exponents exponents;
    std::size_t parent = 0;  ///< the term without the last factor; that of the constant term is itself
  };

  /// Values of the terms from the polynomials of all numbers.
  template <typename Number, typename Polynomial>
  void set_terms(std::vector<Number>& values, const Polynomial& polynomial) const;
  /// Has an entry the constant term alone, or none?
  [[nodiscard]] bool is_constant(Eigen::Index entry) const {
    const std::size_t first = first_[entry], count = first_[entry + 1] - first;
    return count == 0 || (count == 1 && coefficients_[first].first == 0);
  }
  void order_by_entries(const std::vector<Eigen::VectorXd>& coefficients);

  std::vector<Along> along_;
  std::vector<Term> terms_;  ///< parents first
  /// Coefficients by entries: those of entry e are first_[e] … first_[e + 1] − 1.
  std::vector<std::size_t> first_;
  std::vector<std::pair<std::size_t, double>> coefficients_;  ///< term, coefficient
  Eigen::Index entry_count_ = 0;
  std::size_t assembled_ = 0, compared_ = 0;
  double worst_ = 0;
};

struct SumFamilyOrReason {
  std::optional<SumFamily> family;
  std::string reason;
};

}  // namespace trivet::design
