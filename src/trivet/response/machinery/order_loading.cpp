// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/order_loading.h"

#include <algorithm>
#include <variant>

#include "trivet/foundation/invalid_input.h"

namespace trivet::response {
namespace {

/// Orders of one excitation; empty if it does not depend on a shaft speed.
std::vector<excitation::Order> orders_of(const model::Excitation& excitation) {
  if (const auto* orders = std::get_if<model::Orders>(&excitation.course)) return orders->list;
  const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
  if (!harmonic || harmonic->power_of_frequency != 2 || !excitation.action.body) return {};
  return {{1, excitation.action.amplitude, excitation::ComplexVector6::Zero()}};
}

/// Adds `factor` (iω)^power times the force of the action.
void add_force(const assembly::Assembled& assembled, model::Action action, const excitation::ComplexVector6& amplitude,
               int power, double factor, assembly::Loading& total) {
  action.amplitude = factor * amplitude;
  const assembly::Loading one = assembly::loading(assembled, action);
  for (const numerics::LoadTerm& term : one.force.terms())
    total.force.add({term.power + power, term.delay, term.value});
}

OrderLoading& entry_of(std::vector<OrderLoading>& list, double order, const assembly::Assembled& assembled) {
  const auto found = std::ranges::find(list, order, &OrderLoading::order);
  if (found != list.end()) return *found;
  return list.emplace_back(
      OrderLoading{order, {numerics::Load(assembled.layout.size()), numerics::Load(assembled.ground.size())}, {}});
}

}  // namespace

std::vector<OrderLoading> order_loadings(const model::System& system, const assembly::Assembled& assembled,
                                         const std::vector<std::string>& selected) {
  const auto& excitations = system.description().excitations;
  for (const std::string& name : selected)
    if (std::ranges::none_of(excitations,
                             [&](const model::Excitation& e) { return e.name == name && !orders_of(e).empty(); }))
      throw foundation::InvalidInput("\"" + name + "\" is not an order excitation or unbalance of this model");
  std::vector<OrderLoading> result;
  for (const model::Excitation& excitation : excitations) {
    if (!model::is_selected(excitation, selected)) continue;
    for (const excitation::Order& order : orders_of(excitation)) {
      if (!(order.order > 0))
        throw foundation::InvalidInput("\"" + excitation.name + "\" has an order that is not > 0");
      OrderLoading& entry = entry_of(result, order.order, assembled);
      // Ω² = −s²/order²
      add_force(assembled, excitation.action, order.per_speed_squared, 2, -1 / (order.order * order.order),
                entry.loading);
      add_force(assembled, excitation.action, order.fixed, 0, 1, entry.loading);
      entry.excitations.push_back(excitation.name);
    }
  }
  std::ranges::sort(result, {}, &OrderLoading::order);
  return result;
}

}  // namespace trivet::response
