// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_objective.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/overruled_cases.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

/// Places of a requirement with several candidates: the nearest ones count.
constexpr std::size_t most_candidates = 8;

/// Room for measures above 0: of peaks that are not gone, but lower than the least prominence that counts.
constexpr double not_gone = 5;

std::size_t places_of(RequirementKind kind) { return requirement_row(kind).has_candidates ? most_candidates : 1; }

double logarithm(double margin) {
  if (!(margin > 0)) return DesignObjective::unusable;
  if (std::isinf(margin)) return DesignObjective::unlimited;
  return std::clamp(std::log(margin), DesignObjective::unusable, DesignObjective::most);
}

/// The candidates nearest to deciding, by frequency, so that two maxima that overtake each other keep their places; the
/// value itself where there are none.
std::vector<RequirementResult::Candidate> nearest(const RequirementResult& result) {
  std::vector<RequirementResult::Candidate> candidates = result.candidates;
  if (places_of(result.kind) == 1) candidates = {{result.margin, 0, 0, 0, false}};
  std::ranges::stable_sort(candidates, [](const auto& a, const auto& b) { return a.margin < b.margin; });
  candidates.resize(std::min(candidates.size(), most_candidates));
  std::ranges::stable_sort(candidates,
                           [](const auto& a, const auto& b) { return a.angular_frequency < b.angular_frequency; });
  return candidates;
}

/// Only the requirements whose slopes are differences of their values; `no_jump`, with a margin of 0 or ∞, has none.
/// The clearances are those of the model.
project::Analyses differenced_alone(project::Analyses analyses, const std::vector<RequirementResult>& given,
                                    const model::System& system) {
  analyses.limits.clear();
  std::erase_if(analyses.limit_lines, [](const project::LimitLineRequest& line) { return !line.bands; });
  if (!analyses.requirements) return analyses;
  const project::Requirements& all = *analyses.requirements;
  project::Requirements differenced;
  differenced.band = all.band;
  differenced.excitations = all.excitations;
  differenced.limit_lines = all.limit_lines;
  differenced.largest = all.largest;
  differenced.no_contact = all.no_contact;
  differenced.steady = all.steady;
  if (RequirementSlopes::are_missing(RequirementKind::rms, system)) differenced.rms = all.rms;
  differenced.mount_load = std::ranges::any_of(
      given, [](const RequirementResult& result) { return result.kind == RequirementKind::mount_shock_deflection; });
  analyses.requirements = std::move(differenced);
  return analyses;
}

bool is_same(const RequirementResult& a, const RequirementResult& b) {
  return a.kind == b.kind && a.subject == b.subject && a.direction == b.direction;
}

/// A requirement in the list of another model with fewer requirements: of the same kind, subject and direction, and if
/// there are several, such as limits of displacement and velocity, in the same order.
const RequirementResult& counterpart(const std::vector<RequirementResult>& found, std::size_t result,
                                     const std::vector<RequirementResult>& there) {
  std::size_t before = 0;
  for (std::size_t r = 0; r < result; ++r)
    if (is_same(found[r], found[result])) ++before;
  for (const RequirementResult& one : there)
    if (is_same(one, found[result]) && before-- == 0) return one;
  throw foundation::NotComputable("a neighbouring design has other requirements");
}

/// In some designs a mount has a load in a direction without a range: one more result, which is not judged.
void refuse_further_results(const std::vector<RequirementResult>& found, std::size_t expected) {
  if (found.size() == expected) return;
  for (const RequirementResult& result : found)
    if (!result.value) throw foundation::NotComputable(result.reason);
  throw foundation::NotComputable("it has other requirements than the given design");
}

double lowest_natural_frequency(const model::System& system) {
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  for (const modal::Mode& mode : context.modes.list)
    if (mode.angular_frequency.value_or(0) > 0) return *mode.angular_frequency;
  return 1;
}

}  // namespace

DesignObjective::DesignObjective(const project::Project& project, const project::OptimizeRequest& request,
                                 Reserves reserves, Effort effort)
    : space_(project, request.parameters), minimized_(request), reserves_(std::move(reserves)) {
  const std::vector<std::string> hold_in = cases_to_hold(project);
  for (const project::Case& variant : project.cases)
    if (std::ranges::find(hold_in, variant.name) != hold_in.end()) cases_.push_back(&variant);
  for (const project::Case* variant : cases_)
    if (const auto lost = overruled_in(*variant, project.base(), space_.axes()); !lost.empty())
      throw foundation::InvalidInput(lost.front().refusal("optimize"));
  for (const project::Case* variant : cases_) {
    requests_.push_back(variant->analyses);
    minimized_.add_to(requests_.back());
    if (requests_.back().requirements) requests_.back().requirements->connected_only = effort == Effort::quick;
  }
  for (const project::Case* variant : cases_) references_.push_back(lowest_natural_frequency(variant->system));
  for (std::size_t c = 0; c < cases_.size(); ++c) {
    const std::vector<RequirementResult>& given = given_.emplace_back(results(c, cases_[c]->system));
    minimized_.find_in(given);
    std::vector<std::size_t>& width = width_.emplace_back();
    for (std::size_t r = 0; r < given.size(); ++r) {
      if (!given[r].value)
        throw foundation::NotComputable("optimize: \"" + words({c, r}) + "\" cannot be judged: " + given[r].reason);
      width.push_back(places_of(given[r].kind));
      for (std::size_t k = 0; k < width.back(); ++k) {
        places_.push_back({c, r});
        is_objective_.push_back(!minimized_.any() || minimized_.contain({c, r}));
      }
    }
    differenced_requirements_.push_back(differenced_alone(requests_[c], given, cases_[c]->system));
  }
  if (places_.empty())
    throw foundation::InvalidInput(
        "optimize: neither requirements nor limits nor anything to minimise; add [requirements], or minimize = "
        "[\"BODY.x\"] in [analyses.optimize]");
  minimized_.refuse_unlike(given_.front());
  if (!has_quick(effort)) return;
  try {
    quick_ = std::make_unique<const DesignObjective>(project, request, reserves_, Effort::quick);
  } catch (const foundation::NotComputable&) {  // some requirements are judged only with motions that are not connected
  }
}

bool DesignObjective::is_expensive() const {
  return std::ranges::any_of(requests_, [](const project::Analyses& request) {
    return request.requirements && request.requirements->is_about_steady_motion();
  });
}

bool DesignObjective::has_quick(Effort effort) const {
  if (effort == Effort::quick) return false;
  return std::ranges::any_of(requests_, [](const project::Analyses& request) {
    const auto& steady = request.steady;
    return request.requirements && request.requirements->no_jump && !(steady && steady->all_branches);
  });
}

EvaluationCounts DesignObjective::counts() const {
  const std::lock_guard lock(noting_);
  EvaluationCounts all = counts_;
  if (!quick_) return all;
  EvaluationCounts of_quick = quick_->counts();
  if (!all.first_failure.empty()) of_quick.first_failure.clear();  // its own reasons say more
  all.add(of_quick);
  return all;
}

void DesignObjective::add(const EvaluationCounts& of_others) const {
  const std::lock_guard lock(noting_);
  counts_.add(of_others);
}

const std::vector<DesignBatch>& DesignObjective::families() const {
  std::call_once(fitting_, [&] {
    for (std::size_t c = 0; c < cases_.size(); ++c)
      families_.emplace_back(space_.numbers(*cases_[c]), *cases_[c], requests_[c], given_[c]);
  });
  return families_;
}

double DesignObjective::reserve(const Place& place) const {
  if (reserves_.empty() || minimized_.contain(place)) return 0;
  std::size_t number = place.result;
  for (std::size_t r = 0; r < place.result; ++r)
    if (minimized_.contain({place.result_case, r})) --number;
  return reserves_[place.result_case][number];
}

bool DesignObjective::is_differenced(std::size_t c, std::size_t r) const {
  return RequirementSlopes::are_missing(given_[c][r].kind, cases_[c]->system);
}

std::vector<std::string> DesignObjective::differenced() const {
  std::vector<std::string> kinds;
  for (std::size_t c = 0; c < given_.size(); ++c)
    for (std::size_t r = 0; r < given_[c].size(); ++r) {
      const std::string kind = name(given_[c][r].kind);
      if (is_differenced(c, r) && std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
    }
  return kinds;
}

std::string DesignObjective::words(const Place& place) const {
  const RequirementResult& result = given_[place.result_case][place.result];
  return minimized_.contain(place) ? minimized_.words(result) : result.words.text();
}

std::string DesignObjective::words_for_people(const Place& place) const {
  const project::DisplayUnits& display = cases_[place.result_case]->display;
  return minimized_.contain(place) ? words(place) : given_[place.result_case][place.result].words_for_people(display);
}

std::vector<RequirementResult> DesignObjective::results(std::size_t result_case, const model::System& system) const {
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  foundation::Problems warnings;
  return requirement_values(context, requests_[result_case], warnings);
}

void DesignObjective::evaluate(const Eigen::VectorXd& shares, Eigen::VectorXd& values, Eigen::MatrixXd* slopes,
                               const std::optional<Place>& ignored) const {
  const bool keep = !ignored && is_expensive();
  const std::vector<double> key(shares.begin(), shares.end());
  EvaluationCounts counts{.evaluations = 1};
  if (keep && !slopes) {
    const std::lock_guard lock(noting_);
    if (const auto known = known_.find(key); known != known_.end()) {
      values = known->second.values;
      counts_.add(known->second.counts);
      CountedHere::add(known->second.counts);
      return;
    }
  }
  const auto count = to_index(places_.size());
  values = Eigen::VectorXd::Constant(count, unlimited);
  if (slopes) slopes->setZero(count, shares.size());
  try {
    Eigen::Index first = 0;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      evaluate_case(c, shares, first, values, slopes, ignored, counts);
      for (const std::size_t width : width_[c]) first += to_index(width);
    }
  } catch (const foundation::NotComputable& reason) {
    counts.failed = 1;
    counts.first_failure = reason.what();
    values.setConstant(unusable);
    if (slopes) slopes->setZero();
  }
  CountedHere::add(counts);
  const std::lock_guard lock(noting_);
  counts_.add(counts);
  counts.differences = 0;
  if (keep) known_.emplace(key, Known{values, counts});
}

void DesignObjective::evaluate_case(std::size_t c, const Eigen::VectorXd& shares, Eigen::Index first,
                                    Eigen::VectorXd& values, Eigen::MatrixXd* slopes,
                                    const std::optional<Place>& ignored, EvaluationCounts& counts) const {
  const Eigen::VectorXd design = space_.values(shares);
  const model::System system = space_.system(*cases_[c], design);
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  foundation::Problems warnings;
  const std::vector<RequirementResult> found = requirement_values(context, requests_[c], warnings);
  refuse_further_results(found, width_[c].size());
  std::vector<Smooth> smooth(found.size());
  Eigen::Index place = first;
  for (std::size_t r = 0; r < found.size(); ++r) {
    const Eigen::Index end = place + to_index(width_[c][r]);
    const bool is_ignored = ignored && ignored->result_case == c && ignored->result == r;
    if (is_ignored) values.segment(place, end - place).setConstant(unlimited);
    else if (!found[r].value) values.segment(place, end - place).setConstant(unusable);
    else smooth[r] = set_values(found[r], place, values);
    for (const Eigen::Index row : smooth[r].rows) values(row) -= reserve({c, r});
    place = end;
  }
  const std::vector<Absence> absences = set_absences(c, context, found, first, ignored, values);
  if (!slopes) return;
  double least_objective = unlimited;
  for (Eigen::Index i = first; i < place; ++i)
    if (is_objective_[i]) least_objective = std::min(least_objective, values(i));
  for (Smooth& one : smooth)
    one.keep_near(values, is_objective_, minimized_.are_separate() ? one.least(values) : least_objective);
  const RequirementSlopes exact(context, space_, *cases_[c], design, &families()[c]);
  set_slopes(c, exact, found, smooth, *slopes, counts);
  if (!absences.empty()) add_absences(absences, found, exact.neighbours(), references_[c], *slopes);
  for (std::size_t j = 0; j < space_.size(); ++j)
    slopes->block(first, to_index(j), place - first, 1) *= space_.slope(j, shares(to_index(j)));
}

void DesignObjective::set_slopes(std::size_t c, const RequirementSlopes& exact,
                                 const std::vector<RequirementResult>& found, const std::vector<Smooth>& smooth,
                                 Eigen::MatrixXd& slopes, EvaluationCounts& counts) const {
  bool differenced = false;
  for (std::size_t r = 0; r < found.size(); ++r) {
    const std::vector<RequirementResult::Candidate>& candidates = smooth[r].candidates;
    if (candidates.empty() || requirement_row(found[r].kind).slopes == MarginSlopes::zero) continue;
    differenced = differenced || is_differenced(c, r);
    if (is_differenced(c, r)) continue;
    const Eigen::MatrixXd of_result = exact.of(r, found[r], candidates);
    for (std::size_t i = 0; i < smooth[r].rows.size(); ++i) slopes.row(smooth[r].rows[i]) = of_result.row(to_index(i));
  }
  if (differenced) add_differences(c, found, smooth, exact.neighbours(), slopes, counts);
}

double DesignObjective::Smooth::least(const Eigen::VectorXd& values) const {
  double result = most;
  for (const Eigen::Index row : rows) result = std::min(result, values(row));
  return result;
}

void DesignObjective::Smooth::keep_near(const Eigen::VectorXd& values, const std::vector<bool>& is_objective,
                                        double least_objective) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (values(rows[i]) > far + (is_objective[rows[i]] ? least_objective : 0)) continue;
    rows[kept] = rows[i];
    candidates[kept++] = candidates[i];
  }
  rows.resize(kept);
  candidates.resize(kept);
}

DesignObjective::Smooth DesignObjective::set_values(const RequirementResult& result, Eigen::Index place,
                                                    Eigen::VectorXd& values) {
  Smooth smooth;
  for (const RequirementResult::Candidate& candidate : nearest(result)) {
    values(place) = logarithm(candidate.margin);
    if (values(place) > unusable && values(place) < most) {
      smooth.candidates.push_back(candidate);
      smooth.rows.push_back(place);
    }
    ++place;
  }
  return smooth;
}

std::vector<DesignObjective::Absence> DesignObjective::set_absences(std::size_t c, const CaseContext& context,
                                                                    const std::vector<RequirementResult>& found,
                                                                    Eigen::Index first,
                                                                    const std::optional<Place>& ignored,
                                                                    Eigen::VectorXd& values) const {
  std::vector<Absence> absences;
  Eigen::Index width = 0;
  for (const std::size_t one : width_[c]) width += to_index(one);
  if (width == 0 || minimized_.any() || values.segment(first, width).minCoeff() < most) return absences;
  Eigen::Index place = first;
  for (std::size_t r = 0; r < found.size(); ++r) {
    const bool is_ignored = ignored && ignored->result_case == c && ignored->result == r;
    if (found[r].kind == RequirementKind::no_peak && found[r].candidates.empty() && !is_ignored) {
      const std::vector<AbsentPeak> absent = absent_peaks(context, found[r], references_[c]);
      for (std::size_t i = 0; i < std::min(absent.size(), width_[c][r]); ++i) {
        const Eigen::Index row = place + to_index(i);
        values(row) = std::clamp(most + not_gone - absent[i].measure, most, unlimited);
        absences.push_back({r, row, absent[i]});
      }
    }
    place += to_index(width_[c][r]);
  }
  return absences;
}

void DesignObjective::add_absences(const std::vector<Absence>& absences, const std::vector<RequirementResult>& found,
                                   const DesignNeighbours& neighbours, double reference, Eigen::MatrixXd& slopes) {
  for (const Absence& one : absences)
    for (std::size_t j = 0; j < neighbours.parameters(); ++j)
      for (const response::WeightedModel& next : neighbours.along(j))
        slopes(one.row, to_index(j)) -=
            next.weight * absence_measure(*next.system, *next.assembled, found[one.result], one.place, reference);
}

std::vector<std::optional<AbsentPeak>> DesignObjective::absent_peaks_at(std::size_t result_case,
                                                                        const model::System& system) const {
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  std::vector<std::optional<AbsentPeak>> nearest_places;
  for (const RequirementResult& result : results(result_case, system)) {
    auto& nearest_place = nearest_places.emplace_back();
    if (result.kind != RequirementKind::no_peak || !result.candidates.empty()) continue;
    for (const AbsentPeak& one : absent_peaks(context, result, references_[result_case]))
      if (!nearest_place || one.measure > nearest_place->measure) nearest_place = one;
  }
  return nearest_places;
}

void DesignObjective::add_differences(std::size_t c, const std::vector<RequirementResult>& found,
                                      const std::vector<Smooth>& smooth, const DesignNeighbours& neighbours,
                                      Eigen::MatrixXd& slopes, EvaluationCounts& counts) const {
  const foundation::Progress silent;
  foundation::Problems warnings;
  for (std::size_t j = 0; j < space_.size(); ++j)
    for (const response::WeightedModel& model : neighbours.along(j)) {
      ++counts.differences;
      const CaseContext context(*model.system, silent);
      const std::vector<RequirementResult> there = requirement_values(context, differenced_requirements_[c], warnings);
      for (std::size_t r = 0; r < found.size(); ++r) {
        if (!is_differenced(c, r) || smooth[r].rows.empty()) continue;
        const double change = model.weight * logarithm(counterpart(found, r, there).margin);
        for (const Eigen::Index row : smooth[r].rows) slopes(row, to_index(j)) += change;
      }
    }
}

}  // namespace trivet::study
