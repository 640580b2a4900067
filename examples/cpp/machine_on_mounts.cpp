// SPDX-License-Identifier: BSD-3-Clause
// How far does a machine on four mounts move under an oscillating force, described without a project file?
#include <cstdio>
#include <numbers>

#include "trivet/response/steady/frequency_response.h"

int main() {
  using namespace trivet;
  model::Description machine;
  machine.bodies.push_back(
      {.name = "machine", .mass = {.mass = 250, .inertia_about_centre = Eigen::Vector3d(8, 12, 13).asDiagonal()}});
  for (const double x : {-0.4, 0.4})
    for (const double y : {-0.25, 0.25}) {
      model::Element mount{.name = "mount " + std::to_string(machine.elements.size() + 1)};
      mount.k = {.body = 0, .at = {x, y, -0.2}};
      mount.n = {.at = {x, y, -0.2}};
      mount.law.nominal_stiffness = elements::constants_at_point({180e3, 180e3, 420e3, 0, 0, 0}, {0, 0, 0}, 0.5);
      mount.law.damping = elements::LossFactor{0.08};
      machine.elements.push_back(mount);
    }
  model::Excitation force{.name = "force", .action = {.body = 0}};
  force.action.amplitude(2) = 120;  // [N] along z
  machine.excitations.push_back(force);

  const auto system = model::System::checked(machine);
  if (!system) return std::fprintf(stderr, "%s\n", message(system.error().list().front()).c_str()), 1;
  const assembly::Assembled assembled = assembly::assemble(*system);
  const auto channels = assembly::channels(*system, assembled, {"machine.z"}, assembly::MotionQuantity::displacement);
  std::vector<double> omega;
  for (double hertz = 2; hertz <= 20; hertz += 2) omega.push_back(2 * std::numbers::pi * hertz);
  const auto response =
      response::frequency_response(assembled, channels, assembly::harmonic_loading(*system, assembled, {}), omega);
  for (std::size_t i = 0; i < omega.size(); ++i)
    std::printf("%4.0f Hz  %.4f mm\n", omega[i] / (2 * std::numbers::pi),
                1e3 * std::abs(response.curves[0].value(static_cast<Eigen::Index>(i))));
}
