// SPDX-License-Identifier: BSD-3-Clause
// What does Python cost? The response of six coordinates and a sweep over a million designs, each called from C++ and
// from the Python package, on the same file. Usage: benchmarks/python_calls.py, which runs both.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "trivet/judging/read_project.h"
#include "trivet/study/analyses/analysis_commands.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/map/design_sweep.h"

namespace {

using namespace trivet;

/// Median time of some calls [s].
template <typename Call>
double median_time(int calls, const Call& call) {
  std::vector<double> times;
  for (int i = 0; i < calls; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + calls / 2, times.end());
  return times[static_cast<std::size_t>(calls / 2)];
}

std::vector<double> spread(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
  return values;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return std::fputs("usage: python_calls PROJECT\n", stderr), 2;
  const auto project = judging::read_project(words[1]);
  if (!project) return std::fputs("the project has errors\n", stderr), 2;
  const project::Case& base = project->base();
  const study::AnalysisCommand& response = study::analysis_command("response");
  double last = 0;
  const double of_response = median_time(101, [&] {
    last = std::abs(study::case_results(base, response.request(base)).response->curves.curves.front().value(0));
  });
  study::SweepRequest request;
  request.numbers = {
      {"elements." + base.system.elements().front().name + ".scale", spread(0.5, 2, 1000)},
      {"elements." + base.system.elements().front().name + ".damping.proportional", spread(0.02, 0.2, 1000)}};
  double largest = 0;
  const double of_sweep = median_time(5, [&] { largest = study::design_sweep(base, request).highest.maxCoeff(); });
  std::fputs(
      fmt::format("{{\"response\": {}, \"sweep\": {}, \"checks\": [{}, {}]}}\n", of_response, of_sweep, last, largest)
          .c_str(),
      stdout);
  return 0;
}
