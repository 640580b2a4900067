// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/case_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "trivet/model/guides.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/plausibility/overturning.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/earthquake_question.h"
#include "trivet/project/analyses/transmissibility_question.h"
#include "trivet/response/steady/at_rest.h"

namespace trivet::study {
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
  for (const auto& [name, question] : analyses.questions)
    of.insert(of.end(), question->selection.of.begin(), question->selection.of.end());
  if (std::ranges::none_of(of, [](const std::string& word) { return word.starts_with("ground"); })) return;
  for (const model::Body& body : c.system.bodies())
    if (body.is_constrained())
      warnings.warning("ground", (body.is_node ? "node \"" : "body \"") + body.name + "\" is constrained",
                       "totals on the ground are the forces of elements, without the forces of constraints",
                       "add these if they matter");
}

/// Warns of ground motions implied by a question that the constraints of a body do not follow.
void warn_of_guided_motions(const CaseContext& c, const project::Analyses& analyses, foundation::Problems& warnings) {
  const auto warn = [&](const char* question, const model::Direction& direction) {
    model::Action::Amplitude motion = model::Action::Amplitude::Zero();
    (direction.rotation ? motion.tail<3>() : motion.head<3>()) = direction.axis.cast<std::complex<double>>();
    for (const model::Body& body : c.system.bodies())
      if (const std::string names = model::coordinates_left_behind(body, motion, Eigen::Vector3d::Zero());
          !names.empty())
        model::warn_of_guides(body, names, question, warnings);
  };
  const auto* transmitted = analyses.find<project::TransmissibilityQuestion>("transmissibility");
  if (transmitted && transmitted->force.empty()) warn("transmissibility", transmitted->direction);
  if (const auto* shaken = analyses.find<project::EarthquakeQuestion>("earthquake"))
    warn("earthquake", model::Direction{shaken->direction, false});
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
  return warnings;
}

}  // namespace trivet::study
