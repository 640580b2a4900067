// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/requirement_slopes.h"

#include <algorithm>
#include <cmath>

#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/response/random/variance_slopes.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/requirements/mount_loads.h"
#include "trivet/study/requirements/nearest_to_line.h"
#include "trivet/study/requirements/requirement_list.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

template <typename Named>
std::size_t index_by_name(const std::vector<Named>& list, const std::string& name) {
  return to_size(std::ranges::find(list, name, &Named::name) - list.begin());
}

bool is_frequency_dependent(const model::System& system) {
  return std::ranges::any_of(
      system.elements(), [](const model::Element& element) { return elements::is_frequency_dependent(element.law); });
}

/// Σ weight × equations of the models next to a design: differences from here, so that entries that do not change leave
/// no round-off.
template <typename Equations, typename EquationsOf>
Equations change_along(const response::WeightedModels& models, const Equations& here, const EquationsOf& of) {
  Equations change = here;
  add(change, -1, here);
  for (const response::WeightedModel& model : models) {
    Equations apart = of(model);
    add(apart, -1, here);
    add(change, model.weight, apart);
  }
  return change;
}

/// A frequency so low that the slopes are those at rest to 1e-12, where no equation is singular.
double almost_at_rest(const modal::Modes& modes) {
  constexpr double share = 1e-6;
  for (const modal::Mode& mode : modes.list)
    if (const double omega = mode.angular_frequency.value_or(0); omega > 0) return share * omega;
  return share;
}

/// The curve of a requirement in a model, at any ω.
DrivenResult driven(const model::System& system, const assembly::Assembled& assembled, RequirementResult result) {
  if (result.kind == RequirementKind::mount_dynamic_deflection) result.subject += deflection_along_axis;
  RequirementCurve curve = requirement_curve(system, assembled, result);
  return {assembled, std::move(curve.channel), std::move(curve.loading)};
}

CurveEquations equations_at(const DrivenResult& driven, double omega) {
  response::Dynamics all = driven.at(omega);
  return {std::move(all.stiffness[0]), std::move(all.load[0]), std::move(all.channel[0]), all.direct[0]};
}

/// The row of a value at rest.
response::RestRow row_of(const model::System& system, const assembly::Assembled& assembled,
                         const RequirementResult& result) {
  if (result.kind == RequirementKind::static_value) {
    response::RestRow rest = response::rest_row(system, assembled, result.subject);
    const double creep = creep_in(system, result.subject);
    for (Eigen::RowVectorXd* row : {&rest.row, &rest.beside}) *row *= creep;
    rest.at_rest *= creep;
    return rest;
  }
  const bool load = result.kind == RequirementKind::mount_load;
  const MountRows rows =
      mount_rows(system, assembled, system.elements()[index_by_name(system.elements(), result.subject)]);
  const Eigen::RowVectorXd row = load ? Eigen::RowVectorXd(rows.load.row(result.direction)) : rows.deflection;
  return {row, row, load ? rows.load_at_rest(result.direction) : rows.deflection_at_rest};
}

RestEquations rest_equations(const model::System& system, const assembly::Assembled& assembled,
                             const RequirementResult& result) {
  const response::AtRest at_rest(system, assembled);
  const assembly::Assembled& whole = at_rest.assembled();
  return {whole.first_order().matrices.K, whole.matrices.K, response::rest_loads(at_rest.system(), whole),
          row_of(at_rest.system(), whole, result)};
}

/// Changes of the shares of kinetic energy in each coordinate at the centre of mass, modal::OwnSystem::energy.
void set_energy_change(const spatial::MassProperties& mass, const spatial::MassProperties& change,
                       const std::vector<int>& coordinates, modal::OwnSystem& rate) {
  const auto inertia = [](const spatial::MassProperties& of) {
    spatial::Matrix6 six = of.mass * spatial::Matrix6::Identity();
    six.bottomRightCorner<3, 3>() = of.inertia_about_centre;
    return six;
  };
  const spatial::Matrix6 moved = spatial::rigid_motion(change.centre) - spatial::Matrix6::Identity();
  const Eigen::MatrixXd motion = spatial::rigid_motion(mass.centre)(Eigen::all, coordinates),
                        d_motion = moved(Eigen::all, coordinates), momentum = inertia(mass) * motion,
                        d_momentum = inertia(mass) * d_motion + inertia(change) * motion;
  for (Eigen::Index k = 0; k < 6; ++k)
    rate.energy[to_size(k)] =
        d_motion.row(k).transpose() * momentum.row(k) + motion.row(k).transpose() * d_momentum.row(k);
}

}  // namespace

RequirementSlopes::RequirementSlopes(const CaseContext& context, const DesignSpace& space, const project::Case& variant,
                                     const Eigen::VectorXd& values, const DesignBatch* batch)
    : c_(context), space_(space), case_(variant), values_(values), towards_(space.towards(values)), batch_(batch) {}

bool RequirementSlopes::are_missing(RequirementKind kind, const model::System& system) {
  const MarginSlopes slopes = requirement_row(kind).slopes;
  return slopes == MarginSlopes::differences || (slopes == MarginSlopes::variance && is_frequency_dependent(system));
}

const DesignNeighbours& RequirementSlopes::neighbours() const {
  if (!neighbours_) neighbours_ = std::make_unique<const DesignNeighbours>(space_, case_, values_);
  return *neighbours_;
}

const PackedRates* RequirementSlopes::packed(std::size_t number) const {
  if (!batch_ || !batch_->gives_slopes(number)) return nullptr;
  if (!packed_) packed_.emplace(*batch_, values_);
  return &*packed_;
}

Eigen::MatrixXd RequirementSlopes::of(std::size_t number, const RequirementResult& result,
                                      const Candidates& candidates) const {
  const MarginSlopes from = requirement_row(result.kind).slopes;
  Eigen::MatrixXd slopes(to_index(candidates.size()), to_index(space_.size()));
  if (from == MarginSlopes::curve) slopes = of_curve(number, result, candidates);
  else if (from == MarginSlopes::shapes) slopes = of_decoupling(number, result, candidates);
  else
    for (std::size_t i = 0; i < candidates.size(); ++i) slopes.row(to_index(i)) = of_one(number, result, candidates[i]);
  for (Eigen::Index i = 0; i < slopes.rows(); ++i)
    if (!slopes.row(i).allFinite()) slopes.row(i).setZero();
  return slopes;
}

Eigen::MatrixXd RequirementSlopes::of_curve(std::size_t number, const RequirementResult& result,
                                            const Candidates& candidates) const {
  std::vector<double> places, minima;
  for (const RequirementResult::Candidate& candidate : candidates) {
    places.push_back(candidate.angular_frequency);
    minima.push_back(candidate.minimum_at);
  }
  const Eigen::MatrixXd at_places = heights(number, result, places);
  if (result.kind != RequirementKind::no_peak) return -at_places;
  Eigen::MatrixXd slopes = heights(number, result, minima) - at_places;
  // margin (1 + a)/(1 + r) below 1 and a/r above, with 1 + r = peak / minimum
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (const double prominence = result.allowed / candidates[i].margin; candidates[i].margin >= 1)
      slopes.row(to_index(i)) *= (1 + prominence) / prominence;
  return slopes;
}

Eigen::MatrixXd RequirementSlopes::heights(std::size_t number, const RequirementResult& result,
                                           const std::vector<double>& frequencies) const {
  const PackedRates* of_batch = packed(number);
  std::vector<double> places;
  for (const double at : frequencies) places.push_back(std::max(at, almost_at_rest(c_.modes)));
  std::vector<CurveEquations> here;
  if (of_batch) {
    for (const double omega : places) here.push_back(of_batch->curve(number, omega));
  } else {
    const DrivenResult given = driven(c_.system, c_.assembled, result);
    for (const double omega : places) here.push_back(equations_at(given, omega));
  }
  return curve_slopes(here, space_.size(), [&](std::size_t j) {
    std::vector<CurveEquations> changes;
    if (of_batch) {
      for (const double omega : places) changes.push_back(of_batch->curve_change(number, j, omega));
      return changes;
    }
    std::vector<DrivenResult> there;
    for (const response::WeightedModel& model : neighbours().along(j))
      there.push_back(driven(*model.system, *model.assembled, result));
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::size_t next = 0;
      changes.push_back(change_along(neighbours().along(j), here[i], [&](const response::WeightedModel&) {
        return equations_at(there[next++], places[i]);
      }));
    }
    return changes;
  });
}

Eigen::MatrixXd RequirementSlopes::of_decoupling(std::size_t number, const RequirementResult& result,
                                                 const Candidates& candidates) const {
  const std::size_t body = index_by_name(c_.system.bodies(), result.subject);
  const modal::BodyRows rows = modal::rows_of(c_.system, c_.assembled, body);
  const modal::OwnSystem own = modal::own_system(c_.system.bodies()[body], c_.assembled, rows);
  const PackedRates* of_batch = packed(number);
  std::vector<modal::OwnSystem> rates(space_.size(), own);
  for (std::size_t j = 0; j < rates.size(); ++j) {
    modal::OwnSystem& rate = rates[j];
    if (of_batch) {
      const response::MatrixRates& all = of_batch->matrices()[j];
      rate.matrices.A = all.A(rows.body, rows.body);
      rate.matrices.K = all.K(rows.body, rows.body);
      set_energy_change(c_.system.bodies()[body].mass, of_batch->mass_change(number, j), rows.coordinates, rate);
      continue;
    }
    rate.matrices.A.setZero();
    rate.matrices.K.setZero();
    for (Eigen::MatrixXd& energy : rate.energy) energy.setZero();
    for (const response::WeightedModel& model : neighbours().along(j)) {
      const modal::OwnSystem there = modal::own_system(model.system->bodies()[body], *model.assembled,
                                                       modal::rows_of(*model.system, *model.assembled, body));
      rate.matrices.A += model.weight * (there.matrices.A - own.matrices.A);
      rate.matrices.K += model.weight * (there.matrices.K - own.matrices.K);
      for (std::size_t k = 0; k < rate.energy.size(); ++k)
        rate.energy[k] += model.weight * (there.energy[k] - own.energy[k]);
    }
  }
  std::vector<std::size_t> modes;
  for (const RequirementResult::Candidate& candidate : candidates) modes.push_back(to_size(candidate.mode - 1));
  return decoupling_slopes(own, rates, modes);
}

Eigen::RowVectorXd RequirementSlopes::of_one(std::size_t number, const RequirementResult& result,
                                             const RequirementResult::Candidate& candidate) const {
  switch (requirement_row(result.kind).slopes) {
    case MarginSlopes::zero:
      return Eigen::RowVectorXd::Zero(to_index(space_.size()));
    case MarginSlopes::frequencies: {
      const FrequencySlopes& all = frequencies(number);
      if (result.kind == RequirementKind::separation)
        return all.slopes(candidate.mode + 1) - all.slopes(candidate.mode);
      return (candidate.below ? -1 : 1) * all.slopes(candidate.mode);
    }
    case MarginSlopes::roots:
      return of_root(number, to_size(candidate.mode - 1));
    case MarginSlopes::variance:
      return -of_rms(result);
    case MarginSlopes::rest:
      return of_rest(number, result);
    default:
      throw foundation::InvalidInput("RequirementSlopes: this requirement has no slopes");
  }
}

Eigen::RowVectorXd RequirementSlopes::of_root(std::size_t number, std::size_t root) const {
  const PackedRates* of_batch = packed(number);
  return damping_ratio_slopes(c_, root, towards_, [&](const RootEquations& of, std::size_t j) -> Eigen::MatrixXcd {
    if (of_batch) {
      const response::MatrixRates& rates = of_batch->matrices()[j];
      Eigen::MatrixXcd change = rates.K.cast<std::complex<double>>();
      change.imag() = rates.K_loss;
      return change + of.lambda * rates.B + of.lambda * of.lambda * rates.A;
    }
    const Eigen::MatrixXcd here = of.stiffness(c_.assembled);
    Eigen::MatrixXcd change = Eigen::MatrixXcd::Zero(here.rows(), here.cols());
    for (const response::WeightedModel& model : neighbours().along(j))
      change += model.weight * (of.stiffness(*model.assembled) - here);
    return change;
  });
}

Eigen::RowVectorXd RequirementSlopes::of_rest(std::size_t number, const RequirementResult& result) const {
  const PackedRates* of_batch = packed(number);
  const RestEquations here = of_batch ? of_batch->rest(number) : rest_equations(c_.system, c_.assembled, result);
  const Eigen::RowVectorXd slopes =
      rest_slopes(here, numerics::unit_scale(c_.assembled.matrices), space_.size(), [&](std::size_t j) {
        if (of_batch) return of_batch->rest_change(number, j);
        return change_along(neighbours().along(j), here, [&](const response::WeightedModel& model) {
          return rest_equations(*model.system, *model.assembled, result);
        });
      });
  if (result.kind != RequirementKind::mount_load) return -slopes;
  const model::Element& mount = c_.system.elements()[index_by_name(c_.system.elements(), result.subject)];
  return is_near_lower_end(*result.value, *mount.rating->load[result.direction]) ? slopes : -slopes;
}

Eigen::RowVectorXd RequirementSlopes::of_rms(const RequirementResult& result) const {
  std::vector<response::WeightedModels> models;
  for (std::size_t j = 0; j < space_.size(); ++j) models.push_back(neighbours().along(j));
  return response::rms_slopes(c_.system, c_.assembled, {result.subject, result.quantity, result.excitations},
                              c_.roots().poles, models);
}

const FrequencySlopes& RequirementSlopes::frequencies(std::size_t number) const {
  if (!frequencies_) {
    const PackedRates* of_batch = packed(number);
    std::vector<response::MatrixRates> rates;
    if (of_batch) rates = of_batch->matrices();
    else
      for (std::size_t j = 0; j < space_.size(); ++j)
        rates.push_back(response::matrix_rates(neighbours().along(j), c_.assembled));
    frequencies_ = std::make_unique<const FrequencySlopes>(c_.modes, c_.assembled.matrices, std::move(rates), towards_);
  }
  return *frequencies_;
}

}  // namespace trivet::study
