// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/in_documents.h"
#include "trivet/results/model/element_results.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <variant>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/model/model_words.h"

namespace trivet::results {
namespace {

using foundation::two_pi;
using project::DisplayUnits;

/// "F_x", "M_z" and its unit. @param component  0 … 5
DisplayUnit load_unit(const DisplayUnits& display, int component) {
  return display_unit(display, component % 6 < 3 ? "N" : "N m");
}
DisplayUnit motion_unit(const DisplayUnits& display, int component) {
  return display_unit(display, component % 6 < 3 ? "m" : "rad");
}
std::string load_heading(const DisplayUnits& display, int component) {
  return fmt::format("{}_{} [{}]", component < 3 ? "F" : "M", "xyz"[component % 3], load_unit(display, component).unit);
}

std::string vector_words(const Eigen::Vector3d& v, double round_off) {
  const auto part = [&](int i) { return number_text(std::abs(v(i)) < round_off ? 0.0 : v(i), 4); };
  return fmt::format("({}, {}, {})", part(0), part(1), part(2));
}

std::string axes_words(const Eigen::Matrix3d& axes) {
  return fmt::format("x {}, y {}, z {}", vector_words(axes.col(0), 1e-12), vector_words(axes.col(1), 1e-12),
                     vector_words(axes.col(2), 1e-12));
}

std::string ends_text(const project::Case& variant, const model::Element& element) {
  std::string text;
  for (const auto& [letter, end] : {std::pair{'N', &element.n}, std::pair{'K', &element.k}}) {
    const spatial::Pose pose = model::end_in_ground(variant.system.bodies(), *end);
    const DisplayUnit length = display_unit(variant.display, "m");
    text += fmt::format("  end {} on {} at {} {}", letter,
                        end->body ? "body \"" + variant.system.bodies()[*end->body].name + "\"" : "the ground",
                        vector_words(length.factor * end->at, 1e-12), length.unit);
    text += pose.position.isApprox(end->at, 1e-12)
        ? "\n"
        : fmt::format(", in the ground frame at {} {}\n", vector_words(length.factor * pose.position, 1e-12),
                      length.unit);
  }
  const Eigen::Matrix3d n = model::end_in_ground(variant.system.bodies(), element.n).rotation,
                        k = model::end_in_ground(variant.system.bodies(), element.k).rotation;
  if (n.isApprox(k, 1e-12)) return text + "  local axes in the ground frame: " + axes_words(k) + "\n";
  return text + "  local axes of N in the ground frame: " + axes_words(n) +
      "\n  local axes of K in the ground frame: " + axes_words(k) + "\n";
}

/// Twelve rows with the six columns of one end: a width of 80 characters fits a terminal.
std::string half_matrix(const elements::Matrix12& matrix, int first_column, const DisplayUnits& display) {
  constexpr double round_off = 1e-12;
  const char end = first_column == 0 ? 'N' : 'K';
  std::vector<std::string> header = {"end", "load"};
  for (int j = 0; j < 6; ++j)
    header.push_back(fmt::format("{} {} [{}]", end, study::component_name(j), motion_unit(display, j).unit));
  TextTable table(header);
  for (int i = 0; i < 12; ++i) {
    std::vector<std::string> row = {i < 6 ? "N" : "K", load_heading(display, i % 6)};
    for (int j = first_column; j < first_column + 6; ++j) {
      const double scale = std::sqrt(std::abs(matrix(i, i) * matrix(j, j)));
      const double factor = load_unit(display, i).factor / motion_unit(display, j).factor;
      row.push_back(number_text(std::abs(matrix(i, j)) <= round_off * scale ? 0.0 : factor * matrix(i, j)));
    }
    table.add(row);
  }
  return table.text();
}

std::string stiffness_properties_text(const elements::StiffnessProperties& c, const DisplayUnits& display) {
  TextTable table(
      {"principal stiffness of K, N held", "axis (local)", "principal rotational stiffness", "axis (local) "});
  constexpr double round_off = 1e-9;
  const DisplayUnit along = display_unit(display, "N/m"), about = display_unit(display, "N m/rad"),
                    length = display_unit(display, "m");
  const double least = round_off * std::abs(c.principal_rotational_stiffnesses(2));
  for (int i = 0; i < 3; ++i) {
    const double rotational = c.principal_rotational_stiffnesses(i);
    table.add({number_text(along.factor * c.principal_stiffnesses(i)) + " " + along.unit,
               vector_words(c.principal_axes.col(i), round_off),
               number_text(std::abs(rotational) < least ? 0.0 : about.factor * rotational) + " " + about.unit,
               vector_words(c.principal_rotational_axes.col(i), round_off)});
  }
  return table.text() +
      fmt::format("  elastic centre: {} {} from K{}; rotational stiffnesses are about it\n",
                  vector_words(length.factor * c.elastic_centre, 1e-9), length.unit,
                  c.centre_is_unique ? "" : " (not unique: the nearest point of a line)") +
      fmt::format(
             "  coupling of translation and rotation, largest |K_ij|/√(K_ii K_jj): {:.3f} at K, {:.3f} at the elastic "
             "centre\n",
             c.coupling_at_k, c.coupling_at_centre) +
      fmt::format(
             "  strain energy of combined unit motions of end K over the sum of their single energies: {:.3g} … {:.3g} "
             "(1 … 1: uncoupled)\n",
             c.softest_combination, c.stiffest_combination);
}

std::string checks_text(const model::Element& element, const elements::MatrixVerdict& v) {
  const auto verdict = [](bool passed) { return passed ? std::string("ok") : std::string("CHECK IT"); };
  TextTable table({"check of the stiffness", "value (scaled by √(K_ii K_jj))", "verdict"});
  if (element.symmetric)
    table.add({"symmetric", fmt::format("{:.1e}", v.asymmetry), verdict(v.asymmetry <= elements::rounding_of_data)});
  else table.add({"declared unsymmetric", fmt::format("{:.1e}", v.asymmetry), "as declared"});
  if (element.distance_parts.empty())  // else its force turns with the line between its ends
    table.add({element.law.preload ? "rigid motion only rotates the preload" : "no force under rigid motion",
               fmt::format("{:.1e}", v.rigid_residual), verdict(v.rigid_residual <= elements::silent_residual)});
  // A preloaded element does work when rotated as a whole, so N is held.
  const double lowest =
      element.law.preload ? elements::lowest_of_held_end(elements::stiffness(element.law)) : v.lowest_eigenvalue;
  const bool passive = element.law.preload ? lowest >= -elements::rounding_of_data : elements::is_semidefinite(v);
  table.add({element.law.preload ? "generates no energy with N held" : "generates no energy",
             fmt::format("eigenvalues {:.2g} to {:.2g}", std::abs(lowest) < 1e-13 ? 0.0 : lowest, v.highest_eigenvalue),
             verdict(passive)});
  return table.text();
}

std::string energy_text(const study::ElementSummary& summary, const DisplayUnits& display) {
  constexpr double idle = 1e-4;  // share of the strain energy of a mode below which the element is not listed
  TextTable table({"mode", frequency_heading(display), "of the model's strain energy", "in translation", "in rotation",
                   "in coupling", "motion"});
  const auto share_words = [](double share) {
    return fmt::format("{:.1f}%", std::abs(share) < 5e-4 ? 0.0 : 100 * share);
  };
  std::size_t shown_modes = 0;
  for (const study::ElementInMode& mode : summary.modes) {
    if (std::abs(mode.of_stored) < idle || !(mode.inside.energy > 0)) continue;
    table.add({std::to_string(mode.number),
               number_text(shown_frequency(display, mode.angular_frequency.value_or(std::nan("")))),
               fmt::format("{:.2f}%", 100 * mode.of_stored), share_words(mode.inside.translation),
               share_words(mode.inside.rotation), share_words(mode.inside.coupling), mode.name});
    ++shown_modes;
  }
  const std::size_t others = summary.modes.size() - shown_modes;
  if (shown_modes == 0) return "Its strain energy is below 0.01 % in every undamped mode\n";
  return "Strain energy in the undamped modes and its parts inside the element, with K as reference point: three "
         "springs\n"
         "represent only the part in translation (coupling may be negative)\n" +
      table.text() + (others > 0 ? fmt::format("  below 0.01 % in {} more\n", others) : "");
}

std::string uncertainty_text(const model::Element& element, const DisplayUnits& display) {
  if (!element.evidence) return "";
  const model::Evidence& evidence = *element.evidence;
  TextTable table({"diagonal entry", "value", "±", "unit", "of the value"});
  for (int i = 0; i < 12; ++i) {
    const DisplayUnit shown = display_unit(display, i % 6 < 3 ? "N/m" : "N m/rad");
    const double value = shown.factor * element.law.scale * element.law.nominal_stiffness(i, i),
                 half = shown.factor * element.law.scale * evidence.uncertainty(i, i);
    table.add({fmt::format("{} {}", i < 6 ? "N" : "K", study::component_name(i)), number_text(value),
               number_text(half, 3), shown.unit,
               value != 0 ? fmt::format("{:.2g}%", 100 * half / std::abs(value)) : "–"});
  }
  std::string text = "Uncertainty (" + evidence.meaning + ")\n" + table.text();
  for (const model::Residual& r : evidence.residuals)
    if (r.outlier)
      text += fmt::format("  outlier: {}: measured {:.6g}, fitted {:.6g} ({:+.1f} standard deviations)\n", r.what,
                          r.measured, r.fitted, r.standardised);
  return text;
}

std::string law_of_damping(const elements::Law& law) {
  if (const auto* p = std::get_if<elements::ProportionalDamping>(&law.damping))
    return fmt::format("B = {:.6g} s × the {} stiffness", p->factor, p->of_nominal ? "nominal" : "scaled");
  if (const auto* l = std::get_if<elements::LossFactor>(&law.damping))
    return fmt::format("loss factor {:.6g}", l->value);
  if (std::holds_alternative<elements::DampingMatrix>(law.damping)) return "a viscous damping matrix";
  if (const auto* v = std::get_if<elements::Viscoelastic>(&law.damping)) return elements::law_description(*v);
  if (law.frequency_dependence && !law.frequency_dependence->elastic) return "in its table";
  return "none";
}

std::string frequency_text(const model::Element& element) {
  const elements::Law& law = element.law;
  const double over_distance = std::accumulate(
      element.distance_parts.begin(), element.distance_parts.end(), 0.0,
      [](double sum, const model::DistancePart& part) {
        return sum + elements::force_in_motion(part.law, part.at_rest, Eigen::Vector3d::Zero()).by_rate.trace();
      });
  std::string text = "Damping: " +
      (over_distance > 0 ? fmt::format("{:.6g} N s/m along the line between its ends, at rest", over_distance)
                         : law_of_damping(law)) +
      "\n";
  for (const model::NonlinearPart& part : element.nonlinear_parts) {
    const double damping = elements::small_motion(part.laws, part.at_rest).damping;
    if (damping == 0 || part.is_inner()) continue;
    text += fmt::format("  its laws add {:.6g} {} {} at rest\n", damping,
                        part.is_rotation() ? "N m s/rad about" : "N s/m along", "xyz"[part.axis % 3]);
  }
  if (const auto& given = law.frequency_dependence) {
    text += "Frequency dependence: the stiffness above is static; " +
        std::string(given->elastic ? "with its own mass, exact at every frequency" : "a table");
    text += std::isfinite(given->to)
        ? fmt::format(" from {:.6g} to {:.6g} Hz\n", given->from / two_pi, given->to / two_pi)
        : "\n";
  } else if (elements::is_frequency_dependent(law) || std::holds_alternative<elements::Viscoelastic>(law.damping)) {
    text += "Frequency dependence: the material relaxes; the stiffness above is static\n";
  }
  if (law.inertia && law.inertia->angular_frequencies.size() > 0) {
    text += "Own natural frequencies, both ends held:";
    for (Eigen::Index i = 0; i < law.inertia->angular_frequencies.size(); ++i)
      text += fmt::format(" {:.5g}", law.inertia->angular_frequencies(i) / two_pi);
    text += " Hz\n";
  }
  if (std::isfinite(element.massless_up_to))
    text += fmt::format("Its mass is neglected: results are valid only below its first natural frequency, {:.5g} Hz\n",
                        element.massless_up_to / two_pi);
  return text;
}

std::string laws_text(const study::ElementSummary& summary, const DisplayUnits& display) {
  std::string text;
  for (const study::ElementLaws& laws : summary.laws) {
    const bool turns = laws.turns;
    const DisplayUnit deflection = display_unit(display, turns ? "rad" : "m"),
                      force = display_unit(display, turns ? "N m" : "N"),
                      stiffness = display_unit(display, turns ? "N m/rad" : "N/m");
    text += fmt::format("\n{} {}{}, about rest at a deflection of {}{}\n", laws.whole ? "Force" : "Laws", laws.words,
                        laws.whole ? "" : " alone (the 12×12 above contains their tangents)",
                        value_text(laws.at_rest, deflection), laws.damped ? "; dampers left out" : "");
    if (laws.loops.empty()) continue;
    TextTable table({"amplitude", "force from", "to", "storage", "loss", "lost per cycle"});
    for (const nonlinear::LawLoop& loop : laws.loops) {
      const auto [low, high] = std::ranges::minmax_element(loop.forces);
      table.add({value_text(loop.amplitude, deflection), value_text(*low, force), value_text(*high, force),
                 value_text(loop.storage, stiffness), value_text(without_round_off(loop.loss, loop.storage), stiffness),
                 value_text(without_round_off(loop.energy, loop.amplitude * loop.amplitude * loop.storage),
                            display_unit(display, "J"))});
    }
    text += table.text();
  }
  return text;
}

/// At frequencies that divide the band evenly.
std::string over_amplitude_text(const study::ElementSummary& summary, const DisplayUnits& display) {
  if (summary.over_amplitude.empty()) return "";
  constexpr int rows = 8;
  const DisplayUnit stiffness = display_unit(display, "N/m");
  std::vector<std::string> header = {"f [Hz]"};
  for (const nonlinear::AmplitudeStiffness& one : summary.over_amplitude)
    header.push_back("± " + value_text(one.amplitude, display_unit(display, "m")));
  TextTable table(header);
  double from = foundation::infinity, to = 0;
  for (const nonlinear::AmplitudeStiffness& one : summary.over_amplitude)
    for (const double omega : one.angular_frequency) {
      from = std::min(from, omega);
      to = std::max(to, omega);
    }
  for (int i = 0; i < rows && to > 0; ++i) {
    const double omega = from * std::pow(to / from, i / (rows - 1.0));
    std::vector<std::string> row = {number_text(omega / two_pi, 4)};
    for (const nonlinear::AmplitudeStiffness& one : summary.over_amplitude) {
      const std::optional<std::complex<double>> found = one.at(omega);
      row.push_back(
          found ? fmt::format("{}, {:.1f}°", value_text(std::abs(*found), stiffness), std::arg(*found) * 360 / two_pi)
                : "–");
    }
    table.add(row);
  }
  std::string text =
      "\nDynamic stiffness along z of end K, N held, over frequency and amplitude: magnitude and loss angle\n" +
      table.text();
  for (const nonlinear::AmplitudeStiffness& one : summary.over_amplitude)
    if (!one.ended.empty())
      text += fmt::format("  ± {}: {}\n", value_text(one.amplitude, display_unit(display, "m")), one.ended);
  return text;
}

std::string preload_text(const elements::Law& law, const DisplayUnits& display) {
  if (!law.preload) return "";
  std::vector<std::string> header = {"preload on"};
  for (int j = 0; j < 6; ++j) header.push_back(load_heading(display, j));
  TextTable table(header);
  const double round_off = 1e-12 * law.preload->cwiseAbs().maxCoeff();
  for (int end = 0; end < 2; ++end) {
    std::vector<std::string> row = {end == 0 ? "N" : "K"};
    for (int j = 0; j < 6; ++j)
      row.push_back(number_text(std::abs((*law.preload)(6 * end + j)) <= round_off
                                    ? 0.0
                                    : load_unit(display, j).factor * (*law.preload)(6 * end + j)));
    table.add(row);
  }
  return "Preload in the equilibrium state (local axes of each end)\n" + table.text();
}

std::string difference_words(const std::optional<double>& difference) {
  if (!difference) return "–";
  constexpr double round_off = 1e-9;
  if (std::abs(*difference) < round_off) return "0%";
  return std::abs(*difference) < 0.01 ? fmt::format("{:+.2g}%", 100 * *difference)
                                      : fmt::format("{:+.1f}%", 100 * *difference);
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string mode_comparison_text(const study::Simplification& simple) {
  TextTable table({"mode", "f [Hz]", "three springs", "difference", "MAC", "motion"});
  const auto hertz = [](const std::optional<double>& omega) {
    return number_text(omega ? *omega / two_pi : std::nan(""));
  };
  for (const study::ModeComparison& mode : simple.modes)
    table.add({std::to_string(mode.number), hertz(mode.full),
               mode.simplified && *mode.simplified == 0 ? "0 (free)" : hertz(mode.simplified),
               difference_words(study::relative_difference(mode.full, mode.simplified)),
               fmt::format("{:.3f}", mode.similarity), mode.name});
  std::string text = table.text();
  for (const std::string& motion : simple.free_motions) text += "  with three springs " + motion + "\n";
  if (simple.inner_modes > 0)
    text += fmt::format("  {} further modes are mostly inside elements, from {} Hz on; they are not compared\n",
                        simple.inner_modes, hertz(simple.first_inner_mode));
  return text;
}

std::string peak_comparison_text(const study::Simplification& simple) {
  if (!simple.no_peaks.empty()) return "  no peaks compared: " + simple.no_peaks + "\n";
  TextTable table({"highest peak of", "f [Hz]", "three springs", "difference", "amplitude", "three springs ",
                   "difference ", "unit"});
  using study::HighestPeak;
  const auto part = [](const std::optional<HighestPeak>& peak, double HighestPeak::* member) {
    return peak ? std::optional((*peak).*member) : std::nullopt;
  };
  const double none = std::nan("");
  std::string notes;
  for (const study::PeakComparison& peak : simple.peaks) {
    const auto full = part(peak.full, &HighestPeak::angular_frequency),
               simplified = part(peak.simplified, &HighestPeak::angular_frequency);
    const auto high = part(peak.full, &HighestPeak::amplitude),
               high_simplified = part(peak.simplified, &HighestPeak::amplitude);
    table.add({peak.name, number_text(full.value_or(none) / two_pi), number_text(simplified.value_or(none) / two_pi),
               difference_words(study::relative_difference(full, simplified)), number_text(high.value_or(none)),
               number_text(high_simplified.value_or(none)),
               difference_words(study::relative_difference(high, high_simplified)), peak.unit});
    if (peak.vanishes) notes += fmt::format("  {}: no motion with three springs\n", peak.name);
    else if (peak.full && !peak.simplified) notes += fmt::format("  {}: no peak with three springs\n", peak.name);
  }
  return table.text() + notes;
}

}  // namespace

std::string element_text(const project::Case& variant, std::size_t index, const study::ElementSummary& summary) {
  const model::Element& element = variant.system.elements()[index];
  std::string text = fmt::format("Element \"{}\", {}\n", element.name, element.type) + ends_text(variant, element);
  if (element.law.scale != 1) text += fmt::format("  stiffness scaled by {:.6g}\n", element.law.scale);
  for (const std::vector<model::Fact>& facts : {element.facts, law_facts(element)})
    for (const model::Fact& fact : facts) text += "  " + fact.what + ": " + fact.value + "\n";
  for (const auto& problem : summary.warnings.list()) text += "  " + foundation::message(problem) + "\n";
  const DisplayUnits& display = variant.display;
  const std::string force = load_unit(display, 0).unit, moment = load_unit(display, 3).unit,
                    length = motion_unit(display, 0).unit, angle = motion_unit(display, 3).unit;
  text += fmt::format(
      "\nStiffness 12×12, local axes: load per unit displacement, so F rows are {0}/{2} and {0}/{3}, M rows {1}/{2} "
      "and "
      "{1}/{3}\n(entries below 1e-12 √(K_ii K_jj) shown as 0)\n",
      force, moment, length, angle);
  text += half_matrix(summary.stiffness, 0, display) + "\n" + half_matrix(summary.stiffness, 6, display);
  text += laws_text(summary, display) + over_amplitude_text(summary, display);
  text += "\nCharacter\n" + stiffness_properties_text(summary.stiffness_properties, display);
  text += "\nChecks\n" + checks_text(element, summary.verdict);
  for (const std::string& part : {energy_text(summary, display), uncertainty_text(element, display),
                                  frequency_text(element), preload_text(element.law, display)})
    if (!part.empty()) text += "\n" + part;
  return text;
}

std::string simplification_text(const study::Simplification& simple) {
  std::string text = fmt::format(
      "{} replaced by three springs in this model\n(only the translational stiffness of K along the local axes{})\n",
      joined(simple.replaced, ", "),
      simple.left_out.empty() ? "" : "; also neglected: " + joined(simple.left_out, ", "));
  return text + mode_comparison_text(simple) + peak_comparison_text(simple);
}

}  // namespace trivet::results
