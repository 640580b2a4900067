// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine/periodic_excitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/run_up.h"

namespace trivet::nonlinear {
namespace {

/// The largest number of which all are multiples.
std::optional<double> common_divisor(const std::vector<response::OrderLoading>& orders) {
  constexpr int most_parts = 24;
  constexpr double same = 1e-9;
  for (int parts = 1; parts <= most_parts; ++parts) {
    const double divisor = orders.front().order / parts;
    if (std::ranges::all_of(orders, [&](const response::OrderLoading& one) {
          const double multiple = one.order / divisor;
          return std::abs(multiple - std::round(multiple)) <= same * multiple;
        }))
      return divisor;
  }
  return std::nullopt;
}

bool has_orders(const model::System& system, const std::vector<std::string>& selected) {
  const auto& excitations = system.description().excitations;
  const auto any = [&](const auto& is_wanted) { return std::ranges::any_of(excitations, is_wanted); };
  const bool orders = any([&](const model::Excitation& e) {
    return model::is_selected(e, selected) && std::holds_alternative<model::Orders>(e.course);
  });
  return orders && (!selected.empty() || !any([](const model::Excitation& e) {
           return std::holds_alternative<model::Harmonic>(e.course);
         }));
}

PeriodicExcitation::Reference reference_of(const model::Excitation& excitation,
                                           const excitation::ComplexVector6& amplitude) {
  const auto first =
      std::ranges::find_if(amplitude, [](const std::complex<double>& component) { return component != 0.0; });
  return {excitation.name, first == amplitude.end() ? 0 : std::arg(*first), excitation.action.delay};
}

/// Of the excitation that is the first of these, by name, at an order.
PeriodicExcitation::Reference reference_of(const model::System& system, const std::string& name, double order) {
  const auto& excitations = system.description().excitations;
  const model::Excitation& excitation = *std::ranges::find(excitations, name, &model::Excitation::name);
  if (const auto* orders = std::get_if<model::Orders>(&excitation.course))
    for (const excitation::Order& one : orders->list)
      if (one.order == order) return reference_of(excitation, one.fixed.isZero(0) ? one.per_speed_squared : one.fixed);
  return reference_of(excitation, excitation.action.amplitude);
}

}  // namespace

PeriodicExcitation periodic_excitation(const model::System& system, const assembly::Assembled& assembled,
                                       const std::vector<std::string>& selected) {
  PeriodicExcitation found;
  if (!has_orders(system, selected)) {
    found.harmonics.push_back(1);
    found.loadings.push_back(assembly::harmonic_loading(system, assembled, selected));
    for (const model::Excitation& excitation : system.description().excitations)
      if (model::is_selected(excitation, selected) && std::holds_alternative<model::Harmonic>(excitation.course)) {
        if (found.names.empty()) found.reference = reference_of(excitation, excitation.action.amplitude);
        found.names.push_back(excitation.name);
      }
    return found;
  }
  for (const model::Excitation& excitation : system.description().excitations) {
    const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
    if (harmonic && !selected.empty() && model::is_selected(excitation, selected) &&
        (harmonic->power_of_frequency != 2 || !excitation.action.body))
      throw foundation::NotComputable(
          fmt::format("steady: \"{}\" has its own frequency and the orders follow a shaft speed, so that their motion "
                      "has no period; name one of them in excitations",
                      excitation.name));
  }
  const std::vector<response::OrderLoading> orders = response::order_loadings(system, assembled, selected);
  const std::optional<double> divisor = common_divisor(orders);
  if (!divisor) {
    std::string list;
    for (const response::OrderLoading& one : orders)
      list += fmt::format("{}{:.10g}", list.empty() ? "" : ", ", one.order);
    throw foundation::NotComputable("steady: the orders " + list +
                                    " have no common divisor, so that the motion has no period; name excitations "
                                    "whose orders have one");
  }
  found.first_harmonic = *divisor;
  found.of_shaft = true;
  found.reference = reference_of(system, orders.front().excitations.front(), orders.front().order);
  for (const response::OrderLoading& one : orders) {
    const auto harmonic = static_cast<Eigen::Index>(std::llround(one.order / *divisor));
    if (!found.harmonics.empty() && found.harmonics.back() == harmonic) {  // the same order with other digits
      for (const numerics::LoadTerm& term : one.loading.force.terms()) found.loadings.back().force.add(term);
      for (const numerics::LoadTerm& term : one.loading.motion.terms()) found.loadings.back().motion.add(term);
    } else {
      found.harmonics.push_back(harmonic);
      found.loadings.push_back(one.loading);
    }
    for (const std::string& name : one.excitations)
      if (std::ranges::find(found.names, name) == found.names.end()) found.names.push_back(name);
  }
  return found;
}

}  // namespace trivet::nonlinear
