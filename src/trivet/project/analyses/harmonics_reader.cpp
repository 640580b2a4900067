// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/request_readers.h"

#include <fmt/format.h>

#include <cmath>

namespace trivet::project {

void read_harmonics(TableReader& reader, int& harmonics, double& tolerance) {
  constexpr int most_harmonics = 200;
  if (const auto given = reader.number("harmonics", Quantity::pure)) {
    if (*given >= 1 && *given <= most_harmonics && *given == std::floor(*given)) harmonics = static_cast<int>(*given);
    else
      reader.error("harmonics", fmt::format("{:.6g}", *given),
                   fmt::format("a whole number from 1 to {} is expected", most_harmonics),
                   "remove it: their number is found by `tolerance`");
  }
  if (const auto share = reader.number("tolerance", Quantity::pure)) {
    constexpr double round_off = 1e-12;
    if (*share >= round_off && *share < 1) tolerance = *share;
    else
      reader.error("tolerance", fmt::format("{:.6g}", *share),
                   fmt::format("it is a share from {:g}, above round-off, to 1", round_off),
                   "for instance tolerance = 1e-3");
    if (reader.has("harmonics"))
      reader.error("tolerance", "harmonics and tolerance", "a given number of harmonics is not searched",
                   "remove one of them");
  }
}

void require_nonlinear(const char* analysis, const char* remedy, const model::System& system,
                       foundation::Problems& problems) {
  if (!model::is_nonlinear(system))
    problems.error(analysis, "a linear machine", "its motions are those of machines with nonlinear parts", remedy);
}

}  // namespace trivet::project
