// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/transient_rows.h"

#include <fmt/format.h>

#include <set>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

/// A coefficient below this share of the largest of its kind is round-off.
constexpr double sum_round_off = 1e-12;

}  // namespace

LinearRows answer_rows(const StateSpace& space, const std::vector<assembly::Channel>& channels,
                       const std::vector<Drive>& courses) {
  const LinearRows& q = space.displacements();
  const LinearRows velocity = space.derivative(q), acceleration = space.derivative(velocity);
  const auto count = to_index(channels.size());
  LinearRows rows{Eigen::MatrixXd::Zero(count, q.on_state.cols()), Eigen::MatrixXd::Zero(count, q.on_input.cols())};
  for (Eigen::Index i = 0; i < count; ++i) {
    const assembly::Channel& channel = channels[i];
    const Eigen::RowVectorXd k = channel.on_displacement.real().transpose();
    const Eigen::RowVectorXd b = channel.on_velocity.transpose(), a = channel.on_acceleration.transpose();
    LinearRows row{k * q.on_state, k * q.on_input};
    if (!b.isZero(0)) row.on_state += b * velocity.on_state, row.on_input += b * velocity.on_input;
    if (!a.isZero(0)) row.on_state += a * acceleration.on_state, row.on_input += a * acceleration.on_input;
    for (std::size_t c = 0; c < courses.size() && !channel.ground.empty(); ++c) {
      const Eigen::Index first = to_index(c) * input_derivatives;
      row.on_input.middleCols<5>(first) += channel.ground.on_displacement.real().transpose() * courses[c].ground;
      row.on_input.middleCols<5>(first + 1) += channel.ground.on_velocity.transpose() * courses[c].ground;
      row.on_input.middleCols<5>(first + 2) += channel.ground.on_acceleration.transpose() * courses[c].ground;
    }
    for (int d = 0; d < channel.derivative; ++d) row = space.derivative(row);
    rows.on_state.row(i) = row.on_state;
    if (row.on_input.size() > 0) rows.on_input.row(i) = row.on_input;  // none without inputs
  }
  return rows;
}

std::vector<Eigen::Index> used_inputs(const LinearRows& rows) {
  std::vector<Eigen::Index> used;
  for (Eigen::Index j = 0; j < rows.on_input.cols(); ++j)
    if (!rows.on_input.col(j).isZero(0)) used.push_back(j);
  return used;
}

void warn_of_impulses(const LinearRows& rows, const std::vector<assembly::Channel>& channels,
                      const std::vector<InputCourse>& courses, const std::vector<std::string>& names,
                      foundation::Problems& warnings) {
  std::set<std::string> warned;
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const int first = courses[c].smoothness() + 1;  // this derivative of u is infinite somewhere
    if (courses[c].count() == 0 || first > 2 || warned.count(names[c])) continue;
    const Eigen::Index from = to_index(c) * input_derivatives + of_value + first,
                       count = input_derivatives - of_value - first;
    const double scale = rows.on_input.middleCols(from, count).cwiseAbs().maxCoeff();
    std::string list;
    int found = 0;
    for (Eigen::Index i = 0; i < rows.on_input.rows() && scale > 0; ++i) {
      if (!(rows.on_input.row(i).segment(from, count).cwiseAbs().maxCoeff() > sum_round_off * scale)) continue;
      if (++found <= 3) list += (list.empty() ? "" : ", ") + channels[i].name;
    }
    if (found == 0) continue;
    warned.insert(names[c]);
    warnings.warning(
        names[c],
        fmt::format("{} of the given motion while {}{} depend on its {}", first == 1 ? "jumps" : "corners", list,
                    found > 3 ? fmt::format(" and {} more", found - 3) : "", first == 1 ? "velocity" : "acceleration"),
        "each jump gives these results an impulse of zero duration; the later motion includes it, but no curve can "
        "show it",
        first == 1 ? "let the motion rise within a short time" : "give its acceleration, or a motion without corners");
  }
}

}  // namespace trivet::response
