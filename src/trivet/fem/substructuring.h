// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <functional>
#include <span>
#include <vector>

#include "trivet/foundation/interruption.h"

namespace trivet::fem {

/// Halves a set of elements so that the halves share few unknowns: the cost of a condensation grows with the cube of
/// their number.
class Bisection {
 public:
  /// @param element_unknowns  per element the numbers of its unknowns; those ≥ `first_retained` are not counted
  /// @param centres  per element a point [m]
  Bisection(const std::vector<std::vector<int>>& element_unknowns, const Eigen::Matrix3Xd& centres, int first_retained);

  /// Sorts at least two elements along one axis of the mesh and returns the number of those in the first half.
  int halve(std::span<int> elements);

 private:
  const std::vector<int>& shared_before(std::span<const int> elements);

  const std::vector<std::vector<int>>& element_unknowns_;
  const Eigen::Matrix3Xd& centres_;
  int first_retained_;
  std::vector<int> first_, last_, shared_;  ///< working memory: per unknown, its first and last place in a set
};

struct Pivots {
  int negative = 0;
  bool singular = false;
};

/// Eliminates the first `count` unknowns of the symmetric matrix given by its lower triangle: the lower triangle of its
/// lower right corner becomes that of the Schur complement, its first columns become the factors that `recover_leading`
/// needs. The result does not depend on `threads`.
Pivots eliminate_leading(Eigen::Ref<Eigen::MatrixXd> matrix, Eigen::Index count, int threads);

/// Computes the eliminated unknowns from the others, in place: `values` holds the others after the first
/// `factors.cols()`.
void recover_leading(const Eigen::MatrixXd& factors, Eigen::VectorXd& values);

/// Adds a symmetric matrix to the lower triangle of another, row and column i at place[i].
void add_symmetric(const Eigen::MatrixXd& part, const std::vector<int>& place, Eigen::Ref<Eigen::MatrixXd> whole);

/// The lower triangle of a matrix, column after column.
[[nodiscard]] std::vector<double> packed_lower(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// Adds a packed lower triangle to that of a larger matrix, row and column i at place[i], in ascending places.
void add_packed(const std::vector<double>& part, const std::vector<int>& place, Eigen::Ref<Eigen::MatrixXd> whole);

class Bisection;

/// Static condensation of a symmetric system of many elements to its retained unknowns, by recursive substructuring:
/// the solid is halved repeatedly, each part is condensed to its boundary, and boundaries are joined in pairs. Exact in
/// exact arithmetic. The pivots must be nonzero, of any sign in any order: positive definite and quasi-definite (mixed)
/// systems.
class Substructuring {
 public:
  /// @param element_unknowns  per element the numbers of its unknowns; those ≥ `first_retained` are retained
  /// @param centres  per element a point [m] for halving the solid
  Substructuring(std::vector<std::vector<int>> element_unknowns, const Eigen::Matrix3Xd& centres, int first_retained,
                 int retained_count);

  [[nodiscard]] double operations() const { return operations_; }   ///< multiplications of one condensation
  [[nodiscard]] double bytes(bool recoverable, int threads) const;  ///< working memory of one condensation

  /// Full symmetric matrix of an element, in the order of its unknowns. Called from several threads at once.
  using ElementMatrix = std::function<Eigen::MatrixXd(int element)>;

  struct Condensed {
    Eigen::MatrixXd matrix;   ///< on the retained unknowns
    int negative_pivots = 0;  ///< negative eigenvalues of the condensed part (Sylvester)
    bool singular = false;    ///< a pivot vanished: part of the solid is unrestrained
  };
  /// @param recoverable  keep the factors, so that `recover` can give the condensed unknowns
  /// The result does not depend on `threads`.
  [[nodiscard]] Condensed condense(const ElementMatrix& element_matrix, bool recoverable, int threads,
                                   const foundation::Progress& progress);

  /// All unknowns from the retained ones, after a recoverable condensation of a system without loads on the others.
  [[nodiscard]] Eigen::VectorXd recover(const Eigen::VectorXd& retained) const;

 private:
  struct Part {
    int first_element = 0, last_element = 0;  ///< range in order_
    int left = -1, right = -1;                ///< parts; −1: a leaf
    std::vector<int> unknowns = {};  ///< those to be condensed here, then the boundary in the order of the parent
    int condensed = 0;
    std::vector<int> place_in_parent = {};  ///< of the boundary unknowns, ascending
    double operations = 0;                  ///< including all parts below
    Eigen::MatrixXd factors = {};           ///< first `condensed` columns of the eliminated front
  };
  struct Run;
  struct Workspace;

  struct Memory {
    double front, boundaries, result;
  };

  int divide(int first, int last, Bisection& bisection);
  void number(int part);
  void order_boundaries();
  [[nodiscard]] bool splits(const Part& part, int threads) const;
  [[nodiscard]] Memory memory(int part, int threads) const;
  /// Packed lower triangle on the boundary of the part. Only the calling thread `reports` progress.
  std::vector<double> condense_part(int part, Run& run, Workspace& workspace, int threads, bool reports);
  void add_elements(const Part& part, Run& run, Workspace& workspace, Eigen::Map<Eigen::MatrixXd>& front) const;

  std::vector<std::vector<int>> element_unknowns_;
  int first_retained_, retained_count_;
  std::vector<int> order_;                     ///< elements, part by part
  std::vector<int> first_touch_, last_touch_;  ///< per unknown: range in order_ of the elements that contain it
  std::vector<Part> parts_;
  double operations_ = 0;
};

}  // namespace trivet::fem
