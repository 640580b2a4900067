// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/limit_line.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace trivet::assembly {

foundation::Problems check(const LimitLine& line, const std::string& subject) {
  foundation::Problems problems;
  const std::string named = "limit line \"" + line.name + "\"";
  if (line.angular_frequency.size() != line.limit.size() || line.limit.size() < 2)
    problems.error(
        subject,
        fmt::format("{}: {} frequencies and {} limits", named, line.angular_frequency.size(), line.limit.size()),
        "a limit line has at least two points, each with frequency and limit", "complete the table");
  for (std::size_t i = 0; i < line.limit.size(); ++i)
    if (!(line.limit[i] > 0 && std::isfinite(line.limit[i])))
      problems.error(subject, fmt::format("{}: limit {:g} {} in row {}", named, line.limit[i], line.unit, i + 1),
                     "a limit is a number > 0", "correct or remove the row");
  const std::vector<double>& omega = line.angular_frequency;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const double hertz = omega[i] / (2 * std::numbers::pi);
    if (!(omega[i] > 0 && std::isfinite(omega[i])))
      problems.error(subject, fmt::format("{}: {:g} Hz in row {}", named, hertz, i + 1),
                     "frequencies are > 0, as the axis is logarithmic", "correct or remove the row");
    else if (i > 0 && omega[i] < omega[i - 1])
      problems.error(subject,
                     fmt::format("{}: {:g} Hz in row {} after {:g} Hz", named, hertz, i + 1,
                                 omega[i - 1] / (2 * std::numbers::pi)),
                     "frequencies ascend", "sort the table by frequency");
    else if (i > 1 && omega[i] == omega[i - 2])
      problems.error(subject, fmt::format("{}: {:g} Hz three times, row {}", named, hertz, i + 1),
                     "two rows of equal frequency form a step", "remove the middle row");
  }
  if (omega.size() > 1 && omega.front() == omega.back())
    problems.error(subject, fmt::format("{}: all rows at {:g} Hz", named, omega[0] / (2 * std::numbers::pi)),
                   "a limit line covers a band", "give a second frequency");
  return problems;
}

}  // namespace trivet::assembly
