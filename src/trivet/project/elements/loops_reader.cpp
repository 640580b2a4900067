// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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
         fmt::format("{:.5g} Hz, amplitude {:.4g} m: stiffness {} N/m, loss factor {}, loss energy {} J{}",
                     loop.angular_frequency.value_or(std::numeric_limits<double>::quiet_NaN()) / (2 * std::numbers::pi),
                     loop.amplitude.value, interval(loop.stiffness), interval(loop.loss_factor),
                     interval(loop.loss_energy),
                     loop.viscous_coefficient ? ", c = " + interval(*loop.viscous_coefficient) + " N s/m" : "")});
  for (const LawFit& law : ranking.laws)
    element.facts.push_back({law.law + (&law == &taken ? " (taken)" : ""),
                             fmt::format("deviates from the loops by {:.3g} % rms, AICc {:.3g} above the best",
                                         100 * law.relative_rms, law.akaike_difference)});
}

}  // namespace

void read_loops(TableReader& damping, model::Element& element) {
  const auto wanted =
      damping.choice("law", {"best", "hysteretic", "kelvin_voigt", "zener", "fractional_zener"}).value_or("best");
  const auto loops = read_loop_file(damping);
  if (!loops) return;
  foundation::Problems remarks;
  const std::vector<identification::StiffnessPoint> points = identification::stiffness_points(*loops, false, remarks);
  add_loop_problems(damping, remarks);
  const auto ranking = identification::fitted_laws(points);
  if (!ranking) {
    add_loop_problems(damping, ranking.error());
    return;
  }
  const auto taken = std::find_if(ranking->laws.begin(), ranking->laws.end(), [&](const LawFit& law) {
    return wanted == "best" || law.law == law_names.at(wanted);
  });
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
    doubts.warning("loops",
                   fmt::format("the loops have a stiffness of {:.4g} N/m, the element {:.4g} to {:.4g} N/m",
                               taken->stiffness, translations.minCoeff(), translations.maxCoeff()),
                   "loops and stiffness should be of one element", "check length_unit and force_unit of the loops");
  damping.add(doubts);
  if (taken->loss_factor) element.law.damping = elements::LossFactor{*taken->loss_factor};
  else element.law.damping = *taken->viscoelastic;
}

}  // namespace trivet::project
