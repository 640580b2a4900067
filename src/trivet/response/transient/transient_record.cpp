// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/transient_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <set>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::response {

namespace {

/// A coefficient below this share of the largest of its kind is round-off.
constexpr double sum_round_off = 1e-12;

}  // namespace

LinearRows channel_rows(const StateSpace& space, const std::vector<assembly::Channel>& channels,
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
      used_(used_inputs(rows_)),
      kappas_(courses.size()),
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
  constexpr Eigen::Index block = 128, blocks_of_a_report = 8;
  const Eigen::Index count = (grid_.points + block - 1) / block, n = state.x.size();
  blocks_.every = block;
  blocks_.states.resize(n, count);
  blocks_.of_curve.assign(curves_.size(), std::vector<numerics::RowBlock>(to_size(count)));
  const Eigen::Index inputs = to_index(used_.size());
  Eigen::MatrixXd rows(rows_.on_state.rows(), n + inputs);
  rows.leftCols(n) = rows_.on_state;
  if (inputs > 0) rows.rightCols(inputs) = rows_.on_input(Eigen::all, used_);
  numerics::RowsOverTime values(rows, block);
  TimeSamples samples{0, Eigen::MatrixXd(rows.cols(), block + 1),
                      Eigen::MatrixXd(to_index(courses_.size()) * 5, block)};
  for (Eigen::Index b = 0; b < count; ++b) {
    const Eigen::Index first = b * block, points = samples.points = std::min(block, grid_.points - first);
    if (b % blocks_of_a_report == 0)
      foundation::report_progress(progress, "transient", static_cast<double>(b) / static_cast<double>(count));
    blocks_.states.col(b) = state.x;
    add_block(state, first, samples);
    if (!samples.X.col(points - 1).head(n).allFinite())
      throw foundation::NotComputable(fmt::format("transient: the motion exceeds the range of numbers before {:.4g} s",
                                                  grid_.time(first + points - 1)));
    values.evaluate(samples.X.leftCols(points));
    keep(values, first, points);
  }
  add_extremes_at_points();
}

void TransientRecord::add_block(StepperState& state, Eigen::Index first, TimeSamples& samples) {
  const Eigen::Index n = state.x.size(), count = samples.points;
  assert(std::abs(state.time - grid_.time(first)) <= grid_.resolution && "blocks begin at points of the grid");
  for (Eigen::Index i = 0; i < count;) {
    const Eigen::Index most = std::min(count - i, grid_.points - 1 - (first + i));
    samples.X.col(i).head(n) = state.x;
    for (std::size_t c = 0; c < courses_.size(); ++c) kappas_[c] = courses_[c].kappa(state.places[c]);
    const Eigen::Index steps = stepper_.take_whole_steps(
        state, grid_, first + i, held_, samples.X.block(0, i, n, most + 1), samples.w.middleCols(i, most));
    if (steps > 0) {
      add_inputs(i, steps, samples);
      i += steps;
      continue;
    }
    stepper_.inputs(state, inputs_);
    samples.X.col(i).tail(to_index(used_.size())) = inputs_(used_);
    ++i;
    if (first + i < grid_.points) to_next_point(state, grid_.time(first + i));
  }
}

void TransientRecord::add_inputs(Eigen::Index begin, Eigen::Index count, TimeSamples& samples) const {
  const Eigen::Index n = samples.X.rows() - to_index(used_.size());
  for (std::size_t j = 0; j < used_.size(); ++j) {
    const Eigen::Index course = used_[j] / input_derivatives;
    const double kappa = kappas_[course];
    Eigen::Index m = used_[j] % input_derivatives;
    assert(course < to_index(kappas_.size()));
    double factor = 1;
    for (; m > 4; m -= 2) factor *= -kappa * kappa;
    samples.X.row(n + to_index(j)).segment(begin, count) = factor * samples.w.row(course * 5 + m).segment(begin, count);
  }
}

void TransientRecord::to_next_point(StepperState& state, double to) {
  for (double corner = stepper_.next_corner(state); corner <= to + stepper_.resolution();
       corner = stepper_.next_corner(state)) {
    stepper_.advance_to_corner(state, std::min(corner, to));
    const bool jump = channels_jump(state, corner);
    if (jump) note(state);
    stepper_.apply_corners(state);
    if (jump) note(state);
  }
  if (state.time != to) stepper_.advance_to_corner(state, to);
}

bool TransientRecord::channels_jump(const StepperState& state, double corner) const {
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

void TransientRecord::keep(const numerics::RowsOverTime& values, Eigen::Index first, Eigen::Index count) {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    values.copy_row(to_index(k), curves_[k].values.segment(first, count));
    blocks_.of_curve[k][first / blocks_.every] = values.block(to_index(k));
  }
}

void TransientRecord::add_extremes_at_points() {
  const auto less = [](double numerics::RowBlock::* value) {
    return [value](const numerics::RowBlock& a, const numerics::RowBlock& b) { return a.*value < b.*value; };
  };
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    TimeCurve& curve = curves_[k];
    const std::vector<numerics::RowBlock>& blocks = blocks_.of_curve[k];
    const auto position = [&](const auto& block, double value) {
      const Eigen::Index first = (block - blocks.begin()) * blocks_.every;
      const double* begin = curve.values.data() + first;
      return grid_.time(first +
                        (std::find(begin, begin + std::min(blocks_.every, grid_.points - first), value) - begin));
    };
    const auto largest = std::ranges::max_element(blocks, less(&numerics::RowBlock::largest)),
               smallest = std::ranges::min_element(blocks, less(&numerics::RowBlock::smallest));
    if (largest->largest > curve.largest.value) curve.largest = {largest->largest, position(largest, largest->largest)};
    if (smallest->smallest < curve.smallest.value)
      curve.smallest = {smallest->smallest, position(smallest, smallest->smallest)};
  }
}

}  // namespace trivet::response
