// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/machine/linear_machine.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::nonlinear {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

class MachineOverFrequency final : public LinearMachine {
 public:
  MachineOverFrequency(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                       const std::vector<assembly::Loading>& loadings)
      : assembled_(assembled),
        constant_(assembled.frequency_dependent() ? assembled.constant : assembled.matrices),
        loadings_(loadings),
        poles_(numerics::poles(numerics::system_roots(assembled.matrices))),
        scale_(numerics::unit_scale(constant_)) {
    constexpr double singular = 1e-13;
    if (!(numerics::PivotedLu<double>(assembled.matrices.K).reciprocal_condition() > singular))
      throw foundation::NotComputable(free_when_removed);
    const Index n = constant_.size(), count = to_index(deflections.size());
    rows_.resize(n, count);
    ground_rows_.resize(assembled.ground.size(), count);
    for (Index j = 0; j < count; ++j) {
      rows_.col(j) = deflections[j].on_coordinates.head(n);
      ground_rows_.col(j) = deflections[j].on_ground;
    }
    for (const assembly::ElementMap& map : assembled.elements) known_to_ = std::min(known_to_, map.defined_to);
    for (const assembly::Loading& loading : loadings)
      right_sides_.push_back(assembly::right_side(assembled, loading).head(n));
  }

  [[nodiscard]] const VectorXcd& poles() const override { return poles_; }

  void set_receptance(double omega, MatrixXcd& found) const override {
    found = rows_.transpose() * solved(stiffness(omega), rows_.cast<Complex>());
  }

  void set_receptance(double omega, Receptance& found) const override {
    const MatrixXcd z = stiffness(omega);
    const MatrixXcd motion = solved(z, rows_.cast<Complex>());
    found.receptance = rows_.transpose() * motion;
    found.slope = -rows_.transpose() * solved(z, stiffness_slope(omega) * motion);
  }

  [[nodiscard]] LinearMotion motion(std::size_t loading, double omega) const override {
    assert(loading < loadings_.size());
    const MatrixXcd z = stiffness(omega);
    const VectorXcd here = solved(z, right_side(loading, omega));
    const double step = relative_step * omega;
    const VectorXcd load_slope = (right_side(loading, omega + step) - right_side(loading, omega - step)) / (2 * step);
    const VectorXcd slope = solved(z, load_slope - stiffness_slope(omega) * here);
    const numerics::Load& ground = loadings_[loading].motion;
    LinearMotion found{rows_.transpose() * here, rows_.transpose() * slope};
    if (ground.vanishes()) return found;
    found.motion += ground_rows_.transpose() * ground.at(omega);
    found.slope += ground_rows_.transpose() * (ground.at(omega + step) - ground.at(omega - step)) / (2 * step);
    return found;
  }

  [[nodiscard]] VectorXcd coordinates(double omega, const VectorXcd& forces, const std::size_t* loading,
                                      double factor) const override {
    VectorXcd load = -(rows_.cast<Complex>() * forces);
    if (loading) load += factor * right_side(*loading, omega);
    VectorXcd all = VectorXcd::Zero(assembled_.layout.size());
    all.head(load.size()) = solved(stiffness(omega), load);
    return all;
  }

  [[nodiscard]] double known_to() const override { return known_to_; }

 private:
  /// Of differences for slopes, which serve directions and Newton's steps only.
  static constexpr double relative_step = 1e-4;

  [[nodiscard]] static elements::Matrix12c held(const assembly::ElementMap& map, double omega) {
    const double known = std::min(omega, map.defined_to);
    return map.dynamic_stiffness(known, known);
  }

  template <typename Visit>
  void each_dynamic(const Visit& visit) const {
    for (const assembly::ElementMap& map : assembled_.elements)
      if (map.frequency_dependent()) visit(map);
  }

  static void add(const assembly::ElementMap& map, const elements::Matrix12c& stiffness, MatrixXcd& z) {
    const MatrixXd ends = map.ends.topLeftCorner(12, map.end_columns);
    const MatrixXcd local = ends.transpose() * stiffness * ends;
    const std::vector<Index> rows(map.rows.begin(), map.rows.begin() + map.end_columns);
    z(rows, rows) += local;
  }

  [[nodiscard]] MatrixXcd stiffness(double omega) const {
    const numerics::DynamicMatrices& m = constant_;
    MatrixXcd z = m.complex_stiffness() + Complex(0, 1) * omega * m.B - omega * omega * m.A;
    each_dynamic([&](const assembly::ElementMap& map) { add(map, held(map, omega), z); });
    return z;
  }

  [[nodiscard]] MatrixXcd stiffness_slope(double omega) const {
    const numerics::DynamicMatrices& m = constant_;
    MatrixXcd slope = Complex(0, 1) * m.B.cast<Complex>() - 2 * omega * m.A;
    const double step = relative_step * omega;
    each_dynamic([&](const assembly::ElementMap& map) {
      if (omega > map.defined_to) return;
      const elements::Matrix12c change =
          map.dynamic_stiffness(omega + step, omega) - map.dynamic_stiffness(omega - step, omega);
      add(map, change / (2 * step), slope);
    });
    return slope;
  }

  [[nodiscard]] VectorXcd right_side(std::size_t loading, double omega) const {
    VectorXcd load = right_sides_[loading].at(omega);
    const numerics::Load& motion = loadings_[loading].motion;
    if (motion.vanishes()) return load;
    const VectorXcd ground = motion.at(omega);
    each_dynamic([&](const assembly::ElementMap& map) {
      if (map.ground_rows.empty() && !map.resists_following) return;
      const VectorXcd moved = map.moved_by_ground(ground).head(12);
      const VectorXcd force =
          map.ends.topLeftCorner(12, map.end_columns).transpose().cast<Complex>() * (held(map, omega) * moved);
      for (Index j = 0; j < force.size(); ++j) load(map.rows[j]) -= force(j);
    });
    return load;
  }

  /// In coordinates of unit mass, so that metres and radians are alike.
  [[nodiscard]] MatrixXcd solved(const MatrixXcd& z, const MatrixXcd& load) const {
    const MatrixXcd scaled = scale_.asDiagonal() * z * scale_.asDiagonal();
    return scale_.asDiagonal() * numerics::PivotedLu<Complex>(scaled).solve(MatrixXcd(scale_.asDiagonal() * load));
  }

  const assembly::Assembled& assembled_;
  const numerics::DynamicMatrices& constant_;  ///< without elements over frequency
  std::vector<assembly::Loading> loadings_;
  std::vector<numerics::Load> right_sides_;  ///< without the dynamic stiffness
  VectorXcd poles_;
  Eigen::VectorXd scale_;
  MatrixXd rows_, ground_rows_;  ///< coordinates × deflections
  double known_to_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::unique_ptr<LinearMachine> machine_over_frequency(const assembly::Assembled& assembled,
                                                      const std::vector<Deflection>& deflections,
                                                      const std::vector<assembly::Loading>& loadings) {
  return std::make_unique<MachineOverFrequency>(assembled, deflections, loadings);
}

}  // namespace trivet::nonlinear
