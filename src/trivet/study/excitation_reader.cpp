// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/study/part_readers.h"

namespace trivet::study {
namespace {

spatial::Wrench read_wrench(TableReader& reader) {
  spatial::Wrench wrench;
  wrench.force = reader.vector("force", Quantity::force).value_or(Eigen::Vector3d::Zero());
  wrench.moment = reader.vector("moment", Quantity::moment).value_or(Eigen::Vector3d::Zero());
  if (!reader.has("force") && !reader.has("moment"))
    reader.error("force", "neither force nor moment", "an excitation has at least one of them", "give force = [Fx, Fy, Fz] in N");
  return wrench;
}

/// One phase for all six components, or six: three of the force, three of the moment.
spatial::Vector6 read_phase(TableReader& reader) {
  const Node* phase = reader.node("phase");
  if (phase && phase->kind == Node::Kind::array) {
    const auto values = reader.numbers("phase", Quantity::angle);
    if (values && values->size() == 6) return Eigen::Map<const spatial::Vector6>(values->data());
    if (values) reader.error("phase", fmt::format("{} phases", values->size()), "one phase, or six (force x y z, moment x y z)", "complete the list");
    return spatial::Vector6::Zero();
  }
  return spatial::Vector6::Constant(reader.number("phase", Quantity::angle).value_or(0));
}

void read_excitation(const Node& node, const std::string& name, model::Description& description, Mentioned& mentioned, foundation::Problems& problems) {
  TableReader reader(node, "excitations." + name, problems);
  reader.required_text("type");
  const auto type = reader.choice("type", {"harmonic", "constant"});
  if (!reader.has("on")) reader.missing("on", "name the body: on = \"BODY\"");
  const auto on = body_named(reader, "on", description, mentioned);
  const Eigen::Vector3d at = reader.vector("at", Quantity::length).value_or(Eigen::Vector3d::Zero());
  if (!reader.has("at")) reader.missing("at", "give the point of action on the body: at = [x, y, z]");
  (type == "constant" ? mentioned.constant_excitations : mentioned.harmonic_excitations).push_back(name);
  if (!type) return;  // what else may stand here depends on the type
  const spatial::Wrench wrench = read_wrench(reader);
  if (type == "harmonic") {
    const spatial::Vector6 phase = read_phase(reader);
    if (!on) return reader.finish();
    model::Action action;
    action.body = on;
    action.at = at;
    for (int j = 0; j < 6; ++j) {
      const double amplitude = j < 3 ? wrench.force(j) : wrench.moment(j - 3);
      action.amplitude(j) = phase(j) == 0 ? std::complex<double>(amplitude) : amplitude * std::exp(std::complex<double>(0, phase(j)));
    }
    description.excitations.push_back({name, action, model::Harmonic{}});
  } else if (on) {
    description.constant_forces.push_back({name, *on, at, wrench});
  }
  reader.finish();
}

}  // namespace

void read_excitations(TableReader& root, model::Description& description, Mentioned& mentioned) {
  description.gravity = root.vector("gravity", Quantity::acceleration);
  const Node* table = root.table("excitations");
  if (!table) return;
  for (std::size_t i = 0; i < table->keys.size(); ++i) {
    if (table->items[i].kind != Node::Kind::table) mentioned.harmonic_excitations.push_back(table->keys[i]);
    if (table->items[i].kind == Node::Kind::table) read_excitation(table->items[i], table->keys[i], description, mentioned, root.problems());
    else
      root.problems().error("excitations." + table->keys[i], words(table->items[i].kind), "an excitation is a table", "write [excitations.NAME] and its type below").origin =
          table->items[i].origin;
  }
}

}  // namespace trivet::study
