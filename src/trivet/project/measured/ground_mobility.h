// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "trivet/elements/law.h"
#include "trivet/model/system.h"

namespace trivet::project {

/// Measured mobility v = Y F of one or several ground points in their compliant directions, ground axes. Y is symmetric
/// and interpolated linearly, which keeps Re Y positive semidefinite.
struct GroundMobility {
  struct Direction {
    std::size_t point = 0;
    int coordinate = 0;  ///< x, y, z, θx, θy, θz
    std::string name;    ///< of its driving-point mobility in the file: "y_z_z", "12:+z"
    double causality_rms =
        0;  ///< distance from the nearest passive, causal mobility, found by `judge_mobility` (mobility_reader.h)
  };
  std::vector<Direction> directions;
  std::vector<double> knots;           ///< [rad/s]
  std::vector<Eigen::MatrixXcd> rows;  ///< Y at each knot [(m/s)/N …]
  std::string source;                  ///< file, for messages
  std::vector<int> lines;              ///< of each knot in the file; empty if a knot has no line of its own

  /// Compliant coordinates of a point.
  [[nodiscard]] std::vector<int> coordinates(std::size_t point) const;
  /// Dynamic stiffness iω Y⁻¹ of all directions; for complex ω the piece of the table at `near` is continued.
  [[nodiscard]] Eigen::MatrixXcd dynamic_stiffness(std::complex<double> omega, double near) const;
};

/// Gives the element from the ground (N) to a ground point (K) the dynamic stiffness of that point with all other
/// points fixed.
void join_to_ground(const std::shared_ptr<const GroundMobility>& mobility, std::size_t point, model::Element& element);

/// Gives the element from one ground point (N) to another (K) their coupling: a motion of one relative to the ground
/// causes a force on the other.
void couple(const std::shared_ptr<const GroundMobility>& mobility, std::size_t n, std::size_t k,
            model::Element& element);

/// Ground points under the elements on one foundation, each compliant in its own directions.
struct GroundPoints {
  std::vector<int> directions;  ///< of an impedance; the same at every point
  spatial::Vector6 mass = spatial::Vector6::Zero();
  model::Element impedance;                        ///< from the rigid ground to a point
  std::shared_ptr<const GroundMobility> mobility;  ///< then it takes the place of the impedance
  std::map<std::string, std::size_t>
      points;  ///< element and its point of the mobility; empty: all elements have the first
  struct Placed {
    std::size_t point = 0;
    model::End end;
    std::string name;
  };
  std::vector<Placed> placed;  ///< points that elements are on
};

/// Puts end N of an element on a ground point of its own, and adds the element that joins the point to the ground.
void add_ground_point(GroundPoints& ground, const std::string& element, model::Description& description);

/// Adds the couplings between the points of a mobility that elements are on.
void add_couplings(const GroundPoints& ground, model::Description& description);

}  // namespace trivet::project
