// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/unbounded_peaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/modes.h"
#include "trivet/project/model_number.h"
#include "trivet/response/steady/visible_amplitudes.h"

namespace trivet::study {
namespace {

std::vector<std::string> unbounded(const model::System& system, const project::MapRequest& request) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, request.no_peak, request.quantity);
  const modal::Roots roots = modal::roots(system, assembled, modal::modes(system, assembled));
  const std::vector<bool> vanish = response::vanish_at_both_ends(
      assembled, channels, assembly::harmonic_loading(system, assembled, request.excitations), roots);
  std::vector<std::string> names;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (vanish[c]) names.push_back(channels[c].name);
  return names;
}

project::Design middle_of(const std::vector<project::DesignAxis>& axes) {
  constexpr double middle = 0.47;  // of all axes; avoids a symmetric design
  project::Design design;
  for (const project::DesignAxis& axis : axes) design.emplace_back(project::ModelNumber(axis), axis.at(middle));
  return design;
}

/// The base model may have a symmetry that the designs do not have. Without a model in the middle all names remain.
void keep_unbounded_at_middle(const project::Case& variant, const project::MapRequest& request,
                              const std::vector<project::DesignAxis>& axes, std::vector<std::string>& names) {
  const auto system = judging::changed_system(variant, middle_of(axes));
  if (!system) return;
  try {
    const std::vector<std::string> there = unbounded(*system, request);
    std::erase_if(names, [&](const std::string& name) { return std::ranges::find(there, name) == there.end(); });
  } catch (const foundation::NotComputable&) {
  } catch (const foundation::InvalidInput&) {
  }
}

const char* name_of(assembly::MotionQuantity quantity) {
  return quantity == assembly::MotionQuantity::velocity    ? "velocity of "
      : quantity == assembly::MotionQuantity::acceleration ? "acceleration of "
                                                           : "";
}

void refuse(const project::Case& variant, const project::MapRequest& request,
            const std::vector<project::DesignAxis>& axes) {
  if (request.no_peak.empty()) return;
  std::vector<std::string> names = unbounded(variant.system, request);
  if (!names.empty()) keep_unbounded_at_middle(variant, request, axes, names);
  if (names.empty()) return;
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  const std::string key = request.own_no_peak ? "analyses.map.no_peak" : "requirements.no_peak";
  throw foundation::NotComputable(fmt::format(
      "{}: {}: {}{}: a curve that vanishes at ω = 0 and at high frequency has a peak in every "
      "design; "
      "name other results in no_peak, and limit the amplitude of {}{}",
      foundation::place(project::deepest(variant.written, key).origin), key, name_of(request.quantity), list,
      names.size() == 1 ? "this one" : "these",
      request.quantity == assembly::MotionQuantity::displacement ? "" : ", or set quantity = \"displacement\""));
}

}  // namespace

void refuse_unbounded_peaks(const project::Case& variant, const project::MapRequest& request) {
  refuse(variant, request, {request.x, request.y});
}

void refuse_unbounded_peaks(const project::Case& variant, const std::vector<project::DesignAxis>& parameters) {
  if (!variant.analyses.requirements) return;
  const project::Requirements& required = *variant.analyses.requirements;
  project::MapRequest request;
  request.no_peak = required.no_peak;
  request.quantity = required.quantity;
  request.excitations = required.excitations;
  refuse(variant, request, parameters);
}

}  // namespace trivet::study
