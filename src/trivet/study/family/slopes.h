// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <vector>

#include "trivet/modal/suspension.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/packed_margins.h"

namespace trivet::study {

// Slopes from the equations of a design and their changes per unit of each parameter, wherever these come from: models
// next to it, or the numbers of a batch.

/// A result at rest: y = cᵀq_w + dᵀq_l + y₀ (response::StaticSolution).
struct RestEquations {
  Eigen::MatrixXd first, whole;  ///< K₀, K
  response::RestLoads loads;
  response::RestRow row;
};

/// Adds `weight` times other equations.
void add(CurveEquations& to, double weight, const CurveEquations& other);
void add(RestEquations& to, double weight, const RestEquations& other);

/// Derivatives of ln|y| at fixed frequencies, frequencies × parameters: dy = λᵀ(dh − dZ q) + dcᵀq + dy₀ with Zᵀλ = c.
/// At a maximum of |y| its shift does not count.
/// @param changes  of all frequencies, per parameter
[[nodiscard]] Eigen::MatrixXd curve_slopes(
    const std::vector<CurveEquations>& here, std::size_t parameters,
    const std::function<std::vector<CurveEquations>(std::size_t parameter)>& changes);

/// Derivatives of ln|y| of a result at rest, per parameter: K₀ᵀμ = c, Kᵀλ = d give dy = μᵀ(dQ_w − dK₀ q_w) +
/// λᵀ(dQ_l − dK q_l) + dcᵀq_w + ddᵀq_l + dy₀.
/// @param scale  of the coordinates, numerics::unit_scale
[[nodiscard]] Eigen::RowVectorXd rest_slopes(const RestEquations& here, const Eigen::VectorXd& scale,
                                             std::size_t parameters,
                                             const std::function<RestEquations(std::size_t parameter)>& change);

/// Derivatives of ln of the share of kinetic energy in the purest coordinate of modes of a body on its elements, per
/// parameter. The shape moves by (K − λA) dφ − Aφ dλ = −(dK − λ dA) φ with 2 φᵀA dφ = −φᵀdA φ. Of equal frequencies the
/// shapes are those of the value, and stay as they are within their subspace.
/// @param rates  derivatives of what the modes of the body depend on, per parameter
/// @param modes  of modal::BodySuspension::modes, from 0
/// @returns  modes × parameters
[[nodiscard]] Eigen::MatrixXd decoupling_slopes(const modal::OwnSystem& own, const std::vector<modal::OwnSystem>& rates,
                                                const std::vector<std::size_t>& modes);

/// Z and dZ/dλ of the system that a root belongs to: Z(λ) = λ²A + λB + K + iK_loss, or the exact one of
/// frequency-dependent elements.
struct RootEquations {
  std::complex<double> lambda;
  bool exact = false;
  [[nodiscard]] Eigen::MatrixXcd stiffness(const assembly::Assembled& assembled) const;
  [[nodiscard]] Eigen::MatrixXcd slope(const assembly::Assembled& assembled) const;
};

/// Derivatives of ln ζ, ζ = −Re λ/|λ|, of a damped root, per parameter: dλ = −wᵀ dZ(λ) v / wᵀ (dZ/dλ) v with the left
/// and right vectors wᵀZ = 0, Zv = 0. Roots that agree within 1e-6 belong to one subspace, with the slopes of
/// `separated_motions`.
/// @param index    in modal::Roots::list; not real
/// @param towards  how far each parameter may still move, with its sign
/// @param change   dZ(λ)
/// @returns  NaN for a defective pair, which has no slope
[[nodiscard]] Eigen::RowVectorXd damping_ratio_slopes(
    const CaseContext& context, std::size_t index, const Eigen::VectorXd& towards,
    const std::function<Eigen::MatrixXcd(const RootEquations& root, std::size_t parameter)>& change);

}  // namespace trivet::study
