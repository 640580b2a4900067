// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/transient.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/response/transient/time_grid.h"
#include "trivet/response/transient/time_stepper.h"
#include "trivet/response/transient/transient_record.h"
#include "trivet/response/transient/transient_refusals.h"

namespace trivet::response {
namespace {

/// All inputs as courses, one per signal and delay.
struct Inputs {
  std::vector<InputCourse> courses;
  std::vector<Drive> drives;
  std::vector<std::string> names;

  void add(const std::string& name, const excitation::Signal& signal, double delay, Drive drive) {
    const bool integrals = !drive.force.leftCols<of_value>().isZero(0) || !drive.ground.leftCols<of_value>().isZero(0);
    courses.emplace_back(signal, delay,
                         integrals ? InputCourse::Integrals::needed : InputCourse::Integrals::not_needed);
    drives.push_back(std::move(drive));
    names.push_back(name);
  }
};

/// A ground motion given by velocity or acceleration may drift far, while the system hardly moves relative to it: then
/// the coordinates move with the ground.
assembly::Loading in_coordinates_of_time(const assembly::Ground& ground, const assembly::Loading& loading) {
  return !loading.motion.vanishes() && loading.motion.lowest_power() < 0 ? assembly::following(ground, loading)
                                                                         : loading;
}

void add_input(const assembly::Assembled& assembled, const TimeInput& input, Inputs& all) {
  if (input.loading.force.size() != assembled.layout.size() ||
      (!input.loading.motion.vanishes() && input.loading.motion.size() != assembled.ground.size()))
    throw foundation::InvalidInput(fmt::format("input \"{}\": its loading belongs to another model", input.name));
  excitation::require_valid(input.signal);
  std::vector<double> delays;
  std::vector<Drive> drives;
  const auto add = [&](const numerics::LoadTerm& term, InputMatrix Drive::* part) {
    if (term.power < -2 || term.power > 2)
      throw foundation::InvalidInput(
          fmt::format("input \"{}\": derivative {} of its signal; −2 … 2 are allowed in time", input.name, term.power));
    if (!term.value.imag().isZero(0))
      throw foundation::InvalidInput(
          fmt::format("input \"{}\": a phase has no meaning for a time history; give a delay", input.name));
    auto known = std::ranges::find(delays, term.delay);
    const auto c = to_size(known - delays.begin());
    if (known == delays.end()) {
      delays.push_back(term.delay);
      drives.push_back({InputMatrix::Zero(assembled.layout.size(), 5), InputMatrix::Zero(assembled.ground.size(), 5)});
    }
    (drives[c].*part).col(of_value + term.power) += term.value.real();
  };
  const assembly::Loading loading = in_coordinates_of_time(assembled.ground, input.loading);
  const numerics::Load force = assembly::right_side(assembled, loading);
  for (const numerics::LoadTerm& term : force.terms()) add(term, &Drive::force);
  for (const numerics::LoadTerm& term : loading.motion.terms()) add(term, &Drive::ground);
  for (std::size_t c = 0; c < delays.size(); ++c) all.add(input.name, input.signal, delays[c], std::move(drives[c]));
}

StepperState first_state(const StateSpace& space, const Inputs& inputs, const TransientOptions& options) {
  StepperState state{0, Eigen::VectorXd::Zero(space.size()),
                     std::vector<InputCourse::Place>(inputs.courses.size(), -1)};
  if (!options.initial) return state;
  const Eigen::Index n = space.displacements().on_state.rows();
  for (const Eigen::VectorXd* each : {&options.initial->displacement, &options.initial->velocity})
    if (each->size() != n || !each->allFinite())
      throw foundation::InvalidInput(fmt::format(
          "transient: the initial state has {} numbers; it needs {} finite ones, one for each free coordinate",
          each->size(), n));
  state.x = space.state(options.initial->displacement, options.initial->velocity);
  return state;
}

/// Subtracts the motion R g, with which the coordinates move, from a state of absolute displacements and velocities.
void subtract_followed(const StateSpace& space, const assembly::Ground& ground, const Inputs& inputs, double time,
                       StepperState& state) {
  for (std::size_t c = 0; c < inputs.courses.size(); ++c) {
    const InputVector w = inputs.courses[c].at(state.places[c], time);
    const InputMatrix followed = inputs.drives[c].ground.bottomRows(ground.followed());
    state.x -= space.state(ground.R * (followed * w),
                           ground.R * (followed * rate(w, inputs.courses[c].kappa(state.places[c]))));
  }
}

/// Advances the state to the first point of the grid.
void go_to_first_point(TimeStepper& stepper, const StateSpace& space, const assembly::Ground& ground,
                       const Inputs& inputs, const TimeGrid& grid, bool from_rest, StepperState& state) {
  state.time = grid.start;
  if (!from_rest) {
    for (std::size_t c = 0; c < inputs.courses.size(); ++c)
      state.places[c] = inputs.courses[c].place_at(grid.from, -grid.resolution);
    subtract_followed(space, ground, inputs, grid.from, state);
  }
  stepper.apply_corners(state);
  stepper.advance(state, grid.from);
}

void warn_of_growth(const StateSpace& space, double duration, foundation::Problems& warnings) {
  constexpr double visible = 1e-3;
  double growth = 0;
  const auto raise = [&](const Eigen::MatrixXd& rates) {
    const Eigen::VectorXcd eigenvalues = numerics::general_eigenvalues(rates).values;
    for (const std::complex<double>& lambda : eigenvalues) growth = std::max(growth, lambda.real());
  };
  const Eigen::Index pairs = space.groups().pairs;
  for (Eigen::Index j = 0; j < pairs; ++j) {
    const std::vector<Eigen::Index> pair = {j, pairs + j};
    raise(space.F()(pair, pair));
  }
  Eigen::Index first = 2 * pairs;
  for (const Eigen::Index size : space.groups().dense) {
    raise(space.F().block(first, first, size, size));
    first += size;
  }
  if (growth * duration <= visible) return;
  warnings.warning("transient", fmt::format("a free motion grows and doubles every {:.4g} s", std::log(2.0) / growth),
                   "the system is unstable about its position of rest; the results are those of the linear equations",
                   "look for negative stiffness or damping; see the roots");
}

double root_mean_square(const TimeCurve& curve, const std::vector<numerics::RowBlock>& blocks) {
  constexpr double least_squares = 1e-280, most_squares = 1e280;  // no square leaves the range of numbers
  const Eigen::Index last = curve.values.size() - 1;
  assert(last > 0 && "a grid has two points at least");
  const double scale = std::max(curve.largest.value, -curve.smallest.value);
  if (scale == 0 || !std::isfinite(scale)) return scale;
  const auto mean = [&](double squares, double unit) {
    return std::max(0.0, squares - (std::pow(curve.values(0) * unit, 2) + std::pow(curve.values(last) * unit, 2)) / 2) /
        static_cast<double>(last);
  };
  double squares = 0;
  for (const numerics::RowBlock& block : blocks) squares += block.squares;
  if (squares > least_squares && squares < most_squares) return std::sqrt(mean(squares, 1));
  return scale * std::sqrt(mean((curve.values / scale).squaredNorm(), 1 / scale));
}

/// The stored values grow with points × results, and their file is about three times as large.
void require_enough_memory(const TimeGrid& grid, std::size_t channels) {
  constexpr double most_bytes = 2e9;
  const double bytes = static_cast<double>(grid.points) * static_cast<double>(channels + 1) * sizeof(double);
  if (bytes > most_bytes)
    throw foundation::NotComputable(
        fmt::format("transient: {} points × {} results and the time need {:.3g} GB; at most {:.3g} GB are allowed: "
                    "take a longer step, a shorter time or fewer results",
                    grid.points, channels, bytes / 1e9, most_bytes / 1e9));
}

TransientResponse response_of(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                              const std::vector<TimeInput>& given, const TransientOptions& options,
                              const foundation::Progress& progress) {
  Inputs inputs;
  for (const TimeInput& input : given) add_input(assembled, input, inputs);
  const StateSpace modal(assembled.matrices, inputs.drives);
  TransientResponse result;
  const std::vector<ExcitedMode> modes = excited_modes(modal, inputs.courses, first_state(modal, inputs, options).x);
  const StateSpace space = modal.decoupled();
  StepperState state = first_state(space, inputs, options);
  const TimeGrid grid = time_grid(options, modes, inputs.courses, inputs.names, result.warnings);
  require_enough_memory(grid, channels.size());
  const double end = grid.time(grid.points - 1);
  warn_of_growth(space, end - grid.start, result.warnings);
  const LinearRows rows = channel_rows(space, channels, inputs.drives);
  warn_of_impulses(rows, channels, inputs.courses, inputs.names, result.warnings);

  TimeStepper stepper(space, inputs.courses, grid.step, grid.resolution);
  go_to_first_point(stepper, space, assembled.ground, inputs, grid, !options.initial, state);
  TransientRecord record(stepper, inputs.courses, rows, grid);
  record.run(state, progress);
  result.time = Eigen::VectorXd::LinSpaced(grid.points, 0, static_cast<double>(grid.points - 1)) * grid.step;
  result.time.array() += grid.from;
  result.curves = record.release_curves();
  for (std::size_t k = 0; k < channels.size(); ++k) {
    TimeCurve& curve = result.curves[k];
    const auto row = to_index(k);
    curve.name = channels[k].name;
    curve.unit = channels[k].unit;
    curve.rms = root_mean_square(curve, record.blocks().of_curve[k]);
    if (!std::isfinite(curve.rms))
      throw foundation::NotComputable(
          fmt::format("transient: \"{}\" exceeds the range of numbers before {:.4g} s", curve.name, end));
    const LinearRows here{rows.on_state.row(row),
                          rows.on_input.cols() > 0 ? Eigen::MatrixXd(rows.on_input.row(row)) : Eigen::MatrixXd(1, 0)};
    const foundation::Progress of_channel = [&](std::string_view task, double fraction) {
      foundation::report_progress(progress, task,
                                  (static_cast<double>(k) + fraction) / static_cast<double>(channels.size()));
    };
    search_between_points(stepper, space, here, k, grid, record.blocks(), of_channel, curve);
  }
  return result;
}

}  // namespace

InitialState initial_state(const assembly::Assembled& assembled, const Eigen::VectorXd& displacement,
                           const Eigen::VectorXd& velocity) {
  const Eigen::Index bodies = assembled.layout.of_bodies(), others = assembled.layout.size() - bodies;
  if (displacement.size() != bodies || velocity.size() != bodies)
    throw foundation::InvalidInput(
        fmt::format("the initial state has {} displacements and {} velocities, but the bodies have {} free coordinates",
                    displacement.size(), velocity.size(), bodies));
  InitialState state{Eigen::VectorXd::Zero(bodies + others), Eigen::VectorXd::Zero(bodies + others)};
  state.displacement.head(bodies) = displacement;
  state.velocity.head(bodies) = velocity;
  if (others == 0) return state;
  const Eigen::VectorXd d = numerics::unit_scale(assembled.matrices).tail(others);
  const Eigen::MatrixXd& K = assembled.matrices.K;
  const Eigen::MatrixXd held = d.asDiagonal() * K.bottomRightCorner(others, others) * d.asDiagonal();
  for (Eigen::VectorXd* each : {&state.displacement, &state.velocity}) {
    const Eigen::VectorXd load = d.asDiagonal() * (K.bottomLeftCorner(others, bodies) * each->head(bodies));
    each->tail(others) = -(d.asDiagonal() * numerics::smallest_solution(held, load)).eval();
  }
  return state;
}

TransientResponse transient_response(const model::System& system, const assembly::Assembled& assembled,
                                     const std::vector<assembly::Channel>& channels,
                                     const std::vector<TimeInput>& inputs, const TransientOptions& options,
                                     const foundation::Progress& progress) {
  if (inputs.empty() && !options.initial)
    throw foundation::InvalidInput("transient: neither an input nor an initial state drives the model");
  const bool at_rest = std::ranges::all_of(inputs, [](const TimeInput& input) { return input.loading.vanishes(); });
  if (at_rest && !options.initial && !options.to)
    throw foundation::InvalidInput("transient: all components of its excitations are 0; give a direction");
  require_constant_coefficients(system, assembled, inputs, options.nearest_linear_system);
  if (!assembled.frequency_dependent()) return response_of(assembled, channels, inputs, options, progress);
  std::vector<assembly::Channel> own;
  for (const assembly::Channel& channel : channels) own.push_back(nearest_linear(assembled, channel));
  TransientResponse result = response_of(nearest_linear(assembled), own, inputs, options, progress);
  result.warnings.warning("transient", "frequency-dependent elements are replaced by their nearest linear system",
                          "their exact law has no constant matrices, which a transient needs",
                          "compare its frequency response with the exact one");
  return result;
}

}  // namespace trivet::response
