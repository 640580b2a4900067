// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/element_reader.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "trivet/elements/law.h"
#include "trivet/project/elements/adjustments_reader.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/symbol_table.h"
#include "trivet/project/text/table_reader.h"
#include "trivet/project/text/unsupported_keys.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::project {

namespace {

/// Place of an end in the ground frame; empty if it is not stated or cannot be read.
std::optional<Eigen::Vector3d> stated_place(TableReader& reader, const char* on, const char* at,
                                            const model::Description& description) {
  const Node* name = reader.node(on);
  const auto& bodies = description.bodies;
  const bool on_ground = !name || name->text == "ground";
  const auto body =
      std::ranges::find_if(bodies, [&](const model::Body& one) { return name && one.name == name->text; });
  if (!on_ground && body == bodies.end()) return std::nullopt;
  const bool node = !on_ground && body->is_node;
  if (!reader.has(at) && !node) return std::nullopt;
  auto place = reader.has(at) ? reader.vector(at, Quantity::length) : Eigen::Vector3d::Zero();
  if (!place || on_ground) return place;
  return body->pose.position + body->pose.rotation * *place;
}

}  // namespace

std::optional<Node> with_length_between_ends(const Node& element, const std::string& name,
                                             const model::Description& description) {
  const Node* type = element.kind == Node::Kind::table ? element.find("type") : nullptr;
  if (!type || element.find("length") || !element.find("on")) return std::nullopt;
  if (type->text != "beam" && type->text != "link" && type->text != "stay") return std::nullopt;
  foundation::Problems ignored;  // the reader of the element reports them
  TableReader reader(element, "elements." + name, ignored);
  const auto k = stated_place(reader, "on", "at", description),
             n = stated_place(reader, "from", "from_at", description);
  if (!k || !n) return std::nullopt;
  Node length;
  length.kind = Node::Kind::real;
  length.origin = element.origin;
  length.number = (*k - *n).norm();
  Node completed = element;
  completed.keys.push_back("length");
  completed.items.push_back(std::move(length));
  return completed;
}

namespace {

constexpr std::size_t most_elements = 5000;

std::vector<std::string> all_types(const SymbolTable& symbols) {
  std::vector<std::string> types = element_law_names();
  types.insert(types.end(), symbols.element_types.begin(), symbols.element_types.end());
  return types;
}

/// Reads one element: the places of its ends, then its law in their axes.
class ElementReader {
 public:
  ElementReader(const Node& node, const std::string& name, const model::Description& description, SymbolTable& symbols,
                foundation::Problems& problems)
      : node_(node), reader_(node, "elements." + name, problems), bodies_(description), in_file_(symbols) {
    element_.name = name;
  }

  std::optional<model::Element> read() {
    const std::size_t before = reader_.errors();
    element_.type = reader_.required_text("type");
    law_ = element_law(element_.type);
    if (law_ && law_->sized) {
      length_ = stiffened(reader_, law_->sized(reader_, element_), element_);  // its length places end N
      read_creep_of_rubber(reader_, element_);
    }
    ends_.known = read_ends();  // if not, the law is still read for its own problems
    element_.symmetric = reader_.boolean("symmetric").value_or(true);
    element_.allow_residual = reader_.boolean("allow_residual").value_or(false);
    element_.law.scale = reader_.number("scale", Quantity::pure).value_or(1);
    if (element_.law.scale > 0) element_.massless_up_to *= std::sqrt(element_.law.scale);
    if (const auto foundation = reader_.text("foundation"))
      in_file_.foundation_references.push_back({element_.name, *foundation, reader_.node("foundation")->origin});
    if (law_ && law_->placed) law_->placed(reader_, ends_, element_);
    if (!law_) refuse_type();
    if (!law_ || law_->takes_damping) read_damping(reader_, ends_.span, ends_.damping_at, element_);
    if (element_.law.inner && elements::is_frequency_dependent(element_.law))
      reader_.error("damping", "fractional damping of a " + element_.type,
                    "its fluid needs rubber with constant matrices", "take zener or maxwell");
    if (law_ && !law_->takes_laws && reader_.has("scale"))
      reader_.error("scale", "scale of a " + element_.type, "its laws are not scaled", "change their numbers");
    if (law_ && law_->takes_laws) read_laws(reader_, ends_.span, element_);
    check_stiffening(reader_, element_);
    if (law_) read_element_adjustments(reader_, element_, reader_.errors() == before, in_file_);
    if (law_) reader_.finish();
    else report_tables_inside(node_);  // the valid keys depend on the type
    return ends_.known && reader_.errors() == before ? std::optional(element_) : std::nullopt;
  }

 private:
  /// Reports tables that no law has, most likely the rest of a name with a dot: [elements.front.left].
  void report_tables_inside(const Node& node) {
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
      const bool ours = node.keys[i] == "damping" || node.keys[i] == "stiffness_factor" || node.keys[i] == "moved" ||
          node.keys[i].ends_with("orientation");
      if (node.items[i].kind == Node::Kind::table && !ours && !unsupported_key(reader_.path(), node.keys[i]))
        reader_.error(node.keys[i], "unknown key", "no element has a table of this name",
                      "names have no dots; write names with blanks in quotes: [elements.\"front left\"]");
    }
  }

  bool is_node(const std::optional<std::size_t>& body) const { return body && bodies_.bodies[*body].is_node; }

  bool read_ends() {
    if (!reader_.has("on")) reader_.missing("on", "name the body at end K: on = \"BODY\"");
    const auto on = body_named(reader_, "on", bodies_, in_file_);
    const Node* written = reader_.node("from");
    const bool on_ground = !written || (written->kind == Node::Kind::text && written->text == "ground");
    const auto from = on_ground ? std::nullopt : body_named(reader_, "from", bodies_, in_file_);
    const bool from_is_wrong = !on_ground && !from;
    const auto at =
        reader_.has("at") || !is_node(on) ? reader_.vector("at", Quantity::length) : Eigen::Vector3d::Zero();
    if (!at && !reader_.has("at") && (on || !reader_.has("on")))
      reader_.missing("at", "give the point on the body: at = [x, y, z]");
    const auto from_at = reader_.has("from_at") || !is_node(from) ? reader_.vector("from_at", Quantity::length)
                                                                  : Eigen::Vector3d::Zero();
    const auto axis = reader_.direction("axis");
    const auto orientation = reader_.orientation("orientation");
    const auto from_orientation = reader_.orientation("from_orientation");
    if (law_ && law_->sized && reader_.has("from_orientation"))
      reader_.error("from_orientation", "from_orientation of a " + element_.type, "both ends have the same axes",
                    "remove it, and turn the element by axis or orientation");
    if (reader_.has("axis") && reader_.has("orientation"))
      reader_.error("axis", "axis and orientation", "only one of them turns the local axes", "remove one");
    if (!on || !at || from_is_wrong || (reader_.has("from_at") && !from_at)) return false;

    const spatial::Pose body = bodies_.bodies[*on].pose;
    const spatial::Pose other = from ? bodies_.bodies[*from].pose : spatial::Pose{};
    element_.k.body = on;
    element_.k.at = *at;
    element_.k.axes = orientation ? *orientation
        : axis                    ? spatial::axes_along(*axis)
                                  : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Eigen::Vector3d k_in_ground = body.position + body.rotation * *at;
    if (length_ && from_at && !axis && !orientation)
      align_with(body.rotation.transpose() * (k_in_ground - other.position - other.rotation * *from_at));
    const Eigen::Vector3d n_to_k = length_.value_or(0) * (body.rotation * element_.k.axes.col(2));
    element_.n.body = from;
    element_.n.at =
        from_at ? *from_at : Eigen::Vector3d(other.rotation.transpose() * (k_in_ground - n_to_k - other.position));
    element_.n.axes = from_orientation ? *from_orientation
                                       : Eigen::Matrix3d(other.rotation.transpose() * body.rotation * element_.k.axes);
    ends_.span = model::span(bodies_.bodies, element_.n, element_.k);
    if (length_ && from_at) check_length();
    return true;
  }

  /// Aligns e3 of an element with its own length with the line from N to K.
  void align_with(const Eigen::Vector3d& arm) {
    if (arm.norm() > 0) element_.k.axes = spatial::axes_along(arm.normalized());
  }

  void check_length() {
    constexpr double rounding = 1e-6, smallest = 1e-3;  // ends of a bush are at one place
    const Eigen::Vector3d expected = *length_ * Eigen::Vector3d::UnitZ();
    if ((ends_.span.arm - expected).norm() <= rounding * std::max(*length_, smallest)) return;
    reader_.error("from_at",
                  fmt::format("the vector from N to K is ({:.9g}, {:.9g}, {:.9g}) m in the local axes",
                              ends_.span.arm.x(), ends_.span.arm.y(), ends_.span.arm.z()),
                  fmt::format("this element is {:.9g} m long along its local e3", *length_),
                  reader_.has("from_at") ? "remove from_at, or correct the ends, the axis or the element"
                                         : "end N is on the node: move the node, or give from_at in its frame");
  }

  /// Reports a type that is not a law: a misspelling, or a feature outside this version.
  void refuse_type() {
    if (const auto outside = unsupported_type(element_.type))
      reader_.error("type", "\"" + element_.type + "\"", outside->rule, outside->remedy);
    else if (reader_.has("type")) static_cast<void>(reader_.choice("type", all_types(in_file_)));
  }

  const Node& node_;
  TableReader reader_;
  const model::Description& bodies_;
  SymbolTable& in_file_;
  model::Element element_;
  const ElementLaw* law_ = nullptr;  ///< null if the type is not known
  Placement ends_{{Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()}};
  ElementLength length_;  ///< of a law with its own length
};

/// An unchanged element of an earlier description; null for one on a foundation, because foundations get new indices.
const model::Element* known_element(const KnownModel& known, const std::string& name, const Node& now,
                                    const model::Description& description) {
  if (now.find("foundation") || !known.unchanged("elements", name, now)) return nullptr;
  const auto& elements = known.description.elements;
  const auto found = std::ranges::find(elements, name, &model::Element::name);
  if (found == elements.end() || (known.of_text && model::has_laws(*found))) return nullptr;
  const auto same_place = [&](const model::End& end) {
    if (!end.body) return true;
    if (*end.body >= description.bodies.size()) return false;
    const model::Body &before = known.description.bodies[*end.body], &body = description.bodies[*end.body];
    return before.name == body.name && before.pose.position == body.pose.position &&
        before.pose.rotation == body.pose.rotation;
  };
  return same_place(found->n) && same_place(found->k) ? &*found : nullptr;
}

}  // namespace

void read_elements(TableReader& root, model::Description& description, SymbolTable& symbols, const KnownModel* known) {
  const Node* table = root.table("elements");
  if (!table) return;
  symbols.elements = table->keys;
  if (table->keys.size() > most_elements)
    root.error("elements", fmt::format("{} elements", table->keys.size()),
               fmt::format("this version takes at most {}", most_elements), "split the model");
  for (std::size_t i = 0; i < table->keys.size() && i < most_elements; ++i) {
    if (const model::Element* earlier =
            known ? known_element(*known, table->keys[i], table->items[i], description) : nullptr) {
      description.elements.push_back(*earlier);
      description.elements.back().law.nonlinear.reset();
    } else if (table->items[i].kind != Node::Kind::table) {
      root.problems()
          .error("elements." + table->keys[i], kind_name(table->items[i].kind), "an element is a table",
                 "write [elements.NAME] and its type below")
          .origin = table->items[i].origin;
    } else {
      const auto completed = with_length_between_ends(table->items[i], table->keys[i], description);
      if (auto element = ElementReader(completed ? *completed : table->items[i], table->keys[i], description, symbols,
                                       root.problems())
                             .read())
        description.elements.push_back(std::move(*element));
    }
  }
}

std::vector<std::string> element_law_names() {
  std::vector<std::string> types;
  for (const ElementLaw* law : element_laws()) types.emplace_back(law->type);
  return types;
}

void read_system_damping(TableReader& root, model::Description& description, SymbolTable& symbols) {
  const Node* table = root.table("damping");
  if (!table) return;
  TableReader reader(*table, "damping", root.problems());
  if (reader.has("rayleigh") == reader.has("modal"))
    root.error("damping", reader.has("modal") ? "rayleigh and modal" : "neither rayleigh nor modal",
               "the damping of the system is one of them",
               reader.has("modal") ? "keep one" : "give one, or remove the table");
  if (const Node* inside = reader.table("rayleigh")) {
    TableReader rayleigh(*inside, "damping.rayleigh", root.problems());
    description.damping = model::RayleighDamping{rayleigh.number("mass", Quantity::per_time).value_or(0),
                                                 rayleigh.number("stiffness", Quantity::time).value_or(0)};
    rayleigh.finish();
  }
  if (const Node* modal = reader.node("modal")) {
    if (modal->kind == Node::Kind::array) {
      if (const auto ratios = reader.numbers("modal", Quantity::pure))
        description.damping = model::ModalDamping{*ratios};
    } else if (const auto ratio = reader.number("modal", Quantity::pure)) {
      description.damping = model::ModalDamping{{*ratio}};
    }
  }
  read_damping_adjustment(reader, symbols);
  reader.finish();
}

}  // namespace trivet::project
