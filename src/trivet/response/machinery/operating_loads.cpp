// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/operating_loads.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "trivet/foundation/invalid_input.h"
#include "trivet/model/operating_excitation.h"

namespace trivet::response {
namespace {

using excitation::ComplexVector6;

bool runs(const model::Excitation& excitation, const std::vector<std::string>& selected) {
  return selected.empty() ? model::runs_with_machine(excitation) : model::is_selected(excitation, selected);
}

/// Adds a load at order 1, to that of the shafts if there is one.
void add_at_order_one(assembly::Loading loading, const std::string& name, std::vector<OrderLoading>& list) {
  const auto first = std::ranges::find(list, 1.0, &OrderLoading::order);
  if (first == list.end()) {
    list.push_back({1, std::move(loading), {name}});
    return;
  }
  for (const numerics::LoadTerm& term : loading.force.terms()) first->loading.force.add(term);
  for (const numerics::LoadTerm& term : loading.motion.terms()) first->loading.motion.add(term);
  first->excitations.push_back(name);
}

bool has_one_kind(const ComplexVector6& amplitude) {
  return amplitude.head<3>().isZero(0) != amplitude.tail<3>().isZero(0);
}

/// One order of an excitation, at the upper end of the speeds.
OperatingForce force_of_order(const model::System& system, const assembly::Assembled& assembled,
                              const model::Excitation& excitation, const excitation::Order& order,
                              const assembly::Band& speeds) {
  OperatingForce result{.excitation = excitation.name, .order = order.order};
  const bool grows = !order.per_speed_squared.isZero(0), stays = !order.fixed.isZero(0);
  if (grows && stays && speeds.from < speeds.to) {
    result.reason = "its forces of inertia and of the gas change their ratio with the speed; name single speeds";
    return result;
  }
  // Of forces that grow with Ω² the amplitude is that at Ω = 1 rad/s.
  const double speed = stays ? speeds.to : 1;
  model::Action action = excitation.action;
  action.amplitude = speed * speed * order.per_speed_squared + order.fixed;
  if (!has_one_kind(action.amplitude)) {
    result.reason = "it has forces and moments, which have no common transmissibility";
    return result;
  }
  result.rotation = action.amplitude.head<3>().isZero(0);
  const Eigen::Vector3cd vector = action.amplitude.segment<3>(result.rotation ? 3 : 0);
  result.transmission = excitation_transmission(system, assembled, {action, vector, result.rotation});
  result.power_of_speed = stays ? 0 : 2;
  return result;
}

OperatingForce force_of_harmonic(const model::System& system, const assembly::Assembled& assembled,
                                 const model::Excitation& excitation) {
  OperatingForce result{.excitation = excitation.name, .order = 1};
  result.reason = model::reason_without_transmission(system, excitation.name);
  if (!result.reason.empty()) return result;
  result.rotation = model::harmonic_force(system, excitation.name).rotation;
  result.transmission = excitation_transmission(system, assembled, excitation.name);
  result.power_of_speed = std::get<model::Harmonic>(excitation.course).power_of_frequency;
  return result;
}

}  // namespace

std::vector<OrderLoading> operating_loads(const model::System& system, const assembly::Assembled& assembled,
                                          const std::vector<std::string>& selected) {
  const auto& excitations = system.description().excitations;
  for (const std::string& name : selected) {
    const auto found = std::ranges::find(excitations, name, &model::Excitation::name);
    if (found == excitations.end() ||
        !(std::holds_alternative<model::Harmonic>(found->course) ||
          std::holds_alternative<model::Orders>(found->course)))
      throw foundation::InvalidInput("\"" + name + "\" is neither a harmonic nor an order excitation of this model");
  }
  std::vector<OrderLoading> result;
  std::vector<std::string> of_shafts;
  for (const model::Excitation& excitation : excitations)
    if (runs(excitation, selected) && std::holds_alternative<model::Orders>(excitation.course))
      of_shafts.push_back(excitation.name);
  if (!of_shafts.empty()) result = order_loadings(system, assembled, of_shafts);
  for (const model::Excitation& excitation : excitations)
    if (runs(excitation, selected) && std::holds_alternative<model::Harmonic>(excitation.course))
      add_at_order_one(assembly::harmonic_loading(system, assembled, {excitation.name}), excitation.name, result);
  std::erase_if(result, [](const OrderLoading& one) { return one.loading.vanishes(); });
  std::ranges::sort(result, {}, &OrderLoading::order);
  return result;
}

double OperatingForce::exciting(double speed) const { return transmission.exciting * std::pow(speed, power_of_speed); }

std::vector<OperatingForce> operating_forces(const model::System& system, const assembly::Assembled& assembled,
                                             const assembly::Band& speeds, const std::vector<std::string>& selected) {
  std::vector<OperatingForce> result;
  for (const model::Excitation& excitation : system.description().excitations) {
    if (!runs(excitation, selected) || !excitation.action.body) continue;
    if (const auto* orders = std::get_if<model::Orders>(&excitation.course)) {
      for (const excitation::Order& order : orders->list)
        if (!order.per_speed_squared.isZero(0) || !order.fixed.isZero(0))
          result.push_back(force_of_order(system, assembled, excitation, order, speeds));
    } else {
      result.push_back(force_of_harmonic(system, assembled, excitation));
    }
  }
  return result;
}

}  // namespace trivet::response
