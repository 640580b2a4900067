// SPDX-License-Identifier: BSD-3-Clause
// How long do 100,000 steps of a machine of six coordinates under a measured force take? The paper's example, answers
// of all coordinates, of the forces of every element and of the ground, with extremes. Compared with Newmark's average
// acceleration with Eigen's fixed-size matrices (coordinates only, with the same step and so not exact), and with
// scipy.signal.lsim if the system's Python has it. Answers are compared before the timing.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/excitation/signal.h"
#include "trivet/foundation/child_process.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/project.h"
#include "trivet/response/transient/transient.h"

namespace {

using namespace trivet;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr Eigen::Index steps = 100000;
constexpr double step = 0.002;

struct Machine {
  project::Project project = judging::read_project(TRIVET_PAPER).value();
  const model::System& system = project.base().system;
  assembly::Assembled assembled = assembly::assemble(system);
  std::vector<assembly::Channel> coordinates =
      assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement);
  std::vector<assembly::Channel> everything = all_channels();
  Vector6 direction = {0.3, -0.7, 1, 0.1, 0.2, -0.05};
  std::vector<double> samples;
  std::vector<response::TimeInput> inputs;
  response::TransientOptions options;

  Machine() {
    excitation::Samples history;
    for (Eigen::Index i = 0; i <= steps; ++i) {
      const double t = step * static_cast<double>(i);
      history.times.push_back(t);
      history.values.push_back(100 * std::sin(3 * t + 0.01 * t * t) + 30 * std::sin(41 * t));
    }
    samples = history.values;
    inputs.push_back({"measured", excitation::from_samples(history),
                      assembly::Loading(direction.cast<std::complex<double>>().eval())});
    options.to = step * static_cast<double>(steps);
    options.step = step;
  }

  std::vector<assembly::Channel> all_channels() const {
    std::vector<std::string> words = {"coordinates", "ground"};
    for (const model::Element& element : system.elements()) words.push_back(element.name);
    return assembly::channels(system, assembled, words, assembly::MotionQuantity::displacement);
  }
};

const Machine& machine() {
  static const Machine m;
  return m;
}

Eigen::MatrixXd by_trivet() {
  const Machine& m = machine();
  const response::TransientResponse r =
      response::transient_response(m.system, m.assembled, m.coordinates, m.inputs, m.options);
  Eigen::MatrixXd q(6, r.time.size());
  for (Eigen::Index k = 0; k < 6; ++k) q.row(k) = r.curves[k].values.transpose();
  return q;
}

/// Average acceleration (β = 1/4, γ = 1/2), `parts` steps between two samples.
Eigen::MatrixXd by_newmark(int parts) {
  const Machine& machine_ = machine();
  const Matrix6 A = machine_.assembled.matrices.A, B = machine_.assembled.matrices.B, K = machine_.assembled.matrices.K;
  const double h = step / parts;
  const Matrix6 inverse = Matrix6(A + h / 2 * B + h * h / 4 * K).inverse();
  Eigen::MatrixXd result(6, steps + 1);
  Vector6 q = Vector6::Zero(), v = Vector6::Zero(), a = A.inverse() * (machine_.direction * machine_.samples[0]);
  result.col(0) = q;
  for (Eigen::Index i = 0; i < steps; ++i) {
    const double from = machine_.samples[i], to = machine_.samples[i + 1];
    for (int part = 1; part <= parts; ++part) {
      const Vector6 q_ahead = q + h * v + h * h / 4 * a, v_ahead = v + h / 2 * a;
      a = inverse * (machine_.direction * (from + (to - from) * part / parts) - B * v_ahead - K * q_ahead);
      q = q_ahead + h * h / 4 * a;
      v = v_ahead + h / 2 * a;
    }
    result.col(i + 1) = q;
  }
  return result;
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  double worst = 0;
  for (Eigen::Index k = 0; k < 6; ++k)
    worst = std::max(worst, (a.row(k) - b.row(k)).cwiseAbs().maxCoeff() / a.row(k).cwiseAbs().maxCoeff());
  return worst;
}

constexpr const char* script = R"(
import sys, time, numpy as np
try:
    from scipy.signal import lsim
except ImportError:
    sys.exit(0)
d = np.loadtxt(sys.argv[1])
A, B, K, h, q = d[0:36].reshape(6, 6), d[36:72].reshape(6, 6), d[72:108].reshape(6, 6), d[108:114], d[114:]
q = q.reshape(-1, 7)
u, q = q[:, 0], q[:, 1:]
I, O = np.eye(6), np.zeros((6, 6))
F = np.block([[O, I], [-np.linalg.solve(A, K), -np.linalg.solve(A, B)]])
G = np.concatenate([np.zeros(6), np.linalg.solve(A, h)])[:, None]
t = float(sys.argv[2]) * np.arange(len(u))
best = 1e9
for _ in range(5):
    begin = time.perf_counter()
    _, y, _ = lsim((F, G, np.hstack([I, O]), np.zeros((6, 1))), u, t)
    best = min(best, time.perf_counter() - begin)
difference = np.max(np.abs(y - q).max(0) / np.abs(q).max(0))
print("scipy.signal.lsim, coordinates only: %.1f ms, largest relative difference %.1e" % (1e3 * best, difference))
)";

void compare_with_scipy(const Eigen::MatrixXd& q) {
  constexpr const char* python = "/usr/bin/python3";
  if (!std::ifstream(python)) return;
  const foundation::TemporaryFolder folder;
  std::ofstream data(folder.path() / "data.txt"), code(folder.path() / "lsim.py");
  data.precision(17);
  const auto& m = machine().assembled.matrices;
  for (const Eigen::MatrixXd* matrix : {&m.A, &m.B, &m.K}) data << matrix->transpose().reshaped() << "\n";
  data << machine().direction << "\n";
  for (Eigen::Index i = 0; i <= steps; ++i) {
    data << machine().samples[i] << "\n";
    for (Eigen::Index k = 0; k < 6; ++k) data << q(k, i) << "\n";
  }
  code << script;
  data.close();
  code.close();
  const foundation::CommandOutcome outcome = foundation::run(
      {python, {(folder.path() / "lsim.py").string(), (folder.path() / "data.txt").string(), std::to_string(step)}});
  std::printf("%s", outcome.output.c_str());
  if (!outcome.succeeded()) std::exit(1);
}

void compare_answers() {
  const Eigen::MatrixXd exact = by_trivet();
  const double coarse = difference(exact, by_newmark(1)), fine = difference(exact, by_newmark(8));
  std::printf(
      "Newmark with the same step is off by %.1e of the largest, with an eighth of it by %.1e (ratio %.1f, 64 "
      "expected)\n",
      coarse, fine, coarse / fine);
  if (!(coarse / fine > 50 && coarse / fine < 80)) std::exit(1);
  compare_with_scipy(exact);
}

void ExactSteps(benchmark::State& state) {
  const Machine& m = machine();
  for (auto _ : state)
    benchmark::DoNotOptimize(response::transient_response(m.system, m.assembled,
                                                          state.range(0) ? m.everything : m.coordinates, m.inputs,
                                                          m.options)
                                 .curves.data());
  state.counters["answers"] = static_cast<double>(state.range(0) ? m.everything.size() : m.coordinates.size());
}
BENCHMARK(ExactSteps)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// A chain of bodies from the ground, with damping that is not proportional: a record acts on the last one. Times after
/// the set-up are the differences of many and few steps.
struct Chain {
  project::Project project;
  const model::System& system = project.base().system;
  assembly::Assembled assembled = assembly::assemble(system);
  std::vector<assembly::Channel> last_body;

  explicit Chain(long bodies) : project(judging::project_from_text(text(bodies), "chain").value()) {
    last_body =
        assembly::channels(system, assembled, {"b" + std::to_string(bodies)}, assembly::MotionQuantity::displacement);
  }
  static std::string text(long bodies) {
    std::ostringstream all;
    all << "trivet = 1\n";
    for (long i = 1; i <= bodies; ++i)
      all << "[bodies.b" << i << "]\nmass = " << 20 + i % 7 << "\ncenter_of_mass = [" << 0.3 * static_cast<double>(i)
          << ", 0, 0.02]\ninertia = {about = \"center_of_mass\", xx = 0.4, yy = 0.6, zz = 0.5}\n[elements.e" << i
          << "]\ntype = \"bushing\"\non = \"b" << i << "\"\n"
          << (i > 1 ? "from = \"b" + std::to_string(i - 1) + "\"\n" : "") << "at = ["
          << 0.3 * static_cast<double>(i) - 0.15
          << ", 0.01, 0]\ntranslation = [9e5, 7e5, 8e5]\nrotation = [9e3, 7e3, 8e3]\ndamping = {proportional = "
          << (i % 3 == 0 ? 1e-4 : 3e-4) << "}\n";
    return all.str();
  }
};

void ExactStepsOfAChain(benchmark::State& state) {
  const Chain chain(state.range(0));
  std::vector<response::TimeInput> inputs = machine().inputs;
  inputs[0].loading = assembly::Loading(
      Eigen::VectorXcd::Unit(chain.assembled.layout.size(), chain.assembled.layout.size() - 6).eval());
  response::TransientOptions options;
  options.step = step;
  options.to = step * static_cast<double>(state.range(1));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        response::transient_response(chain.system, chain.assembled, chain.last_body, inputs, options).curves.data());
}
BENCHMARK(ExactStepsOfAChain)
    ->ArgsProduct({{10, 20, 50}, {1000, steps}})
    ->ArgNames({"bodies", "steps"})
    ->Unit(benchmark::kMillisecond);

/// The same machine with points between its samples: every other step has a corner inside.
void ExactStepsBetweenSamples(benchmark::State& state) {
  const Machine& m = machine();
  response::TransientOptions options = m.options;
  options.step = 0.73 * step;
  options.to = 0.73 * step * static_cast<double>(steps);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        response::transient_response(m.system, m.assembled, m.coordinates, m.inputs, options).curves.data());
}
BENCHMARK(ExactStepsBetweenSamples)->Unit(benchmark::kMillisecond);

void Newmark(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(by_newmark(1).data());
}
BENCHMARK(Newmark)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare_answers();
  benchmark::RunSpecifiedBenchmarks();
}
