// SPDX-License-Identifier: BSD-3-Clause
// Sensitivities of peaks of machines on laws, which rest elsewhere when they are changed.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "support/peak_slopes.h"
#include "support/projects.h"
#include "support/sensitivity_request.h"
#include "trivet/judging/changed_case.h"
#include "trivet/project/model_number.h"
#include "trivet/study/explain/explanation.h"

namespace explain_at_rest_test {

using namespace trivet;

/// Bears its weight on hardening mounts, a stop, a gas spring along a line, and rubber whose stiffness depends on
/// frequency.
constexpr const char* nonlinear_machine = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.machine]
mass = 200
center_of_mass = [0.02, -0.03, 0.2]
inertia = {about = "center_of_mass", xx = 9, yy = 12, zz = 14, xy = 0.5}
[excitations.f]
type = "harmonic"
on = "machine"
at = [0.1, 0.2, 0.3]
force = [10, 20, 50]
[elements.front]
type = "bushing"
on = "machine"
at = [0.4, 0.1, 0]
translation = [1e5, 1.2e5, 6e4]
rotation = [900, 800, 500]
damping = {loss_factor = 0.05}
laws.z = {cubic = 4e9, quadratic = 1e6}
[elements.rear]
type = "bushing"
on = "machine"
at = [-0.3, -0.2, 0.05]
translation = [1e5, 1.1e5, 5e4]
damping = {fractional_zener = {ratio = 0.3, time = "10 ms", order = 0.5}}
laws.z = {cubic = 6e9}
[elements.stop]
type = "stop"
on = "machine"
at = [-0.2, 0.3, 0]
axis = "-z"
gap = "1 mm"
stiffness = 3e6
power = 1.5
[elements.lift]
type = "strut"
on = "machine"
at = [0.1, -0.3, 0]
from_at = [0.1, -0.4, -0.3]
free_length = "340 mm"
stiffness = 3e4
coefficient = 150
[analyses]
response = {of = ["machine.z", "machine.rx", "front.force.z"], band = ["2 Hz", "30 Hz"]}
)";

TEST(PeakSensitivities, FollowThePositionOfRestOfANonlinearMachine) {
  const project::Project file = test::project(nonlinear_machine);
  const project::Case& base = file.base();
  const study::Explanation found = study::explanation(base, {{}, 3});
  ASSERT_EQ(found.peaks.size(), 3u);
  EXPECT_FALSE(found.notes.empty()) << "the tangents that were used";
  int compared = 0, moved = 0;
  for (const study::ExplainedPeak& peak : found.peaks) {
    for (std::size_t e = 0; e < base.system.elements().size(); ++e) {
      const auto& share = peak.shares.elements[e];
      EXPECT_NEAR(share.by_direction.sum(), share.stored, 1e-9) << base.system.elements()[e].name;
    }
    const response::SensitivityRequest request = test::sensitivity_request({peak.name});
    double largest_height = 0, largest_frequency = 0;
    for (const response::Sensitivity& s : peak.sensitivities) {
      const double size = found.parameters[s.parameter].size / 0.01;
      largest_height = std::max(largest_height, std::abs(s.height.value()) * size);
      largest_frequency = std::max(largest_frequency, std::abs(s.frequency.value()) * size);
    }
    for (const response::Sensitivity& s : peak.sensitivities) {
      const response::Parameter& parameter = found.parameters[s.parameter];
      SCOPED_TRACE(parameter.name);
      const project::ModelNumber number(parameter.name, "");
      const double before = number.read(base).value(), size = parameter.size / 0.01;
      const bool is_added = parameter.change != "+1 %";
      const double step = test::step_by_circles * (is_added ? 0.2 : 1);
      const auto changed = [&](double amount) {
        return judging::changed_system(base, {{number, is_added ? before + amount : before * (1 + amount)}}).value();
      };
      const test::PeakSlopes difference =
          test::peak_slopes(changed, step, request, {{0, peak.peak.angular_frequency, {}}}).front();
      EXPECT_NEAR(*s.height * size, difference.height * size, test::truncation_by_circles * largest_height)
          << parameter.name << " on the height of " << peak.name;
      EXPECT_NEAR(*s.frequency * size, difference.frequency * size, test::truncation_by_circles * largest_frequency)
          << parameter.name << " on the frequency of " << peak.name;
      ++compared;
      // Without the new position of rest, more mass lowers every frequency; here it hardens the mounts.
      if (parameter.name == "bodies.machine.mass_about_center" && *s.frequency > -0.1) ++moved;
    }
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(moved, 0);
}

/// The stop closes exactly at rest: one side has another stiffness than the other.
TEST(PeakSensitivities, EndWhereAStopClosesAtRest) {
  const project::Project file = test::project(R"(trivet = 1
gravity = [0, 0, -10]
[bodies.m]
mass = 50
free = ["z"]
[elements.s]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 5e4]
damping = {translation = [0, 0, 50]}
[elements.stop]
type = "stop"
on = "m"
at = [0, 0, 0]
axis = "-z"
gap = "10.001 mm"
stiffness = 1e5
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 1]
[analyses]
response = {of = ["m.z"], band = ["1 Hz", "30 Hz"]}
)");
  const study::Explanation found = study::explanation(file.base(), {{}, 1});
  ASSERT_EQ(found.peaks.size(), 1u);
  EXPECT_THAT(found.peaks[0].notes, testing::Contains(testing::HasSubstr("opens or closes a stop at rest")));
  EXPECT_EQ(std::ranges::count_if(found.peaks[0].notes,
                                  [](const std::string& note) { return note.find("no slopes") != std::string::npos; }),
            1);
  for (const response::Sensitivity& s : found.peaks[0].sensitivities) {
    const std::string& name = found.parameters[s.parameter].name;
    EXPECT_EQ(s.height.has_value(), name.ends_with("damping_factor") || name.find("moved") != std::string::npos)
        << name;
  }
}

}  // namespace explain_at_rest_test
