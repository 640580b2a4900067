// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {
namespace {

/// One phase for all six components, or six: three of the force or translation, three of the moment or rotation.
spatial::Vector6 read_phase(TableReader& reader) {
  const Node* phase = reader.node("phase");
  if (phase && phase->kind == Node::Kind::array) {
    const auto values = reader.numbers("phase", Quantity::angle);
    if (values && values->size() == 6) return Eigen::Map<const spatial::Vector6>(values->data());
    if (values)
      reader.error("phase", fmt::format("{} phases", values->size()), "one phase, or six (force x y z, moment x y z)",
                   "complete the list");
    return spatial::Vector6::Zero();
  }
  return spatial::Vector6::Constant(reader.number("phase", Quantity::angle).value_or(0));
}

/// Reads six numbers under two keys; at least one key is required.
void read_six(TableReader& reader, const std::string& first, Quantity of_first, const std::string& second,
              Quantity of_second, const std::string& remedy, ActionNumbers numbers, model::Action& action) {
  const bool factors = numbers == ActionNumbers::factors;
  spatial::Vector6 six;
  const Levels levels = numbers == ActionNumbers::amplitudes ? Levels::of_harmonic : Levels::none;
  six << reader.vector(first, factors ? Quantity::pure : of_first, levels).value_or(Eigen::Vector3d::Zero()),
      reader.vector(second, factors ? Quantity::pure : of_second, levels).value_or(Eigen::Vector3d::Zero());
  if (!reader.has(first) && !reader.has(second))
    reader.error(first, "neither " + first + " nor " + second, "an excitation has at least one of them", remedy);
  if (factors && reader.has("phase"))
    reader.error("phase", "a phase", "only harmonic excitations have a phase", "remove it, or give a delay");
  static_cast<void>(reader.node("phase"));
  const spatial::Vector6 phase = factors ? spatial::Vector6(spatial::Vector6::Zero()) : read_phase(reader);
  for (int j = 0; j < 6; ++j)
    action.amplitude(j) =
        phase(j) == 0 ? std::complex<double>(six(j)) : six(j) * std::exp(std::complex<double>(0, phase(j)));
}

/// Index of the element with an end on the ground: the named one, or the impedance of its foundation.
std::optional<std::size_t> standing_on_ground(const model::Description& description, const std::string& name) {
  for (std::size_t e = 0; e < description.elements.size(); ++e) {
    const model::Element& element = description.elements[e];
    const bool meant = element.name == name || (element.is_foundation && element.name == name + ".foundation");
    if (meant && (element.n.on_ground() || element.k.on_ground())) return e;
  }
  return std::nullopt;
}

void read_moving_elements(TableReader& reader, const model::Description& description, const SymbolTable& symbols,
                          model::Action& action) {
  const auto names = reader.texts("elements", R"(["front left", "front right"])");
  if (!names) return;
  if (names->empty())
    reader.error("elements", "an empty list", "at least one element is expected",
                 "remove the key to move the whole foundation");
  for (const std::string& name : *names) {
    if (const auto found = standing_on_ground(description, name)) {
      action.elements.push_back(*found);
      continue;
    }
    const bool read =
        std::ranges::any_of(description.elements, [&](const model::Element& e) { return e.name == name; });
    const bool known = std::ranges::find(symbols.elements, name) != symbols.elements.end();
    if (known && !read) continue;  // its own problem is reported elsewhere
    const std::string guess = foundation::nearest_name(name, symbols.elements);
    if (read)
      reader.error("elements", foundation::quoted(name),
                   "it has no end on moving ground: it is on a body, or on the modes of a foundation",
                   "name elements that are on the ground");
    else
      reader.error("elements", foundation::quoted(name), "no element has this name",
                   guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
}

void read_wave(TableReader& reader, model::Action& action) {
  const Node* node = reader.table("wave");
  if (!node) return;
  TableReader wave(*node, reader.path() + ".wave", reader.problems());
  const auto direction = wave.direction("direction");
  const double speed = wave.required_number("speed", Quantity::velocity);
  if (!wave.has("direction")) wave.missing("direction", "give its direction: direction = \"x\"");
  if (wave.has("speed") && !(speed > 0))
    wave.error("speed", fmt::format("{:.6g} m/s", speed), "a wave travels with a speed > 0",
               "reverse the direction instead");
  wave.finish();
  if (direction && speed > 0) action.wave = model::Wave{*direction, speed};
}

}  // namespace

std::optional<model::Action> read_place(TableReader& reader, const model::Description& description,
                                        const SymbolTable& symbols) {
  if (!reader.has("on")) reader.missing("on", "name the body: on = \"BODY\"");
  model::Action action;
  action.body = body_named(reader, "on", description, symbols);
  action.at = reader.vector("at", Quantity::length).value_or(Eigen::Vector3d::Zero());
  const bool on_node = action.body && description.bodies[*action.body].is_node;
  if (!reader.has("at") && !on_node) reader.missing("at", "give the point of action on the body: at = [x, y, z]");
  return action.body ? std::optional(action) : std::nullopt;
}

std::optional<model::Action> read_force(TableReader& reader, const model::Description& description,
                                        const SymbolTable& symbols, ActionNumbers numbers) {
  std::optional<model::Action> placed = read_place(reader, description, symbols);
  model::Action action = placed.value_or(model::Action{});
  const std::string remedy =
      numbers == ActionNumbers::factors ? "give the direction: force = [0, 0, 1]" : "give force = [Fx, Fy, Fz] in N";
  read_six(reader, "force", Quantity::force, "moment", Quantity::moment, remedy, numbers, action);
  action.delay = reader.number("delay", Quantity::time).value_or(0);
  return placed ? std::optional(action) : std::nullopt;
}

std::optional<model::Action> read_ground_motion(TableReader& reader, const model::Description& description,
                                                const SymbolTable& symbols, ActionNumbers numbers) {
  model::Action action;
  const auto quantity = reader.choice("quantity", assembly::motion_names());
  action.derivative = quantity ? static_cast<int>(assembly::motion_quantity(*quantity)) : 0;
  static constexpr Quantity translation[] = {Quantity::length, Quantity::velocity, Quantity::acceleration};
  static constexpr Quantity rotation[] = {Quantity::angle, Quantity::angular_velocity, Quantity::angular_acceleration};
  const std::string remedy = numbers == ActionNumbers::factors ? "give the direction: translation = [0, 0, 1]"
                                                               : "give translation = [x, y, z]";
  read_six(reader, "translation", translation[action.derivative], "rotation", rotation[action.derivative], remedy,
           numbers, action);
  action.at = reader.vector("at", Quantity::length).value_or(Eigen::Vector3d::Zero());
  action.delay = reader.number("delay", Quantity::time).value_or(0);
  read_moving_elements(reader, description, symbols, action);
  read_wave(reader, action);
  if (reader.has("at") && (!action.elements.empty() || action.wave))
    reader.error("at", "a centre of rotation together with elements or a wave",
                 "then each ground end moves about its own reference point", "remove `at`");
  if (reader.has("on"))
    reader.error("on", "a body under a moving ground", "a base excitation moves the ground, not a body", "remove `on`");
  static_cast<void>(reader.node("on"));
  // Elements on the modes of a foundation are on the ground too; the checks of the model report that modes cannot
  // follow it.
  if (action.elements.empty() &&
      std::ranges::none_of(
          description.elements,
          [](const model::Element& e) { return e.n.on_ground() || e.k.on_ground() || e.n.foundation; }) &&
      description.elements.size() == symbols.elements.size())
    reader.error("", "no element is on the ground", "a moving ground acts through the elements that are on it",
                 "add one, or excite a body");
  return action;
}

Quantity course_quantity(const model::Action& action) {
  const bool linear = !action.amplitude.head<3>().isZero(0);
  if (action.body) return linear ? Quantity::force : Quantity::moment;
  static constexpr Quantity translation[] = {Quantity::length, Quantity::velocity, Quantity::acceleration};
  static constexpr Quantity rotation[] = {Quantity::angle, Quantity::angular_velocity, Quantity::angular_acceleration};
  return (linear ? translation : rotation)[action.derivative];
}

}  // namespace trivet::project
