// SPDX-License-Identifier: BSD-3-Clause
// Drawn designs judged by kernels against the same designs assembled and judged one by one.
#include "trivet/study/sample/sampled_case.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "support/projects.h"
#include "trivet/foundation/index.h"
#include "trivet/judging/changed_case.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/requirements/requirement_values.h"
#include "trivet/study/requirements/verdict.h"
#include "trivet/study/sample/sample_tally.h"

namespace trivet {
namespace sampled_case_test {

/// Amplitudes have nine digits in both ways, shares and frequencies more.
constexpr double digits = 2e-8;
/// A relative prominence is known to 1e-6 (design_peaks.h).
constexpr double of_prominence = 2e-6;
/// The kernel must prove most designs.
constexpr double most_are_proven = 0.8;

/// A machine on four mounts with random mass, places and stiffnesses, and tolerances of all shapes.
std::string random_machine(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
  };
  std::string text = fmt::format(R"(
trivet = 1
gravity = [0, 0, -9.80665]
[bodies.machine]
mass = {}
center_of_mass = [{}, {}, 0.3]
inertia = {{about = "center_of_mass", xx = {}, yy = {}, zz = {}}}
points = {{seat = [0.2, 0.3, 0.9]}}
[excitations.rotor]
type = "{}"
on = "machine"
at = [0.1, 0, 0.4]
{}
[analyses]
response = {{of = ["machine"]}}
)",
                                 between(200, 600), between(-0.05, 0.05), between(-0.05, 0.05), between(10, 20),
                                 between(20, 25), between(25, 30), seed % 2 ? "unbalance" : "harmonic",
                                 seed % 2 ? "axis = \"x\"\nmass_eccentricity = \"20 g m\"" : "force = [20, 10, 150]");
  for (const auto& [name, x, y] : {std::tuple("a", 0.4, 0.3), {"b", 0.4, -0.3}, {"c", -0.4, 0.3}, {"d", -0.4, -0.3}})
    text += fmt::format(R"([elements.{}]
type = "bushing"
on = "machine"
at = [{}, {}, 0]
translation = [{}, {}, {}]
rotation = [0, 0, 0]
damping = {}
)",
                        name, x + between(-0.05, 0.05), y + between(-0.05, 0.05), between(1e5, 3e5), between(1e5, 3e5),
                        between(3e5, 8e5), seed % 3 ? "{loss_factor = 0.12}" : "{translation = [400, 400, 900]}");
  return text + R"(
[tolerances.rubber]
path = ["elements.a.scale", "elements.b.scale", "elements.c.scale", "elements.d.scale"]
standard_deviation = "8 %"
truncated_at = "20 %"
[tolerances.casting]
path = "bodies.machine.mass"
half_width = "5 %"
distribution = "triangular"
correlation = {with = "core", value = 0.6}
[tolerances.core]
path = "bodies.machine.center_of_mass.z"
standard_deviation = "10 mm"
[tolerances.drilled]
path = {"elements.a.at.x" = 1, "elements.b.at.x" = -1}
half_width = "3 mm"
[requirements]
limits = {"machine.seat.z" = "0.2 mm", "machine.seat.x" = "0.3 mm"}
no_peak = "machine.z"
peak_tolerance = 0.2
natural_frequencies = {avoid = [["6 Hz", "8 Hz"]], separation = 1.01}
decoupling = {machine = "60 %"}
static = {"machine.seat.z" = "5 mm"}
)";
}

TEST(SampledCase, AgreesWithAssembledDesigns) {
  constexpr std::size_t designs = 60;
  double worst = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const project::Project project = test::project(random_machine(seed));
    const std::vector<project::Tolerance>& tolerances = project.base().analyses.tolerances;
    const study::DrawnDesigns drawn(tolerances, {.seed = seed});
    const study::SampledCase one(project.base(), tolerances, drawn);
    ASSERT_EQ(one.no_kernels(), "");
    const Eigen::MatrixXd draws = drawn.draw(0, designs);
    const study::SampledMargins quick = one.judged(draws), exact = one.assembled(draws);
    EXPECT_EQ(exact.in_kernels, 0);
    EXPECT_EQ(quick.in_kernels + quick.one_by_one, designs);
    EXPECT_GE(quick.in_kernels, most_are_proven * designs) << seed;
    ASSERT_EQ(quick.margins.cols(), 7);
    for (Eigen::Index d = 0; d < draws.rows(); ++d) {
      EXPECT_EQ(quick.failures[d], exact.failures[d]);
      for (Eigen::Index r = 0; r < quick.margins.cols(); ++r) {
        const double a = quick.margins(d, r), b = exact.margins(d, r);
        if (a == b) continue;  // also both infinite
        const bool peak = one.given()[r].kind == study::RequirementKind::no_peak;
        worst = std::max(worst, std::abs(a / b - 1));
        EXPECT_LT(std::abs(a / b - 1), peak ? of_prominence : digits)
            << "machine " << seed << ", design " << d << ", " << one.given()[r].words.text();
      }
    }
  }
  RecordProperty("worst", fmt::format("{:.1e}", worst));
}

std::ptrdiff_t failed(const study::SampledMargins& margins) {
  return std::ranges::count_if(margins.failures, [](const std::string& why) { return !why.empty(); });
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Those of designs 0 … count − 1 whose last draw is below a number, by kernels and assembled: the same ones fail, for
/// the same reasons, and the margins agree.
study::SampledMargins judged_alike(const project::Project& project, std::size_t count, double below) {
  const std::vector<project::Tolerance>& tolerances = project.base().analyses.tolerances;
  const study::DrawnDesigns drawn(tolerances, {});
  const study::SampledCase one(project.base(), tolerances, drawn);
  const Eigen::MatrixXd all = drawn.draw(0, count);
  std::vector<Eigen::Index> rows;
  for (Eigen::Index d = 0; d < all.rows(); ++d)
    if (all(d, all.cols() - 1) < below) rows.push_back(d);
  const Eigen::MatrixXd draws = all(rows, Eigen::all);
  study::SampledMargins quick = one.judged(draws), exact = one.assembled(draws);
  EXPECT_EQ(quick.failures, exact.failures);
  EXPECT_EQ(to_index(quick.in_kernels + quick.one_by_one) + failed(quick), draws.rows());
  for (Eigen::Index d = 0; d < draws.rows(); ++d)
    for (Eigen::Index r = 0; exact.failures[to_size(d)].empty() && r < exact.margins.cols(); ++r) {
      const double a = quick.margins(d, r), b = exact.margins(d, r);
      if (a == b) continue;  // also both infinite
      const bool peak = one.given()[r].kind == study::RequirementKind::no_peak;
      EXPECT_LT(std::abs(a / b - 1), peak ? of_prominence : digits) << d << ", " << one.given()[r].words.text();
    }
  return quick;
}

study::SampledMargins judged_alike(const std::string& more, std::size_t count, double below, unsigned seed = 2) {
  return judged_alike(test::project(random_machine(seed) + more), count, below);
}

const std::string wide = "[tolerances.wide]\npath = \"elements.c.translation.x\"\n";

// A stiffness with a deviation of 37 % is negative in 0.3 % of the designs, so the kernels have the numbers above its
// lowest 1 %: those below are assembled, and those without a model fail for the same reason.
TEST(SampledCase, AssemblesDesignsBeyondTheFittedNumbers) {
  const study::SampledMargins found = judged_alike(wide + "standard_deviation = \"37 %\"\n", 800, infinity);
  EXPECT_GT(failed(found), 0);
  EXPECT_GE(found.one_by_one, 4) << "of 8 below the range, without those that have no model";
  EXPECT_LT(found.one_by_one, 20);
  EXPECT_GT(found.in_kernels, 770);
}

// Few designs without a model at one end of a range are found too: 0.495 % of a uniform number, 0.028 % of a normal
// one.
TEST(SampledCase, FindsTheFewDesignsWithoutAModel) {
  constexpr double low = 0.1, dispersion = 3;  // of the nominal stiffness; standard deviations of random designs
  const study::SampledMargins uniform = judged_alike(wide + "half_width = \"101 %\"\n", 4000, low);
  EXPECT_NEAR(failed(uniform), 19.8, dispersion * std::sqrt(19.8));
  EXPECT_GT(uniform.in_kernels, 100) << "those above the lowest 1 %";
  const study::SampledMargins normal = judged_alike(wide + "standard_deviation = \"29 %\"\n", 50000, low);
  EXPECT_NEAR(failed(normal), 14.1, dispersion * std::sqrt(14.1));
}

// Inertias about three axes have a body only together: each end of a range has one, a corner of two ranges has none.
TEST(SampledCase, FindsDesignsThatTwoNumbersTogetherMakeImpossible) {
  const study::SampledMargins found = judged_alike(
      "[tolerances.yy]\npath = \"bodies.machine.inertia.yy\"\nhalf_width = \"20 %\"\n"
      "[tolerances.zz]\npath = \"bodies.machine.inertia.zz\"\nhalf_width = \"20 %\"\n",
      1000, infinity);
  EXPECT_GT(failed(found), 0);
}

const std::string speeds = "[operation]\nspeeds = [\"410 rpm\", [\"300 rpm\", \"900 rpm\"]]\n",
                  single = "[operation]\nspeeds = [\"410 rpm\", \"1500 rpm\"]\n",
                  effective = "limits = {\"machine.seat.z\" = \"0.5 mm/s rms\", \"machine.seat.x\" = \"0.1 mm rms\"}\n";
constexpr const char* shaft = R"(
[excitations.shaft]
type = "orders"
on = "machine"
at = [0, 0.1, 0.3]
table = [{order = 0.5, moment = [3, 0, 0]}, {order = 1, moment = [8, 2, 0], force_per_speed2 = [0, 0, 0.012], phase = 0.3}, {order = 2, force = [4, 0, 9]}]
)";

study::SampledCase sampled_case(const project::Project& project) {
  const std::vector<project::Tolerance>& tolerances = project.base().analyses.tolerances;
  return {project.base(), tolerances, study::DrawnDesigns(tolerances, {})};
}

// Of one order, a force or an unbalance, the amplitudes at all levels, and over ranges of speeds, in which the largest
// one may be a peak. Seeds have loss factors (2) and viscous damping (3).
TEST(SampledCase, JudgesOneOrderAtSpeedsOfTheMachine) {
  const std::string limits =
      "limits = {\"machine.seat.z\" = \"0.5 mm/s rms\", \"machine.seat.x\" = \"0.1 mm p-p\", "
      "\"ground.force.z\" = \"30 N\"}\n";
  bool any_peak = false;
  for (const unsigned seed : {2U, 3U}) {
    EXPECT_GE(judged_alike(speeds + limits, 60, infinity, seed).in_kernels, most_are_proven * 60) << seed;
    const project::Project project = test::project(random_machine(seed) + speeds + limits);
    const study::SampledCase sampled = sampled_case(project);
    for (const study::RequirementResult& one : sampled.given()) {
      if (one.kind != study::RequirementKind::operation) continue;
      EXPECT_NEAR(*study::value_at_margin(one, one.margin) / *one.value, 1, 1e-12) << one.words.text();
      any_peak = any_peak ||
          (one.speed->from < one.speed->to && *one.angular_frequency > 1.001 * one.speed->from &&
           *one.angular_frequency < 0.999 * one.speed->to);
    }
  }
  EXPECT_TRUE(any_peak);
}

// Far above the resonances of lightly damped springs the partial fractions of a small force on the ground cancel: the
// value at the lower end of the band is computed from the equations.
TEST(SampledCase, JudgesIsolationAboveTheResonances) {
  const std::string fan = R"(
trivet = 1
[bodies.fan]
mass = 2813
center_of_mass = [0.085, 0, 0.356]
inertia = {about = "center_of_mass", xx = 710, yy = 1330, zz = 1330}
[element_types.spring]
type = "bushing"
translation = [160e3, 160e3, 200e3]
damping = {loss_factor = 0.02}
[tables.elements]
rows = [
  {name = "a", type = "spring", on = "fan", at = [1.0, 0.6, 0]},
  {name = "b", type = "spring", on = "fan", at = [1.0, -0.6, 0]},
  {name = "c", type = "spring", on = "fan", at = [-1.0, 0.6, 0]},
  {name = "d", type = "spring", on = "fan", at = [-1.0, -0.6, 0]},
]
[excitations.rotor]
type = "unbalance"
on = "fan"
at = [0.5, 0, 0.8]
axis = "x"
grade = 6.3
rotor_mass = 370
service_speed = "980 rpm"
[requirements]
isolation = {least = "95 %", band = ["700 rpm", "1000 rpm"]}
[tolerances.springs]
path = ["elements.a.scale", "elements.b.scale", "elements.c.scale", "elements.d.scale"]
half_width = "15 %"
)";
  EXPECT_GE(judged_alike(test::project(fan), 60, infinity).in_kernels, most_are_proven * 60);
}

// A force that turns twice as fast as the shaft, and grows with the square of its speed: the order scales the
// frequency, but not the speed of the load.
TEST(SampledCase, JudgesAnotherOrderThanTheFirst) {
  const std::string twice = R"(
[excitations.shaft]
type = "orders"
on = "machine"
at = [0, 0.1, 0.3]
table = [{order = 2, force = [4, 0, 9], force_per_speed2 = [0, 0, 0.012]}]
)";
  const std::string limits =
      "excitations = [\"shaft\"]\nlimits = {\"machine.seat.z\" = \"0.5 mm/s rms\", \"machine.seat.x\" = \"0.1 mm "
      "p-p\"}\n";
  for (const unsigned seed : {2U, 3U})
    EXPECT_GE(judged_alike(twice + speeds + limits, 60, infinity, seed).in_kernels, most_are_proven * 60) << seed;
}

// Of three orders the root mean square at a speed, of all excitations or one; a peak or a range has no kernel.
TEST(SampledCase, JudgesTheSumOfOrdersAtASpeed) {
  for (const std::string selected : {"", "excitations = [\"shaft\"]\n"})
    for (const unsigned seed : {2U, 3U})
      EXPECT_EQ(judged_alike(shaft + single + selected + effective, 60, infinity, seed).in_kernels, 60) << seed;
  for (const std::string& other : {speeds + effective, single + "limits = {\"machine.seat.z\" = \"0.1 mm\"}\n"})
    EXPECT_THAT(sampled_case(test::project(random_machine(2) + shaft + other)).no_kernels(),
                testing::EndsWith("of several orders it judges the root mean square at single speeds only"));
}

constexpr const char* two_forces = R"(
trivet = 1
[bodies.machine]
mass = 400
inertia = {about = "center_of_mass", xx = 15, yy = 22, zz = 27}
[elements.k]
type = "bushing"
on = "machine"
at = [0, 0, -0.3]
translation = [6e5, 6e5, 2e6]
rotation = [5e4, 5e4, 5e4]
damping = {loss_factor = 0.1}
[excitations.rotor]
type = "harmonic"
on = "machine"
at = [0.1, 0, 0.4]
force = [20, 10, 150]
[excitations.pump]
type = "harmonic"
on = "machine"
at = [0, 0.2, 0.1]
force = [0, 40, 60]
phase = 0.4
[operation]
speeds = ["410 rpm"]
limits = {"machine.z" = "0.5 mm/s rms"}
[requirements]
limits = {"machine.z" = [{limit = "0.2 mm", excitations = ["rotor"]}]}
natural_frequencies = {separation = 1.01}
)";

// A load that turns with a phase between two forces is no sum over a few numbers: the limit at the speed is left to
// models, amplitudes and frequencies are not.
TEST(SampledCase, LosesNoOtherKernelsByAnOrderWithoutOne) {
  const project::Project project = test::project(two_forces);
  const auto system = [&](const Eigen::VectorXd& values) {
    auto changed =
        judging::changed_system(project.base(), {{project::ModelNumber("excitations.pump.phase", ""), values(0)}});
    return std::move(changed.value());
  };
  study::DesignNumbers numbers;
  numbers.variables.push_back({0.1, 6, "phase"});
  numbers.model = system;
  foundation::Problems warnings;
  const study::CaseContext context(project.base().system, {});
  const std::vector<study::RequirementResult> given =
      study::requirement_values(context, project.base().analyses, warnings);
  ASSERT_EQ(given.size(), 3);
  const study::DesignBatch batch(numbers, project.base(), project.base().analyses, given);
  EXPECT_EQ(batch.reason(), "");
  for (std::size_t r = 0; r < given.size(); ++r)
    EXPECT_EQ(batch.packed().covers(r), given[r].kind != study::RequirementKind::operation) << given[r].words.text();
}

// Cases have the numbers of their own, moved by the same draws.
TEST(SampledCase, MovesTheNumbersOfTheCase) {
  const project::Project project = test::project(random_machine(1) + "[cases.warm.elements]\na.scale = 0.7\n");
  const std::vector<project::Tolerance>& tolerances = project.base().analyses.tolerances;
  const study::DrawnDesigns drawn(tolerances, {});
  const study::SampledCase warm(*project.find("warm"), tolerances, drawn);
  const Eigen::MatrixXd draws = drawn.draw(0, 5);
  for (Eigen::Index d = 0; d < draws.rows(); ++d) {
    // The first draw is the ratio of element a: a base model with 0.7 of it is the same machine.
    Eigen::MatrixXd moved = draws.row(d);
    const study::SampledCase base(project.base(), tolerances, drawn);
    moved(0, 0) *= 0.7;
    const Eigen::ArrayXXd a = warm.assembled(draws.row(d)).margins, b = base.assembled(moved).margins;
    EXPECT_LT(((a - b) / b).abs().maxCoeff(), 1e-12);
  }
}

}  // namespace sampled_case_test
}  // namespace trivet
