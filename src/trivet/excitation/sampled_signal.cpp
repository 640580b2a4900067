// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/sampled_signal.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/excitation/refusal.h"

namespace trivet::excitation {
namespace {

constexpr const char* times_increase = "times must increase";

void check_times(foundation::Problems& problems, const std::string& subject, const std::vector<double>& t) {
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] > t[i - 1]) continue;
    const bool repeated = t[i] == t[i - 1];
    problems.error(subject, fmt::format("row {}: time {:.9g} s after {:.9g} s", i + 1, t[i], t[i - 1]), times_increase,
                   repeated ? "for a jump, give two different times, however close" : "sort the rows");
    return;
  }
}

}  // namespace

foundation::Problems check(const Samples& samples, const std::string& subject) {
  foundation::Problems problems;
  const std::vector<double>&t = samples.times, &u = samples.values;
  if (t.size() != u.size())
    problems.error(subject, fmt::format("{} times and {} values", t.size(), u.size()), "each time has one value",
                   "complete the rows");
  if (t.size() < 2)
    problems.error(subject, fmt::format("{} samples", t.size()), "a time history has two or more", "add rows");
  for (const auto* column : {&t, &u})
    for (std::size_t i = 0; i < column->size(); ++i)
      if (!std::isfinite((*column)[i])) {
        problems.error(subject,
                       fmt::format("row {}: the {} is {}", i + 1, column == &t ? "time" : "value", (*column)[i]),
                       "numbers must be finite", "fill the gap or remove the row");
        break;
      }
  if (!problems.has_errors()) check_times(problems, subject, t);
  if (problems.has_errors()) return problems;
  if (u.front() != 0)
    problems.warning(subject, fmt::format("the first value is {:.6g}", u.front()),
                     "the signal is zero before it and jumps there",
                     "begin with zero, or remove the mean, if no jump is intended");
  if (u.back() != 0) {
    const bool held = samples.afterwards == Samples::Afterwards::hold;
    problems.warning(subject, fmt::format("the last value is {:.6g}", u.back()),
                     held ? "the last value is held" : "the signal jumps to zero after it",
                     held ? "end with zero, or choose zero afterwards, if it should not be held"
                          : "end with zero if no jump is intended");
  }
  return problems;
}

Signal from_samples(const Samples& samples) {
  refuse_errors(check(samples, "samples"));
  Signal signal;
  signal.pieces.reserve(samples.times.size());
  for (std::size_t i = 0; i + 1 < samples.times.size(); ++i)
    signal.pieces.push_back({samples.times[i], samples.values[i],
                             (samples.values[i + 1] - samples.values[i]) / (samples.times[i + 1] - samples.times[i])});
  signal.pieces.push_back(
      {samples.times.back(), samples.afterwards == Samples::Afterwards::hold ? samples.values.back() : 0});
  require_valid(signal);  // throws if two times are so close that the rate overflows
  return signal;
}

}  // namespace trivet::excitation
