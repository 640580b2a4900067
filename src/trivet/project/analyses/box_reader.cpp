// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/project/analyses/request_readers.h"

namespace trivet::project {

std::optional<BoxRequest> read_box(TableReader& root, TableReader& analyses) {
  const Node* table = analyses.table("box");
  if (!table) return std::nullopt;
  TableReader reader(*table, "analyses.box", root.problems());
  BoxRequest request;
  if (const auto points = read_whole(reader, "points", fewest_box_points, most_box_points, "1_000_000 is usual"))
    request.points = static_cast<std::size_t>(*points);
  if (const auto seed = read_whole(reader, "seed", 0, most_seed, "seed = 1 is as good as any"))
    request.seed = static_cast<std::uint64_t>(*seed);
  if (const auto most = reader.number("most", Quantity::pure)) {
    if (*most >= 1 && *most <= most_box_times) request.most = *most;
    else
      reader.error(
          "most", fmt::format("{:.6g}", *most),
          fmt::format("the largest range that is tried is 1 to {:.0f} times that of the tolerance", most_box_times),
          "most = 10 is usual");
  }
  reader.finish();
  if (!root.has("tolerances"))
    reader.error("", "no tolerances", "a box has ranges of at least one number",
                 "write [tolerances.NAME] with path and half_width, which give the proportions of the ranges");
  return request;
}

}  // namespace trivet::project
