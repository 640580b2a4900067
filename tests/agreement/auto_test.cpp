// SPDX-License-Identifier: BSD-3-Clause
// AUTO-07p, run as a process: orthogonal collocation in time, with multipliers by its own decomposition, against
// harmonic balance and multipliers by splitting. Smooth machines of one or two masses in natural units.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/nonlinear/branch/stable_motions.h"
#include "trivet/nonlinear/branch/steady_branch.h"

namespace auto_test {

using namespace trivet;
using nonlinear::StabilityChange;
using nonlinear::SteadyBranch;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

/// A mass of 1 kg on a spring from the ground under F cos ωt, and one on it by a second spring, or none: forces k x + q
/// x² + a x³ + c ẋ over the deflection of each spring.
struct Machine {
  struct Spring {
    double stiffness = 0, quadratic = 0, cubic = 0, damping = 0;
  };
  Spring first, second;
  double second_mass = 0;
  double force = 0, from = 0, to = 0;  ///< [N], [rad/s]
};

SteadyBranch ours(const Machine& machine) {
  std::vector<double> masses = {1}, springs = {machine.first.stiffness}, dampers = {machine.first.damping};
  if (machine.second_mass > 0) {
    masses.push_back(machine.second_mass);
    springs.push_back(machine.second.stiffness);
    dampers.push_back(machine.second.damping);
  }
  springs.push_back(0);
  model::Description description =
      test::project(
          test::chain(masses, springs, dampers) +
          fmt::format("[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [{}, 0, 0]\n",
                      machine.force))
          .base()
          .system.description();
  const std::vector<Machine::Spring> laws = {machine.first, machine.second};
  for (std::size_t i = 0; i < masses.size(); ++i)
    description.elements[i].nonlinear_parts = {
        {0, 0.5, {elements::PolynomialForce{{0, laws[i].quadratic, laws[i].cubic}}}}};
  nonlinear::SteadyOptions options{.from = machine.from, .to = machine.to, .harmonics = 25};
  options.of = {"m1.x"};
  return nonlinear::steady_branch(model::System::checked(description).value(), options);
}

/// The frequencies that AUTO finds, by its two letters of the kind. Those of a curve that begins at the first doubling
/// or branch point follow with an apostrophe.
class Auto : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(std::system("command -v auto-07p >/dev/null 2>&1"), 0) << "AUTO-07p is missing: scripts/packages tests";
  }

  [[nodiscard]] std::map<std::string, std::vector<double>> frequencies(const Machine& machine) const {
    const int masses = machine.second_mass > 0 ? 2 : 1;
    std::ofstream(folder_.path() / "machine.f90") << equations(machine, masses);
    // From rest without a force to the force; then over the frequency, up to the end of the band.
    std::ofstream(folder_.path() / "run.auto") << fmt::format(
        R"(exact = dict(NDIM={}, IPS=2, ILP=0, ISP=0, NTST=150, NCOL=4, IAD=1, EPSL=1e-10, EPSU=1e-10, EPSS=1e-8, NPR=100000)
loaded = run('machine', IRS=0, ICP=[2, 11], NMX=400, DS=0.01, DSMAX=0.05, UZSTOP={{2: {}}}, **exact)
exact.update(ILP=1, ISP=2)
curve = run(loaded('UZ1'), ICP=[1, 11], NMX=4000, DS=0.005, DSMAX=0.02, UZSTOP={{1: {}}}, **exact)
for kind in ('LP', 'PD', 'TR', 'BP'):
    for point in curve(kind):
        print('FOUND', kind, repr(point['PAR(1)']))
for kind in ('PD', 'BP'):
    for point in curve(kind)[:1]:
        second = run(point, ISW=-1, ICP=[1, 11], NMX=1200, DS=0.005, DSMAX=0.02, **exact)
        for fold in second('LP'):
            print('FOUND', "LP'", repr(fold['PAR(1)']))
)",
        2 * masses + 2, machine.force, machine.to);
    const std::string command =
        "cd '" + folder_.path().string() + "' && OMP_NUM_THREADS=1 auto-07p run.auto >log.txt 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << "AUTO-07p failed";
    std::ifstream log(folder_.path() / "log.txt");
    std::map<std::string, std::vector<double>> found;
    for (std::string word, kind; log >> word;)
      if (double value = 0; word == "FOUND" && log >> kind >> value) found[kind].push_back(value);
    return found;
  }

 private:
  /// A number of double precision.
  static std::string number(double value) {
    std::string text = fmt::format("{:.17e}", value);
    text[text.find('e')] = 'd';
    return text;
  }

  /// u: deflections, velocities, and cos ωt and sin ωt as the limit cycle of two equations more.
  static std::string equations(const Machine& machine, int masses) {
    const auto constants = [](const Machine::Spring& s, int n) {
      return fmt::format(
          "double precision, parameter :: k{0}={1}, q{0}={2}\ndouble precision, parameter :: a{0}={3}, "
          "c{0}={4}\n",
          n, number(s.stiffness), number(s.quadratic), number(s.cubic), number(s.damping));
    };
    const std::string course = masses == 1 ? "x=u(1)\nv=u(2)\n" : "x=u(1)\nv=u(3)\ny=u(2)-x\nw=u(4)-v\n";
    const std::string motion = masses == 1
        ? "f(1)=v\nf(2)=par(2)*u(3)-first\n"
        : "second=k2*y+q2*y**2+a2*y**3+c2*w\nf(1)=v\nf(2)=u(4)\nf(3)=par(2)*u(5)-first+second\nf(4)=-second/m2\n";
    const int c = 2 * masses + 1, s = c + 1;
    return fmt::format(R"(subroutine func(ndim,u,icp,par,ijac,f,dfdu,dfdp)
implicit none
integer, intent(in) :: ndim, icp(*), ijac
double precision, intent(in) :: u(ndim), par(*)
double precision, intent(out) :: f(ndim)
double precision, intent(inout) :: dfdu(ndim,ndim), dfdp(ndim,*)
double precision x, v, y, w, first, second, r
{0}{1}double precision, parameter :: m2={2}
{3}first=k1*x+q1*x**2+a1*x**3+c1*v
{4}r=1-u({5})**2-u({6})**2
f({5})=r*u({5})-par(1)*u({6})
f({6})=r*u({6})+par(1)*u({5})
end subroutine
subroutine stpnt(ndim,u,par,t)
implicit none
integer, intent(in) :: ndim
double precision, intent(inout) :: u(ndim), par(*)
double precision, intent(in) :: t
par(1)={7}
par(2)=0
par(11)={8}
u(1:ndim)=0
u({5})=cos(8*atan(1d0)*t)
u({6})=sin(8*atan(1d0)*t)
end subroutine
subroutine bcnd
end subroutine
subroutine icnd
end subroutine
subroutine fopt
end subroutine
subroutine pvls
end subroutine
)",
                       constants(machine.first, 1), constants(machine.second, 2), number(machine.second_mass), course,
                       motion, c, s, number(machine.from), number(2 * pi / machine.from));
  }

  foundation::TemporaryFolder folder_;
};

std::vector<double> folds(const SteadyBranch& branch) {
  std::vector<double> found;
  for (const nonlinear::Fold& fold : branch.folds) found.push_back(fold.point.angular_frequency);
  return found;
}

std::vector<double> changes(const SteadyBranch& branch, StabilityChange::Kind kind) {
  std::vector<double> found;
  for (const StabilityChange& change : branch.changes)
    if (change.kind == kind) found.push_back(change.point.angular_frequency);
  return found;
}

/// Of the collocation, with 150 intervals of fourth degree in a period, and of 25 harmonics.
constexpr double agreed = 1e-6;

void expect_same(const std::vector<double>& ours, const std::vector<double>& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_THAT(ours[i], RelativelyNear(theirs[i], agreed));
}

TEST_F(Auto, FoldsOfAHardeningSpring) {
  const Machine machine{.first = {1, 0, 1, 0.1}, .force = 0.3, .from = 0.5, .to = 3};
  auto theirs = frequencies(machine);
  ASSERT_EQ(theirs["LP"].size(), 2u);
  expect_same(folds(ours(machine)), theirs["LP"]);
}

TEST_F(Auto, PeriodDoublingsOfAnAsymmetricSpring) {
  const Machine machine{.first = {1, 0.8, 0.3, 0.1}, .force = 0.4, .from = 0.6, .to = 3};
  auto theirs = frequencies(machine);
  const SteadyBranch branch = ours(machine);
  ASSERT_EQ(theirs["PD"].size(), 2u);
  expect_same(folds(branch), theirs["LP"]);
  expect_same(changes(branch, StabilityChange::Kind::period_doubling), theirs["PD"]);
  // The motions of twice the period turn back beyond the first doubling.
  ASSERT_EQ(branch.further.size(), 1u);
  EXPECT_EQ(branch.further[0].periods, 2);
  EXPECT_EQ(branch.changes[0].curve, 0u);
  EXPECT_EQ(branch.changes[1].curve, 0u);
  ASSERT_FALSE(branch.further[0].folds.empty());
  ASSERT_FALSE(theirs["LP'"].empty());
  EXPECT_THAT(folds(branch.further[0]).front(), RelativelyNear(theirs["LP'"].front(), agreed));
  // From there they jump to the only stable motion of one period.
  ASSERT_TRUE(branch.further[0].folds.front().lands);
  EXPECT_LT(branch.further[0].folds.front().lands->results[0].half_of_range(),
            0.5 * branch.further[0].folds.front().point.results[0].half_of_range());
}

/// Without AUTO: between F = 1.45 and 1.46 the steps of the path pass the whole stretch of unstable motion, in which a
/// less symmetric motion is stable. It ends where symmetry returns.
TEST(LostSymmetry, StretchesOfUnstableMotionWithinOneStep) {
  double before = 0;
  for (const double force : {1.45, 1.46, 1.48}) {
    SCOPED_TRACE(force);
    const std::vector<double> found = changes(ours({.first = {1, 0, 1, 0.1}, .force = force, .from = 0.5, .to = 2.5}),
                                              StabilityChange::Kind::branch_point);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_GT(found[1] - found[0], before);
    before = found[1] - found[0];
  }
}

/// Without AUTO: a curve of doubled motions ends where they have one period again. Beyond are the same motions, a
/// period of the excitation later.
TEST(DoubledMotions, EndWhereTheyHaveOnePeriodAgain) {
  const model::System system = test::project(R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.crusher]
mass = 400
center_of_mass = [0.03, 0, 0.1]
inertia = {about = "center_of_mass", xx = 25, yy = 30, zz = 34}
free = ["x", "z", "ry"]
[element_types.mount]
type = "bushing"
translation = ["150 N/mm", "150 N/mm", "120 N/mm"]
damping = {translation = [300, 300, 400], rotation = [0, 0, 0]}
laws.z = {polynomial = [0, -2e6, 4e8]}
[elements.left]
type = "mount"
on = "crusher"
at = [-0.5, 0, -0.1]
[elements.right]
type = "mount"
on = "crusher"
at = [0.5, 0, -0.1]
[elements."tilt stop"]
type = "stop"
on = "crusher"
at = [0.5, 0, 0.5]
axis = "x"
gaps = ["2 mm", "5 mm"]
stiffness = "800 N/mm"
[excitations.shaft]
type = "unbalance"
on = "crusher"
at = [0.1, 0, 0.2]
axis = "y"
mass_eccentricity = 0.5
)")
                                   .base()
                                   .system;
  constexpr double two_pi = 2 * std::numbers::pi;
  const SteadyBranch branch =
      nonlinear::steady_branch(system, {.from = 2.2 * two_pi, .to = 3.6 * two_pi, .harmonics = 12});
  ASSERT_EQ(branch.changes.size(), 2u);
  ASSERT_EQ(branch.further.size(), 1u);
  EXPECT_EQ(branch.further[0].periods, 2);
  for (const StabilityChange& change : branch.changes) EXPECT_EQ(change.curve, 0u);
  const std::vector<nonlinear::SteadyPoint>& doubled = branch.further[0].points;
  for (std::size_t i = 0; i + 1 < doubled.size(); ++i)
    EXPECT_LT(doubled[i].angular_frequency, doubled[i + 1].angular_frequency);
}

TEST_F(Auto, QuasiPeriodicMotionsOfANonlinearAbsorber) {
  const Machine machine{.first = {1, 0, 0, 0.02},
                        .second = {0.02, 0, 0.5, 0.01},
                        .second_mass = 0.1,
                        .force = 0.1,
                        .from = 0.6,
                        .to = 1.6};
  auto theirs = frequencies(machine);
  const SteadyBranch branch = ours(machine);
  ASSERT_EQ(theirs["TR"].size(), 2u);
  expect_same(changes(branch, StabilityChange::Kind::quasi_periodic), theirs["TR"]);
}

}  // namespace auto_test
