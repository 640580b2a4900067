// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "trivet/modal/modes.h"
#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/report/drawing/view_projection.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/spatial/types.h"

namespace trivet::report {

/// Small motion of a machine at one instant, ground axes.
struct MachineMotion {
  std::vector<spatial::Vector6> bodies;  ///< of the poles: translation [m], rotation [rad]
  std::vector<Eigen::Vector3d> feet;     ///< of the ends N, one per drawn element [m]
};

[[nodiscard]] MachineMotion motion_of(const modal::Mode& mode, const model::System& system);
/// At the phase ωt [rad].
[[nodiscard]] MachineMotion motion_of(const response::DeflectionShape& shape, const model::System& system,
                                      double phase);

/// How much all drawn places move: the largest distance from rest [m], and the sum of the squares of the motions in the
/// plane of the front, side and top view.
struct DrawnExcursion {
  double largest = 0;
  std::array<double, 3> in_plane{};

  /// Place in `four_views()` of the view with the largest motion in its plane.
  [[nodiscard]] std::size_t best_view() const;
};
[[nodiscard]] DrawnExcursion drawn_excursion(const DrawnMachine& machine, const MachineMotion& motion);

/// The machine, displaced: bodies turn as rigid ones do, so that an enlarged motion does not distort them. An element
/// has its ends where its symbol ends.
/// @param size  of the machine [m]
[[nodiscard]] DrawnMachine moved(DrawnMachine machine, const MachineMotion& motion, double scale, double size);

/// Motions are enlarged so that the largest one is this share of the size of the machine: less than the length of the
/// symbol of a spring, which so does not turn over.
inline constexpr double drawn_motion = 0.075;

/// A machine at rest in grey and displaced in colour, in one view inside a rectangle. The scale is the same in the
/// front, side and top view.
class MovedPicture {
 public:
  explicit MovedPicture(const project::Case& variant);
  /// @param motion  of the machine, `enlarged` times
  /// @param paths   of some places, over one period
  void draw(SvgCanvas& canvas, const Box& area, std::size_t view, const MachineMotion& motion, double enlarged,
            const std::vector<response::MovingPlace>& paths = {}) const;
  /// The height that a rectangle of a width needs, at most `most` [pixels].
  [[nodiscard]] double height(double width, double most) const;
  /// How much a motion is enlarged; 0 if nothing moves.
  [[nodiscard]] double enlargement(double largest) const { return largest > 0 ? drawn_motion * size_ / largest : 0; }
  [[nodiscard]] const DrawnMachine& machine() const { return rest_; }

 private:
  [[nodiscard]] PixelPoint extent_in(std::size_t view) const;  // [m]
  [[nodiscard]] double scale(double width, double height, std::size_t view) const;

  DrawnMachine rest_;
  Bounds bounds_;  // with room for the motion
  double size_;
};

}  // namespace trivet::report
