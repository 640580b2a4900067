// SPDX-License-Identifier: BSD-3-Clause
// Machines near the paper's, drawn from a fixed seed: mass, stiffness and damping are each rotated and scaled a little,
// damping also by a power of ten.
#pragma once

#include <cmath>
#include <cstdint>

#include "paper_machine.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::benchmarks {

/// Random numbers, the same on every machine: xorshift64*, uniform on [−1, 1).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed * 2685821657736338717ULL + 1) {}
  double operator()() {
    state_ ^= state_ >> 12, state_ ^= state_ << 25, state_ ^= state_ >> 27;
    return static_cast<double>((state_ * 2685821657736338717ULL) >> 11) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_;
};

/// Random designs with damping times 10^least … 10^most.
inline numerics::Designs random_designs(Eigen::Index count, double least = -1.5, double most = 0.5) {
  const PaperMachine m = paper_machine();
  Draws draw(20);
  numerics::Designs designs{Eigen::ArrayXXd(count, 21), Eigen::ArrayXXd(count, 21), Eigen::ArrayXXd(count, 21),
                            m.load.transpose().array()};
  const Vector6 unit = m.A.diagonal().cwiseSqrt();  // metres and radians are mixed as weighted in A
  const auto varied = [&](const Matrix6& x, double scale) -> Matrix6 {
    Matrix6 turn = Matrix6::Identity();
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) turn(i, j) += 0.1 * draw() * unit[j] / unit[i];
    const Matrix6 turned = scale * (turn.transpose() * x * turn);
    return (turned + turned.transpose()) / 2;
  };
  for (Eigen::Index d = 0; d < count; ++d) {
    numerics::pack(varied(m.A, std::exp(0.3 * draw())), designs.A, d);
    numerics::pack(varied(m.B, std::pow(10, (least + most) / 2 + (most - least) / 2 * draw())), designs.B, d);
    numerics::pack(varied(m.K, std::exp(draw())), designs.K, d);
  }
  return designs;
}

inline PaperMachine machine_of(const numerics::Designs& designs, Eigen::Index d) {
  return {numerics::unpacked(designs.A, d), numerics::unpacked(designs.B, d), numerics::unpacked(designs.K, d),
          designs.load.row(0).transpose().matrix()};
}

/// The first designs as consecutive full matrices, for rivals.
inline std::vector<double> full_matrices(const Eigen::ArrayXXd& packed, Eigen::Index count) {
  std::vector<double> all;
  for (Eigen::Index d = 0; d < count; ++d) {
    const Eigen::MatrixXd x = numerics::unpacked(packed, d);
    all.insert(all.end(), x.data(), x.data() + 36);
  }
  return all;
}

}  // namespace trivet::benchmarks
