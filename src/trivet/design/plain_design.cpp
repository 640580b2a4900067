// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/plain_design.h"

#include <cassert>
#include <complex>
#include <optional>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::design {
namespace {

/// A load with all components in phase, rotated to be real.
std::optional<Eigen::VectorXd> real_load(const numerics::Load& load) {
  assert(load.is_constant() && "plain designs have forces that do not change with frequency");
  if (load.vanishes()) return Eigen::VectorXd::Zero(load.size());
  const Eigen::VectorXcd& value = load.terms().front().value;
  Eigen::Index largest = 0;
  const double size = value.cwiseAbs().maxCoeff(&largest);
  const Eigen::VectorXcd turned = value * (std::conj(value(largest)) / size);
  constexpr double round_off = 1e-15;
  if (turned.imag().cwiseAbs().maxCoeff() > round_off * size) return std::nullopt;
  return turned.real();
}

}  // namespace

Eigen::VectorXd packed(const PlainDesign& design) {
  const Eigen::Index n = design.load.size(), triangle = n * (n + 1) / 2;
  Eigen::VectorXd all(3 * triangle + n);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd* m : {&design.A, &design.B, &design.K})
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j) all(at++) = (*m)(i, j);
  assert(at == 3 * triangle && "three lower triangles, then the load");
  all.tail(n) = design.load;
  return all;
}

Eigen::VectorXd scales(const PlainDesign& design) {
  const Eigen::Index n = design.load.size();
  PlainDesign scale = design;
  for (Eigen::MatrixXd* m : {&scale.A, &scale.B, &scale.K}) {
    const Eigen::VectorXd root = m->diagonal().cwiseAbs().cwiseSqrt();
    *m = root * root.transpose();
  }
  scale.load = Eigen::VectorXd::Constant(n, design.load.cwiseAbs().maxCoeff());
  return packed(scale);
}

std::string reason_for_separate_families(const PlainDesign& a, const PlainDesign& b) {
  if (a.load.size() != b.load.size()) return "designs with more coordinates than others";
  if (a.rows != b.rows || a.rows_on_velocity != b.rows_on_velocity)
    return "results whose definition differs between designs (a force of an element that the numbers change, or a "
           "point that they move)";
  return "";
}

numerics::Designs unpacked_like(const PlainDesign& first, const Eigen::MatrixXd& entries) {
  assert(entries.cols() == packed(first).size());
  const Eigen::Index n = first.load.size(), triangle = n * (n + 1) / 2;
  return {entries.leftCols(triangle).array(), entries.middleCols(triangle, triangle).array(),
          entries.middleCols(2 * triangle, triangle).array(), entries.rightCols(n).array()};
}

DesignOrReason<PlainDesign> plain_design(const assembly::Assembled& assembled,
                                         const std::vector<assembly::Channel>& channels,
                                         const assembly::Loading& loading) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  if (assembled.frequency_dependent()) return {{}, "frequency-dependent elements"};
  if (m.lossy()) return {{}, "loss factors"};
  if (!m.symmetric) return {{}, "matrices that are not symmetric"};
  if (to_index(numerics::massive_rows(m.A).size()) < m.size()) return {{}, "coordinates without mass"};
  if (!loading.motion.vanishes()) return {{}, "a moving ground"};
  if (!loading.force.is_constant()) return {{}, "a force that changes with frequency"};
  const auto load = real_load(loading.force);
  if (!load) return {{}, "forces of different phases"};
  PlainDesign design{m.A, m.B, m.K, *load, {}, {}, {}};
  const auto channel_count = to_index(channels.size());
  design.rows = Eigen::MatrixXd::Zero(channel_count, m.size());
  design.rows_on_velocity = design.rows;
  for (Eigen::Index c = 0; c < channel_count; ++c) {
    const assembly::Channel& channel = channels[c];
    const bool other = !channel.dynamic_forces.empty() || !channel.on_displacement.imag().isZero(0) ||
        (channel.on_acceleration.size() > 0 && !channel.on_acceleration.isZero(0));
    if (other) return {{}, "forces of elements with mass or loss"};
    design.rows.row(c) = channel.on_displacement.real().transpose();
    if (channel.on_velocity.size() > 0) design.rows_on_velocity.row(c) = channel.on_velocity.transpose();
    design.derivative.push_back(channel.derivative);
  }
  return {std::move(design), ""};
}

}  // namespace trivet::design
