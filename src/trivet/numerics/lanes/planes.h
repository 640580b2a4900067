// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>

namespace trivet::numerics {

/// Complex numbers of many frequencies: number k of frequency f at [k · stride + f].
struct Planes {
  double* re = nullptr;
  double* im = nullptr;
  Eigen::Index stride = 0;

  void put(Eigen::Index at, const std::complex<double>& value) const {
    re[at] = value.real();
    im[at] = value.imag();
  }
};

}  // namespace trivet::numerics
