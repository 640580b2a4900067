// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::test {

/// A project from text; fails the running test with the messages if it is rejected.
[[nodiscard]] project::Project project(const std::string& text, const std::vector<std::string>& settings = {});

/// A chain of guided masses along a direction between two walls: springs [N/m], dashpots [N s/m] and loss factors, each
/// one more than masses (0: no joint). Masses are named m1, m2, …, their free coordinate is "x".
[[nodiscard]] std::string chain(const std::vector<double>& masses, const std::vector<double>& springs,
                                const std::vector<double>& dashpots, const std::vector<double>& loss_factors = {},
                                const std::string& orientation = "");

/// A chain of two masses, m1 of 10 kg and m2 of 4 kg, under a harmonic force of 10 N on m1; the next table of the file
/// follows.
[[nodiscard]] std::string driven_pair();

/// A mass of 10 kg, m1, that sags by its weight on a spring of 40 kN/m, k1, along its free coordinate "z"; the next
/// table of the file follows.
[[nodiscard]] std::string sagging_mass();

/// Complex value of a curve by name.
[[nodiscard]] std::complex<double> value(const study::ResponseResult& result, const std::string& name, Eigen::Index at);

}  // namespace trivet::test
