// SPDX-License-Identifier: BSD-3-Clause
// Flexible foundations, compared with the same foundations modelled by bodies.
#include <gmock/gmock.h>

#include <complex>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/temporary_folder.h"

namespace foundation_test {

using namespace trivet;

constexpr double round_off = 1e-9;       // solves of up to 18 coordinates
constexpr double root_round_off = 1e-8;  // roots of the same
constexpr double last_digits = 1e-12;    // one coordinate

std::string machine(const std::string& mount, const std::string& rest) {
  return R"(trivet = 1
[bodies.machine]
mass = 400
inertia = {about = "center_of_mass", xx = 30, yy = 50, zz = 60}
center_of_mass = [0.02, 0.01, 0.3]
[excitations.push]
type = "harmonic"
on = "machine"
at = [0.1, 0.2, 0.3]
force = [10, 20, 100]
)" + mount +
      rest +
      R"([analyses]
response = {at = [20, 60, 95, 150, 400], of = ["machine", "ground"]}
roots = {}
)";
}

std::string mount(const std::string& name, const std::string& at, const std::string& more) {
  return "[elements." + name + "]\ntype = \"bushing\"\non = \"machine\"\nat = " + at +
      "\ntranslation = [2e6, 2e6, 4e6]\nrotation = [1e3, 1e3, 1e3]\ndamping = {proportional = 0.002}\n" + more;
}

study::CaseResults results_of(const std::string& text) {
  const project::Project project = test::project(text);
  return study::case_results(project.base(), project.base().analyses);
}

void expect_same(const study::CaseResults& a, const study::CaseResults& b, double tolerance) {
  ASSERT_TRUE(a.response && b.response);
  for (const auto& curve : a.response->curves.curves)
    for (const auto& other : b.response->curves.curves)
      if (curve.name == other.name) {
        EXPECT_LT((curve.value - other.value).cwiseAbs().maxCoeff(), tolerance * other.value.cwiseAbs().maxCoeff())
            << curve.name;
      }
  EXPECT_TRUE(a.response->deep.passed);
}

const std::string deck =
    "[foundations.deck]\ntype = \"impedance\"\nmass = 60\ntranslation = [5e6, 6e6, 3e6]\nfree = [\"z\"]\ndamping = "
    "{loss_factor = 0.06}\n";

/// A guided body of 60 kg under each mount.
std::string raft(const std::string& name, const std::string& at) {
  return "[bodies." + name + "]\nmass = 60\nfree = [\"z\"]\nposition = " + at + "\n[elements.\"under " + name +
      "\"]\ntype = \"three_springs\"\non = \"" + name +
      "\"\nat = [0, 0, 0]\ntranslation = [5e6, 6e6, 3e6]\ndamping = {loss_factor = 0.06}\n";
}

TEST(Foundation, ImpedanceIsABodyOnASpring) {
  const std::string stands = "foundation = \"deck\"\n";
  const study::CaseResults given =
      results_of(machine(mount("a", "[0.5, 0.4, -0.2]", stands) + mount("b", "[-0.5, -0.4, -0.2]", stands) +
                             mount("c", "[0.5, -0.4, -0.2]", ""),
                         deck));
  const study::CaseResults built = results_of(machine(
      raft("p", "[0.5, 0.4, -0.2]") + raft("q", "[-0.5, -0.4, -0.2]") +
          mount("a", "[0.5, 0.4, -0.2]", "from = \"p\"\nfrom_at = [0, 0, 0]\n") +
          mount("b", "[-0.5, -0.4, -0.2]", "from = \"q\"\nfrom_at = [0, 0, 0]\n") + mount("c", "[0.5, -0.4, -0.2]", ""),
      ""));
  // The totals on the ground contain the forces of the mounts on the foundation; in the model of bodies, those of its
  // springs. So only the machine is compared.
  for (const auto& curve : given.response->curves.curves)
    for (const auto& other : built.response->curves.curves)
      if (curve.name == other.name && curve.name.starts_with("machine")) {
        EXPECT_LT((curve.value - other.value).cwiseAbs().maxCoeff(), round_off * other.value.cwiseAbs().maxCoeff())
            << curve.name;
      }
  EXPECT_TRUE(given.response->deep.passed);
  ASSERT_EQ(given.roots.list.size(), built.roots.list.size());
  for (std::size_t i = 0; i < given.roots.list.size(); ++i)
    EXPECT_LT(std::abs(given.roots.list[i].eigenvalue - built.roots.list[i].eigenvalue),
              root_round_off * std::abs(built.roots.list[i].eigenvalue));
}

TEST(Foundation, OneModeIsABodyThatSharesIt) {
  // One mode that lifts both feet equally: a rigid strip of 150 kg guided along z.
  const std::string strip =
      "[bodies.strip]\nmass = 150\nfree = [\"z\"]\n[elements.ground_spring]\ntype = \"three_springs\"\non = "
      "\"strip\"\nat = [0, 0, 0]\ntranslation = [0, 0, 1.2e6]\ndamping = {matrix = "
      "[[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,800,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]}\n";
  const double omega = std::sqrt(1.2e6 / 150), ratio = 800 / (2 * omega * 150);
  char mode[400];
  std::snprintf(mode, sizeof mode,
                "[foundations.deck]\ntype = \"modal\"\nmodes = [{frequency = %.17g, modal_mass = 150, damping = %.17g, "
                "shapes = {a = [0, 0, 1], b = [0, 0, 1]}}]\n",
                omega, ratio);
  const std::string stands = "foundation = \"deck\"\n", on_strip = "from = \"strip\"\n";
  expect_same(
      results_of(machine(mount("a", "[0.5, 0.4, -0.2]", stands) + mount("b", "[-0.5, -0.4, -0.2]", stands), mode)),
      [&] {
        study::CaseResults built = results_of(
            machine(strip + mount("a", "[0.5, 0.4, -0.2]", on_strip) + mount("b", "[-0.5, -0.4, -0.2]", on_strip), ""));
        std::erase_if(built.response->curves.curves,
                      [](const auto& curve) { return !curve.name.starts_with("machine"); });
        return built;
      }(),
      round_off);
}

TEST(Foundation, WithoutMassIsASpringInSeries) {
  // Along z only: two springs in series under a guided machine.
  const std::string text = R"(trivet = 1
[bodies.machine]
mass = 100
free = ["z"]
[elements.mount]
type = "three_springs"
on = "machine"
at = [0, 0, 0]
translation = [1e5, 1e5, 2e5]
foundation = "floor"
[foundations.floor]
type = "impedance"
translation = [1, 1, 3e5]
free = ["z"]
[excitations.push]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 5]
[analyses]
response = {at = [10, 50], of = ["machine", "mount"]}
roots = {}
modes = {}
)";
  const study::CaseResults found = results_of(text);
  const double k = 1 / (1 / 2e5 + 1 / 3e5);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double w = found.response->curves.angular_frequency[i];
    EXPECT_NEAR(test::value(*found.response, "machine.z", i).real(), 5 / (k - 100 * w * w),
                last_digits * std::abs(5 / (k - 100 * w * w)));
    EXPECT_NEAR(test::value(*found.response, "mount.force.z", i).real(), 5 * k / (k - 100 * w * w), round_off);
  }
  EXPECT_NEAR(*found.modes.list[0].angular_frequency, std::sqrt(k / 100), round_off);
  ASSERT_EQ(found.roots.list.size(), 2u);
  EXPECT_NEAR(std::abs(found.roots.list[0].eigenvalue), std::sqrt(k / 100), round_off);
}

/// 100 kg guided along z on a mount, on ground of 800 kg, 5e5 N/m and 2000 N s/m.
std::string on_heavy_ground(const std::string& ground) {
  return R"(trivet = 1
[bodies.m]
mass = 100
free = ["z"]
[elements.k]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [4e5, 4e5, 4e5]
damping = {matrix = [[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,600,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]}
foundation = "floor"
[excitations.push]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 100]
[analyses]
response = {band = ["1 Hz", "15 Hz"], of = ["m", "k"]}
peaks = {}
)" + ground;
}

TEST(Foundation, MeasuredMobilityHasThePeaksOfItsImpedance) {
  constexpr double straight_lines = 1e-3;  // rows every 0.02 Hz across resonances 0.4 Hz wide
  constexpr double one_row = 0.13;         // rad/s: 0.02 Hz
  const foundation::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "mobility_of_a_floor.csv";
  {
    std::ofstream csv(file);
    csv << "frequency_hz,y_z_z,y_z_z_im\n";
    csv.precision(15);
    for (int i = 50; i <= 1000; ++i) {
      const double w = 2 * std::numbers::pi * 0.02 * i;
      const std::complex<double> y = 1.0 / std::complex<double>(2000, 800 * w - 5e5 / w);
      csv << 0.02 * i << "," << y.real() << "," << y.imag() << "\n";
    }
  }
  const study::CaseResults measured =
      results_of(on_heavy_ground("[foundations.floor]\ntype = \"mobility\"\nfile = \"" + file.string() + "\"\n"));
  const study::CaseResults given = results_of(on_heavy_ground(
      "[foundations.floor]\ntype = \"impedance\"\nfree = [\"z\"]\nmass = 800\ntranslation = [1, 1, 5e5]\n"
      "damping = {matrix = "
      "[[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,2000,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]}\n"));
  std::filesystem::remove(file);
  ASSERT_TRUE(measured.peaks && given.peaks);
  int compared = 0;
  for (const response::Peak& wanted : given.peaks->peaks.list) {
    const std::string& name = given.peaks->peaks.curves[wanted.curve].name;
    if (wanted.angular_frequency > 2 * std::numbers::pi * 15 || !(wanted.prominence > 0.05 * wanted.amplitude))
      continue;
    bool found = false;
    for (const response::Peak& peak : measured.peaks->peaks.list)
      if (measured.peaks->peaks.curves[peak.curve].name == name)
        found = found ||
            (std::abs(peak.angular_frequency - wanted.angular_frequency) < one_row &&
             std::abs(peak.amplitude - wanted.amplitude) < straight_lines * wanted.amplitude);
    EXPECT_TRUE(found) << name << " at " << wanted.angular_frequency << " rad/s";
    ++compared;
  }
  EXPECT_GE(compared, 4);  // two resonances in the motion and two in the force
}

TEST(Foundation, MobilityTablesHaveUnitsInTheirHeadings) {
  constexpr double last_digits = 1e-9;  // of 15 in the tables
  const foundation::TemporaryFolder folder;
  const auto highest = [&](const std::string& heading, double per_hertz, double per_mobility) {
    {
      std::ofstream csv(folder.path() / "y.csv");
      csv << heading << "\n";
      csv.precision(15);
      for (int i = 50; i <= 1000; i += 5) {
        const double w = 2 * std::numbers::pi * 0.02 * i;
        const std::complex<double> y = per_mobility / std::complex<double>(2000, 800 * w - 5e5 / w);
        csv << per_hertz * 0.02 * i << "," << y.real() << "," << y.imag() << "\n";
      }
    }
    const study::CaseResults found = results_of(on_heavy_ground("[foundations.floor]\ntype = \"mobility\"\nfile = \"" +
                                                                (folder.path() / "y.csv").string() + "\"\n"));
    return found.peaks->peaks.list.front().amplitude;
  };
  const double si = highest("frequency_hz,y_z_z,y_z_z_im", 1, 1);
  EXPECT_THAT(highest("frequency [Hz],y_z_z [m/(N s)],y_z_z_im [m/(N s)]", 1, 1),
              test::RelativelyNear(si, last_digits));
  EXPECT_THAT(highest("frequency [rpm],y_z_z [(mm/s)/N],y_z_z_im [(mm/s)/N]", 60, 1e3),
              test::RelativelyNear(si, last_digits));
  EXPECT_THAT(highest("frequency (Hz),y_z_z (m/s/kN),y_z_z_im (m/s/kN)", 1, 1e3),
              test::RelativelyNear(si, last_digits));
}

}  // namespace foundation_test
