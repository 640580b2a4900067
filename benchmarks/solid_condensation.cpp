// SPDX-License-Identifier: BSD-3-Clause
// How long does the condensation of a meshed solid onto the 12 motions of its plates take, and how much memory, by
// recursive substructuring and by MUMPS, a general sparse solver? Both start from the same mesh and compute the same
// element matrices. Each run is a process of its own, so that its memory is known. Answers are compared before times
// are reported.
//   solid_condensation [RUNS [SOLID...]]   default: medians of 3 runs, all solids (numbers from 0)
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "../tests/support/tetrahedra.h"
#include "trivet/fem/shapes.h"
#include "trivet/fem/solid.h"
#include "trivet/foundation/index.h"
#include "trivet/spatial/rigid_motion.h"

#ifdef TRIVET_HAS_MUMPS
#include <cblas.h>
#include <dmumps_c.h>
#endif

namespace {

using namespace trivet;
using spatial::Matrix12;

const fem::Block block{.width = 0.06, .depth = 0.05, .layers = {{.thickness = 0.03}}};
const fem::Disc cylinder{.diameter = 0.05, .layers = {{.thickness = 0.025}}};
const fem::Disc sandwich{.diameter = 0.1, .layers = fem::sandwich_layers(4, 0.008, 0.002)};
const std::vector<fem::Material> materials{fem::linear_elastic(3e6, 0.4995), fem::linear_elastic(2.1e11, 0.3)};

/// Continuous pressures of tetrahedra are unknowns: the matrix is indefinite. Those of hexahedra are condensed in the
/// element: the matrix is positive definite.
struct Case {
  std::string name;
  fem::Shape shape;
  int level;
  bool tetrahedra = false;
};
const std::vector<Case> cases{{"block, tetrahedra", block, 4, true},
                              {"block, tetrahedra", block, 5, true},
                              {"block, tetrahedra", block, 8, true},
                              {"cylinder, hexahedra", cylinder, 4},
                              {"cylinder, hexahedra", cylinder, 5},
                              {"cylinder, hexahedra", cylinder, 8},
                              {"sandwich of four layers, level 2", sandwich, 2},
                              {"sandwich of four layers, level 3", sandwich, 3}};

/// Of entries over √(C_ii C_jj): round-off times the condition of a matrix of steel and nearly incompressible rubber.
/// 4e-11 was observed, the discretisation has 1e-4.
constexpr double tolerance = 1e-9;

constexpr auto pressure = fem::TetPressure::continuous;

fem::Mesh mesh_of(const Case& c) {
  const fem::Mesh mesh = fem::mesh(c.shape, c.level);
  return c.tetrahedra ? test::in_tetrahedra(mesh) : mesh;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a process reports of its run, and what its parent adds.
struct Outcome {
  double unknowns = 0, negative = 0;           ///< negative eigenvalues of the condensed part
  double assembly = 0, ordering = 0, all = 0;  ///< wall times from the mesh to the result [s]
  Matrix12 stiffness = Matrix12::Zero();
  double cpu = 0;     ///< of all threads, with the mesh [s]
  double memory = 0;  ///< largest resident, with the mesh [byte]
};

Outcome by_substructuring(const Case& c, int threads) {
  const fem::Mesh mesh = mesh_of(c);
  const fem::ElementFrame frame = fem::frame(c.shape);
  Outcome outcome;
  const double start = seconds_now();
  fem::Solid solid(mesh, materials, pressure);
  outcome.ordering = seconds_now() - start;
  const auto result = solid.linearise(solid.rest(frame.point_n, frame.point_k), false, threads, {});
  outcome.all = seconds_now() - start;
  if (result.singular || result.inverted) throw std::runtime_error("singular");
  outcome.unknowns = solid.unknowns().count;
  outcome.negative = result.negative_pivots + solid.unknowns().pressure_count;
  outcome.stiffness = result.tangent;
  return outcome;
}

#ifdef TRIVET_HAS_MUMPS

/// Lower triangle of the assembled matrix with the 12 motions of the plates as the last unknowns; MUMPS sums entries
/// that are given twice.
struct Triplets {
  std::vector<MUMPS_INT> rows, columns;  ///< from 1
  std::vector<double> values;
};

Triplets assembled(const fem::Mesh& mesh, const fem::Unknowns& unknowns, const fem::ElementFrame& frame) {
  Triplets all;
  const Eigen::Index nodes = mesh.elements.rows();
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Matrix3Xd x = mesh.nodes(Eigen::all, Eigen::VectorXi(mesh.elements.col(e)));
    const fem::ElementSystem system =
        fem::element_system(mesh.kind, pressure, x, materials[mesh.material[e]], nullptr, nullptr);
    std::vector<int> own;  // of free displacements, pressures and motions of plates
    std::vector<Eigen::Index> local, bonded;
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(system.tangent.rows(), 12);
    for (Eigen::Index i = 0; i < system.tangent.rows(); ++i) {
      const Eigen::Index a = i % nodes;
      const int number = i < 3 * nodes ? unknowns.displacement[mesh.elements(a, e)] : 0;
      if (number < 0) {
        const bool at_n = number == fem::Unknowns::on_plate_n;
        bonded.push_back(i);
        motion.block<1, 6>(i, at_n ? 0 : 6) =
            spatial::rigid_motion(x.col(a) - (at_n ? frame.point_n : frame.point_k)).row(i / nodes);
        continue;
      }
      local.push_back(i);
      own.push_back(i < 3 * nodes ? number + static_cast<int>(i / nodes) : unknowns.pressure[e][i - 3 * nodes]);
    }
    const Eigen::Index free = to_index(local.size());
    Eigen::MatrixXd matrix = system.tangent(local, local);
    if (!bonded.empty()) {
      const Eigen::MatrixXd levers = motion(bonded, Eigen::all);
      matrix.conservativeResize(free + 12, free + 12);
      matrix.block(free, 0, 12, free) = levers.transpose() * system.tangent(bonded, local);
      matrix.block(free, free, 12, 12) = levers.transpose() * system.tangent(bonded, bonded) * levers;
      for (int i = 0; i < 12; ++i) own.push_back(unknowns.count + i);
    }
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const double value = matrix(to_index(i), to_index(j));
        if (value == 0) continue;
        all.rows.push_back(own[i] + 1);
        all.columns.push_back(own[j] + 1);
        all.values.push_back(value);
      }
  }
  return all;
}

/// A job of MUMPS; more working memory is given if pivoting needs it.
void run(DMUMPS_STRUC_C& mumps, int job) {
  mumps.job = job;
  for (int attempt = 0; attempt < 4; ++attempt) {
    dmumps_c(&mumps);
    if (mumps.infog[0] != -9 && mumps.infog[0] != -8) break;
    mumps.icntl[13] *= 2;
  }
  if (mumps.infog[0] < 0)
    throw std::runtime_error("MUMPS: INFOG(1) = " + std::to_string(mumps.infog[0]) +
                             ", INFOG(2) = " + std::to_string(mumps.infog[1]));
}

/// An instance of sequential MUMPS on a matrix of `size` unknowns, silent, with one thread.
class Mumps {
 public:
  Mumps(int symmetry, int size, Triplets& matrix) {
    job_.par = 1;
    job_.sym = symmetry;
    job_.comm_fortran = -987654;
    run(job_, -1);
    for (int output = 0; output < 4; ++output) job_.icntl[output] = output < 3 ? -1 : 0;
    job_.n = size;
    job_.nnz = to_index(matrix.values.size());
    job_.irn = matrix.rows.data();
    job_.jcn = matrix.columns.data();
    job_.a = matrix.values.data();
  }
  ~Mumps() { run(job_, -2); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;
  DMUMPS_STRUC_C* operator->() { return &job_; }
  void analyse() { run(job_, 1); }
  void factorise() { run(job_, 2); }
  void solve() { run(job_, 3); }

 private:
  DMUMPS_STRUC_C job_{};
};

/// Schur complement by MUMPS with one thread, its factors discarded. With a Schur complement MUMPS itself orders by
/// approximate minimum degree only, which takes more operations; so the order is computed first without one.
Outcome by_mumps(const Case& c, int ordering) {
  constexpr int given_order = 1, plain_order = 1, centralized = 1;
  openblas_set_num_threads(1);
  const fem::Mesh mesh = mesh_of(c);
  Outcome outcome;
  const double start = seconds_now();
  const fem::Unknowns unknowns = fem::number_unknowns(mesh, pressure);
  const int free = unknowns.count, all = free + 12;
  Triplets matrix = assembled(mesh, unknowns, fem::frame(c.shape));
  outcome.assembly = seconds_now() - start;

  const int symmetry = c.tetrahedra ? 2 : 1;  // indefinite, or positive definite and not pivoted
  std::vector<MUMPS_INT> place(to_size(all));
  {
    Mumps order(symmetry, all, matrix);
    order->icntl[6] = ordering;
    order->icntl[11] = plain_order;
    order.analyse();
    std::copy(order->sym_perm, order->sym_perm + all, place.begin());
  }
  std::vector<int> unknown(to_size(all));
  for (int i = 0; i < all; ++i) unknown[place[i] - 1] = i;
  std::erase_if(unknown, [free](int i) { return i >= free; });
  for (int i = 0; i < 12; ++i) unknown.push_back(free + i);
  for (int i = 0; i < all; ++i) place[unknown[i]] = i + 1;

  Mumps mumps(symmetry, all, matrix);
  std::array<MUMPS_INT, 12> retained{};
  std::array<double, 144> schur{};
  for (int i = 0; i < 12; ++i) retained[i] = free + i + 1;
  mumps->icntl[6] = given_order;
  mumps->perm_in = place.data();
  mumps->icntl[18] = centralized;
  mumps->size_schur = 12;
  mumps->listvar_schur = retained.data();
  mumps->schur = schur.data();
  mumps->icntl[30] = 1;  // factors are discarded
  mumps.analyse();
  outcome.ordering = seconds_now() - start - outcome.assembly;
  mumps.factorise();
  outcome.all = seconds_now() - start;
  outcome.unknowns = free;
  outcome.negative = mumps->infog[11];
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j <= i; ++j) outcome.stiffness(i, j) = outcome.stiffness(j, i) = schur[12 * i + j];
  return outcome;
}

#else
Outcome by_mumps(const Case&, int) { throw std::runtime_error("built without MUMPS"); }
#endif

struct Method {
  std::string name;
  bool ours;
  int option;  ///< threads, or MUMPS's number of its ordering
};
#ifdef TRIVET_HAS_MUMPS
constexpr int scotch = 3, pord = 4;
const std::vector<Method> methods{{"Trivet, one thread", true, 1},
                                  {"Trivet, two threads", true, 2},
                                  {"MUMPS, ordered by PORD", false, pord},
                                  {"MUMPS, ordered by SCOTCH", false, scotch}};
#else
const std::vector<Method> methods{{"Trivet, one thread", true, 1}, {"Trivet, two threads", true, 2}};
#endif

/// Runs one method on one solid in this process and writes the outcome to the standard output.
int answer(const std::string& solid, const std::string& method) {
  const Case& c = cases.at(std::stoul(solid));
  const Method& m = methods.at(std::stoul(method));
  const Outcome outcome = m.ours ? by_substructuring(c, m.option) : by_mumps(c, m.option);
  return std::fwrite(&outcome, sizeof outcome, 1, stdout) == 1 ? 0 : 1;
}

/// The same in a process of its own.
Outcome in_process(std::size_t solid, std::size_t method) {
  std::string words[] = {"/proc/self/exe", "--answer", std::to_string(solid), std::to_string(method)};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  for (const int end : ends) posix_spawn_file_actions_addclose(&actions, end);
  pid_t process = 0;
  const int failed = posix_spawn(&process, arguments[0], &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) throw std::runtime_error("this program cannot start itself");
  Outcome outcome;
  std::FILE* from = fdopen(ends[0], "r");
  const bool complete = std::fread(&outcome, sizeof outcome, 1, from) == 1;
  std::fclose(from);
  int status = 0;
  rusage usage{};
  wait4(process, &status, 0, &usage);
  if (!complete || status != 0) throw std::runtime_error(methods[method].name + " failed");
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  outcome.cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  outcome.memory = 1024.0 * double(usage.ru_maxrss);
  return outcome;
}

/// Largest difference over √(C_ii C_jj).
double difference(const Matrix12& a, const Matrix12& b) {
  const spatial::Vector12 scale = a.diagonal().cwiseAbs().cwiseSqrt();
  return (a - b).cwiseAbs().cwiseQuotient(scale * scale.transpose()).maxCoeff();
}

double median(const std::vector<Outcome>& runs, double Outcome::* number) {
  std::vector<double> values;
  for (const Outcome& run : runs) values.push_back(run.*number);
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// OpenBLAS does not know every processor and then uses kernels of an old one; the name must be set before it is
/// loaded, so here, for the processes that this one starts.
void choose_kernels_of_openblas() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) setenv("OPENBLAS_CORETYPE", "SKYLAKEX", 0);
  else if (__builtin_cpu_supports("avx2")) setenv("OPENBLAS_CORETYPE", "HASWELL", 0);
#endif
}

/// Whether all methods agree. Methods take turns.
bool compare(std::size_t solid, int count) {
  std::vector<std::vector<Outcome>> runs(methods.size());
  for (int run = 0; run < count; ++run)
    for (std::size_t m = 0; m < methods.size(); ++m) runs[m].push_back(in_process(solid, m));
  const Outcome& ours = runs[0][0];
  std::printf("%s: %.0f unknowns, %.0f negative eigenvalues\n", cases[solid].name.c_str(), ours.unknowns,
              ours.negative);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double error = difference(ours.stiffness, runs[m][0].stiffness);
    if (!(error < tolerance) || runs[m][0].negative != ours.negative) {
      std::printf("  %s: WRONG, differs by %.1e\n", methods[m].name.c_str(), error);
      return false;
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
    std::printf("  %-26s CPU %7.2f s  wall %7.2f s (assembly %5.2f, ordering %5.2f)  %5.0f MB  differs by %.1e\n",
                methods[m].name.c_str(), median(runs[m], &Outcome::cpu), median(runs[m], &Outcome::all),
                median(runs[m], &Outcome::assembly), median(runs[m], &Outcome::ordering),
                1e-6 * median(runs[m], &Outcome::memory), difference(ours.stiffness, runs[m][0].stiffness));
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc == 4 && std::string(argv[1]) == "--answer") return answer(argv[2], argv[3]);
  choose_kernels_of_openblas();
#ifndef TRIVET_HAS_MUMPS
  std::puts("MUMPS is missing (Debian: libmumps-seq-dev); Trivet is timed alone.");
#endif
  std::vector<std::size_t> solids;
  for (int word = 2; word < argc; ++word) solids.push_back(std::stoul(argv[word]));
  for (std::size_t solid = 0; argc < 3 && solid < cases.size(); ++solid) solids.push_back(solid);
  bool agree = true;
  for (const std::size_t solid : solids) agree = compare(solid, argc > 1 ? std::stoi(argv[1]) : 3) && agree;
  return agree ? 0 : 1;
} catch (const std::exception& failure) {
  std::fprintf(stderr, "solid_condensation: %s\n", failure.what());
  return 1;
}
