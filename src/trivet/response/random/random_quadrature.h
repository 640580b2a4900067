// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/random/random_variance.h"

namespace trivet::response {

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
