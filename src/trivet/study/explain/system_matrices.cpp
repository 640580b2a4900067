// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/system_matrices.h"

#include <fmt/format.h>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/project/analyses/drive.h"

namespace trivet::study {
namespace {

void name_block(const std::string& owner, Eigen::Index first, Eigen::Index count, std::vector<std::string>& names) {
  for (Eigen::Index i = 0; i < count; ++i) names[first + i] = fmt::format("{}.coordinate {}", owner, i + 1);
}

}  // namespace

std::vector<std::string> row_names(const model::System& system, const assembly::Assembled& assembled) {
  const assembly::Layout& layout = assembled.layout;
  const model::Description& parts = system.description();
  std::vector<std::string> names(to_size(layout.size()));
  for (std::size_t b = 0; b < parts.bodies.size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (layout.row(b, j) >= 0) names[layout.row(b, j)] = parts.bodies[b].name + "." + model::coordinate_names[j];
  for (std::size_t f = 0; f < parts.foundations.size(); ++f)
    name_block(parts.foundations[f].name, layout.foundation_row(f), parts.foundations[f].mass.rows(), names);
  constexpr Eigen::Index of_ends = 12;
  for (std::size_t e = 0; e < parts.elements.size(); ++e)
    name_block(parts.elements[e].name, layout.internal_row(e), assembled.elements[e].ends.rows() - of_ends, names);
  return names;
}

std::vector<std::string> row_units(const model::System& system, const assembly::Assembled& assembled) {
  std::vector<std::string> units(to_size(assembled.layout.size()), "1");
  for (std::size_t b = 0; b < system.bodies().size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (const Eigen::Index row = assembled.layout.row(b, j); row >= 0) units[row] = j < 3 ? "m" : "rad";
  return units;
}

SystemMatrices system_matrices(const project::Case& variant) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  SystemMatrices found;
  found.coordinates = row_names(variant.system, assembled);
  found.units = row_units(variant.system, assembled);
  found.matrices = assembled.matrices;
  found.exact = !assembled.frequency_dependent();
  found.load = numerics::Load(assembled.layout.size());
  if (project::is_driven(variant.system, project::Drive::harmonic))
    found.load = assembly::right_side(assembled, assembly::harmonic_loading(variant.system, assembled));
  return found;
}

}  // namespace trivet::study
