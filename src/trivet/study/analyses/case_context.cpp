// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/case_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <string_view>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/model/guides.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/model/system.h"
#include "trivet/plausibility/overturning.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/response/steady/at_rest.h"

namespace trivet::study {

namespace {

constexpr double default_band_factor = 1.3;

}  // namespace

CaseContext::CaseContext(std::shared_ptr<const SolvedCase> solved_case, const foundation::Progress& shown_progress)
    : solved_(std::move(solved_case)),
      system(solved_->system),
      progress(shown_progress),
      assembled(solved_->assembled),
      modes(solved_->modes) {}

Eigen::VectorXcd CaseContext::resonances() const {
  constexpr Eigen::Index large = 60;  // whose roots take some hundredths of a second
  if (assembled.matrices.size() <= large || assembled.frequency_dependent()) return roots().poles;
  Eigen::VectorXcd natural(to_index(modes.list.size()));
  for (std::size_t i = 0; i < modes.list.size(); ++i)
    natural(to_index(i)) = {0, modes.list[i].angular_frequency.value_or(0)};
  return natural;
}

assembly::Band default_band(const CaseContext& c) { return default_band(c, c.roots().poles); }

assembly::Band default_band(const CaseContext& c, const Eigen::VectorXcd& poles) {
  double highest = 0;
  for (const modal::Mode& mode : c.modes.list) highest = std::max(highest, mode.angular_frequency.value_or(0));
  if (poles.size() > 0) highest = std::max(highest, poles.imag().maxCoeff());
  assembly::Band band{0, highest > 0 ? default_band_factor * highest : 1.0};
  for (const assembly::ElementMap& map : c.assembled.elements)
    band = {std::max(band.from, map.defined_from), std::min(band.to, map.defined_to)};
  return band;
}

bool is_too_large_for_roots(const assembly::Assembled& assembled) {
  return assembled.matrices.size() > to_index(project::most_coordinates);
}

foundation::Problems warning_of_unknown_roots() {
  foundation::Problems warnings;
  warnings.warning("roots", "the stiffness or the damping may feed energy",
                   "motions may grow, and the damped roots of so large a model are not computed",
                   "check the damping, or split the model and compute its roots");
  return warnings;
}

foundation::NotComputable without_excitation(const std::string& analysis) {
  const project::MissingExcitation missing = project::missing_excitation(project::drive_of(analysis));
  return foundation::NotComputable(analysis + ": " + missing.finding + "; " + missing.remedy);
}

std::vector<assembly::Channel> channels_of(const CaseContext& c, const project::ChannelSelection& selection) {
  return assembly::channels(c.system, c.assembled, selection.of, selection.quantity);
}

std::vector<double> grid_over(const CaseContext& c, const std::vector<assembly::Channel>& channels,
                              const assembly::Loading& loading, const response::Peaks& peaks,
                              const assembly::Band& band) {
  return response::automatic_grid(c.assembled, channels, loading, c.roots().poles, peaks, band, c.progress);
}

void require_rigid_ground(const CaseContext& c, const std::string& analysis) {
  if (const auto standing = model::element_on_modes(c.system.description()))
    throw foundation::NotComputable(
        analysis + ": \"" + *standing +
        "\" is mounted on a modal foundation, for which a rigid motion of the ground is not defined; describe it "
        "by an impedance or a mobility, or as a body on its own elements");
}

namespace {

/// Warns of excitations without effect: a force along a constraint, an unbalance that turns about the only free
/// direction …
void warn_of_vanishing_load(const CaseContext& c, const project::Analyses& analyses, foundation::Problems& warnings) {
  for (const std::vector<std::string>* selected :
       {analyses.response ? &analyses.response->selection.excitations : nullptr,
        analyses.peaks ? &analyses.peaks->selection.excitations : nullptr,
        analyses.map ? &analyses.map->excitations : nullptr})
    if (selected && project::is_driven(c.system, project::Drive::harmonic) &&
        assembly::harmonic_loading(c.system, c.assembled, *selected).vanishes()) {
      warnings.warning("excitations", "they act on no free coordinate", "all results are 0",
                       "check the directions of forces and constraints");
      return;
    }
}

/// Warns that totals on the ground are forces of elements, without the forces of constraints.
void warn_of_guide_forces(const CaseContext& c, const project::Analyses& analyses, foundation::Problems& warnings) {
  std::vector<std::string> of = analyses.static_of.value_or(std::vector<std::string>{});
  if (analyses.response)
    of.insert(of.end(), analyses.response->selection.of.begin(), analyses.response->selection.of.end());
  if (analyses.peaks) of.insert(of.end(), analyses.peaks->selection.of.begin(), analyses.peaks->selection.of.end());
  if (analyses.map) {
    of.insert(of.end(), analyses.map->no_peak.begin(), analyses.map->no_peak.end());
    for (const project::AmplitudeLimit& limit : analyses.map->limits) of.push_back(limit.name);
  }
  for (const auto& [name, analysis] : project::independent_analyses(analyses))
    of.insert(of.end(), analysis.selection.of.begin(), analysis.selection.of.end());
  if (analyses.operation) of.emplace_back("ground");
  if (std::ranges::none_of(of, [](const std::string& word) { return word.starts_with("ground"); })) return;
  for (const model::Body& body : c.system.bodies())
    if (body.is_constrained())
      warnings.warning("ground", (body.is_node ? "node \"" : "body \"") + body.name + "\" is constrained",
                       "totals on the ground are the forces of elements, without the forces of constraints",
                       "add these if they matter");
}

/// Warns of ground motions implied by an analysis that the constraints of a body do not follow.
void warn_of_guided_motions(const CaseContext& c, const project::Analyses& analyses, foundation::Problems& warnings) {
  const auto warn = [&](const char* analysis, const model::Direction& direction) {
    model::Action::Amplitude motion = model::Action::Amplitude::Zero();
    (direction.rotation ? motion.tail<3>() : motion.head<3>()) = direction.axis.cast<std::complex<double>>();
    for (const model::Body& body : c.system.bodies())
      if (const std::string names = model::coordinates_left_behind(body, motion, Eigen::Vector3d::Zero());
          !names.empty())
        model::warn_of_guides(body, names, analysis, warnings);
  };
  const auto& transmitted = analyses.transmissibility;
  if (transmitted && transmitted->force.empty()) warn("transmissibility", transmitted->direction);
  if (const auto& shaken = analyses.earthquake) warn("earthquake", model::Direction{shaken->direction, false});
}

/// Warns of frequency-dependent elements: undamped modes use one stiffness, the static one.
void warn_of_frequency_dependence(const CaseContext& c, foundation::Problems& warnings) {
  constexpr double noticeable = 0.2;
  for (const model::Element& element : c.system.elements()) {
    if (model::couples_ground_points(element)) continue;
    if (element.is_foundation && element.law.frequency_dependence)
      warnings.warning("elements." + element.name, "flexible ground given by its mobility",
                       "modes, roots, mode numbers and the Campbell diagram use the spring stiffness of its first "
                       "row, without its inertia, its resonances and its couplings to other points",
                       "use the response, its peaks and critical speeds, which are exact");
    else if (element.law.frequency_dependence && element.law.frequency_dependence->from > 0)
      warnings.warning(
          "elements." + element.name,
          fmt::format("its table begins at {:.4g} Hz", element.law.frequency_dependence->from / (2 * std::numbers::pi)),
          "undamped modes use its first row as the static stiffness", "add rows at lower frequencies if they matter");
    const auto* relaxing = std::get_if<elements::Viscoelastic>(&element.law.damping);
    if (!relaxing || std::holds_alternative<elements::KelvinVoigt>(*relaxing)) continue;
    double gain = 0;
    for (const modal::Mode& mode : c.modes.list)
      gain = std::max(gain, elements::relative_modulus(*relaxing, mode.angular_frequency.value_or(0)).real() - 1);
    if (gain > noticeable)
      warnings.warning(
          "elements." + element.name, fmt::format("dynamically up to {:.3g} times as stiff as statically", 1 + gain),
          "undamped modes use the static stiffness", "use natural frequencies from the damped roots or the peaks");
  }
}

/// One warning for elements of which the same is said, with all their names: equal mounts.
foundation::Problems of_equal_elements_together(const foundation::Problems& warnings) {
  constexpr std::string_view elements = "elements.";
  foundation::Problems together;
  for (const foundation::Problem& warning : warnings.list()) {
    const auto equal = std::ranges::find_if(together.list(), [&](const foundation::Problem& known) {
      return known.subject.starts_with(elements) && known.origin.line == 0 && known.finding == warning.finding &&
          known.rule == warning.rule && known.remedy == warning.remedy;
    });
    const bool is_of_element = warning.subject.starts_with(elements) && warning.origin.line == 0;
    if (is_of_element && equal != together.list().end())
      equal->subject += ", " + warning.subject.substr(elements.size());
    else together.add(warning);
  }
  return together;
}

/// Warns of massless springs: they are valid only well below their own first natural frequency.
void warn_of_massless_springs(const CaseContext& c, double search_to, foundation::Problems& warnings) {
  constexpr double safe = 0.3;
  double top = search_to;
  for (const modal::Mode& mode : c.modes.list) top = std::max(top, mode.angular_frequency.value_or(0));
  for (const model::Element& element : c.system.elements()) {
    const double own = element.massless_up_to;
    if (!(top > safe * own)) continue;
    warnings.warning("elements." + element.name,
                     fmt::format("massless, but its own first natural frequency is {:.4g} Hz; the model is "
                                 "computed up to {:.4g} Hz",
                                 own / (2 * std::numbers::pi), top / (2 * std::numbers::pi)),
                     "a massless spring is valid only well below its own natural frequencies",
                     "set level = \"with_mass\" or \"exact\", or use only results well below");
  }
}
}  // namespace

foundation::Problems rest_warnings(const CaseContext& c, const project::Analyses& analyses) {
  foundation::Problems warnings;
  const bool judges_rest =
      analyses.requirements && (!analyses.requirements->statics.empty() || analyses.requirements->mount_load);
  if (!analyses.static_of && !judges_rest && c.system.description().clearances.empty()) return warnings;
  if (!model::has_static_stiffness(c.system))
    for (const model::Element& element : c.system.elements())
      if (element.stiffening != 1)
        warnings.warning("elements." + element.name, fmt::format("stiffening = {:.4g}", element.stiffening),
                         "a machine with nonlinear parts has one stiffness, that of vibration, at rest too; under a "
                         "static load the element is softer",
                         "look at rest with stiffening = 1");
  if (&response::of_statics(c.system, c.assembled) == &c.assembled) return warnings;  // of both orders
  constexpr double noticeable = 0.05;                                                 // of the tilt by a load
  for (const std::string& note : plausibility::overturning_notes(c.system, c.assembled, noticeable))
    warnings.warning("analyses.static", note,
                     "static results of a machine with nonlinear laws are of the first order: they leave out what the "
                     "weight takes of the stiffness, so that tilting comes out too small",
                     "compare with the same machine without these laws, or take a wider or stiffer support");
  return warnings;
}

foundation::Problems case_warnings(const CaseContext& c, const project::Analyses& analyses, double search_to) {
  foundation::Problems warnings;
  warn_of_frequency_dependence(c, warnings);
  warnings.add(rest_warnings(c, analyses));
  warn_of_guide_forces(c, analyses, warnings);
  warn_of_guided_motions(c, analyses, warnings);
  warn_of_vanishing_load(c, analyses, warnings);
  warn_of_massless_springs(c, search_to, warnings);
  return of_equal_elements_together(warnings);
}

assembly::MotionQuantity quantity_of(const assembly::LimitLine& line) {
  if (line.unit == "m/s" || line.unit == "rad/s") return assembly::MotionQuantity::velocity;
  if (line.unit == "m/s²" || line.unit == "rad/s²") return assembly::MotionQuantity::acceleration;
  return assembly::MotionQuantity::displacement;
}

std::vector<LimitLineResult> limit_line_results(const CaseContext& c,
                                                const std::vector<project::LimitLineRequest>& requests,
                                                const project::ChannelSelection& selection,
                                                const assembly::Band& band) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, selection.excitations);
  std::vector<LimitLineResult> results;
  for (const project::LimitLineRequest& request : requests) {
    const std::vector<assembly::Channel> channel =
        assembly::channels(c.system, c.assembled, {request.of}, quantity_of(request.line));
    const response::Peaks peaks =
        response::peaks(c.assembled, channel, loading, c.modes, c.roots(), {.search_to = band.to}, c.progress);
    results.push_back({request.of, request.line,
                       response::compared_with_limit(c.assembled, channel.front(), loading, c.roots().poles, peaks,
                                                     request.line, band, c.progress)});
  }
  return results;
}

}  // namespace trivet::study
