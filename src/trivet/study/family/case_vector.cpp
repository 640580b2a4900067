// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/case_vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/assembly/loads.h"
#include "trivet/assembly/second_order.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/response/machinery/operating_loads.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/requirements/mount_loads.h"
#include "trivet/study/requirements/requirement_list.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

constexpr Eigen::Index mass_entries = 10;

/// Numbers and their scales, appended piece by piece.
class PackedList {
 public:
  void add(const Eigen::VectorXd& numbers, const Eigen::VectorXd& scales) {
    entries_.insert(entries_.end(), numbers.begin(), numbers.end());
    scales_.insert(scales_.end(), scales.begin(), scales.end());
  }
  [[nodiscard]] design::PackedDesign list() const {
    return {Eigen::Map<const Eigen::VectorXd>(entries_.data(), to_index(entries_.size())),
            Eigen::Map<const Eigen::VectorXd>(scales_.data(), to_index(scales_.size()))};
  }

 private:
  std::vector<double> entries_, scales_;
};

/// Scale of a vector that multiplies displacements: its components times √mass have one unit.
Eigen::VectorXd scale_of(const Eigen::VectorXd& vector, const Eigen::VectorXd& root_of_mass) {
  return vector.cwiseAbs().cwiseQuotient(root_of_mass).maxCoeff() * root_of_mass;
}

Eigen::VectorXd scale_of(const spatial::MassProperties& mass) {
  const Eigen::Vector3d root = mass.inertia_about_centre.diagonal().cwiseAbs().cwiseSqrt();
  MassNumbers scale;
  scale << mass.mass, Eigen::Vector3d::Constant(root.maxCoeff() / std::sqrt(mass.mass)), root.cwiseAbs2(),
      root(0) * root(1), root(0) * root(2), root(1) * root(2);
  return scale;
}

/// Entries of the lower triangle, row by row, as numerics::Designs has them.
Eigen::VectorXd lower_triangle(const Eigen::MatrixXd& matrix) {
  Eigen::VectorXd entries(matrix.rows() * (matrix.rows() + 1) / 2);
  Eigen::Index at = 0;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j) entries(at++) = matrix(i, j);
  return entries;
}

/// √(K_ii K_jj) of the same entries.
Eigen::VectorXd triangle_scale(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd root = matrix.diagonal().cwiseAbs().cwiseSqrt();
  return lower_triangle(root * root.transpose());
}

/// Compression or deflection of a mount as linear functions of the displacements, with their constants.
std::pair<Eigen::VectorXd, double> mount_row(const model::System& system, const assembly::Assembled& assembled,
                                             const RequirementResult& result) {
  for (const model::Element& element : system.elements()) {
    if (element.name != result.subject) continue;
    const MountRows rows = mount_rows(system, assembled, element);
    return result.kind == RequirementKind::mount_load
        ? std::pair<Eigen::VectorXd, double>{rows.load.row(result.direction).transpose(),
                                             rows.load_at_rest(result.direction)}
        : std::pair<Eigen::VectorXd, double>{rows.deflection.transpose(), rows.deflection_at_rest};
  }
  throw foundation::InvalidInput("CaseVector: no mount " + result.subject);
}

bool is_mount(RequirementKind kind) {
  return kind == RequirementKind::mount_load || kind == RequirementKind::mount_deflection;
}

/// Do constant forces meet another stiffness at rest than the weight?
bool has_loads_beside_weight(const model::System& system, const assembly::Assembled& assembled) {
  return !system.description().constant_forces.empty() &&
      response::AtRest(system, assembled).assembled().without_second_order != nullptr;
}

/// Has a static result, such as the force of a mount between two bodies, another row under loads beside the weight?
bool contains_forces_at_rest(const model::System& system, const assembly::Assembled& assembled,
                             const std::string& result) {
  const response::RestRow row = response::rest_row(system, assembled, result);
  return row.row != row.beside;
}

constexpr const char* no_rest = "no position of rest to first order";

/// A value at rest as a linear function of the displacements, with its constant.
std::pair<Eigen::VectorXd, double> rest_row(const model::System& system, const assembly::Assembled& assembled,
                                            const RequirementResult& result) {
  if (is_mount(result.kind)) return mount_row(system, assembled, result);
  const assembly::Channel channel =
      assembly::channels(system, assembled, {result.subject}, assembly::MotionQuantity::displacement).front();
  const double creep = creep_in(system, result.subject);
  return {creep * channel.on_displacement.real(), creep * channel.at_rest};
}

}  // namespace

MassNumbers mass_numbers(const spatial::MassProperties& mass) {
  const Eigen::Matrix3d& J = mass.inertia_about_centre;
  MassNumbers numbers;
  numbers << mass.mass, mass.centre, J.diagonal(), J(0, 1), J(0, 2), J(1, 2);
  return numbers;
}

spatial::MassProperties mass_of(const MassNumbers& numbers) {
  spatial::MassProperties mass{numbers(0), numbers.segment<3>(1), numbers.segment<3>(4).asDiagonal()};
  Eigen::Matrix3d& J = mass.inertia_about_centre;
  J(0, 1) = J(1, 0) = numbers(7);
  J(0, 2) = J(2, 0) = numbers(8);
  J(1, 2) = J(2, 1) = numbers(9);
  return mass;
}

CaseVector::CaseVector(const project::Case& variant, const project::Analyses& request,
                       const std::vector<RequirementResult>& results, bool any_size, bool with_orders)
    : results_(results), covered_(results.size(), false), not_covered_(results.size()) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  n_ = assembled.matrices.size();
  second_order_ = assembled.without_second_order != nullptr;
  has_static_stiffness_ = model::has_static_stiffness(variant.system);
  has_loads_ = has_loads_beside_weight(variant.system, assembled);
  plan_searches(request, variant.system, assembled);
  if (with_orders) plan_operation(variant.system, assembled);
  plan_rest(variant.system, assembled);
  plan_decoupling(variant.system, assembled);
  if (request.requirements) avoided_ = request.requirements->avoided;
  for (std::size_t r = 0; r < results_.size(); ++r)
    covered_[r] = covered_[r] || requirement_row(results_[r].kind).packed == PackedPart::frequencies;
  std::vector<design::DrivenDesign> designs;
  reason_ = form(variant.system, assembled, designs);
  if (reason_.empty() && !any_size && n_ > numerics::most_driven_coordinates) reason_ = "more than twelve coordinates";
  if (!reason_.empty()) {
    covered_.assign(covered_.size(), false);
    return;
  }
  Eigen::Index at = design::matrix_entries(n_);
  for (std::size_t s = 0; s < searches_.size(); ++s) {
    searches_[s].at = at;
    searches_[s].size = packed(designs[s]).size() - design::matrix_entries(n_);
    searches_[s].first = std::move(designs[s]);
    at += searches_[s].size;
  }
}

void CaseVector::plan_searches(const project::Analyses& request, const model::System& system,
                               const assembly::Assembled& assembled) {
  const project::Requirements required = request.requirements.value_or(project::Requirements());
  for (std::size_t r = 0; r < results_.size(); ++r) {
    const RequirementResult& result = results_[r];
    const bool peaks = result.kind == RequirementKind::no_peak;
    if (requirement_row(result.kind).packed != PackedPart::curve) continue;
    Search search;
    search.count_peaks = peaks;
    search.band = result.band;
    if (peaks) search.min_prominence = required.min_prominence;
    const auto same = std::ranges::find_if(searches_, [&](const Search& other) {
      return other.count_peaks == search.count_peaks && have_same_drive(results_[other.results.front()], result);
    });
    Search& chosen = same != searches_.end() ? *same : searches_.emplace_back(search);
    chosen.results.push_back(r);
    covered_[r] = true;
  }
  for (Search& search : searches_) set_curves(search);
  unite_searches(system, assembled);
}

void CaseVector::unite_searches(const model::System& system, const assembly::Assembled& assembled) {
  const auto peaks = std::ranges::find_if(searches_, &Search::count_peaks);
  if (peaks == searches_.end()) return;
  const auto amplitudes = std::ranges::find_if(searches_, [&](const Search& one) {
    RequirementResult first = results_[one.results.front()];
    const bool is_range = first.band.from < first.band.to;
    first.band = peaks->band;
    return !one.count_peaks && is_range && have_same_drive(first, results_[peaks->results.front()]);
  });
  if (amplitudes == searches_.end()) return;
  Search both = *peaks;
  both.band = amplitudes->band;
  both.results.insert(both.results.begin(), amplitudes->results.begin(), amplitudes->results.end());
  set_curves(both);
  if (!design_of(both, system, assembled).design) return;
  *peaks = std::move(both);
  searches_.erase(amplitudes);
}

void CaseVector::plan_operation(const model::System& system, const assembly::Assembled& assembled) {
  for (std::size_t r = 0; r < results_.size(); ++r) {
    const RequirementResult& result = results_[r];
    if (requirement_row(result.kind).packed != PackedPart::orders || !result.value) continue;
    const std::vector<response::OrderLoading> loads = response::operating_loads(system, assembled, result.excitations);
    const assembly::Band speed = *result.speed;
    const bool has_sum = *result.level_of_limit == project::Level::rms && speed.from == speed.to;
    if (loads.size() > 1 && !has_sum)
      not_covered_[r] = "of several orders it judges the root mean square at single speeds only";
    else if (!(speed.from > 0)) not_covered_[r] = "speeds from 0 on";
    if (loads.empty() || !not_covered_[r].empty()) continue;
    std::vector<Search> with_result = searches_;
    const bool have_form = std::ranges::all_of(loads, [&](const response::OrderLoading& load) {
      const assembly::Band band{load.order * speed.from, load.order * speed.to};
      const auto same = std::ranges::find_if(with_result, [&](const Search& other) {
        return other.order == load.order && other.band == band &&
            results_[other.results.front()].excitations == result.excitations;
      });
      Search& search = same != with_result.end()
          ? *same
          : with_result.emplace_back(Search{.band = band, .order = load.order, .orders = loads.size()});
      search.results.push_back(r);
      set_curves(search);
      not_covered_[r] = design_of(search, system, assembled).reason;
      return not_covered_[r].empty();
    });
    if (!have_form) continue;  // it alone is assembled
    searches_ = std::move(with_result);
    covered_[r] = true;
  }
}

void CaseVector::set_curves(Search& search) const {
  std::vector<std::size_t> named;  // results, one for each curve
  search.curves.clear();
  for (const std::size_t r : search.results) {
    const auto same = std::ranges::find_if(named, [&](std::size_t other) {
      return results_[other].subject == results_[r].subject && results_[other].quantity == results_[r].quantity &&
          results_[other].transmitted == results_[r].transmitted;
    });
    search.curves.push_back(same - named.begin());
    if (same == named.end()) named.push_back(r);
  }
}

assembly::Loading CaseVector::order_loading(const Search& search, const model::System& system,
                                            const assembly::Assembled& assembled) const {
  std::vector<response::OrderLoading> loads =
      response::operating_loads(system, assembled, results_[search.results.front()].excitations);
  const auto of_order = std::ranges::find(loads, search.order, &response::OrderLoading::order);
  if (of_order == loads.end() || loads.size() != search.orders)
    throw foundation::NotComputable("designs with and without a load of some order");
  return std::move(of_order->loading);
}

design::DesignOrReason<design::DrivenDesign> CaseVector::design_of(const Search& search, const model::System& system,
                                                                   const assembly::Assembled& assembled) const {
  std::vector<assembly::Channel> channels;
  assembly::Loading loading(Eigen::VectorXd::Zero(n_));
  try {
    if (search.order > 0) loading = order_loading(search, system, assembled);
    for (std::size_t k = 0; k < search.results.size(); ++k) {
      if (search.curves[k] < std::ssize(channels)) continue;
      const RequirementResult& result = results_[search.results[k]];
      if (search.order > 0) {
        channels.push_back(assembly::channels(system, assembled, {result.subject}, result.quantity).front());
        continue;
      }
      RequirementCurve curve = requirement_curve(system, assembled, result);
      if (channels.empty()) loading = std::move(curve.loading);
      channels.push_back(std::move(curve.channel));
    }
  } catch (const foundation::NotComputable& refused) {
    return {{}, refused.what()};
  } catch (const foundation::InvalidInput& refused) {
    return {{}, refused.what()};
  }
  return design::driven_design(assembled, channels, loading, !search.count_peaks && std::isfinite(search.band.to));
}

void CaseVector::plan_rest(const model::System& system, const assembly::Assembled& assembled) {
  for (std::size_t r = 0; r < results_.size(); ++r) {
    const RequirementKind kind = results_[r].kind;
    if (requirement_row(kind).packed != PackedPart::rest) continue;
    if (has_loads_ && kind == RequirementKind::static_value &&
        contains_forces_at_rest(system, assembled, results_[r].subject))
      continue;
    RestValue& value = at_rest_.emplace_back(RestValue{r, {}});
    for (const model::Element& element : system.elements())
      if (kind == RequirementKind::mount_load && element.name == results_[r].subject)
        value.range = element.rating->load[results_[r].direction];
    covered_[r] = true;
  }
}

void CaseVector::plan_decoupling(const model::System& system, const assembly::Assembled& assembled) {
  const auto& bodies = system.bodies();
  if (assembled.layout.of_bodies() != n_) return;
  for (std::size_t r = 0; r < results_.size(); ++r) {
    if (requirement_row(results_[r].kind).packed != PackedPart::bodies) continue;
    const auto at = std::ranges::find_if(bodies, [&](const auto& body) { return body.name == results_[r].subject; });
    Decoupled one{r, to_size(at - bodies.begin()), {}, {}};
    for (int j = 0; j < 6; ++j)
      if (const Eigen::Index row = assembled.layout.row(one.body, j); row >= 0) {
        one.rows.push_back(row);
        one.coordinates.push_back(j);
      }
    decoupled_.push_back(std::move(one));
    covered_[r] = true;
  }
}

std::string CaseVector::form(const model::System& system, const assembly::Assembled& assembled,
                             std::vector<design::DrivenDesign>& designs) const {
  if (second_order_ && !numerics::is_positive_definite(assembled.first_order().matrices.K)) return no_rest;
  if (assembled.hangs_aside) return "a hung body beside its plumb line";
  for (const Search& search : searches_) {
    auto found = design_of(search, system, assembled);
    if (!found.design) return found.reason;
    designs.push_back(std::move(*found.design));
  }
  if (!searches_.empty()) return "";
  auto found = design::driven_design(assembled, {}, assembly::Loading(Eigen::VectorXd::Zero(n_)));
  if (found.design) designs.push_back(std::move(*found.design));
  return found.reason;
}

design::PackedOrReason CaseVector::pack(const model::System& system) const {
  const assembly::Assembled assembled = assembly::assemble(system);
  std::vector<design::DrivenDesign> designs;
  if (assembled.matrices.size() != n_) return {{}, "designs with more coordinates than others"};
  if ((assembled.without_second_order != nullptr) != second_order_)
    return {{}, "designs with and without an effect of the forces at rest"};
  if (const std::string reason = form(system, assembled, designs); !reason.empty()) return {{}, reason};
  // Forces at rest are no polynomials of the numbers of a design; the stiffness that they are found with is.
  const assembly::Assembled& first = assembled.first_order();
  for (design::DrivenDesign& one : designs) one.K = first.matrices.K;
  for (std::size_t s = 0; s < searches_.size(); ++s)
    if (const std::string reason = design::reason_for_separate_families(searches_[s].first, designs[s]);
        !reason.empty())
      return {{}, reason};
  PackedList list;
  const Eigen::Index matrices = design::matrix_entries(n_);
  list.add(packed(designs.front()).head(matrices), scales(designs.front()).head(matrices));
  for (std::size_t s = 0; s < searches_.size(); ++s)
    list.add(packed(designs[s]).tail(searches_[s].size), scales(designs[s]).tail(searches_[s].size));
  if (loads()) {
    if (!has_static_stiffness_ && model::has_static_stiffness(system))
      return {{}, "some designs have a static stiffness of their own"};
    if (has_loads_beside_weight(system, assembled) != has_loads_)
      return {{}, "designs with and without constant forces"};
    const response::AtRest at_rest(system, assembled);
    const Eigen::MatrixXd& stiffness = at_rest.assembled().first_order().matrices.K;
    if (!numerics::is_positive_definite(stiffness)) return {{}, no_rest};
    const Eigen::VectorXd root_of_mass = assembled.matrices.A.diagonal().cwiseAbs().cwiseSqrt();
    const Eigen::VectorXd load = assembly::static_load(at_rest.system(), at_rest.assembled());
    list.add(load, scale_of(load, root_of_mass));
    if (has_loads_) list.add(assembly::constant_load(system, first), scale_of(load, root_of_mass));
    if (has_static_stiffness_) list.add(lower_triangle(stiffness), triangle_scale(stiffness));
    const Eigen::VectorXd rest = numerics::cholesky_solution(stiffness, load);
    if (second_order_) {
      const assembly::SecondOrderForms forms = assembly::second_order_forms(system, first);
      const Eigen::VectorXd scale = triangle_scale(first.matrices.K);
      constexpr double least = 1e-12;  // of a machine whose preloads carry it [m √kg]
      const double largest = std::max(least, rest.cwiseProduct(root_of_mass).cwiseAbs().maxCoeff());
      list.add(lower_triangle(forms.constant), scale);
      for (Eigen::Index k = 0; k < n_; ++k)
        list.add(lower_triangle(forms.per_coordinate[k]), scale * root_of_mass(k) / largest);
    }
    for (const RestValue& value : at_rest_) {
      if (has_loads_ && results_[value.result].kind == RequirementKind::static_value &&
          contains_forces_at_rest(system, assembled, results_[value.result].subject))
        return {{}, "designs in which a static result contains forces at rest"};
      const auto row = rest_row(at_rest.system(), at_rest.assembled().first_order(), results_[value.result]);
      list.add(row.first, scale_of(row.first, root_of_mass));
      const double size = row.first.cwiseAbs().dot(rest.cwiseAbs()) + std::abs(row.second);
      list.add(Eigen::VectorXd::Constant(1, row.second), Eigen::VectorXd::Constant(1, size));
    }
  }
  for (const Decoupled& one : decoupled_) {
    const spatial::MassProperties& mass = system.bodies()[one.body].mass;
    list.add(mass_numbers(mass), scale_of(mass));
  }
  return {list.list(), ""};
}

CaseVector::Unpacked CaseVector::parted(Eigen::MatrixXd entries) const {
  Unpacked designs;
  const Eigen::Index triangle = n_ * (n_ + 1) / 2;
  Eigen::Index at = design::matrix_entries(n_);
  for (const Search& search : searches_) at += search.size;
  const auto next = [&](Eigen::Index columns) -> Eigen::MatrixXd {
    at += columns;
    return entries.middleCols(at - columns, columns);
  };
  if (loads()) {
    designs.load = next(n_);
    if (has_loads_) designs.beside = next(n_);
    designs.rest_stiffness = has_static_stiffness_ ? next(triangle) : Eigen::MatrixXd(stiffness_in(entries));
    designs.standing = designs.rest_stiffness;
  }
  if (second_order_) designs.constant = next(triangle);
  for (Eigen::Index k = 0; second_order_ && k < n_; ++k) designs.per_coordinate.push_back(next(triangle));
  for (std::size_t i = 0; i < at_rest_.size(); ++i) designs.rows.push_back(next(n_ + 1));
  for (std::size_t i = 0; i < decoupled_.size(); ++i) designs.bodies.push_back(next(mass_entries));
  designs.falls.assign(to_size(entries.rows()), false);
  designs.entries = std::move(entries);
  return designs;
}

CaseVector::Unpacked CaseVector::unpacked(Eigen::MatrixXd entries) const {
  Unpacked designs = parted(std::move(entries));
  if (!second_order_) return designs;
  auto stiffness = stiffness_in(designs.entries);
  for (Eigen::Index d = 0; d < designs.count(); ++d) {
    const Eigen::MatrixXd first = numerics::unpacked(designs.rest_stiffness, d);
    designs.falls[d] = true;
    if (!numerics::is_positive_definite(first)) continue;
    const Eigen::VectorXd rest = numerics::cholesky_solution(first, Eigen::VectorXd(designs.load.row(d).transpose()));
    Eigen::ArrayXXd added = designs.constant.row(d).array();
    for (Eigen::Index k = 0; k < n_; ++k) added += rest(k) * designs.per_coordinate[k].row(d).array();
    designs.standing.row(d) += added;
    const Eigen::ArrayXXd of_vibration = stiffness.row(d).array() + added;
    if (!numerics::is_positive_definite(numerics::unpacked(of_vibration, 0)) ||
        !numerics::is_positive_definite(numerics::unpacked(designs.standing, d)))
      continue;
    designs.falls[d] = false;
    stiffness.row(d) = of_vibration.matrix();
  }
  return designs;
}

numerics::Designs CaseVector::free(const Unpacked& designs) const {
  const Eigen::Index triangle = n_ * (n_ + 1) / 2;
  return {designs.entries.leftCols(triangle).array(), designs.entries.middleCols(triangle, triangle).array(),
          designs.entries.middleCols(2 * triangle, triangle).array(), Eigen::ArrayXXd::Zero(1, n_)};
}

Eigen::ArrayXXd CaseVector::loss(const Unpacked& designs) const {
  const Eigen::Index triangle = n_ * (n_ + 1) / 2;
  return designs.entries.middleCols(3 * triangle, triangle).array();
}

numerics::DrivenDesigns CaseVector::searched(const Unpacked& designs, const Search& search) const {
  return design::unpacked_like(search.first, designs.entries, search.at);
}

CaseVector::Rest CaseVector::rest_of(const Unpacked& designs, Eigen::Index design) {
  const Eigen::VectorXd load = designs.load.row(design).transpose();
  const Eigen::MatrixXd first = numerics::unpacked(designs.rest_stiffness, design);
  if (!numerics::is_positive_definite(first)) {
    const Eigen::VectorXd none = Eigen::VectorXd::Constant(load.size(), std::numeric_limits<double>::quiet_NaN());
    return {none, none};
  }
  if (designs.beside.size() == 0) return {numerics::cholesky_solution(first, load), Eigen::VectorXd::Zero(load.size())};
  const Eigen::VectorXd beside = designs.beside.row(design).transpose();
  return {numerics::cholesky_solution(first, Eigen::VectorXd(load - beside)),
          numerics::cholesky_solution(numerics::unpacked(designs.standing, design), beside)};
}

CaseVector::Unpacked CaseVector::changes(const Unpacked& here, Eigen::MatrixXd slopes) const {
  Unpacked changes = parted(std::move(slopes));
  if (!second_order_) return changes;
  const Eigen::MatrixXd stiffness = numerics::unpacked(here.rest_stiffness, 0);
  if (!numerics::is_positive_definite(stiffness)) return changes;  // it has no margin either
  const Eigen::VectorXd load = here.load.row(0).transpose(), rest = numerics::cholesky_solution(stiffness, load);
  for (Eigen::Index j = 0; j < changes.count(); ++j) {
    const Eigen::VectorXd pull = changes.load.row(j).transpose() - numerics::unpacked(changes.rest_stiffness, j) * rest,
                          moved = numerics::cholesky_solution(stiffness, pull);
    Eigen::RowVectorXd added = changes.constant.row(j);
    for (Eigen::Index k = 0; k < n_; ++k)
      added += moved(k) * here.per_coordinate[k].row(0) + rest(k) * changes.per_coordinate[k].row(j);
    stiffness_in(changes.entries).row(j) += added;
    changes.standing.row(j) += added.array();
  }
  return changes;
}

}  // namespace trivet::study
