// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/suspension.h"
#include "trivet/study/requirements/band_words.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

using foundation::infinity;

class FrequencyRequirements {
 public:
  FrequencyRequirements(const CaseContext& context, RequirementList& list) : c_(context), list_(list) {}

  void add_natural_frequencies(const project::Requirements& required) {
    std::vector<const modal::Mode*> oscillating;
    for (const modal::Mode& mode : c_.modes.list)
      if (mode.angular_frequency.value_or(0) > 0) oscillating.push_back(&mode);
    for (const assembly::Band& window : required.avoided) {
      RequirementResult& result = list_.add(RequirementKind::avoided_frequencies, "",
                                            "no natural frequency in " + hertz_words(window), "rad/s", window.to);
      result.band = window;
      result.margin = result.value.emplace(infinity);
      for (const modal::Mode* mode : oscillating) {
        const double omega = *mode->angular_frequency, margin = margin_outside(window, omega);
        const bool below = window.from / omega > omega / window.to;
        result.candidates.push_back({margin, omega, 0, mode->number, below});
        if (margin >= result.margin) continue;
        result.margin = margin;
        result.value = result.angular_frequency = omega;
        result.allowed = below ? window.from : window.to;
        result.detail = fmt::format("mode {}", mode->number);
      }
    }
    if (required.separation == 0) return;
    RequirementResult& result =
        list_.add(RequirementKind::separation, "",
                  fmt::format("natural frequencies apart by {:.4g}", required.separation), "1", required.separation);
    result.margin = result.value.emplace(infinity);
    for (std::size_t i = 0; i + 1 < oscillating.size(); ++i) {
      const double ratio = *oscillating[i + 1]->angular_frequency / *oscillating[i]->angular_frequency;
      result.candidates.push_back(
          {margin_of_least(required.separation, ratio), *oscillating[i]->angular_frequency, 0, oscillating[i]->number});
      if (ratio >= *result.value) continue;
      result.value = ratio;
      result.margin = margin_of_least(required.separation, ratio);
      result.angular_frequency = oscillating[i]->angular_frequency;
      result.detail = fmt::format("modes {} and {}", oscillating[i]->number, oscillating[i + 1]->number);
    }
  }

  void add_damping_ratio(const project::Requirements& required) {
    if (required.damping_ratio == 0) return;
    const std::size_t first = list_.size();
    RequirementResult& result = list_.add(RequirementKind::damping_ratio, "",
                                          {"every damping ratio", fmt::format("≥ {:.4g}", required.damping_ratio)}, "1",
                                          required.damping_ratio);
    list_.attempt(first, [&] {
      result.margin = result.value.emplace(infinity);
      const std::vector<modal::Root>& roots = c_.roots().list;
      for (std::size_t i = 0; i < roots.size(); ++i) {
        const modal::Root& root = roots[i];
        const bool grows = root.kind == modal::RootKind::growing;
        if (!grows && !(root.kind == modal::RootKind::oscillating && root.damping_ratio)) continue;
        const double ratio = root.damping_ratio.value_or(-1);
        result.candidates.push_back({margin_of_least(required.damping_ratio, ratio), root.angular_frequency.value_or(0),
                                     0, static_cast<int>(i) + 1, false});
        if (ratio >= *result.value) continue;
        result.value = ratio;
        result.margin = margin_of_least(required.damping_ratio, ratio);
        result.angular_frequency = root.angular_frequency;
        if (root.nearest_mode) result.detail = fmt::format("mode {}", *root.nearest_mode);
      }
    });
  }

  void add_decoupling(const project::Requirements& required) {
    for (const project::Requirements::Decoupling& wanted : required.decoupling) {
      const std::size_t first = list_.size();
      RequirementResult& result =
          list_.add(RequirementKind::decoupling, wanted.body,
                    fmt::format("{} decoupled by {:.4g} %", wanted.body, 100 * wanted.least), "1", wanted.least);
      list_.attempt(first, [&] {
        const auto& bodies = c_.system.bodies();
        const auto at = std::ranges::find_if(bodies, [&](const auto& b) { return b.name == wanted.body; });
        const modal::BodySuspension suspension =
            modal::body_suspension(c_.system, c_.assembled, to_size(at - bodies.begin()));
        result.margin = result.value.emplace(infinity);
        for (std::size_t i = 0; i < suspension.modes.size(); ++i) {
          const double share = suspension.modes[i].decoupling();
          result.candidates.push_back({margin_of_least(wanted.least, share),
                                       suspension.modes[i].angular_frequency.value_or(0), 0, static_cast<int>(i) + 1,
                                       false});
          if (share >= *result.value) continue;
          result.value = share;
          result.margin = margin_of_least(wanted.least, share);
          result.angular_frequency = suspension.modes[i].angular_frequency;
          result.detail = fmt::format("its mode {}", i + 1);
        }
      });
    }
  }

 private:
  const CaseContext& c_;
  RequirementList& list_;
};

}  // namespace

void add_frequency_requirements(const CaseContext& context, const project::Requirements& required,
                                RequirementList& list) {
  FrequencyRequirements frequencies(context, list);
  frequencies.add_natural_frequencies(required);
  frequencies.add_damping_ratio(required);
  frequencies.add_decoupling(required);
}

}  // namespace trivet::study
