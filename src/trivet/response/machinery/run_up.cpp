// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/run_up.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <variant>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/resonant_mode.h"

namespace trivet::response {

namespace {

/// Orders of one excitation; empty if it does not depend on a shaft speed.
std::vector<excitation::Order> orders_of(const model::Excitation& excitation) {
  if (const auto* orders = std::get_if<model::Orders>(&excitation.course)) return orders->list;
  const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
  if (!harmonic || harmonic->power_of_frequency != 2 || !excitation.action.body) return {};
  return {{1, excitation.action.amplitude, excitation::ComplexVector6::Zero()}};
}

/// Adds `factor` (iω)^power times the force of the action.
void add_force(const assembly::Assembled& assembled, model::Action action, const excitation::ComplexVector6& amplitude,
               int power, double factor, assembly::Loading& total) {
  action.amplitude = factor * amplitude;
  const assembly::Loading one = assembly::loading(assembled, action);
  for (const numerics::LoadTerm& term : one.force.terms())
    total.force.add({term.power + power, term.delay, term.value});
}

OrderLoading& entry_of(std::vector<OrderLoading>& list, double order, const assembly::Assembled& assembled) {
  const auto found = std::ranges::find(list, order, &OrderLoading::order);
  if (found != list.end()) return *found;
  return list.emplace_back(
      OrderLoading{order, {numerics::Load(assembled.layout.size()), numerics::Load(assembled.ground.size())}, {}});
}

}  // namespace

std::vector<OrderLoading> order_loadings(const model::System& system, const assembly::Assembled& assembled,
                                         const std::vector<std::string>& selected) {
  const auto& excitations = system.description().excitations;
  for (const std::string& name : selected)
    if (std::ranges::none_of(excitations,
                             [&](const model::Excitation& e) { return e.name == name && !orders_of(e).empty(); }))
      throw foundation::InvalidInput("\"" + name + "\" is not an order excitation or unbalance of this model");
  std::vector<OrderLoading> result;
  for (const model::Excitation& excitation : excitations) {
    if (!model::is_selected(excitation, selected)) continue;
    for (const excitation::Order& order : orders_of(excitation)) {
      if (!(order.order > 0))
        throw foundation::InvalidInput("\"" + excitation.name + "\" has an order that is not > 0");
      OrderLoading& entry = entry_of(result, order.order, assembled);
      // Ω² = −s²/order²
      add_force(assembled, excitation.action, order.per_speed_squared, 2, -1 / (order.order * order.order),
                entry.loading);
      add_force(assembled, excitation.action, order.fixed, 0, 1, entry.loading);
      entry.excitations.push_back(excitation.name);
    }
  }
  std::ranges::sort(result, {}, &OrderLoading::order);
  return result;
}

namespace {

using foundation::infinity;

/// Sorts ascending and removes speeds that are equal within round-off.
void sort_apart(std::vector<double>& speed) {
  constexpr double same = 1e-13;
  std::ranges::sort(speed);
  speed.erase(std::ranges::unique(speed, [](double a, double b) { return b - a <= same * b; }).begin(), speed.end());
}

void note_critical(const Peaks& found, double order, std::vector<CriticalSpeed>& critical) {
  for (const Peak& peak : found.list)
    critical.push_back({peak.curve, order, peak.angular_frequency / order, peak.angular_frequency, peak.amplitude,
                        peak.prominence, 0, peak.nearest_mode});
}

void set_relative_heights(std::size_t curves, std::vector<CriticalSpeed>& critical) {
  std::vector<double> highest(curves, 0);
  for (const CriticalSpeed& c : critical) highest[c.curve] = std::max(highest[c.curve], c.amplitude);
  for (CriticalSpeed& c : critical)
    c.relative_height = c.amplitude == highest[c.curve] ? 1 : c.amplitude / highest[c.curve];
}

/// Adds speeds around a resonance at multiples of |Re λ| of its root.
void add_around(const CriticalSpeed& critical, const Eigen::VectorXcd& poles, std::vector<double>& speed) {
  Eigen::Index nearest = 0;
  (poles.array() - std::complex<double>(0, critical.angular_frequency)).abs().minCoeff(&nearest);
  const double width = std::max(std::abs(poles(nearest).real()), 1e-6 * critical.angular_frequency);
  for (const double t : {0.25, 0.5, 0.8, 1.2, 1.8, 2.8, 4.5, 8.0})
    for (const int side : {-1, 1}) speed.push_back((poles(nearest).imag() + side * t * width) / critical.order);
}

OrderCurves order_curves(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                         const OrderLoading& order, RunUp& result) {
  std::vector<double> omega;
  for (const double speed : result.speed) omega.push_back(order.order * speed);
  FrequencyResponse response = frequency_response(assembled, channels, order.loading, omega);
  result.worst_backward_error = std::max(result.worst_backward_error, response.check.worst_backward_error);
  for (const double at : response.check.undefined_at) result.undefined_at.push_back(at / order.order);
  return {order.order, std::move(response.curves)};
}

Overall overall(const RunUp& run_up, std::size_t curve) {
  const Curve& first = run_up.orders.front().curves[curve];
  const Eigen::Index count = first.value.size();
  Overall sum{first.name, first.unit,          Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count),
              0,          run_up.speed.front()};
  for (const OrderCurves& order : run_up.orders) {
    const Eigen::VectorXd amplitude = order.curves[curve].value.cwiseAbs();
    sum.rms += 0.5 * amplitude.cwiseAbs2();
    sum.bound += amplitude;
  }
  sum.rms = sum.rms.cwiseSqrt().eval();
  const auto raise = [&](double rms, double speed) {
    if (!(rms > sum.highest_rms)) return;
    sum.highest_rms = rms;
    sum.highest_rms_at = speed;
  };
  for (Eigen::Index i = 0; i < count; ++i) raise(sum.rms(i), run_up.speed[i]);
  for (const CriticalSpeed& critical : run_up.critical)
    if (critical.curve == curve && std::isinf(critical.amplitude)) raise(infinity, critical.speed);
  return sum;
}

}  // namespace

RunUp run_up(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
             const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes, const modal::Roots& roots,
             const RunUpOptions& options, const foundation::Progress& progress) {
  const assembly::Band& speed = options.speed;
  if (!(speed.from >= 0 && speed.to > speed.from && std::isfinite(speed.to)))
    throw foundation::InvalidInput("run-up: the speed range must satisfy 0 ≤ from < to");
  if (order_loadings.empty())
    throw foundation::InvalidInput("run-up: no excitation depends on a shaft speed; give orders or an unbalance");
  if (options.points < 2) throw foundation::InvalidInput("run-up: at least two speeds are needed");
  RunUp result;
  for (const OrderLoading& order : order_loadings) {
    Peaks found = peaks(assembled, channels, order.loading, modes, roots,
                        {options.min_prominence, order.order * speed.to, false}, progress);
    std::erase_if(found.list, [&](const Peak& peak) {
      return peak.angular_frequency < order.order * speed.from || peak.angular_frequency > order.order * speed.to;
    });
    set_nearest_modes(assembled, channels, order.loading, modes, found);
    note_critical(found, order.order, result.critical);
  }
  set_relative_heights(channels.size(), result.critical);
  result.speed = linear_grid(speed, options.points);
  for (const CriticalSpeed& critical : result.critical) {
    if (critical.relative_height < options.tall_from) continue;
    if (std::isfinite(critical.amplitude)) result.speed.push_back(critical.speed);
    add_around(critical, roots.poles, result.speed);
  }
  std::erase_if(result.speed, [&](double at) { return at < speed.from || at > speed.to; });
  sort_apart(result.speed);
  std::ranges::stable_sort(result.critical, [](const CriticalSpeed& a, const CriticalSpeed& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.speed < b.speed;
  });
  for (std::size_t k = 0; k < order_loadings.size(); ++k) {
    foundation::report_progress(progress, "run-up",
                                static_cast<double>(k) / static_cast<double>(order_loadings.size()));
    result.orders.push_back(order_curves(assembled, channels, order_loadings[k], result));
  }
  sort_apart(result.undefined_at);
  for (std::size_t c = 0; c < channels.size(); ++c) result.overall.push_back(overall(result, c));
  return result;
}

std::vector<WaterfallLine> waterfall(const RunUp& run_up, std::size_t curve, int spectra) {
  if (spectra < 2 || run_up.orders.empty() || curve >= run_up.orders.front().curves.size())
    throw foundation::InvalidInput("waterfall: a curve of the run-up and at least two spectra are needed");
  std::vector<WaterfallLine> lines;
  std::size_t last = run_up.speed.size();
  for (const double wanted : linear_grid({run_up.speed.front(), run_up.speed.back()}, spectra)) {
    const auto above = std::ranges::lower_bound(run_up.speed, wanted);
    auto nearest = to_size(std::min(above, run_up.speed.end() - 1) - run_up.speed.begin());
    if (nearest > 0 && wanted - run_up.speed[nearest - 1] < run_up.speed[nearest] - wanted) --nearest;
    if (nearest == last) continue;
    last = nearest;
    for (const OrderCurves& order : run_up.orders)
      lines.push_back({run_up.speed[nearest], order.order * run_up.speed[nearest], order.order,
                       std::abs(order.curves[curve].value(to_index(nearest)))});
  }
  return lines;
}

namespace {

std::vector<NaturalLine> natural_lines(const modal::Roots& roots) {
  std::vector<NaturalLine> lines;
  for (const modal::Root& root : roots.list)
    if (root.damped_angular_frequency && root.eigenvalue.imag() > 0)
      lines.push_back({root.eigenvalue.imag(), root.damping_ratio.value_or(0), root.nearest_mode});
  std::ranges::sort(lines, {}, &NaturalLine::angular_frequency);
  return lines;
}

}  // namespace

Campbell campbell(const std::vector<OrderLoading>& order_loadings, const modal::Modes& modes, const modal::Roots& roots,
                  const assembly::Band& speed) {
  if (!(speed.from >= 0 && speed.to > speed.from && std::isfinite(speed.to)))
    throw foundation::InvalidInput("campbell: the speed range must satisfy 0 ≤ from < to");
  Campbell result{speed, {}, natural_lines(roots), {}};
  for (const OrderLoading& order : order_loadings) {
    result.orders.push_back(order.order);
    assert(order.order > 0 && "the speed is the frequency over the order");
    for (std::size_t i = 0; i < result.natural.size(); ++i) {
      const NaturalLine& line = result.natural[i];
      Interference point{
          i, order.order, line.angular_frequency / order.order, line.angular_frequency, line.nearest_mode, {}, false};
      if (point.speed < speed.from || point.speed > speed.to) continue;
      const Eigen::VectorXd forces =
          modal::modal_forces(modes, order.loading.force.at(line.angular_frequency)).cwiseAbs();
      const auto mode = std::ranges::find(modes.list, point.mode, &modal::Mode::number);
      if (mode != modes.list.end() && forces.squaredNorm() > 0) {
        point.modal_force_share = std::pow(forces(mode - modes.list.begin()), 2) / forces.squaredNorm();
        point.excited = *point.modal_force_share >= excited_from;
      }
      result.points.push_back(point);
    }
  }
  std::ranges::stable_sort(result.points, {}, &Interference::speed);
  return result;
}

}  // namespace trivet::response
