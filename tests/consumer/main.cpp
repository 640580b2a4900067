// SPDX-License-Identifier: BSD-3-Clause
// An external program: describes a system, requests results, reads them.
#include <cmath>
#include <cstdio>

#include "trivet/judging/read_project.h"
#include "trivet/modal/modes.h"
#include "trivet/project/project.h"

int main() {
  trivet::model::Description description;
  trivet::model::Body body;
  body.name = "mass";
  body.mass.mass = 4;
  body.has_inertia = false;
  body.free = {true, false, false, false, false, false};
  description.bodies.push_back(body);
  trivet::model::Element spring;
  spring.name = "spring";
  spring.k.body = 0;
  spring.law.nominal_stiffness = trivet::elements::constants_at_point({100, 0, 0, 0, 0, 0}, {0, 0, 0}, 0.5);
  description.elements.push_back(spring);
  const auto system = trivet::model::System::checked(description);
  if (!system) return 1;
  const auto modes = trivet::modal::modes(*system);
  std::printf("%.17g\n", *modes.list.at(0).angular_frequency);
  constexpr double round_off = 1e-12;  // a root of a quotient
  const bool right = std::abs(*modes.list.at(0).angular_frequency - 5.0) < round_off;
  const bool rejects = !trivet::judging::project_from_text("trivet = 1", "empty").has_value();
  return right && rejects ? 0 : 1;
}
