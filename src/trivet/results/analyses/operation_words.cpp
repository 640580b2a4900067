// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/operation_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/response/machinery/transmissibility.h"

namespace trivet::results {
namespace {

using study::OperatingMode;
using study::OperatingSpeed;
using study::OperatingValue;

constexpr int sentence_digits = 4;

/// The largest of those that are wanted; nullptr if there is none above 0.
const OperatingValue* largest_value(const std::vector<const OperatingValue*>& list) {
  const OperatingValue* largest = nullptr;
  for (const OperatingValue* one : list)
    if (one->rms > (largest ? largest->rms : 0)) largest = one;
  return largest;
}

std::vector<const OperatingValue*> velocities(const OperatingSpeed& at) {
  std::vector<const OperatingValue*> list;
  for (const study::OperatingMotion& motion : at.motions)
    if (motion.velocity.unit == "m/s") list.push_back(&motion.velocity);
  return list;
}

std::vector<const OperatingValue*> forces_on_the_ground(const OperatingSpeed& at) {
  std::vector<const OperatingValue*> list;
  for (const OperatingValue& force : at.forces)
    if (force.name.starts_with("ground.force.")) list.push_back(&force);
  return list;
}

void add_speed(const OperatingSpeed& at, double speed, Sentence& sentence) {
  if (!at.is_range()) return;
  sentence.parts.emplace_back(" at ");
  sentence.parts.emplace_back(Quantity{.value = speed, .kind = Kind::speed, .digits = sentence_digits});
}

/// At the level of its table: where any value has several orders, all are root mean squares.
void add_largest_value(const OperatingSpeed& at, const std::vector<const OperatingValue*>& list, const char* words,
                       Sentence& sentence) {
  const OperatingValue* value = largest_value(list);
  if (!value) return;
  sentence.parts.emplace_back(words);
  const bool several = std::ranges::any_of(list, &OperatingValue::has_several_orders);
  sentence.parts.emplace_back(Quantity{.value = several ? value->rms : value->amplitude(),
                                       .unit = value->unit,
                                       .kind = several ? Kind::quantity : Kind::amplitude,
                                       .digits = sentence_digits});
  sentence.parts.emplace_back((several ? " rms (" : " (") + value->name + ")");
  if (value->reason.empty()) add_speed(at, value->at, sentence);
  else sentence.parts.emplace_back(": " + value->reason);
}

void add_isolation(const OperatingSpeed& at, Sentence& sentence) {
  const study::OperatingIsolation* worst = nullptr;
  for (const study::OperatingIsolation& one : at.isolation)
    if (one.reason.empty() && (!worst || one.transmissibility > worst->transmissibility)) worst = &one;
  if (!worst) {
    if (!at.isolation.empty()) sentence.parts.emplace_back("; isolation not defined: " + at.isolation.front().reason);
    return;
  }
  const bool other_orders = std::ranges::any_of(
      at.isolation, [&](const study::OperatingIsolation& one) { return one.order != worst->order; });
  sentence.parts.emplace_back(
      fmt::format("; isolation from {}{} {}: {}", foundation::quoted(worst->excitation),
                  other_orders || worst->order != 1 ? fmt::format(" in order {:.6g}", worst->order) : "",
                  worst->direction, isolation_words(worst->transmissibility)));
  add_speed(at, worst->at, sentence);
}

void add_nearest_mode(const OperatingSpeed& at, Sentence& sentence) {
  const OperatingMode* nearest = nullptr;
  std::size_t passed = 0;
  for (const OperatingMode& mode : at.modes) {
    passed += mode.excited && mode.passes;
    if (!nearest || is_nearer(mode, *nearest)) nearest = &mode;
  }
  if (!nearest || !nearest->excited) return;
  const std::string order = fmt::format("order {:.6g}", nearest->order);
  if (nearest->passes) sentence.parts.emplace_back(fmt::format("; {} passes through mode {} (", order, nearest->mode));
  else sentence.parts.emplace_back(fmt::format("; nearest to resonance: mode {} (", nearest->mode));
  sentence.parts.emplace_back(
      Quantity{.value = nearest->angular_frequency, .kind = Kind::frequency, .digits = sentence_digits});
  sentence.parts.emplace_back(nearest->passes ? ")"
                                              : fmt::format("), {} at {:.4g} % of it", order, 100 * nearest->ratio));
  if (nearest->passes) add_speed(at, nearest->at, sentence);
  if (passed > 1)
    sentence.parts.emplace_back(fmt::format(" and {} more resonance{}", passed - 1, passed > 2 ? "s" : ""));
}

}  // namespace

std::string isolation_words(double transmissibility) {
  if (std::isinf(transmissibility)) return "AMPLIFIED without bound: an undamped resonance";
  if (transmissibility == 0) return "complete, no force reaches it";
  const std::string numbers = fmt::format("{:.4g} %, {:.3g} dB", 100 * response::isolation_efficiency(transmissibility),
                                          response::isolation_level(transmissibility));
  return transmissibility > 1 ? fmt::format("AMPLIFIED: T = {:.4g}, isolation {}", transmissibility, numbers) : numbers;
}

std::string nearness_remark(const study::OperatingMode& mode) {
  const std::string near = mode.passes
      ? fmt::format("passes through it at {:.4g} rpm", mode.at * foundation::rpm_per_rad_s)
      : mode.is_near() ? "NEAR"
                       : "";
  if (mode.excited) return near;
  return near.empty() ? "not excited" : (mode.passes ? near : "near") + ", but not excited";
}

Sentence operation_sentence(const study::OperatingSpeed& at) {
  Sentence sentence{.parts = {"At " + study::speed_words(at.speed) + ": "}, .place = Sentence::Place::text};
  const OperatingValue *velocity = largest_value(velocities(at)), *force = largest_value(forces_on_the_ground(at));
  add_largest_value(at, velocities(at), "largest velocity ", sentence);
  add_largest_value(at, forces_on_the_ground(at),
                    velocity ? "; largest force on the ground " : "largest force on the ground ", sentence);
  if (!velocity && !force) sentence.parts.emplace_back("nothing moves");
  add_isolation(at, sentence);
  add_nearest_mode(at, sentence);
  return sentence;
}

}  // namespace trivet::results
