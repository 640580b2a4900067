// SPDX-License-Identifier: BSD-3-Clause
// How long do whole commands take for chains of one to a hundred bodies? Each body stands on two bushings with dampers
// and is coupled to the next; compared with LAPACK's eigensolvers on the same matrices.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "process.h"
#include "rivals/lapack.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/project.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;

constexpr int answers = 12;

std::string bushing(const std::string& name, const std::string& between, const std::string& at, double stiffness,
                    double rotation) {
  return fmt::format(
      "[elements.{}]\ntype = \"bushing\"\n{}\nat = {}\ntranslation = [{}, {}, {}]\nrotation = [{}, {}, {}]\n"
      "damping = {{translation = [{}, {}, {}], rotation = [1, 1, 1]}}\n",
      name, between, at, stiffness, 1.1 * stiffness, 2 * stiffness, rotation, 1.2 * rotation, 0.9 * rotation,
      1.5e-3 * stiffness, 1.6e-3 * stiffness, 1.3e-3 * stiffness);
}

/// Least-squares slope of log time over log size.
double slope(const std::vector<std::pair<double, double>>& size_and_seconds) {
  const auto count = static_cast<double>(size_and_seconds.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [size, seconds] : size_and_seconds) {
    const double a = std::log(size), b = std::log(seconds);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

/// The project file of a chain.
std::string chain(int bodies, int points = 6000) {
  std::string text = "trivet = 1\n";
  for (int i = 0; i < bodies; ++i)
    text += fmt::format(
        "[bodies.b{}]\nmass = {}\ncenter_of_mass = [0.02, 0.01, 0.05]\nposition = [{}, 0, 0]\ninertia = {{about = "
        "\"center_of_mass\", xx = {}, yy = {}, zz = 6}}\n",
        i, 100 + 3 * (i % 7), i, 4 + 0.1 * (i % 5), 5 + 0.2 * (i % 3));
  for (int i = 0; i < bodies; ++i) {
    for (const auto& [side, y] : {std::pair{"l", 0.4}, {"r", -0.4}})
      text += bushing(fmt::format("g{}{}", i, side), fmt::format("on = \"b{}\"", i), fmt::format("[0.1, {}, -0.2]", y),
                      2e5 + 1e4 * (i % 4), 100);
    if (i > 0)
      text += bushing(fmt::format("c{}", i), fmt::format("on = \"b{}\"\nfrom = \"b{}\"", i, i - 1), "[-0.5, 0.05, 0.1]",
                      5e5, 500);
  }
  std::string of;
  for (int k = 0; k < answers; ++k)
    of += fmt::format("{}\"b{}.{}\"", k > 0 ? ", " : "", k * (bodies - 1) / (answers - 1),
                      (std::array{"x", "y", "z", "rx", "ry", "rz"})[bodies > 1 ? k % 3 : k % 6]);
  if (bodies == 1) of = R"("b0.x", "b0.y", "b0.z", "b0.rx", "b0.ry", "b0.rz")";
  return text +
      fmt::format(
             "[excitations.drive]\ntype = \"harmonic\"\non = \"b0\"\nat = [0, 0, 0.1]\nforce = [10, 20, 100]\n"
             "[analyses.response]\nband = [\"0 Hz\", \"40 Hz\"]\npoints = {1}\nspacing = \"linear\"\nof = [{0}]\n"
             "[analyses.peaks]\nof = [{0}]\n",
             of, points);
}

/// Squared natural frequencies by LAPACK, and its CPU time.
Eigen::VectorXd by_lapack(const numerics::DynamicMatrices& m, double& seconds) {
  const auto n = static_cast<lapack_int>(m.size());
  Eigen::VectorXd values(n);
  seconds = in_process("", 1, [&] {
              Eigen::MatrixXd k = m.K, a = m.A;
              LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', n, k.data(), n, a.data(), n, values.data());
            }).seconds();
  return values;
}

/// CPU time of the eigenproblem of the states.
double states_by_lapack(const numerics::DynamicMatrices& m) {
  const Eigen::Index n = m.size();
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(2 * n, 2 * n), a = m.A, right(n, 2 * n);
  right << -m.K, -m.B;
  std::vector<lapack_int> pivots(to_size(n));
  LAPACKE_dgesv(LAPACK_COL_MAJOR, static_cast<lapack_int>(n), static_cast<lapack_int>(2 * n), a.data(),
                static_cast<lapack_int>(n), pivots.data(), right.data(), static_cast<lapack_int>(n));
  state.topRightCorner(n, n).setIdentity();
  state.bottomRows(n) = right;
  const auto size = static_cast<lapack_int>(2 * n);
  return in_process("", 1,
                    [&] {
                      Eigen::MatrixXd copy = state, vectors(2 * n, 2 * n);
                      Eigen::VectorXd real(2 * n), imaginary(2 * n);
                      LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'V', size, copy.data(), size, real.data(), imaginary.data(),
                                    nullptr, 1, vectors.data(), size);
                    })
      .seconds();
}

}  // namespace

int main() {
  const std::string question = "many bodies";
  const foundation::TemporaryFolder folder;
  const double start = median({TRIVET_PROGRAM, "--version"}, 21).cpu;
  record(question, "start of the program, CPU", start, "s", "", true);
  std::map<std::string, std::vector<std::pair<double, double>>> grown;  // by command: bodies and seconds
  struct Growth {
    const char* command;
    double least, most;  ///< 0: no goal
  };
  struct Goals {
    int bodies;
    double modes, roots, response, peaks;
  };
  for (const Goals& goal :
       {Goals{1, 0.02, 0.02, 0.1, 0.05}, Goals{10, 0.02, 0.03, 0.1, 0.15}, Goals{20, 0.05, 0.1, 0.2, 0.5},
        Goals{50, 0.1, 0.6, 0.5, 4}, Goals{100, 0.4, 4.5, 1.2, 0}}) {
    const std::string file = (folder.path() / fmt::format("chain{}.toml", goal.bodies)).string();
    std::ofstream(file) << chain(goal.bodies);
    const auto project = judging::read_project(file);
    if (!project) return 1;
    const numerics::DynamicMatrices m = assembly::assemble(project->base().system).matrices;
    double eigh = 0;
    const Eigen::VectorXd squared = by_lapack(m, eigh);
    const Eigen::VectorXd found = [&] {
      Eigen::VectorXd values(m.size());
      const modal::Modes modes = modal::modes(project->base().system);
      for (std::size_t i = 0; i < modes.list.size(); ++i) values(to_index(i)) = modes.list[i].eigenvalue_squared;
      return values;
    }();
    compared("squared natural frequencies", (found - squared).cwiseAbs().maxCoeff() / squared.maxCoeff(), 1e-12);
    const auto command = [&](const char* name, const char* format, double limit) {
      const Run run = median({TRIVET_PROGRAM, name, file, format}, 7);
      const std::string what = fmt::format("`trivet {}`, {} bodies, CPU", name, goal.bodies);
      if (limit > 0) record(question, what, run.cpu, "s", fmt::format("≤ {}", limit), run.cpu <= limit);
      else record(question, what, run.cpu, "s", "", true);
      if (goal.bodies >= 10) grown[name].emplace_back(goal.bodies, run.cpu - start);
    };
    command("modes", "--json", goal.modes);
    record(question, "… LAPACK `dsygvd` of the same matrices", eigh, "s", "", true);
    command("roots", "--json", goal.roots);
    record(question, "… LAPACK `dgeev` of the same states", states_by_lapack(m), "s", "", true);
    command("response", "--csv", goal.response);
    if (goal.bodies >= 10) {
      std::ofstream(file) << chain(goal.bodies, 2);
      const Run set_up = median({TRIVET_PROGRAM, "response", file, "--csv"}, 7);
      record(question, "… of which before its 6000 frequencies", set_up.cpu, "s", "", true);
      grown["response after set-up"].emplace_back(goal.bodies, grown["response"].back().second + start - set_up.cpu);
    }
    command("peaks", "--json", goal.peaks);
  }
  for (const Growth& growth : {Growth{"modes", 0, 2.7}, Growth{"roots", 0, 3}, Growth{"response", 0, 0},
                               Growth{"response after set-up", 0.85, 1.15}, Growth{"peaks", 0, 2.3}}) {
    const double found = slope(grown[growth.command]);
    const bool met = growth.most == 0 || (found >= growth.least && found <= growth.most);
    record(question, fmt::format("{}: growth from 10 to 100 bodies, exponent", growth.command), found, "",
           growth.most == 0       ? ""
               : growth.least > 0 ? fmt::format("{} … {}", growth.least, growth.most)
                                  : fmt::format("≤ {}", growth.most),
           met);
  }
}
