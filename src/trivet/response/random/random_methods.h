// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/random/pole_expansion.h"
#include "trivet/response/random/random_variance.h"

namespace trivet::response {

/// Mean squares from the pole–residue form, for constant matrices. S enters only through J_k = ∫ S e^{−iωτ}/(iω − λ_k)
/// dω, on Gauss panels graded toward the poles: ∫ S e^{−iωτ}/((iω − λ_j)(−iω − λ̄_k)) dω = −(J_j(τ) + conj J_k(−τ))/(λ_j
/// + λ̄_k). If that sum would lose digits, and for powers of s, the integral itself is computed on the same nodes.
/// `error` is twice the largest relative difference from direct solutions.
[[nodiscard]] RandomVariances variances_by_poles(const assembly::Assembled& assembled,
                                                 const std::vector<assembly::Channel>& channels,
                                                 const RandomLoading& loading, const std::vector<RandomMoment>& moments,
                                                 const PoleExpansions& expansions,
                                                 const foundation::Progress& progress);

/// Mean squares from direct solutions on panels graded toward the poles. Each panel has 15 Gauss–Kronrod nodes and is
/// halved until the two rules agree within `options.accuracy`. For every system, also with frequency-dependent
/// elements, for which `poles` are only approximate.
[[nodiscard]] RandomVariances variances_by_quadrature(const assembly::Assembled& assembled,
                                                      const std::vector<assembly::Channel>& channels,
                                                      const RandomLoading& loading,
                                                      const std::vector<RandomMoment>& moments,
                                                      const Eigen::VectorXcd& poles, const RandomOptions& options,
                                                      const foundation::Progress& progress);

}  // namespace trivet::response
