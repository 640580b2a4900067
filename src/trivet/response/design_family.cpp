// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/design_family.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/numerics/dynamic_matrices.h"

namespace trivet::response {
namespace {

/// Packed lower triangles of A, B, K, then the load.
Eigen::VectorXd packed(const PlainDesign& design) {
  const Eigen::Index n = design.load.size(), triangle = n * (n + 1) / 2;
  Eigen::VectorXd all(3 * triangle + n);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd* m : {&design.A, &design.B, &design.K})
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j) all(at++) = (*m)(i, j);
  all.tail(n) = design.load;
  return all;
}

/// What each packed entry is measured by.
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

/// Chebyshev points with both ends.
std::vector<double> nodes_between(double from, double to, int count) {
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k) nodes.push_back(k == 0 ? from : k + 1 == count ? to : from + (to - from) * 0.5 * (1 - std::cos(std::numbers::pi * k / (count - 1))));
  return nodes;
}

/// Lagrange's polynomials at t.
Eigen::VectorXd weights(const std::vector<double>& nodes, double t) {
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::VectorXd w = Eigen::VectorXd::Ones(n);
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index l = 0; l < n; ++l)
      if (l != k) w(k) *= (t - nodes[static_cast<std::size_t>(l)]) / (nodes[static_cast<std::size_t>(k)] - nodes[static_cast<std::size_t>(l)]);
  return w;
}

/// A lattice up to the ends, then points between by the additive recurrence of the plastic number, which leaves no gaps.
std::vector<FamilyPoint> check_points() {
  std::vector<FamilyPoint> shares;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) shares.push_back({0.25 * i, 0.25 * j});
  constexpr double plastic = 1.3247179572447460;
  double x = 0.5, y = 0.5;
  for (int k = 0; k < 16; ++k) {
    x = std::fmod(x + 1 / plastic, 1.0);
    y = std::fmod(y + 1 / (plastic * plastic), 1.0);
    shares.push_back({x, y});
  }
  return shares;
}

/// A load whose components swing together, turned to be real.
std::optional<Eigen::VectorXd> real_load(const numerics::Load& load) {
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

PlainOrNot plain_design(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  if (assembled.frequency_dependent()) return {{}, "elements that depend on frequency in their own way"};
  if (m.lossy()) return {{}, "loss factors"};
  if (!m.symmetric) return {{}, "matrices that are not symmetric"};
  if (static_cast<Eigen::Index>(numerics::massive_rows(m.A).size()) < m.size()) return {{}, "coordinates without mass"};
  if (!loading.motion.vanishes()) return {{}, "a moving ground"};
  if (!loading.force.is_constant()) return {{}, "a force that changes with frequency"};
  const auto load = real_load(loading.force);
  if (!load) return {{}, "forces of different phases"};
  PlainDesign design{m.A, m.B, m.K, *load, {}, {}, {}};
  const auto answers = static_cast<Eigen::Index>(channels.size());
  design.rows = Eigen::MatrixXd::Zero(answers, m.size());
  design.rows_on_velocity = design.rows;
  for (Eigen::Index c = 0; c < answers; ++c) {
    const assembly::Channel& channel = channels[static_cast<std::size_t>(c)];
    const bool other = !channel.dynamic_forces.empty() || !channel.on_displacement.imag().isZero(0) || (channel.on_acceleration.size() > 0 && !channel.on_acceleration.isZero(0));
    if (other) return {{}, "forces of elements with mass or loss"};
    design.rows.row(c) = channel.on_displacement.real().transpose();
    if (channel.on_velocity.size() > 0) design.rows_on_velocity.row(c) = channel.on_velocity.transpose();
    design.derivative.push_back(channel.derivative);
  }
  return {std::move(design), ""};
}

Eigen::VectorXd DesignFamily::entries(const FamilyPoint& point) const {
  const Eigen::VectorXd x = weights(x_nodes_, logarithmic_ ? std::log(point.x) : point.x), y = weights(y_nodes_, logarithmic_ ? std::log(point.y) : point.y);
  const Eigen::MatrixXd both = x * y.transpose();
  return values_ * Eigen::Map<const Eigen::VectorXd>(both.data(), both.size());
}

std::optional<DesignFamily> DesignFamily::fitted(const Source& source, const FamilyVariable& x, const FamilyVariable& y) {
  struct Check {
    FamilyPoint point;
    Eigen::VectorXd entries, scale;
  };
  std::vector<Check> checks;
  DesignFamily family;
  for (const FamilyPoint& share : check_points()) {
    const FamilyPoint point{x.from + share.x * (x.to - x.from), y.from + share.y * (y.to - y.from)};
    const auto design = source(point);
    ++family.assembled_;
    if (!design) return std::nullopt;
    if (checks.empty()) family.first_ = *design;
    if (design->rows != family.first_.rows || design->rows_on_velocity != family.first_.rows_on_velocity || design->load.size() != family.first_.load.size()) return std::nullopt;
    checks.push_back({point, packed(*design), scales(*design)});
  }
  for (const int count : {2, 3, 5, 9})
    for (const bool logarithmic : {false, true}) {
      if (logarithmic && !(x.from > 0 && y.from > 0)) continue;
      const auto variable = [&](double value) { return logarithmic ? std::log(value) : value; };
      family.logarithmic_ = logarithmic;
      family.x_nodes_ = nodes_between(variable(x.from), variable(x.to), count);
      family.y_nodes_ = nodes_between(variable(y.from), variable(y.to), count);
      family.values_.resize(checks[0].entries.size(), count * count);
      for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
          const auto value = [&](const FamilyVariable& v, int k, double node) { return k == 0 ? v.from : k + 1 == count ? v.to : logarithmic ? std::exp(node) : node; };
          const auto design = source({value(x, i, family.x_nodes_[static_cast<std::size_t>(i)]), value(y, j, family.y_nodes_[static_cast<std::size_t>(j)])});
          ++family.assembled_;
          if (!design || design->load.size() != family.first_.load.size()) return std::nullopt;
          family.values_.col(j * count + i) = packed(*design);
        }
      family.worst_ = 0;
      for (const Check& check : checks) {
        const Eigen::ArrayXd difference = (family.entries(check.point) - check.entries).array().abs();
        for (Eigen::Index e = 0; e < difference.size(); ++e)
          if (difference(e) > 0) family.worst_ = std::max(family.worst_, difference(e) / check.scale(e));
      }
      if (family.worst_ <= reproduced_within) return family;
    }
  return std::nullopt;
}

numerics::Designs DesignFamily::designs(std::span<const FamilyPoint> points) const {
  const auto count = static_cast<Eigen::Index>(points.size()), n = first_.load.size(), triangle = n * (n + 1) / 2;
  const auto nx = static_cast<Eigen::Index>(x_nodes_.size()), ny = static_cast<Eigen::Index>(y_nodes_.size());
  numerics::Designs designs{Eigen::ArrayXXd(count, triangle), Eigen::ArrayXXd(count, triangle), Eigen::ArrayXXd(count, triangle), Eigen::ArrayXXd(count, n)};
  for (Eigen::Index first = 0; first < count;) {  // runs along x share what belongs to y
    const double y = points[static_cast<std::size_t>(first)].y;
    Eigen::Index last = first;
    while (last < count && points[static_cast<std::size_t>(last)].y == y) ++last;
    const Eigen::VectorXd of_y = weights(y_nodes_, logarithmic_ ? std::log(y) : y);
    Eigen::MatrixXd along_x = Eigen::MatrixXd::Zero(values_.rows(), nx);
    for (Eigen::Index j = 0; j < ny; ++j) along_x += of_y(j) * values_.middleCols(j * nx, nx);
    Eigen::MatrixXd of_x(last - first, nx);
    for (Eigen::Index d = first; d < last; ++d) {
      const double x = points[static_cast<std::size_t>(d)].x;
      of_x.row(d - first) = weights(x_nodes_, logarithmic_ ? std::log(x) : x).transpose();
    }
    Eigen::Index row = 0;
    for (Eigen::ArrayXXd* part : {&designs.A, &designs.B, &designs.K, &designs.load}) {
      part->middleRows(first, last - first).matrix().noalias() = of_x * along_x.middleRows(row, part->cols()).transpose();
      row += part->cols();
    }
    first = last;
  }
  return designs;
}

}  // namespace trivet::response
