// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "trivet/foundation/significant_digits.h"
#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {
namespace {

/// From this value on a modal ratio is more likely a percentage; that of a whole machine seldom exceeds 0.3.
constexpr double percent_ratio = 0.5;
/// From this value on a loss factor is more likely a percentage; filled rubbers reach 0.3, soft damping layers 0.5 in
/// their transition.
constexpr double percent_loss = 0.6;
/// δ of B = δK [s] above which all vibration is damped out.
constexpr double most_proportional = 1;
/// Damping ratios from Rayleigh damping: overdamped or without any effect as typed, and usual with both numbers
/// exchanged.
constexpr double overdamped = 1, hardly_damped = 1e-5, usual_ratio_from = 5e-4, usual_ratio_to = 1;

void judge_elements(const model::System& system, Suspicions& found) {
  std::map<double, std::pair<std::size_t, int>> loss, proportional;  // value → first element, number of elements
  const auto count = [](auto& map, double value, std::size_t e) {
    auto& entry = map.try_emplace(value, e, 0).first->second;
    ++entry.second;
  };
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const auto& damping = system.elements()[e].law.damping;
    if (const auto* factor = std::get_if<elements::LossFactor>(&damping); factor && factor->value >= percent_loss)
      count(loss, factor->value, e);
    if (const auto* delta = std::get_if<elements::ProportionalDamping>(&damping);
        delta && delta->factor > most_proportional)
      count(proportional, delta->factor, e);
  }
  const auto others = [](int n) { return n > 1 ? fmt::format(", the same for {} more", n - 1) : std::string(); };
  const auto subject = [&](std::size_t e) {
    const model::Element& element = system.elements()[e];
    const std::string suffix = ".foundation";  // the impedance of a ground point has the name of the element on it
    if (element.is_foundation && element.name.ends_with(suffix))
      return "foundations." + element.name.substr(0, element.name.size() - suffix.size());
    return "elements." + element.name;
  };
  for (const auto& [value, entry] : loss)
    found.push_back({"loss factor", subject(entry.first) + ".damping.loss_factor",
                     fmt::format("{:.6g}{}", value, others(entry.second)),
                     fmt::format("loss factors of rubber and metal are below {:.3g}", percent_loss),
                     fmt::format("write \"{:.6g} %\" if percent are meant", value)});
  for (const auto& [value, entry] : proportional)
    found.push_back({"proportional damping", subject(entry.first) + ".damping.proportional",
                     fmt::format("{:.6g} s{}", value, others(entry.second)),
                     fmt::format("B = δK with δ above {:.3g} s damps out every vibration", most_proportional),
                     "check the unit, or the intended ratio of B to K"});
}

/// B = δK that overdamps the translations of a body, judged by the mean of δ weighted with its stiffnesses.
void judge_overdamped(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  constexpr double far_overdamped = 2;
  for (const BodyPicture& picture : pictures) {
    double stiffness = 0, damping = 0;
    const Attachment* most = nullptr;
    for (const Attachment& a : picture.attachments) {
      const bool proportional =
          std::holds_alternative<elements::ProportionalDamping>(system.elements()[a.element].law.damping);
      const double part = proportional ? a.proportional * a.translation.trace() : 0;
      stiffness += a.translation.trace();
      damping += part;
      if (part > 0 && (!most || part > most->proportional * most->translation.trace())) most = &a;
    }
    const Features features = plausibility::features(picture, {});
    if (!most || !features.frequency || most->proportional > most_proportional) continue;
    const double ratio = std::numbers::pi * *features.frequency * damping / stiffness;
    if (!(ratio > far_overdamped)) continue;
    found.push_back(
        {"proportional damping", "elements." + system.elements()[most->element].name + ".damping.proportional",
         fmt::format("{:.6g} s", most->proportional),
         fmt::format("with it the translations of \"{}\" (mean {:.3g} Hz) have a damping ratio of about {:.3g}",
                     system.bodies()[picture.body].name, *features.frequency, ratio),
         fmt::format("write \"{:.6g} ms\" if milliseconds are meant", most->proportional)});
    return;
  }
}

void judge_rayleigh(const model::RayleighDamping& rayleigh, const std::vector<BodyPicture>& pictures,
                    Suspicions& found) {
  double lowest = 0, highest = 0;
  for (const BodyPicture& picture : pictures) {
    const Features features = plausibility::features(picture, {});
    if (!features.lowest || !features.highest) continue;
    lowest = lowest > 0 ? std::min(lowest, *features.lowest) : *features.lowest;
    highest = std::max(highest, *features.highest);
  }
  if (!(lowest > 0)) return;
  const auto ratio = [](double mass, double stiffness, double hertz) {
    const double omega = 2 * std::numbers::pi * hertz;
    return mass / (2 * omega) + stiffness * omega / 2;
  };
  const auto [least, most] = std::minmax(
      {ratio(rayleigh.mass, rayleigh.stiffness, lowest), ratio(rayleigh.mass, rayleigh.stiffness, highest)});
  const auto [least_exchanged, most_exchanged] = std::minmax(
      {ratio(rayleigh.stiffness, rayleigh.mass, lowest), ratio(rayleigh.stiffness, rayleigh.mass, highest)});
  const bool odd = most > overdamped || (most > 0 && most < hardly_damped);
  if (!odd || most_exchanged > usual_ratio_to || most_exchanged < usual_ratio_from) return;
  found.push_back({"rayleigh", "damping.rayleigh",
                   fmt::format("mass = {:.6g} 1/s, stiffness = {:.6g} s", rayleigh.mass, rayleigh.stiffness),
                   fmt::format("between {:.3g} and {:.3g} Hz they give damping ratios of {:.3g} … {:.3g}", lowest,
                               highest, least, most),
                   fmt::format("exchanged, they give {:.3g} … {:.3g}", least_exchanged, most_exchanged)});
}

}  // namespace

void judge_dampers(const model::System& system, Suspicions& found) {
  constexpr double unequal = 50;
  using Bodies = std::pair<std::optional<std::size_t>, std::optional<std::size_t>>;
  std::map<Bodies, std::vector<std::pair<double, std::size_t>>> groups;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    const double coefficient = elements::viscous_damping(element.law).block<3, 3>(6, 6).trace();
    const Bodies bodies = std::minmax(element.k.body, element.n.body);
    if (element.type == "damper" && coefficient > 0) groups[bodies].emplace_back(coefficient, e);
  }
  for (auto& group : groups) {
    std::vector<std::pair<double, std::size_t>>& dampers = group.second;
    if (dampers.size() < 3) continue;
    std::ranges::sort(dampers);
    const auto judge_one = [&](std::size_t which, std::size_t least,
                               std::size_t most) {  // the others range from least to most
      const double low = dampers[least].first, high = dampers[most].first, own = dampers[which].first;
      if (high > unequal * low || (own < unequal * high && unequal * own > low)) return;
      found.push_back({"viscous damping", "elements." + system.elements()[dampers[which].second].name + ".coefficient",
                       foundation::prefixed_exactly(own, "N s/m", 6),
                       fmt::format("the {} others between these bodies have {}", dampers.size() - 1,
                                   foundation::prefixed_range(low, high, "N s/m")),
                       "check its digits and its unit"});
    };
    judge_one(0, 1, dampers.size() - 1);
    judge_one(dampers.size() - 1, 0, dampers.size() - 2);
  }
}

void judge_damping(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  judge_elements(system, found);
  judge_overdamped(system, pictures, found);
  const auto& damping = system.description().damping;
  if (const auto* rayleigh = std::get_if<model::RayleighDamping>(&damping)) judge_rayleigh(*rayleigh, pictures, found);
  if (const auto* modal = std::get_if<model::ModalDamping>(&damping); modal && !modal->ratios.empty())
    if (const double largest = std::ranges::max(modal->ratios); largest >= percent_ratio)
      found.push_back(
          {"modal damping", "damping.modal", fmt::format("ratio {:.6g}", largest),
           fmt::format("damping ratios of modes are below {:.3g}, mostly between 0.002 and 0.2", percent_ratio),
           fmt::format("write \"{:.6g} %\" if percent are meant", largest)});
}

}  // namespace trivet::plausibility
