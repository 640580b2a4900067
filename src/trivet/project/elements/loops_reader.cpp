// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/identification/law_fit.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/loop_file.h"

namespace trivet::project {
namespace {

using identification::LawFit;
using identification::LoopFit;

/// Laws that can be fitted: their names in the project file and in LawFit.
const std::map<std::string, std::string> law_names = {{"hysteretic", "hysteretic"},
                                                      {"kelvin_voigt", "viscous (Kelvin–Voigt)"},
                                                      {"zener", "Zener"},
                                                      {"fractional_zener", "fractional Zener"}};

std::string interval(const identification::Estimate& estimate) {
  return fmt::format("{:.5g} ± {:.2g}", estimate.value, estimate.half_width);
}

void add_facts(const std::vector<LoopFit>& loops, const identification::LawRanking& ranking, const LawFit& taken,
               model::Element& element) {
  for (const LoopFit& loop : loops)
    element.facts.push_back(
        {loop.name,
         fmt::format("{}amplitude {}: stiffness {} N/m, loss factor {}, loss energy {} J{}",
                     loop.angular_frequency
                         ? fmt::format("{:.5g} Hz, ", *loop.angular_frequency / (2 * std::numbers::pi))
                         : std::string(),
                     foundation::prefixed(loop.amplitude.value, "m"), interval(loop.stiffness),
                     interval(loop.loss_factor), interval(loop.loss_energy),
                     loop.viscous_coefficient ? ", c = " + interval(*loop.viscous_coefficient) + " N s/m" : "")});
  for (const LawFit& law : ranking.laws)
    element.facts.push_back(
        {law.law + (&law == &taken ? " (taken)" : ""),
         fmt::format("deviates from the loops by {:.3g} % rms{}", 100 * law.relative_rms,
                     std::isnan(law.akaike) ? ", too few loops to compare it with other laws"
                                            : fmt::format(", AICc {:.3g} above the best", law.akaike_difference))});
}

/// The hysteretic law does not depend on frequency: loops without one determine it, too.
std::vector<LoopFit> with_any_frequency(std::vector<LoopFit> loops) {
  for (LoopFit& loop : loops) loop.angular_frequency = loop.angular_frequency.value_or(1);
  return loops;
}

/// A law that the project names, for too few loops to compare laws.
foundation::Expected<identification::LawRanking> only_law(const std::string& law,
                                                          const std::vector<identification::StiffnessPoint>& points) {
  auto fit = identification::fitted_law(law, points);
  if (!fit) return tl::make_unexpected(fit.error());
  identification::LawRanking ranking;
  ranking.laws.push_back(*std::move(fit));
  return ranking;
}

}  // namespace

void read_loops(TableReader& damping, model::Element& element) {
  const auto wanted =
      damping.choice("law", {"best", "hysteretic", "kelvin_voigt", "zener", "fractional_zener"}).value_or("best");
  const auto loops = read_loop_file(damping);
  if (!loops) return;
  foundation::Problems remarks;
  const std::vector<identification::StiffnessPoint> points =
      identification::stiffness_points(wanted == "hysteretic" ? with_any_frequency(*loops) : *loops, false, remarks);
  add_loop_problems(damping, remarks);
  const bool alone = wanted != "best" && points.size() < identification::fewest_ranked_points;
  const auto ranking = alone ? only_law(law_names.at(wanted), points) : identification::fitted_laws(points);
  if (!ranking) {
    add_loop_problems(damping, ranking.error());
    return;
  }
  const auto taken = std::ranges::find_if(
      ranking->laws, [&](const LawFit& law) { return wanted == "best" || law.law == law_names.at(wanted); });
  if (taken == ranking->laws.end()) {
    damping.error("law", "\"" + wanted + "\"", "this law could not be fitted to these loops",
                  "measure at more frequencies, or take law = \"best\"");
    return;
  }
  add_facts(*loops, *ranking, *taken, element);
  constexpr double poor = 0.05, alike = 2;
  foundation::Problems doubts;
  if (taken->relative_rms > poor)
    doubts.warning(
        "loops",
        fmt::format("the law \"{}\" deviates from the loops by {:.3g} %", taken->law, 100 * taken->relative_rms),
        "a law should fit its data within 5 %", "take law = \"best\", or check the loops");
  const Eigen::Vector3d translations = element.law.nominal_stiffness.diagonal().tail<6>().head<3>();
  if (translations.maxCoeff() > 0 &&
      !(taken->stiffness > translations.minCoeff() / alike && taken->stiffness < alike * translations.maxCoeff()))
    doubts.warning(
        "loops",
        fmt::format("the loops have a stiffness of {}, the element {}", foundation::prefixed(taken->stiffness, "N/m"),
                    foundation::prefixed_range(translations.minCoeff(), translations.maxCoeff(), "N/m")),
        "loops and stiffness should be of one element", "check length_unit and force_unit of the loops");
  damping.add(doubts);
  if (taken->loss_factor) element.law.damping = elements::LossFactor{*taken->loss_factor};
  else element.law.damping = *taken->viscoelastic;
}

}  // namespace trivet::project
