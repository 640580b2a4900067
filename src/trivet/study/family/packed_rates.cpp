// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/packed_rates.h"

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/family/packed_margins.h"

namespace trivet::study {

PackedRates::PackedRates(const DesignBatch& batch, const Eigen::VectorXd& values) : of_(batch.packed()) {
  here_.designs = of_.unpacked(batch.family().at(values).transpose());
  changes_.designs = of_.changes(here_.designs, batch.family().slopes(values).transpose());
  for (Part* part : {&here_, &changes_}) part->searched.resize(of_.searches().size());
  const numerics::Designs changes = of_.free(changes_.designs);
  const Eigen::ArrayXXd loss = of_.loss(changes_.designs);
  for (Eigen::Index j = 0; j < changes.count(); ++j)
    matrices_.push_back({numerics::unpacked(changes.A, j), numerics::unpacked(changes.B, j),
                         numerics::unpacked(changes.K, j), numerics::unpacked(loss, j)});
}

CurveEquations PackedRates::curve_in(Part& part, std::size_t result, std::size_t row, double omega) const {
  for (std::size_t s = 0; s < of_.searches().size(); ++s) {
    const CaseVector::Search& search = of_.searches()[s];
    const auto at = std::ranges::find(search.results, result);
    if (at == search.results.end()) continue;
    if (!part.searched[s]) part.searched[s] = of_.searched(part.designs, search);
    return packed_curve(*part.searched[s], to_index(row), to_size(search.curves[at - search.results.begin()]), omega);
  }
  throw foundation::InvalidInput("PackedRates: this requirement has no curve");
}

RestEquations PackedRates::rest_in(const Part& part, std::size_t result, std::size_t row) const {
  const auto number = std::ranges::find(of_.at_rest(), result, &CaseVector::RestValue::result) - of_.at_rest().begin();
  const CaseVector::Unpacked& all = part.designs;
  const auto d = to_index(row);
  const Eigen::Index n = of_.coordinates();
  const Eigen::RowVectorXd of_result = all.rows[number].row(d).head(n);
  const Eigen::VectorXd load = all.load.row(d).transpose();
  const Eigen::VectorXd beside =
      all.beside.size() > 0 ? Eigen::VectorXd(all.beside.row(d).transpose()) : Eigen::VectorXd::Zero(n);
  return {numerics::unpacked(all.rest_stiffness, d),
          numerics::unpacked(all.standing, d),
          {load - beside, beside},
          {of_result, of_result, all.rows[number](d, n)}};
}

spatial::MassProperties PackedRates::mass_change(std::size_t result, std::size_t parameter) const {
  const auto number =
      std::ranges::find(of_.decoupled(), result, &CaseVector::Decoupled::result) - of_.decoupled().begin();
  return mass_of(MassNumbers(changes_.designs.bodies[number].row(to_index(parameter)).transpose()));
}

}  // namespace trivet::study
