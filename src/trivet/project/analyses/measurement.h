// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"

/// Measured curves and mode shapes, expressed in results and places of the model.
namespace trivet::project {

/// A measured function that belongs to one result. Values are in the quantity of the response, multiplied by the force
/// of the excitation if the function is measured per force.
struct MeasuredCurve {
  std::string result;                     ///< "machine.seat.z"
  std::string source;                     ///< in its file: "3:+z", or the name of its columns
  std::vector<double> angular_frequency;  ///< [rad/s], ascending, > 0
  Eigen::VectorXcd value;                 ///< SI
  Eigen::VectorXd coherence;              ///< 0 … 1; empty if it is not measured
};

/// One measured component of a shape: a translation of a place along an axis of the ground.
struct ShapeComponent {
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< of the place, body frame [m]
  int axis = 0;                                  ///< 0, 1, 2: x, y, z of the ground
};

struct MeasuredMode {
  int number = 0;  ///< as in the file
  double angular_frequency = 0;
  double damping_ratio = 0;
  Eigen::VectorXcd shape;  ///< one value per component
};

/// True for a frequency inside a band, ends included.
[[nodiscard]] inline bool covers(const assembly::Band& band, double omega) {
  constexpr double rounding = 1e-9;
  return omega >= band.from * (1 - rounding) && omega <= band.to * (1 + rounding);
}

/// A table of [measurements].
struct Measurement {
  std::string name;
  std::string file;        ///< as the project file names it
  std::string excitation;  ///< the only one that acts; empty: those of the response
  std::vector<MeasuredCurve> curves;
  std::vector<ShapeComponent> components;  ///< of all shapes
  std::vector<MeasuredMode> modes;
};

}  // namespace trivet::project
