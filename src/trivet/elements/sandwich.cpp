// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/sandwich.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/elements/dimension_checks.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/complete_pivoting.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {
namespace {

double layer_thickness(const Sandwich& s) {
  return std::visit([](const auto& layer) { return layer.thickness; }, s.layer);
}

/// Inverse of a 6×6 of newtons and newton metres, scaled by its diagonal; the flag shows whether it is regular.
std::pair<Matrix6, bool> inverse(const Matrix6& matrix) {
  const Vector6 scale = matrix.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return {Matrix6::Zero(), false};
  const Matrix6 scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  return {scale.asDiagonal() * numerics::completely_pivoted_inverse(scaled) * scale.asDiagonal(),
          numerics::is_regular(scaled)};
}

}  // namespace

Matrix12 in_series(const std::vector<SeriesPart>& parts, const std::vector<Eigen::Vector3d>& spacers) {
  if (parts.empty() || spacers.size() + 1 != parts.size())
    throw foundation::InvalidInput(
        fmt::format("elements in series: {} spacers between {} parts, must be one fewer than the parts", spacers.size(),
                    parts.size()));
  Matrix6 flexibility = Matrix6::Zero();
  Eigen::Vector3d to_end = Eigen::Vector3d::Zero();  // from K of the current part to the last K
  for (std::size_t i = parts.size(); i-- > 0;) {
    const auto [own, regular] = inverse(parts[i].stiffness.bottomRightCorner<6, 6>());
    if (!regular) throw foundation::InvalidInput(fmt::format("elements in series: part {} is free to move", i + 1));
    const Matrix6 carry = spatial::rigid_motion(to_end);
    flexibility += carry * own * carry.transpose();
    to_end += parts[i].arm;
    if (i > 0) to_end += spacers[i - 1];
  }
  return from_moved_end(inverse(flexibility).first, to_end);
}

double height(const Sandwich& s) { return s.layers * layer_thickness(s) + (s.layers - 1) * s.plate_thickness; }

Matrix12 sandwich(const Sandwich& s) {
  require_sound(check(s));
  const SeriesPart part{std::holds_alternative<RubberDisc>(s.layer) ? rubber_disc(std::get<RubberDisc>(s.layer))
                                                                    : rubber_block(std::get<RubberBlock>(s.layer)),
                        {0, 0, layer_thickness(s)}};
  const auto count = to_size(s.layers);
  return in_series(std::vector(count, part), std::vector(count - 1, Eigen::Vector3d(0, 0, s.plate_thickness)));
}

foundation::Problems check(const Sandwich& s) {
  constexpr int most_layers = 1000;
  foundation::Problems problems = std::visit([](const auto& layer) { return check(layer); }, s.layer);
  if (s.layers < 1 || s.layers > most_layers)
    problems.error("layers", fmt::format("layers = {}", s.layers),
                   fmt::format("a sandwich has 1 … {} rubber layers", most_layers), "give the number of rubber layers");
  if (s.plate_thickness > 0) static_cast<void>(check_length(problems, "plate_thickness", s.plate_thickness));
  else if (s.plate_thickness != 0)
    problems.error("plate_thickness", fmt::format("plate_thickness = {:.6g} m", s.plate_thickness), "it must be ≥ 0",
                   "give a length in metres");
  return problems;
}

}  // namespace trivet::elements
