// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "trivet/elements/law.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/modal/roots.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/response/machinery/power.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::test {

inline constexpr double turn = 2 * std::numbers::pi;

/// A machine of 400 kg with a point "seat" on four mounts of unequal stiffness, with dashpots; one is on a flexible
/// deck.
inline model::Description machine_on_four_mounts() {
  model::Description d;
  model::Body machine;
  machine.name = "machine";
  machine.mass.mass = 400;
  machine.mass.centre = {0.05, 0.02, 0.35};
  machine.mass.inertia_about_centre = Eigen::Vector3d(20, 35, 40).asDiagonal();
  machine.points = {{"seat", {0.3, 0.1, 0.8}}};
  d.bodies = {machine};
  const char* const names[] = {"front left", "front right", "rear left", "rear right"};
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d at(i < 2 ? 0.5 : -0.5, i % 2 ? -0.3 : 0.3, 0);
    spatial::Vector6 stiffness = spatial::Vector6::Zero();
    stiffness.head<3>() = (1 + 0.15 * i) * Eigen::Vector3d(2e5, 2.5e5, 6e5);
    model::Element mount;
    mount.name = names[i];
    mount.type = "three_springs";
    mount.k.body = 0;
    mount.k.at = at;
    mount.n.at = at - Eigen::Vector3d(0, 0, 0.1);
    mount.law.nominal_stiffness = elements::constants_at_point(stiffness, Eigen::Vector3d(0, 0, 0.1), 0.5);
    mount.law.damping = elements::DampingMatrix{8e-4 * mount.law.nominal_stiffness};
    d.elements.push_back(mount);
  }
  model::Foundation deck{"deck", Eigen::MatrixXd::Constant(1, 1, 900), Eigen::MatrixXd::Constant(1, 1, 4e3),
                         Eigen::MatrixXd::Constant(1, 1, 2e7)};
  d.foundations = {deck};
  d.elements.back().n.foundation = model::OnFoundation{0, spatial::Vector6::Unit(2)};
  return d;
}

/// All analyses that a case can request, for that machine.
inline study::CaseResults results_of_everything() {
  model::Description d = machine_on_four_mounts();
  model::Action on_machine, base;
  on_machine.body = 0;
  on_machine.at = {0.1, 0, 0.4};
  on_machine.amplitude << 20, 40, 100, 5, 0, 0;
  base.amplitude(2) = 1;
  base.amplitude(0) = 0.3;
  base.derivative = 2;
  base.elements = {0, 1, 2};  // the fourth is on the mode of the deck
  d.excitations = {
      {"piston", on_machine, model::Harmonic{}},
      {"deck", base, model::Random{excitation::from_table({{1, 10, 100, 200}, {0.01, 0.1, 0.1, 0.02}}), {}}}};
  model::Orders orders;
  for (const double order : {0.5, 1.0, 2.0, 4.0}) {
    excitation::Order one{order, {}, {}};
    one.per_speed_squared.setZero();
    one.fixed.setZero();
    one.per_speed_squared(2) = order == 2 ? 4e-3 : 5e-4;
    one.fixed(3) = order == 2 ? 60 : 15;
    if (order == 1) one.per_speed_squared(1) = 1e-3;
    orders.list.push_back(one);
  }
  d.excitations.push_back({"engine", on_machine, orders});
  const model::System system = *model::System::checked(d);
  const assembly::Assembled assembled = assembly::assemble(system);

  study::CaseResults a;
  a.modes = modal::modes(system, assembled);
  a.roots = modal::roots(system, assembled, a.modes);
  const std::vector<std::string> of = {"coordinates", "machine.seat", "ground"};
  const auto channels = assembly::channels(system, assembled, of, assembly::MotionQuantity::displacement);
  const auto velocities = assembly::channels(system, assembled, {"machine.seat.z"}, assembly::MotionQuantity::velocity);
  const response::RandomLoading random = response::random_loading(system, assembled);
  a.random = study::RandomResult{response::random_response(assembled, channels, random),
                                 response::random_curves(assembled, channels, random),
                                 {"deck"},
                                 {}};

  const excitation::Signal pulse = excitation::half_sine(50, 0.011, 0.01);
  response::TransientOptions time;
  time.to = 0.6;
  time.step = 2e-4;
  a.transient =
      study::TransientResult{response::transient_response(system, assembled, channels,
                                                          {{"shock", pulse, assembly::loading(assembled, base)}}, time),
                             {}};

  const auto by_order = response::order_loadings(system, assembled);
  const assembly::Band speed{turn * 5, turn * 50};
  a.orders = study::OrdersResult{response::run_up(assembled, channels, by_order, a.modes, a.roots, {.speed = speed}),
                                 response::campbell(by_order, a.modes, a.roots, speed),
                                 {}};

  const assembly::Band band{turn * 1, turn * 100};
  const auto grid = response::logarithmic_grid(band, 801);
  const auto transmission = response::force_transmission(system, assembled, {0, {0.05, 0.02, 0.35}, {}});
  const auto transmitted_peaks =
      response::peaks(assembled, transmission.channels, transmission.loading, a.modes, a.roots);
  std::vector<design::LargestAmplitude> in_band;
  for (std::size_t c = 0; c < transmission.channels.size(); ++c)
    in_band.push_back(
        design::largest_in_band(assembled, transmission.channels, transmission.loading, transmitted_peaks, c, band));
  a.transmissibility = study::TransmissibilityResult{
      "force on the ground over piston",
      response::frequency_response(assembled, transmission.channels, transmission.loading, grid),
      transmitted_peaks,
      response::crossovers(assembled, transmission, transmitted_peaks),
      band,
      in_band};

  const assembly::Loading harmonic = assembly::harmonic_loading(system, assembled, {"piston"});
  a.power = response::power_flow(system, assembled, harmonic, grid);
  a.shapes = std::vector{response::deflection_shape(system, assembled, harmonic, turn * 12)};
  std::vector<double> natural;
  for (int i = 0; i <= 300; ++i) natural.push_back(turn * std::pow(10.0, 3.3 * i / 300));
  a.shock_spectrum = std::vector<study::ShockSpectrumResult>{
      {"shock", "m/s²", 0.05, excitation::shock_spectrum(pulse, natural, 0.05)}};
  const assembly::LimitLine line{
      "class B", "m/s", true, {turn * 2, turn * 8, turn * 8, turn * 90}, {2e-2, 5e-3, 9e-3, 9e-3}};
  const auto velocity_peaks = response::peaks(assembled, velocities, harmonic, a.modes, a.roots);
  a.limit_lines = {{"machine.seat.z", line,
                    response::compared_with_limit(assembled, velocities.front(), harmonic, a.roots.poles,
                                                  velocity_peaks, line, band)}};
  return a;
}

}  // namespace trivet::test
