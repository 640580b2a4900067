// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/design_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/index.h"

namespace trivet::design {
namespace {

constexpr int most_nodes_along_one = 17;  // along one number

/// Chebyshev nodes, both ends included.
std::vector<double> nodes_between(double from, double to, int count) {
  std::vector<double> nodes;
  for (int k = 0; k < count; ++k)
    nodes.push_back(k == 0 ? from
                        : k + 1 == count
                        ? to
                        : from + (to - from) * 0.5 * (1 - std::cos(std::numbers::pi * k / (count - 1))));
  return nodes;
}

/// The number at a node; exact at the ends of its range.
template <typename Along>
double node_value(const FamilyVariable& variable, const Along& along, std::size_t k) {
  if (k == 0) return variable.from;
  if (k + 1 == along.nodes.size()) return variable.to;
  return along.logarithmic ? std::exp(along.nodes[k]) : along.nodes[k];
}

/// Largest difference between entries, divided by their scales; infinite if one is NaN.
double difference(const Eigen::VectorXd& interpolated, const Eigen::VectorXd& exact, const Eigen::VectorXd& scale) {
  assert(interpolated.size() == exact.size() && scale.size() == exact.size());
  double worst = 0;
  for (Eigen::Index e = 0; e < exact.size(); ++e)
    if (interpolated(e) != exact(e)) {
      const double one = std::abs(interpolated(e) - exact(e)) / scale(e);
      if (std::isnan(one)) return std::numeric_limits<double>::infinity();
      worst = std::max(worst, one);
    }
  return worst;
}

/// A lattice up to the ends, then points between by the additive recurrence of the plastic number, which fills the area
/// evenly.
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

}  // namespace

template <typename Design>
Eigen::VectorXd DesignFamily<Design>::Along::weights(double value) const {
  const double t = logarithmic ? std::log(value) : value;
  Eigen::VectorXd w = Eigen::VectorXd::Ones(to_index(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (std::size_t l = 0; l < nodes.size(); ++l)
      if (l != k) w(to_index(k)) *= (t - nodes[l]) / (nodes[k] - nodes[l]);
  // Lagrange's polynomials add up to 1; they cancel by the Lebesgue constant of the nodes, which is small.
  assert(std::abs(w.sum() - 1) <= 1e-9 * w.cwiseAbs().sum());
  return w;
}

template <typename Design>
Eigen::VectorXd DesignFamily<Design>::entries(const FamilyPoint& point) const {
  const Eigen::MatrixXd both = x_.weights(point.x) * y_.weights(point.y).transpose();
  return values_ * Eigen::Map<const Eigen::VectorXd>(both.data(), both.size());
}

template <typename Design>
std::optional<typename DesignFamily<Design>::Along> DesignFamily<Design>::fitted_along(
    const std::function<std::optional<Design>(double)>& source, const FamilyVariable& variable) {
  constexpr double golden = 0.6180339887498949;
  constexpr int checks = 7;
  std::vector<double> at;
  std::vector<Eigen::VectorXd> exact, scale;
  for (int k = 1; k <= checks; ++k) {
    at.push_back(variable.from + std::fmod(k * golden, 1.0) * (variable.to - variable.from));
    const auto design = source(at.back());
    if (!design) return std::nullopt;
    exact.push_back(packed(*design));
    scale.push_back(scales(*design));
  }
  for (const int count : {2, 3, 5, 9, most_nodes_along_one})
    for (const bool logarithmic : {false, true}) {
      if (logarithmic && !(variable.from > 0)) continue;
      Along along{logarithmic,
                  logarithmic ? nodes_between(std::log(variable.from), std::log(variable.to), count)
                              : nodes_between(variable.from, variable.to, count)};
      Eigen::MatrixXd values(exact[0].size(), count);
      for (int k = 0; k < count; ++k) {
        const auto design = source(node_value(variable, along, to_size(k)));
        if (!design) return std::nullopt;
        values.col(k) = packed(*design);
      }
      bool good = true;
      for (std::size_t k = 0; k < at.size() && good; ++k) {
        const Eigen::VectorXd interpolated = values * along.weights(at[k]);
        good = difference(interpolated, exact[k], scale[k]) <= reproduced_within;
      }
      if (good) return along;
    }
  return std::nullopt;
}

template <typename Design>
FamilyOrReason<Design> DesignFamily<Design>::fitted(const Source& source, const FamilyVariable& x,
                                                    const FamilyVariable& y) {
  DesignFamily family;
  std::string reason;
  bool has_first = false;
  const auto design_at = [&](const FamilyPoint& point) -> std::optional<Design> {
    DesignOrReason<Design> found = source(point);
    reason = found.design ? has_first ? reason_for_separate_families(family.first_, *found.design) : "" : found.reason;
    if (reason.empty() && !has_first) family.first_ = *found.design, has_first = true;
    return reason.empty() ? std::move(found.design) : std::nullopt;
  };
  const auto not_met_along = [](const std::string& name) {
    return fmt::format("matrices that polynomials on {} nodes do not reproduce within {:.0e} along {}",
                       most_nodes_along_one, reproduced_within, name);
  };
  const auto declined = [&](const std::string& otherwise) -> FamilyOrReason<Design> {
    return {std::nullopt, reason.empty() ? otherwise : reason};
  };
  if (!design_at({x.from, y.from})) return declined("");
  const auto along_x = fitted_along([&](double value) { return design_at({value, 0.5 * (y.from + y.to)}); }, x);
  if (!along_x) return declined(not_met_along(x.name));
  const auto along_y = fitted_along([&](double value) { return design_at({0.5 * (x.from + x.to), value}); }, y);
  if (!along_y) return declined(not_met_along(y.name));
  family.x_ = *along_x;
  family.y_ = *along_y;
  const auto nx = family.x_.nodes.size(), ny = family.y_.nodes.size();
  family.values_.resize(packed(family.first_).size(), to_index(nx * ny));
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const auto design = design_at({node_value(x, family.x_, i), node_value(y, family.y_, j)});
      if (!design) return declined("");
      family.values_.col(to_index(j * nx + i)) = packed(*design);
    }
  for (const FamilyPoint& share : check_points()) {
    const FamilyPoint point{x.from + share.x * (x.to - x.from), y.from + share.y * (y.to - y.from)};
    const auto design = design_at(point);
    if (!design) return declined("");
    const double worst = difference(family.entries(point), packed(*design), scales(*design));
    if (worst > reproduced_within)
      return declined(
          fmt::format("matrices that the polynomials along {} and {} together do not reproduce within {:.0e}", x.name,
                      y.name, reproduced_within));
    family.worst_ = std::max(family.worst_, worst);
  }
  return {std::move(family), ""};
}

template <typename Design>
Eigen::MatrixXd DesignFamily<Design>::packed_designs(std::span<const FamilyPoint> points) const {
  const auto count = to_index(points.size());
  const auto nx = to_index(x_.nodes.size()), ny = to_index(y_.nodes.size());
  Eigen::MatrixXd result(count, values_.rows());
  for (Eigen::Index first = 0; first < count;) {  // points with the same y share its weights
    const double y = points[first].y;
    Eigen::Index last = first;
    while (last < count && points[last].y == y) ++last;
    const Eigen::VectorXd of_y = y_.weights(y);
    Eigen::MatrixXd along_x = Eigen::MatrixXd::Zero(values_.rows(), nx);
    for (Eigen::Index j = 0; j < ny; ++j) along_x += of_y(j) * values_.middleCols(j * nx, nx);
    Eigen::MatrixXd of_x(last - first, nx);
    for (Eigen::Index d = first; d < last; ++d) of_x.row(d - first) = x_.weights(points[d].x).transpose();
    result.middleRows(first, last - first).noalias() = of_x * along_x.transpose();
    first = last;
  }
  return result;
}

template class DesignFamily<PlainDesign>;
template class DesignFamily<DrivenDesign>;

}  // namespace trivet::design
