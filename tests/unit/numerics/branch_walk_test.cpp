// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/periodic/branch.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Walks along λ(u) of straight pieces, whose direction turns by any angle between them.
namespace branch_walk_test {

using namespace trivet;
using numerics::Branch;
using numerics::BranchPoint;
using numerics::BranchWalk;

struct Piece {
  double from, slope;
};

double parameter_at(const std::vector<Piece>& pieces, double u) {
  double found = 0;
  for (std::size_t i = 0; i < pieces.size() && (i == 0 || pieces[i].from < u); ++i) {
    const double to = i + 1 < pieces.size() ? std::min(u, pieces[i + 1].from) : u;
    found += pieces[i].slope * (to - pieces[i].from);
  }
  return found;
}

Branch of(const std::vector<Piece>& pieces) {
  return {[pieces](const Eigen::VectorXd& u, double parameter, numerics::Equations& equations) {
            double slope = pieces.front().slope;
            for (const Piece& piece : pieces)
              if (piece.from < u(0)) slope = piece.slope;
            equations.value = Eigen::VectorXd::Constant(1, parameter_at(pieces, u(0)) - parameter);
            equations.by_unknowns = Eigen::MatrixXd::Constant(1, 1, slope);
            equations.by_parameter = Eigen::VectorXd::Constant(1, -1);
          },
          Eigen::VectorXd::Constant(1, 1), 1};
}

struct Walked {
  std::vector<BranchPoint> points;
  int hops = 0;
};

/// Takes back what was found beyond the last smooth point, as its users do.
Walked walked(const Branch& branch, double to) {
  constexpr double any = std::numeric_limits<double>::infinity();
  constexpr int most = 2000;
  Walked found;
  found.points.push_back(branch.start(Eigen::VectorXd::Constant(1, 0.5), 0.5).value());
  BranchWalk walk(branch, found.points.front(), {.sharp_turns = 1e-4}, 0.02, -any, any);
  std::size_t smooth = 1;
  for (int i = 0; i < most && found.points.back().unknowns(0) < to; ++i) {
    std::optional<BranchWalk::Step> step = walk.next();
    if (!step) break;
    if (step->hops) {
      found.points.resize(smooth);
      ++found.hops;
    }
    EXPECT_EQ(walk.now().parameter, found.points.back().parameter);
    found.points.push_back(step->to);
    walk.go(std::move(*step));
    if (walk.is_smooth()) smooth = found.points.size();
  }
  return found;
}

void expect_onwards(const std::vector<Piece>& pieces, const Walked& found, double to) {
  EXPECT_GE(found.points.back().unknowns(0), to);
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    const BranchPoint& point = found.points[i];
    EXPECT_NEAR(point.parameter, parameter_at(pieces, point.unknowns(0)), 1e-12);
    if (i > 0) {
      EXPECT_GT(point.unknowns(0), found.points[i - 1].unknowns(0));
    }
  }
}

TEST(BranchWalk, HopsOverAKinkAtWhichTheParameterTurns) {
  const std::vector<Piece> pieces = {{0, 1}, {1, -3}};
  const Walked found = walked(of(pieces), 2);
  EXPECT_EQ(found.hops, 1);
  expect_onwards(pieces, found, 2);
}

TEST(BranchWalk, NeedsNoHopWhereAKinkIsBlunt) {
  const std::vector<Piece> pieces = {{0, 1}, {1, 3}};
  const Walked found = walked(of(pieces), 2);
  EXPECT_EQ(found.hops, 0);
  expect_onwards(pieces, found, 2);
}

/// The first hop lands before the second kink, from which it cannot go on either.
TEST(BranchWalk, HopsOverKinksThatFollowClosely) {
  for (const double apart : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    const std::vector<Piece> pieces = {{0, 1}, {1, -3}, {1 + apart, 4}, {1 + 2 * apart, -2}};
    expect_onwards(pieces, walked(of(pieces), 2), 2);
  }
}

TEST(BranchWalk, EndsWhereNothingGoesOn) {
  const Branch branch(
      [](const Eigen::VectorXd& u, double parameter, numerics::Equations& equations) {
        const bool ends = u(0) > 1;
        equations.value = Eigen::VectorXd::Constant(1, ends ? std::nan("") : u(0) - parameter);
        equations.by_unknowns = Eigen::MatrixXd::Constant(1, 1, 1);
        equations.by_parameter = Eigen::VectorXd::Constant(1, -1);
      },
      Eigen::VectorXd::Constant(1, 1), 1);
  const Walked found = walked(branch, 2);
  EXPECT_LE(found.points.back().unknowns(0), 1);
  EXPECT_GT(found.points.back().unknowns(0), 1 - 1e-6);
}

}  // namespace branch_walk_test
