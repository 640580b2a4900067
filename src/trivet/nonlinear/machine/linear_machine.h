// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/nonlinear/laws/deflections.h"

namespace trivet::nonlinear {

/// At one frequency: δ = motion − receptance · f, with the forces f of the nonlinear parts.
struct Receptance {
  Eigen::MatrixXcd receptance;  ///< deflections × deflections [m/N, …]
  Eigen::MatrixXcd slope;       ///< its derivative by ω
};
struct LinearMotion {
  Eigen::VectorXcd motion;  ///< deflections of the linear machine under its excitation
  Eigen::VectorXcd slope;   ///< derivative by ω
};

/// The linear machine under several loadings, as its nonlinear deflections see it, at frequencies ω > 0 [rad/s].
class LinearMachine {
 public:
  virtual ~LinearMachine() = default;
  /// Of the machine, or of the nearest one with constant matrices.
  [[nodiscard]] virtual const Eigen::VectorXcd& poles() const = 0;
  virtual void set_receptance(double omega, Receptance& found) const = 0;
  /// Without the slope.
  virtual void set_receptance(double omega, Eigen::MatrixXcd& found) const = 0;
  /// Under one of the loadings.
  [[nodiscard]] virtual LinearMotion motion(std::size_t loading, double omega) const = 0;
  /// All coordinates under the forces of the nonlinear parts and `factor` times a loading, if one is given.
  /// @param forces  complex amplitudes, one per deflection
  [[nodiscard]] virtual Eigen::VectorXcd coordinates(double omega, const Eigen::VectorXcd& forces,
                                                     const std::size_t* loading, double factor) const = 0;
  /// Frequency beyond which the data of an element end, which is then held constant [rad/s].
  [[nodiscard]] virtual double known_to() const = 0;
};

inline constexpr const char* free_when_removed =
    "the machine is free to move when its nonlinear parts are removed; add a soft linear stiffness";

/// Of constant matrices: poles and residues, so that one frequency costs (poles × deflections²). Where poles repeat
/// without as many shapes, as at critical damping, residues do not exist or cancel each other: the dynamic stiffness is
/// then factorised at each frequency, as below. `assembled` must outlive it.
/// @throws foundation::NotComputable if the machine is free to move when its nonlinear parts are removed
[[nodiscard]] std::unique_ptr<LinearMachine> machine_of_poles(const assembly::Assembled& assembled,
                                                              const std::vector<Deflection>& deflections,
                                                              const std::vector<assembly::Loading>& loadings);

/// The exact dynamic stiffness, factorised at each frequency, also with elements whose stiffness is a function of
/// frequency. `assembled` must outlive it.
/// @throws foundation::NotComputable as above
[[nodiscard]] std::unique_ptr<LinearMachine> machine_over_frequency(const assembly::Assembled& assembled,
                                                                    const std::vector<Deflection>& deflections,
                                                                    const std::vector<assembly::Loading>& loadings);

}  // namespace trivet::nonlinear
