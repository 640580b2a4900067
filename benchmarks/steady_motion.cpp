// SPDX-License-Identifier: BSD-3-Clause
// How long does a curve of steady motion take, with its folds, stability and results? One hardening spring, and a body
// on four hardening mounts; compared with condensed harmonic balance in NumPy without stability, the spring also with
// pyHarm if it is installed. Then machines with two stops and with eight sliders, and the position of rest on stops,
// for which no program is at hand to compare with. Last the LU of a step along a curve, compared with Eigen's (which
// PivotedLu has) and LAPACK's.
#include "trivet/nonlinear/branch/steady_branch.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "measure.h"
#include "rival.h"
#include "rivals/lapack.h"
#include "trivet/foundation/freed_memory.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/judging/read_project.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/lane_lu.h"
#include "trivet/project/project.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;
using nonlinear::SteadyBranch;
using nonlinear::SteadyOptions;

constexpr double two_pi = 2 * std::numbers::pi;

const char* const one_mass = R"(trivet = 1
[bodies.m]
mass = 1.5
free = ["x"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [600, 0, 0]
damping = {translation = [0.9, 0, 0]}
laws.x = {cubic = 2e5}
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0.8, 0, 0]
)";

const char* const four_mounts = R"(trivet = 1
[bodies.m]
mass = 180
center_of_mass = [0.02, -0.015, 0.11]
inertia = {about = "center_of_mass", xx = 9.5, yy = 14.0, zz = 12.5, xy = 0.4, xz = -0.3, yz = -0.2}
[element_types.mount]
type = "bushing"
translation = [3e5, 3e5, 4.5e5]
damping = {proportional = 1.2e-3}
laws.z = {cubic = 1.2e11}
[tables.elements]
rows = [
  {name = "a", type = "mount", on = "m", at = [-0.45, -0.3, 0]},
  {name = "b", type = "mount", on = "m", at = [-0.45, 0.3, 0]},
  {name = "c", type = "mount", on = "m", at = [0.45, -0.3, 0]},
  {name = "d", type = "mount", on = "m", at = [0.45, 0.3, 0]},
]
[excitations.F]
type = "harmonic"
on = "m"
at = [0.1, 0.05, 0.2]
force = [0, 0, 400]
)";

model::System machine(const char* text) {
  const auto project = judging::project_from_text(text, "benchmark");
  if (!project) {
    for (const foundation::Problem& problem : project.error().list())
      std::fprintf(stderr, "%s\n", problem.finding.c_str());
    std::exit(1);
  }
  return project->base().system;
}

void write_problem(const model::System& system, const SteadyOptions& options, double cubic,
                   const std::filesystem::path& folder) {
  const nonlinear::References references = nonlinear::tangents_at_rest(system);
  const assembly::Assembled assembled = assembly::assemble(system);
  const std::vector<nonlinear::Deflection> deflections =
      nonlinear::nonlinear_deflections(system, assembled, references);
  const Eigen::Index n = assembled.matrices.size();
  Eigen::MatrixXd across(n, to_index(deflections.size()));
  for (std::size_t j = 0; j < deflections.size(); ++j) across.col(to_index(j)) = deflections[j].on_coordinates;
  const numerics::Load right = assembly::right_side(assembled, assembly::harmonic_loading(system, assembled));
  const Eigen::VectorXd force = right.terms().front().value.real();
  const double sizes[] = {static_cast<double>(n), static_cast<double>(deflections.size()),
                          static_cast<double>(options.harmonics)};
  const double scalars[] = {cubic, options.from, options.to};
  const auto write = [&](const char* name, const double* data, Eigen::Index count) {
    write_numbers(folder / name, data, to_size(count));
  };
  write("A", assembled.matrices.A.data(), n * n);
  write("B", assembled.matrices.B.data(), n * n);
  write("K", assembled.matrices.K.data(), n * n);
  write("W", across.data(), across.size());
  write("force", force.data(), n);
  write("sizes", sizes, 3);
  write("scalars", scalars, 3);
}

/// Largest error of the amplitudes that a rival has at the end of the band, relative to ours.
double error_at_the_end(Rival& rival, const SteadyBranch& branch) {
  const std::vector<std::complex<double>> theirs = rival.answers("curve");
  double error = 0;
  for (std::size_t j = 0; j < theirs.size(); ++j) {
    const double ours = branch.points.back().deflections.col(to_index(j)).segment<2>(1).norm();
    error = std::max(error, std::abs(ours - theirs[j].real()) / ours);
  }
  return error;
}

/// Required speed of Trivet relative to the rivals.
struct Goals {
  double numpy = 0;
  double pyharm = 0;  ///< 0: pyHarm is not asked
};

void compare(const char* name, const char* text, SteadyOptions options, double cubic, Goals goals) {
  const model::System system = machine(text);
  const foundation::TemporaryFolder folder;
  write_problem(system, options, cubic, folder.path());
  Rival python("steady.py", folder.path());
  const SteadyBranch branch = nonlinear::steady_branch(system, options);
  if (!branch.ended.empty() || branch.folds.size() != 2) {
    std::fprintf(stderr, "%s: %zu folds; %s\n", name, branch.folds.size(), branch.ended.c_str());
    std::exit(1);
  }
  double error = error_at_the_end(python, branch);
  SteadyOptions with_results = options;
  with_results.of = {"coordinates"};
  std::vector<Method> methods = {
      in_process("Trivet, with folds and stability", 1, [&] { (void)nonlinear::steady_branch(system, options); }),
      in_process("Trivet, with all coordinates too", 1, [&] { (void)nonlinear::steady_branch(system, with_results); }),
      python.method("curve", "NumPy, condensed, no stability", 1, goals.numpy),
  };
  std::optional<Rival> pyharm;
  if (goals.pyharm > 0) pyharm.emplace("steady_pyharm.py", folder.path());
  if (pyharm && pyharm->has("curve")) {
    error = std::max(error, error_at_the_end(*pyharm, branch));
    methods.push_back(pyharm->method("curve", "pyHarm, folds, no stability", 1, goals.pyharm));
  } else if (pyharm) {
    std::puts("pyHarm is absent");
  }
  compared(name, error, 1e-8);
  measure({name, std::to_string(branch.points.size()) + " points", "curve", error}, methods, 9);
}

const char* const two_stops = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m]
mass = 180
center_of_mass = [0.02, -0.015, 0.11]
inertia = {about = "center_of_mass", xx = 9.5, yy = 14.0, zz = 12.5, xy = 0.4}
[element_types.mount]
type = "bushing"
translation = [3e5, 3e5, 4.5e5]
damping = {proportional = 2e-3}
[tables.elements]
rows = [
  {name = "a", type = "mount", on = "m", at = [-0.45, -0.3, 0]},
  {name = "b", type = "mount", on = "m", at = [-0.45, 0.3, 0]},
  {name = "c", type = "mount", on = "m", at = [0.45, 0, 0]},
  {name = "front", type = "stop", on = "m", at = [0.5, 0.2, 0], axis = "-z", gap = 2e-3, stiffness = 1e6},
  {name = "rear", type = "stop", on = "m", at = [-0.5, 0.2, 0], axis = "z", gap = 5e-4, stiffness = 1e6},
]
[excitations.F]
type = "harmonic"
on = "m"
at = [0.1, 0.05, 0.2]
force = [0, 0, 400]
)";

/// Two inclined struts that hold one coordinate: six deflections of one motion, with a snap through.
const char* const two_struts = R"(trivet = 1
[bodies.m]
mass = 25
free = ["z"]
[elements.up]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [0, 0, 3210]
damping = {translation = [0, 0, 8]}
[elements.l]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [-0.1, 0, 0]
free_length = 0.14
stiffness = 4000
[elements.r]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [0.1, 0, 0]
free_length = 0.14
stiffness = 4000
[excitations.F]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [0, 0, 3]
)";

/// Ten bodies in a row on bushings, eight of them with friction snubbers.
std::string ten_bodies() {
  std::string text = "trivet = 1\n";
  for (int i = 0; i < 10; ++i) {
    const std::string name = std::to_string(i), x = std::to_string(0.5 * i);
    text += "[bodies.b" + name + "]\nmass = 20\nposition = [" + x +
        ", 0, 0]\ninertia = {about = \"center_of_mass\", xx = 0.4, yy = 0.5, zz = 0.6}\n[elements.m" + name +
        "]\ntype = \"bushing\"\non = \"b" + name +
        "\"\nat = [0, 0, -0.1]\ntranslation = [4e4, 5e4, 6e4]\nrotation = [500, 500, 500]\ndamping = {proportional = "
        "2e-3}\n" +
        (i < 8 ? "laws.z = {friction = {slip = 6, stiffness = 3e4}}\n" : "");
    if (i > 0)
      text += "[elements.c" + name + "]\ntype = \"bushing\"\non = \"b" + name + "\"\nat = [-0.25, 0, 0]\nfrom = \"b" +
          std::to_string(i - 1) + "\"\ntranslation = [2e4, 2e4, 2e4]\nrotation = [100, 100, 100]\n";
  }
  return text + "[excitations.F]\ntype = \"harmonic\"\non = \"b3\"\nat = [0.05, 0.05, 0.1]\nforce = [5, 0, 40]\n";
}

/// Of ours alone.
void time_curve(const char* name, const std::string& text, const SteadyOptions& options) {
  const model::System system = machine(text.c_str());
  const SteadyBranch branch = nonlinear::steady_branch(system, options);
  if (!branch.ended.empty()) {
    std::fprintf(stderr, "%s: %s\n", name, branch.ended.c_str());
    std::exit(1);
  }
  const auto points = static_cast<double>(branch.points.size());
  measure({name, std::to_string(branch.points.size()) + " points", "point"},
          {in_process("Trivet, with stability", points, [&] { (void)nonlinear::steady_branch(system, options); })}, 5);
}

void time_rest() {
  const model::System system = machine(two_stops);
  measure({"position of rest of six coordinates with two stops", "1 machine", "position"},
          {in_process("Trivet", 1, [&] { (void)nonlinear::rest_position(system); })}, 9);
}

void compare_lu(Eigen::Index rows) {
  Eigen::MatrixXd A(rows, rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < rows; ++j) A(i, j) = std::sin(static_cast<double>(1 + 3 * i + 7 * j + i * j));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(rows, 1, 2);
  const Eigen::VectorXd ours = numerics::LaneLu(A).solve(b), eigens = numerics::PivotedLu<double>(A).solve(b);
  Eigen::MatrixXd factors;
  std::vector<lapack_int> pivots(to_size(rows));
  Eigen::VectorXd lapacks = b;
  const auto by_lapack = [&](Eigen::VectorXd& x) {
    factors = A;
    const auto n = static_cast<lapack_int>(rows);
    lapack_int info = 0;
    const lapack_int one = 1;
    LAPACK_dgesv(&n, &one, factors.data(), &n, pivots.data(), x.data(), &n, &info);
  };
  by_lapack(lapacks);
  const double error = std::max((ours - eigens).norm(), (ours - lapacks).norm()) / ours.norm();
  compared("LU", error, 1e-9);
  measure({"LU of a step along a curve and one solution", std::to_string(rows) + " unknowns", "matrix", error},
          {in_process("Trivet, in lanes", 1, [&] { (void)numerics::LaneLu(A).solve(b); }),
           in_process("Eigen, PartialPivLU", 1, [&] { (void)numerics::PivotedLu<double>(A).solve(b); }),
           in_process("LAPACK dgesv", 1, [&] {
             lapacks = b;
             by_lapack(lapacks);
           })});
}

}  // namespace

int main() {
  foundation::keep_freed_memory();  // as the program does
  const OneCore one_core;
  SteadyOptions one{.from = 14, .to = 30, .harmonics = 7};
  compare("curve of a hardening spring", one_mass, one, 2e5, {.numpy = 35, .pyharm = 3000});
  SteadyOptions four{.from = 8 * two_pi, .to = 26 * two_pi, .harmonics = 9};
  compare("curve of a body on four hardening mounts", four_mounts, four, 1.2e11, {.numpy = 10});
  time_curve("two struts on one coordinate, 15 harmonics", two_struts, {.from = 0.8, .to = 14, .harmonics = 15});
  time_curve("six coordinates with two stops, 25 harmonics", two_stops,
             {.from = 8 * two_pi, .to = 16 * two_pi, .harmonics = 25});
  time_curve("sixty coordinates with eight sliders, 9 harmonics", ten_bodies(),
             {.from = 5 * two_pi, .to = 12 * two_pi, .harmonics = 9});
  time_rest();
  for (const Eigen::Index unknowns : {16, 77, 103}) compare_lu(unknowns);  // the first three curves
}
