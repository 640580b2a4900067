// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/whole_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "trivet/elements/checks.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"
#include "trivet/model/nodes.h"
#include "trivet/model/point_mass.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/plausibility/overturning.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/explain/element_summary.h"
#include "trivet/study/optimize/design_front.h"
#include "trivet/study/optimize/optimization.h"
#include "trivet/study/requirements/overruled_cases.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

/// Computes the map that the file requests, with the cases as points on it.
void add_map(const project::Project& project, const project::Case& variant, const foundation::Progress& step,
             CaseResults& results) {
  try {
    const project::MapRequest& request = *variant.analyses.map;
    if (request.pairs.empty()) results.map = design_map(project, variant, request, {}, step);
    else results.map_pairs = design_maps(project, variant, request, {}, step);
    if (results.map) results.warnings.add(results.map->warnings);
    for (const DesignMap& map : results.map_pairs) results.warnings.add(map.warnings);
  } catch (const foundation::NotComputable& reason) {
    results.failures.emplace_back(reason.what());
  } catch (const foundation::InvalidInput& reason) {
    results.failures.emplace_back(reason.what());
  }
}

/// Judges the case, with the warnings of the verdict that its results do not have yet.
void add_verdict(const project::Project& project, const project::Case& variant, const foundation::Progress& step,
                 CaseResults& results) {
  results.verdict = case_verdict(variant, cases_to_hold(project), step);
  std::set<std::string> known;
  for (const foundation::Problem& problem : results.warnings.list()) known.insert(foundation::message(problem));
  for (const foundation::Problem& problem : results.verdict->warnings.list())
    if (known.insert(foundation::message(problem)).second) results.warnings.add(problem);
}

/// What a case contributes to the envelope of a run: nothing without a verdict or static results.
LoadCase load_case_of(const project::Case& variant, const CaseResults& results) {
  if (results.verdict) return results.verdict->load_case;
  if (!variant.analyses.static_of) return {variant.name, {}, ""};
  return load_case(variant.name, variant.system, assembly::assemble(variant.system), variant.analyses);
}

/// Searches the best design, or the front, that the file requests.
void add_optimum(const project::Project& project, const foundation::Progress& step, CaseResults& results) {
  const auto& request = project.base().analyses.optimize;
  if (!request) return;
  try {
    if (request->front.empty()) {
      results.optimization = std::make_shared<const Optimization>(optimization(project, step));
      results.warnings.add(results.optimization->warnings);
    } else {
      results.front = std::make_shared<const DesignFront>(design_front(project, step));
      results.warnings.add(results.front->warnings);
    }
  } catch (const foundation::NotComputable& reason) {
    results.failures.emplace_back(reason.what());
  } catch (const foundation::InvalidInput& reason) {
    results.failures.emplace_back(reason.what());
  }
}

/// Samples the designs within the tolerances that the file requests.
void add_sample(const project::Project& project, const foundation::Progress& step, CaseResults& results) {
  if (!project.base().analyses.sample) return;
  try {
    results.sample = std::make_shared<const Sample>(sample_in_a_run(project, true, step));
  } catch (const foundation::NotComputable& reason) {
    results.failures.emplace_back(reason.what());
  } catch (const foundation::InvalidInput& reason) {
    results.failures.emplace_back(reason.what());
  }
}

/// @param lowest  lowest scaled eigenvalue; negative if the element generates energy
void add_matrix_lines(const std::string& subject, const std::string& quantity, const elements::MatrixVerdict& v,
                      double lowest, bool symmetric, std::vector<CheckLine>& lines) {
  if (v.highest_eigenvalue == 0) return;
  lines.push_back({subject, quantity + " gives no force under rigid motion",
                   fmt::format("{:.1e} (scaled by √(K_ii K_jj))", v.rigid_residual),
                   v.rigid_residual <= elements::silent_residual});
  if (symmetric) {
    lines.push_back({subject, quantity + " is symmetric", fmt::format("{:.1e} (scaled by √(K_ii K_jj))", v.asymmetry),
                     v.asymmetry <= elements::rounding_of_data});
    lines.push_back({subject, quantity + " generates no energy",
                     fmt::format("lowest scaled eigenvalue {:.2g}", std::abs(lowest) < 1e-13 ? 0.0 : lowest),
                     lowest >= -elements::rounding_of_data * std::max(1.0, v.highest_eigenvalue)});
  }
}

}  // namespace

std::vector<MountAtRest> quick_mounts(const model::System& system, const assembly::Assembled& assembled) {
  constexpr Eigen::Index quick = 300;  // coordinates, whose position of rest takes some hundredths of a second
  const model::Description& d = system.description();
  if (assembled.matrices.size() > quick || (!d.gravity && d.constant_forces.empty())) return {};
  try {
    return mounts_at_rest(system, assembled);
  } catch (const foundation::NotComputable&) {  // the check names rigid-body modes itself
    return {};
  }
}

Sample sample_in_a_run(const project::Project& project, bool shares, const foundation::Progress& progress) {
  // The number of designs does not depend on the machine, so results do not either.
  constexpr std::size_t most_sampled = 100'000, most_assembled = 1000;
  return sample(project, progress,
                {.shares = shares,
                 .most_by_kernels = most_sampled,
                 .most_assembled = most_assembled,
                 .worst_of_assembled = false});
}

std::vector<CaseResults> run(const project::Project& project, const foundation::Progress& progress,
                             const std::function<void(std::size_t, const CaseResults&)>& done) {
  std::vector<CaseResults> all;
  for (std::size_t i = 0; i < project.cases.size(); ++i) {
    const project::Case& variant = project.cases[i];
    const auto step = [&](std::string_view task, double fraction) {
      if (progress)
        progress(fmt::format("{}: {}", variant.name.empty() ? "base model" : variant.name, task),
                 (static_cast<double>(i) + fraction) / static_cast<double>(project.cases.size()));
    };
    all.push_back(case_results(variant, variant.analyses, step));
    if (is_judged_in_a_run(variant)) add_verdict(project, variant, step, all.back());
    if (project.cases.size() > 1) all.back().load_case = load_case_of(variant, all.back());
    if (has_own_map(project, variant)) add_map(project, variant, step, all.back());
    if (i == 0) add_optimum(project, step, all.back());
    if (i == 0) add_sample(project, step, all.back());
    if (i == 0 && !project.base().analyses.optimize) all.back().warnings.add(overruled_by_search(project));
    if (done) done(i, all.back());
  }
  return all;
}

Envelope envelope_of(const std::vector<CaseResults>& results) {
  std::vector<const LoadCase*> cases;
  for (const CaseResults& one : results)
    if (one.load_case) cases.push_back(&*one.load_case);
  Envelope result = envelope(cases);
  if (!results.empty()) result.display = results.front().display;
  return result;
}

std::vector<CheckLine> check_lines(const project::Case& variant) {
  std::vector<CheckLine> lines;
  for (const auto& body : variant.system.bodies()) {
    if (body.is_node) continue;
    const std::string subject = "body " + body.name;
    lines.push_back({subject, "mass is positive", fmt::format("{:.6g} kg", body.mass.mass), body.mass.mass > 0});
    if (!body.has_inertia || model::is_point_mass(body)) continue;
    const Eigen::Vector3d j = spatial::principal_inertia(body.mass).moments;
    const Eigen::VectorXd a = numerics::symmetric_eigenvalues(Eigen::MatrixXd(spatial::mass_matrix(body.mass)));
    lines.push_back({subject, "principal central moments are those of a real body",
                     fmt::format("{:.6g}, {:.6g}, {:.6g} kg m²", j(0), j(1), j(2)),
                     spatial::violated_bounds(body.mass).empty()});
    lines.push_back(
        {subject, "mass matrix is positive definite", fmt::format("lowest eigenvalue {:.12g}", a(0)), a(0) > 0});
  }
  for (const auto& element : variant.system.elements()) {
    if (!element.distance_parts.empty()) continue;  // its force turns with the line between its ends
    const std::string subject = "element " + element.name;
    const elements::Matrix12 k = elements::stiffness(element.law), b = elements::viscous_damping(element.law);
    const elements::MatrixVerdict of_k = study::matrix_verdict(variant, element, k),
                                  of_b = study::matrix_verdict(variant, element, b);
    // A preloaded element does work when rotated as a whole, so N is held.
    add_matrix_lines(subject, "stiffness", of_k,
                     element.law.preload ? elements::lowest_of_held_end(k) : of_k.lowest_eigenvalue, element.symmetric,
                     lines);
    add_matrix_lines(subject, "damping", of_b, of_b.lowest_eigenvalue, element.symmetric, lines);
  }
  return lines;
}

std::vector<CaseCheck> check(const project::Project& project, bool deep) {
  std::vector<CaseCheck> cases;
  std::vector<MountAtRest> of_base;
  for (const project::Case& variant : project.cases) {
    CaseCheck found;
    found.case_name = variant.name;
    found.display = variant.display;
    const assembly::Assembled assembled = assembly::assemble(variant.system);
    const modal::Modes modes = project::lowest_modes_suffice(variant.analyses)
        ? modal::lowest_modes(variant.system, assembled, variant.analyses.lowest_modes)
        : modal::modes(variant.system, assembled);
    found.warnings = variant.warnings;
    if (cases.empty()) {
      found.warnings.add(overruled_by_search(project));
      found.warnings.add(overruled_by_map(project));
    }
    found.warnings.add(modes.warnings);
    if (!modal::cannot_grow(assembled, modes))
      found.warnings.add(is_too_large_for_roots(assembled) ? warning_of_unknown_roots()
                                                           : modal::roots(variant.system, assembled, modes).warnings);
    found.lines = check_lines(variant);
    if (!cases.empty())
      std::erase_if(found.lines, [&](const CheckLine& line) {
        return std::ranges::find(cases.front().lines, line) != cases.front().lines.end();
      });
    found.mounts = quick_mounts(variant.system, assembled);
    if (!cases.empty() && found.mounts == of_base) found.mounts.clear();
    if (cases.empty()) of_base = found.mounts;
    found.free_motions = modal::free_motions(variant.system, assembled, modes);
    found.notes = model::left_out_notes(variant.system.description());
    for (std::string& note : plausibility::first_order_notes(variant.system, assembled))
      found.notes.push_back(std::move(note));
    if (cases.empty())
      for (std::string& note : plausibility::overturning_notes(variant.system, assembled))
        found.notes.push_back(std::move(note));
    if (deep) found.deep = deep_check(variant);
    cases.push_back(std::move(found));
  }
  return cases;
}

}  // namespace trivet::study
