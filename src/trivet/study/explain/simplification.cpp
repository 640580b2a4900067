// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/simplification.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/elements/stiffness_properties.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::study {
namespace {

using modal::Mode;

elements::Matrix12 springs_only(const elements::Matrix12& matrix, const model::Span& span) {
  return elements::in_end_axes(elements::three_springs(matrix, span.arm), span.n_from_k);
}

elements::Law simplified_law(const elements::Law& full, const model::Span& span) {
  elements::Law law;
  law.nominal_stiffness = springs_only(full.nominal_stiffness, span);
  law.scale = full.scale;
  law.damping = full.damping;
  if (const auto* given = std::get_if<elements::DampingMatrix>(&full.damping))
    law.damping = elements::DampingMatrix{springs_only(given->matrix, span)};
  return law;
}

std::vector<std::string> left_out(const model::Element& element) {
  std::vector<std::string> words;
  if (element.law.inertia) words.push_back("the mass of \"" + element.name + "\"");
  if (!element.nonlinear_parts.empty() || !element.distance_parts.empty())
    words.push_back("the laws of \"" + element.name + "\"");
  if (element.law.preload) words.push_back("the preload of \"" + element.name + "\"");
  if (const auto& given = element.law.frequency_dependence)
    words.push_back(
        std::string(given->elastic ? "the frequency dependence" : "the frequency dependence and the losses") +
        " of \"" + element.name + "\"");
  return words;
}

bool is_inner(const Mode& mode) { return mode.element_kinetic_energy_share.sum() > 0.5; }

/// Σ φᵀAψ over the bodies, at their centres of mass; negative principal moments of an unphysical body count by their
/// absolute value.
double mass_product(const model::System& system, const Eigen::VectorXd& phi, const Eigen::VectorXd& psi) {
  double sum = 0;
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const auto first = 6 * to_index(b);
    const spatial::MassProperties& mass = system.bodies()[b].mass;
    const spatial::PrincipalInertia principal = spatial::principal_inertia(mass);
    const Eigen::Vector3d turn_phi = principal.axes.transpose() * phi.segment<3>(first + 3),
                          turn_psi = principal.axes.transpose() * psi.segment<3>(first + 3);
    sum += std::abs(mass.mass) * phi.segment<3>(first).dot(psi.segment<3>(first)) +
        turn_phi.dot(principal.moments.cwiseAbs().asDiagonal() * turn_psi);
  }
  return sum;
}

/// Modes of one natural frequency: their shapes are an arbitrary basis of one subspace, so that a shape is compared
/// with all of them.
struct Group {
  std::vector<const Mode*> modes;
  std::size_t taken = 0;
};

std::vector<Group> groups(const modal::Modes& modes) {
  std::vector<Group> result;
  for (const Mode& mode : modes.list) {
    if (is_inner(mode)) continue;
    const bool same = !result.empty() &&
        ((mode.repeated && result.back().modes.back()->repeated &&
          std::abs(mode.eigenvalue_squared - result.back().modes.back()->eigenvalue_squared) <=
              1e-9 * std::abs(mode.eigenvalue_squared)) ||
         (mode.eigenvalue_squared == 0 && result.back().modes.back()->eigenvalue_squared == 0));
    if (!same) result.emplace_back();
    result.back().modes.push_back(&mode);
  }
  return result;
}

double similarity(const model::System& system, const Mode& mode, const Group& group) {
  double sum = 0;
  const double own = mass_product(system, mode.shape_at_centre, mode.shape_at_centre);
  for (const Mode* other : group.modes) {
    const double product = mass_product(system, mode.shape_at_centre, other->shape_at_centre);
    const double norms = own * mass_product(system, other->shape_at_centre, other->shape_at_centre);
    if (norms > 0) sum += product * product / norms;
  }
  return sum;
}

/// Pairs the modes of both models, the most similar first.
std::vector<ModeComparison> paired(const model::System& system, const modal::Modes& full,
                                   const modal::Modes& simplified) {
  std::vector<ModeComparison> result;
  std::vector<Group> partners = groups(simplified);
  struct Candidate {
    std::size_t row, partner;
    double similarity;
  };
  std::vector<Candidate> candidates;
  for (const Mode& mode : full.list) {
    if (is_inner(mode)) continue;
    for (std::size_t g = 0; g < partners.size(); ++g)
      candidates.push_back({result.size(), g, similarity(system, mode, partners[g])});
    result.push_back({mode.number, mode.name, mode.angular_frequency, std::nullopt, 0});
  }
  std::ranges::stable_sort(candidates, std::ranges::greater{}, &Candidate::similarity);
  std::vector<bool> done(result.size(), false);
  for (const Candidate& candidate : candidates) {
    Group& partner = partners[candidate.partner];
    if (done[candidate.row] || partner.taken == partner.modes.size()) continue;
    done[candidate.row] = true;
    result[candidate.row].simplified = partner.modes[partner.taken++]->angular_frequency;
    result[candidate.row].similarity = candidate.similarity;
  }
  return result;
}

std::optional<HighestPeak> highest(const response::Peaks& peaks, std::size_t curve) {
  std::optional<HighestPeak> result;
  for (const response::Peak& peak : peaks.list)
    if (peak.curve == curve && (!result || peak.amplitude > result->amplitude))
      result = HighestPeak{peak.angular_frequency, peak.amplitude};
  return result;
}

std::vector<PeakComparison> compared(const response::Peaks& full, const response::Peaks& simplified) {
  std::vector<PeakComparison> result;
  for (std::size_t c = 0; c < full.curves.size(); ++c)
    if (!full.curves[c].vanishes)
      result.push_back({full.curves[c].name, full.curves[c].unit, highest(full, c), highest(simplified, c),
                        simplified.curves[c].vanishes});
  return result;
}

/// Adds the highest peaks of both models, or the reason why there are none.
void compare_peaks(const project::Case& full, const project::Case& simple, const foundation::Progress& progress,
                   Simplification& result) {
  project::Analyses request;
  request.peaks = full.analyses.peaks.value_or(
      project::PeaksRequest{full.analyses.response ? full.analyses.response->selection : project::ChannelSelection{}});
  try {
    const CaseResults of_full = case_results(full, request, progress),
                      of_simple = case_results(simple, request, progress);
    if (of_full.peaks && of_simple.peaks) result.peaks = compared(of_full.peaks->peaks, of_simple.peaks->peaks);
    else
      result.no_peaks = of_full.peaks ? "with three springs: " + of_simple.failures.front() : of_full.failures.front();
  } catch (const foundation::NotComputable& reason) {
    result.no_peaks = reason.what();
  }
}

}  // namespace

std::optional<double> relative_difference(std::optional<double> full, std::optional<double> simplified) {
  if (!full || !simplified || !(*full > 0) || !std::isfinite(*full) || !std::isfinite(*simplified)) return std::nullopt;
  return *simplified / *full - 1;
}

model::System with_three_springs(const model::System& system, const std::vector<std::size_t>& replaced) {
  model::Description description = system.description();
  for (const std::size_t index : replaced) {
    const model::Element& full = system.elements().at(index);
    model::Element element;
    element.name = full.name;
    element.type = "three_springs";
    element.n = full.n;
    element.k = full.k;
    element.law = simplified_law(full.law, model::span(system.bodies(), full.n, full.k));
    description.elements[index] = std::move(element);
  }
  auto checked = model::System::checked(std::move(description));
  if (!checked)
    throw foundation::NotComputable("three springs instead of the element: " +
                                    foundation::first_message(checked.error()));
  return std::move(*checked);
}

Simplification simplification(const project::Case& variant, const std::vector<std::size_t>& replaced,
                              const foundation::Progress& progress) {
  project::Case simple = variant;
  simple.system = with_three_springs(variant.system, replaced);
  const assembly::Assembled assembled = assembly::assemble(variant.system),
                            simple_assembled = assembly::assemble(simple.system);
  const modal::Modes full = modal::modes(variant.system, assembled),
                     simplified = modal::modes(simple.system, simple_assembled);
  const std::vector<std::string> already_free = modal::free_motions(variant.system, assembled, full);

  Simplification result;
  for (const std::size_t index : replaced) {
    const model::Element& element = variant.system.elements()[index];
    result.replaced.push_back(element.name);
    for (std::string& words : left_out(element)) result.left_out.push_back(std::move(words));
  }
  result.modes = paired(variant.system, full, simplified);
  for (const Mode& mode : full.list)
    if (is_inner(mode) && result.inner_modes++ == 0) result.first_inner_mode = mode.angular_frequency;
  for (const std::string& motion : modal::free_motions(simple.system, simple_assembled, simplified))
    if (std::ranges::find(already_free, motion) == already_free.end()) result.free_motions.push_back(motion);
  compare_peaks(variant, simple, progress, result);
  return result;
}

}  // namespace trivet::study
