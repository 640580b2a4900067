// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient_record.h"

#include <fmt/format.h>

#include <limits>

#include "trivet/foundation/invalid_input.h"
#include "trivet/response/transient_rows.h"

namespace trivet::response {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Jumps below this share of the largest value are round-off of joints.
constexpr double round_off = 1e-9;

/// Which pieces of a course begin with a jump of something that an answer holds: of u, u̇, ü (and of what follows from them where κ > 0).
std::vector<bool> jumps_of(const InputCourse& course, const Eigen::Ref<const Eigen::MatrixXd>& on_input, bool state_jumps) {
  Eigen::Array3d largest = Eigen::Array3d::Zero();
  for (InputCourse::Place i = 0; i < course.count(); ++i) largest = largest.max(course.at(i, course.next_corner(i - 1)).tail<3>().array().abs());
  std::vector<bool> jumps;
  for (InputCourse::Place i = 0; i < course.count(); ++i) {
    const Eigen::Array3d jump = course.jump_into(i).tail<3>().array().abs();
    bool found = false;
    for (Eigen::Index m = 0; m < 3; ++m) {
      const Eigen::Index columns = m < 2 ? 1 : input_derivatives - of_value - 2;
      const bool used = (state_jumps && m < 2) || !on_input.middleCols(of_value + m, columns).isZero(0);
      found = found || (used && jump(m) > round_off * largest(m));
    }
    jumps.push_back(found);
  }
  return jumps;
}

}  // namespace

TransientRecord::TransientRecord(TransientWalk& walk, const std::vector<InputCourse>& courses, LinearRows rows, const TimeGrid& grid)
    : walk_(walk), courses_(courses), rows_(std::move(rows)), grid_(grid), values_(grid.points, rows_.on_state.rows()),
      largest_(static_cast<std::size_t>(rows_.on_state.rows()), {-infinity, 0}), smallest_(largest_.size(), {infinity, 0}), inputs_(rows_.on_input.cols()) {
  for (std::size_t c = 0; c < courses.size(); ++c)
    jumps_.push_back(jumps_of(courses[c], rows_.on_input.middleCols(static_cast<Eigen::Index>(c) * input_derivatives, input_derivatives),
                              walk.state_jumps(c)));
}

void TransientRecord::run(WalkState state, const foundation::Progress& progress) {
  constexpr Eigen::Index block = 256;
  checkpoints_ = {block, {}};
  const std::vector<Eigen::Index> used = used_inputs(rows_);
  const Eigen::MatrixXd on_used = rows_.on_input(Eigen::all, used);
  Eigen::MatrixXd X(state.x.size(), block), W(static_cast<Eigen::Index>(used.size()), block), Y;
  for (Eigen::Index first = 0; first < grid_.points; first += block) {
    foundation::report_progress(progress, "transient", static_cast<double>(first) / static_cast<double>(grid_.points));
    checkpoints_.states.push_back(state);
    const Eigen::Index count = std::min(block, grid_.points - first);
    for (Eigen::Index i = 0; i < count; ++i) {
      X.col(i) = state.x;
      if (!used.empty()) walk_.inputs(state, inputs_);
      for (std::size_t j = 0; j < used.size(); ++j) W(static_cast<Eigen::Index>(j), i) = inputs_(used[j]);
      if (first + i + 1 < grid_.points) to_next_point(state, grid_.time(first + i + 1));
    }
    if (!X.leftCols(count).allFinite())
      throw foundation::NotComputable(fmt::format("transient: the motion outgrows all numbers before {:.4g} s", grid_.time(first + count - 1)));
    Y.noalias() = X.leftCols(count).transpose() * rows_.on_state.transpose();
    Y.noalias() += W.leftCols(count).transpose() * on_used.transpose();
    values_.middleRows(first, count) = Y;
  }
}

void TransientRecord::to_next_point(WalkState& state, double to) {
  for (double corner = walk_.next_corner(state); corner <= to + walk_.resolution(); corner = walk_.next_corner(state)) {
    walk_.glide(state, std::min(corner, to));
    const bool jump = answers_jump(state, corner);
    if (jump) note(state);
    walk_.take_corners(state);
    if (jump) note(state);
  }
  if (state.time != to) walk_.glide(state, to);
}

bool TransientRecord::answers_jump(const WalkState& state, double corner) const {
  for (std::size_t c = 0; c < courses_.size(); ++c)
    if (courses_[c].next_corner(state.places[c]) <= corner + walk_.resolution() && jumps_[c][static_cast<std::size_t>(state.places[c] + 1)]) return true;
  return false;
}

void TransientRecord::note(const WalkState& state) {
  walk_.inputs(state, inputs_);
  for (std::size_t k = 0; k < largest_.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const double value = rows_.on_state.row(row).dot(state.x) + rows_.on_input.row(row).dot(inputs_);
    if (value > largest_[k].value) largest_[k] = {value, state.time};
    if (value < smallest_[k].value) smallest_[k] = {value, state.time};
  }
}

Extreme TransientRecord::largest(Eigen::Index answer) const {
  Eigen::Index at = 0;
  const double value = values_.col(answer).maxCoeff(&at);
  const Extreme& jump = largest_[static_cast<std::size_t>(answer)];
  return jump.value > value ? jump : Extreme{value, grid_.time(at)};
}

Extreme TransientRecord::smallest(Eigen::Index answer) const {
  Eigen::Index at = 0;
  const double value = values_.col(answer).minCoeff(&at);
  const Extreme& jump = smallest_[static_cast<std::size_t>(answer)];
  return jump.value < value ? jump : Extreme{value, grid_.time(at)};
}

}  // namespace trivet::response
