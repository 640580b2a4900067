// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_curve.h"

#include <fmt/format.h>

#include <utility>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/response/machinery/order_loading.h"
#include "trivet/response/machinery/transmissibility.h"

namespace trivet::study {

RequirementCurve requirement_curve(const model::System& system, const assembly::Assembled& assembled,
                                   const RequirementResult& result) {
  if (result.order > 0) {
    for (const response::OrderLoading& one : response::order_loadings(system, assembled, result.excitations))
      if (one.order == result.order)
        return {assembly::channels(system, assembled, {result.subject}, result.quantity).front(), one.loading};
    throw foundation::NotComputable(fmt::format(
        "no excitation of this model{} acts in order {:.6g} of the shaft",
        result.excitations.empty() ? "" : " among " + foundation::comma_separated(result.excitations), result.order));
  }
  if (!result.transmitted)
    return {assembly::channels(system, assembled, {result.subject}, result.quantity).front(),
            assembly::harmonic_loading(system, assembled, result.excitations)};
  const RequirementResult::Transmitted& of = *result.transmitted;
  if (of.force.empty()) {
    response::Transmission moved = response::displacement_transmission(system, assembled, {of.of}, of.base);
    return {std::move(moved.channels.front()), std::move(moved.loading)};
  }
  response::ExcitationTransmission forced = response::excitation_transmission(system, assembled, of.force);
  return {std::move(forced.channels.at(of.direction)), std::move(forced.loading)};
}

bool have_same_drive(const RequirementResult& a, const RequirementResult& b) {
  if (a.band != b.band || a.order != b.order || a.transmitted.has_value() != b.transmitted.has_value()) return false;
  if (!a.transmitted) return a.excitations == b.excitations;
  return a.transmitted->force == b.transmitted->force && a.transmitted->base == b.transmitted->base;
}

}  // namespace trivet::study
