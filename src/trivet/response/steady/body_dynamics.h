// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/peaks/jet.h"

namespace trivet::response {

using numerics::Jet;

/// D(ω) of the frequency-dependent elements; empty for the others.
using ElementJets = std::vector<std::optional<Jet<elements::Matrix12c>>>;
[[nodiscard]] Jet<elements::Matrix12c> element_jet(const assembly::ElementMap& map, double omega);
[[nodiscard]] ElementJets element_jets(const assembly::Assembled& assembled, double omega);

/// Equations of one result at ω: Z q = h, y = cᵀq + direct, including the time derivatives of the channel. A moving
/// ground is part of h and of `direct`.
struct Dynamics {
  Jet<Eigen::MatrixXcd> stiffness;  ///< Z
  Jet<Eigen::VectorXcd> load;       ///< h
  Jet<Eigen::VectorXcd> channel;    ///< c
  Jet<std::complex<double>> direct = {0, 0, 0};

  /// Adds `weight` times another of the same size, for difference quotients.
  void add(double weight, const Dynamics& other);
};

/// Dynamics in all coordinates except those of frequency-dependent elements (rows before `Layout::before_last`).
[[nodiscard]] Dynamics dynamics(const assembly::Assembled& assembled, const assembly::Channel& channel,
                                const assembly::Loading& loading, double omega, const ElementJets& jets);

/// The same in the coordinates of the bodies alone, with the inner coordinates of elements eliminated with all
/// derivatives. The result does not depend on the basis that elements choose for their inner coordinates.
/// @param of_bodies  number of leading rows to keep, Layout::of_bodies
[[nodiscard]] Dynamics body_dynamics(const Dynamics& all, Eigen::Index of_bodies);

/// q and y of Z q = h with their derivatives. @throws NotComputable if Z is singular
struct Motion {
  Jet<Eigen::VectorXcd> coordinates;
  Jet<std::complex<double>> value;
};
[[nodiscard]] Motion motion(const Dynamics& dynamics);

/// λ of Zᵀλ = c and dλ/dω: dy = λᵀ(dh − dZ q) + dcᵀ q + d direct.
[[nodiscard]] std::array<Eigen::VectorXcd, 2> adjoint(const Dynamics& dynamics);

}  // namespace trivet::response
