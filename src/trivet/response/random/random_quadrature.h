// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/random/random_variance.h"

namespace trivet::response {

/// Mean squares from direct solutions on panels graded toward the poles, each panel by 15 nodes of Gauss and Kronrod
/// and halved until the difference of the two rules is within `options.accuracy`. For every system, also with
/// frequency-dependent elements, whose poles are only near those given.
[[nodiscard]] RandomVariances variances_by_quadrature(const assembly::Assembled& assembled,
                                                      const std::vector<assembly::Channel>& channels,
                                                      const RandomLoading& loading,
                                                      const std::vector<RandomMoment>& moments,
                                                      const Eigen::VectorXcd& poles, const RandomOptions& options,
                                                      const foundation::Progress& progress);

}  // namespace trivet::response
