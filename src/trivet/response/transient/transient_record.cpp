// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/transient_record.h"

#include <fmt/format.h>

#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/transient/transient_rows.h"

namespace trivet::response {
namespace {

using foundation::infinity;
/// Bit m if results jump with the mth derivative of u (or, with κ > 0, with derivatives that follow from it).
int held_derivatives(const Eigen::Ref<const Eigen::MatrixXd>& on_input, bool state_jumps) {
  int held = state_jumps ? 3 : 0;
  for (Eigen::Index m = 0; m < 3; ++m) {
    const Eigen::Index columns = m < 2 ? 1 : input_derivatives - of_value - 2;
    if (!on_input.middleCols(of_value + m, columns).isZero(0)) held |= 1 << m;
  }
  return held;
}

}  // namespace

TransientRecord::TransientRecord(TimeStepper& stepper, const std::vector<InputCourse>& courses, LinearRows rows,
                                 const TimeGrid& grid)
    : stepper_(stepper),
      courses_(courses),
      rows_(std::move(rows)),
      grid_(grid),
      curves_(to_size(rows_.on_state.rows())),
      inputs_(rows_.on_input.cols()) {
  for (std::size_t c = 0; c < courses.size(); ++c)
    held_.push_back(held_derivatives(rows_.on_input.middleCols(to_index(c) * input_derivatives, input_derivatives),
                                     stepper.state_jumps(c)));
  for (TimeCurve& curve : curves_) {
    curve.values.resize(grid.points);
    curve.largest.value = -infinity;
    curve.smallest.value = infinity;
  }
}

void TransientRecord::run(StepperState state, const foundation::Progress& progress) {
  constexpr Eigen::Index block = 256;
  checkpoints_ = {block, {}};
  const std::vector<Eigen::Index> used = used_inputs(rows_);
  const Eigen::MatrixXd on_used = rows_.on_input(Eigen::all, used);
  Eigen::MatrixXd X(state.x.size(), block), W(to_index(used.size()), block), Y;
  for (Eigen::Index first = 0; first < grid_.points; first += block) {
    foundation::report_progress(progress, "transient", static_cast<double>(first) / static_cast<double>(grid_.points));
    checkpoints_.states.push_back(state);
    const Eigen::Index count = std::min(block, grid_.points - first);
    for (Eigen::Index i = 0; i < count; ++i) {
      X.col(i) = state.x;
      if (!used.empty()) stepper_.inputs(state, inputs_);
      for (std::size_t j = 0; j < used.size(); ++j) W(to_index(j), i) = inputs_(used[j]);
      if (first + i + 1 < grid_.points) to_next_point(state, grid_.time(first + i + 1));
    }
    if (!X.leftCols(count).allFinite())
      throw foundation::NotComputable(fmt::format("transient: the motion exceeds the range of numbers before {:.4g} s",
                                                  grid_.time(first + count - 1)));
    Y.noalias() = X.leftCols(count).transpose() * rows_.on_state.transpose();
    Y.noalias() += W.leftCols(count).transpose() * on_used.transpose();
    keep(Y, first);
  }
}

void TransientRecord::to_next_point(StepperState& state, double to) {
  for (double corner = stepper_.next_corner(state); corner <= to + stepper_.resolution();
       corner = stepper_.next_corner(state)) {
    stepper_.advance_to_corner(state, std::min(corner, to));
    const bool jump = answers_jump(state, corner);
    if (jump) note(state);
    stepper_.apply_corners(state);
    if (jump) note(state);
  }
  if (state.time != to) stepper_.advance_to_corner(state, to);
}

bool TransientRecord::answers_jump(const StepperState& state, double corner) const {
  for (std::size_t c = 0; c < courses_.size(); ++c)
    for (int m = 0; m < 3; ++m)
      if ((held_[c] >> m & 1) != 0 && courses_[c].next_corner(state.places[c]) <= corner + stepper_.resolution() &&
          courses_[c].jumps(state.places[c] + 1, m))
        return true;
  return false;
}

void TransientRecord::note(const StepperState& state) {
  stepper_.inputs(state, inputs_);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const auto row = to_index(k);
    const double value =
        rows_.on_state.row(row).dot(state.x) + (inputs_.size() > 0 ? rows_.on_input.row(row).dot(inputs_) : 0);
    if (value > curves_[k].largest.value) curves_[k].largest = {value, state.time};
    if (value < curves_[k].smallest.value) curves_[k].smallest = {value, state.time};
  }
}

void TransientRecord::keep(const Eigen::MatrixXd& values, Eigen::Index first) {
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    TimeCurve& curve = curves_[to_size(k)];
    curve.values.segment(first, values.rows()) = values.col(k);
    Eigen::Index at = 0;
    if (values.col(k).maxCoeff() > curve.largest.value) {
      const double value = values.col(k).maxCoeff(&at);
      curve.largest = {value, grid_.time(first + at)};
    }
    if (values.col(k).minCoeff() < curve.smallest.value) {
      const double value = values.col(k).minCoeff(&at);
      curve.smallest = {value, grid_.time(first + at)};
    }
  }
}

}  // namespace trivet::response
