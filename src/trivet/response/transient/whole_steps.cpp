// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/whole_steps.h"

namespace trivet::response {
namespace {

bool jumps_in(const InputCourse& course, InputCourse::Place place, int held) {
  for (int m = 0; m < 3; ++m)
    if ((held >> m & 1) != 0 && course.jumps(place, m)) return true;
  return false;
}

}  // namespace

Eigen::Index sample_whole_steps(const InputCourse& course, const TimeGrid& grid, Eigen::Index point, int held,
                                InputCourse::Place place, Eigen::Ref<Eigen::Matrix<double, 5, Eigen::Dynamic>> w) {
  const double resolution = grid.resolution;
  double now = grid.time(point), corner = course.next_corner(place);
  for (Eigen::Index count = 0; count < w.cols(); ++count) {
    const double to = grid.time(point + count + 1);
    const bool enters = corner <= to + resolution;
    const double after = enters ? course.next_corner(place + 1) : corner;
    if (enters &&
        (corner < to - resolution || after <= to + resolution || (held != 0 && jumps_in(course, place + 1, held))))
      return count;
    w.col(count) = course.at(place, now);
    now = to;
    if (!enters) continue;
    corner = after;
    ++place;
    if (place == 0 || course.kappa_index(place - 1) != course.kappa_index(place)) return count + 1;
  }
  return w.cols();
}

}  // namespace trivet::response
