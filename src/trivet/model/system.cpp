// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/system.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/model/checks.h"
#include "trivet/model/nodes.h"
#include "trivet/model/point_mass.h"
#include "trivet/model/static_stiffness.h"

namespace trivet::model {

namespace {

struct NameOnly {
  std::string name;
};

template <typename Parts>
void check_names(const Parts& parts, const std::string& kind, foundation::Problems& problems,
                 bool with_results = true) {
  std::set<std::string> seen;
  for (const auto& part : parts) {
    const bool empty = part.name.empty();
    const bool a_word = with_results && (part.name == "ground" || part.name == "base" || part.name == "coordinates");
    if (empty || a_word || part.name.find_first_of(".\n") != std::string::npos)
      problems.error(
          kind + "." + part.name, fmt::format("name \"{}\"", part.name),
          "a name must not be empty, \"ground\", \"base\" or \"coordinates\", and must have no dot and no line break",
          "choose another name");
    if (!seen.insert(part.name).second)
      problems.error(kind + "." + part.name, fmt::format("name \"{}\" given twice", part.name), "names must be unique",
                     "rename one of them");
  }
}

/// The asymmetry that passed the check is rounding of the data; all solvers use the mean.
void make_exactly_symmetric(elements::Matrix12& matrix) { matrix = (0.5 * (matrix + matrix.transpose())).eval(); }

void check_shared_names(const Description& description, foundation::Problems& problems) {
  for (const auto& element : description.elements)
    for (const auto& body : description.bodies)
      if (element.name == body.name)
        problems.error("elements." + element.name,
                       fmt::format("\"{}\" is also the name of a {}", element.name, body.is_node ? "node" : "body"),
                       "results are named after bodies, nodes and elements, so these names must differ",
                       "rename the element");
  for (const auto& node : description.bodies)
    for (const auto& body : description.bodies)
      if (node.is_node && !body.is_node && node.name == body.name)
        problems.error("nodes." + node.name, fmt::format("\"{}\" is also the name of a body", node.name),
                       "results are named after bodies, nodes and elements, so these names must differ",
                       "rename the node");
}

void check_damping(const Description& description, foundation::Problems& problems) {
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&description.damping)) {
    if (!(rayleigh->mass >= 0))
      problems.error("damping.rayleigh.mass", fmt::format("{:.6g} 1/s", rayleigh->mass), "it must be ≥ 0",
                     "negative damping would feed energy");
    if (!(rayleigh->stiffness >= 0))
      problems.error("damping.rayleigh.stiffness", fmt::format("{:.6g} s", rayleigh->stiffness), "it must be ≥ 0",
                     "negative damping would feed energy");
  }
  constexpr double most_mass = 1e9, most_stiffness = 1e6,
                   most_ratio = 1000;  // far beyond critical damping of any vibration
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&description.damping)) {
    if (rayleigh->mass > most_mass)
      problems.error("damping.rayleigh.mass", fmt::format("{:.6g} 1/s", rayleigh->mass), "it is at most 1e9 1/s",
                     "check the number: alone it gives a mode at ω the damping ratio mass/(2ω)");
    if (rayleigh->stiffness > most_stiffness)
      problems.error("damping.rayleigh.stiffness", fmt::format("{:.6g} s", rayleigh->stiffness), "it is at most 1e6 s",
                     "check the number: alone it gives a mode at ω the damping ratio stiffness ω/2");
  }
  if (const auto* modal = std::get_if<ModalDamping>(&description.damping)) {
    std::size_t coordinates = 0;
    for (std::size_t b = 0; b < description.bodies.size(); ++b) {
      const Body& body = description.bodies[b];
      coordinates += turns_without_mass(body) ? coordinates_with_mass(description, b)
                                              : to_size(std::ranges::count(body.free, true));
    }
    for (const auto& element : description.elements)
      if (element.law.inertia) coordinates += to_size(element.law.inertia->angular_frequencies.size());
    for (const auto& foundation : description.foundations)
      coordinates += to_size((foundation.mass.diagonal().array() > 0).count());
    if (modal->ratios.size() != 1 && modal->ratios.size() != coordinates)
      problems.error("damping.modal", fmt::format("{} ratios", modal->ratios.size()),
                     fmt::format("one for all modes, or one for each of the {} modes", coordinates),
                     "complete or shorten the list");
    for (const double ratio : modal->ratios)
      if (!(ratio >= 0))
        problems.error("damping.modal", fmt::format("ratio {:.6g}", ratio), "a damping ratio must be ≥ 0",
                       "negative damping would feed energy");
    for (const double ratio : modal->ratios)
      if (ratio > most_ratio)
        problems.error("damping.modal", fmt::format("ratio {:.6g}", ratio),
                       "a damping ratio is at most 1000; 1 is critical", "check the number");
    for (const auto& body : description.bodies)
      if (body.allow_unphysical && !body.is_node && !is_point_mass(body) &&
          !spatial::violated_bounds(body.mass).empty())
        problems.error("damping.modal", fmt::format("body \"{}\" has an unphysical mass", body.name),
                       "modal damping ratios need a model in which every undamped mode oscillates",
                       "define the damping of the elements instead");
    for (const auto& element : description.elements)
      if (!element.symmetric)
        problems.error("damping.modal", fmt::format("element \"{}\" is unsymmetric", element.name),
                       "modal damping ratios need a symmetric stiffness", "define the damping of the elements instead");
  }
}

/// Checks the coherences of random excitations: their matrix must have no negative eigenvalue.
void check_random(const Description& description, foundation::Problems& problems) {
  excitation::RandomInputs inputs;
  std::vector<std::string> names;
  for (const Excitation& excitation : description.excitations)
    if (const auto* random = std::get_if<Random>(&excitation.course)) {
      inputs.spectra.push_back(random->spectrum);
      names.push_back(excitation.name);
    }
  bool known = true;
  for (const Excitation& excitation : description.excitations)
    if (const auto* random = std::get_if<Random>(&excitation.course))
      for (const Random::Partner& partner : random->partners) {
        const auto at = [&](const std::string& name) {
          return to_size(std::ranges::find(names, name) - names.begin());
        };
        if (at(partner.other) == names.size()) {
          const std::string guess = foundation::nearest_name(partner.other, names);
          problems.error("excitations." + excitation.name + ".coherence", "with \"" + partner.other + "\"",
                         "no random excitation has this name",
                         guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
          known = false;
        } else {
          // Both excitations may state the coherence if they agree.
          const excitation::InputPair pair{at(partner.other), at(excitation.name), partner.coherence, 0};
          const bool known_pair = std::ranges::any_of(inputs.pairs, [&](const excitation::InputPair& p) {
            return p.first == pair.second && p.second == pair.first && p.coherence.at_zero == pair.coherence.at_zero &&
                p.coherence.decay == pair.coherence.decay && p.coherence.distance == pair.coherence.distance &&
                p.coherence.speed == pair.coherence.speed;
          });
          if (!known_pair) inputs.pairs.push_back(pair);
        }
      }
  if (known && !inputs.pairs.empty()) problems.add(excitation::check(inputs, "excitations"));
}

/// Checks that a foundation with fixed directions has an impedance that joins it to the ground.
void check_fixed_directions(const Description& description, foundation::Problems& problems) {
  for (const Element& element : description.elements)
    for (const End* end : {&element.n, &element.k}) {
      if (!end->foundation || end->foundation->fixed_directions.isZero(0)) continue;
      const bool joined = std::ranges::any_of(description.elements, [&](const Element& e) {
        return joins_foundation_to_ground(e) && e.k.foundation->foundation == end->foundation->foundation;
      });
      if (!joined)
        problems.error("elements." + element.name, "an end with fixed directions on a foundation without an impedance",
                       "fixed directions move with the ground under the impedance",
                       "add the element from the ground to the foundation, or set fixed_directions to zero");
    }
}

void check_moving_ground(const Description& description, foundation::Problems& problems) {
  const auto standing = element_on_modes(description);
  if (!standing) return;
  for (const Excitation& excitation : description.excitations)
    if (!excitation.action.body && excitation.action.elements.empty())
      problems.error(
          "excitations." + excitation.name,
          "the whole ground moves under \"" + *standing + "\", which is mounted on the modes of a foundation",
          "the modes of a foundation do not define how it moves with the ground",
          "describe the foundation by an impedance or a mobility (their fixed directions move with the "
          "ground), or model it as a body on its own elements");
}

}  // namespace

void set_linear_law_at(double deflection, Element& element) {
  const Eigen::Index along_k = 6 + element.over_deflection->axis();
  element.law.nominal_stiffness = element.over_deflection->at(deflection, 0);
  element.law.preload.reset();
  element.nonlinear_parts.front().laws[1] =
      elements::ElasticForce(elements::PolynomialForce{{-element.law.nominal_stiffness(along_k, along_k)}});
}

System System::in_other_state(Description description) const {
  const bool has_nodes =
      std::ranges::any_of(description.bodies, [](const Body& body) { return turns_without_mass(body); });
  if (!has_nodes) {
    System system;
    system.description_ = std::move(description);
    system.warnings_ = warnings_;
    return system;
  }
  auto found = checked(std::move(description));
  if (!found) throw std::logic_error("a machine in another state of its nonlinear parts is not valid");
  return std::move(*found);
}

foundation::Expected<System> System::checked(Description description) {
  foundation::Problems problems;
  std::vector<NameOnly> bodies, nodes;
  for (const auto& body : description.bodies) (body.is_node ? nodes : bodies).push_back({body.name});
  if (bodies.empty()) problems.error("bodies", "no body", "a model has at least one body", "add [bodies.NAME]");
  check_names(bodies, "bodies", problems);
  check_names(nodes, "nodes", problems);
  std::vector<NameOnly> elements;  // a foundation has the name of the element above it
  for (const auto& element : description.elements)
    if (!element.is_foundation) elements.push_back({element.name});
  check_names(elements, "elements", problems);
  std::vector<NameOnly> excitations;
  for (const auto& excitation : description.excitations) excitations.push_back({excitation.name});
  for (const auto& force : description.constant_forces) excitations.push_back({force.name});
  check_names(excitations, "excitations", problems, false);
  check_random(description, problems);
  check_moving_ground(description, problems);
  check_fixed_directions(description, problems);
  check_shared_names(description, problems);
  for (const auto& body : description.bodies) {
    check_names(body.points, "bodies." + body.name + ".points", problems);
    for (const auto& point : body.points)
      for (const char* coordinate : coordinate_names)
        if (point.name == coordinate || point.name == "relative")
          problems.error("bodies." + body.name + ".points." + point.name, fmt::format("point named \"{}\"", point.name),
                         "x, y, z, rx, ry, rz (coordinates of the pole) and relative are reserved",
                         "choose another name");
    check_body(body, problems);
  }
  for (const auto& element : description.elements) check_element(description, element, problems);
  if (!problems.has_errors()) settle_nodes(description, problems);
  check_observations(description, problems);
  if (bodies.size() == description.bodies.size() || !problems.has_errors()) check_damping(description, problems);
  if (!problems.has_errors())
    check_preloads(description, problems), check_guides(description, problems),
        check_loose_bodies(description, problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));

  for (Element& element : description.elements) {
    if (!element.symmetric) continue;
    make_exactly_symmetric(element.law.nominal_stiffness);
    if (auto* given = std::get_if<elements::DampingMatrix>(&element.law.damping)) make_exactly_symmetric(given->matrix);
  }
  System system;
  system.description_ = std::move(description);
  system.warnings_ = std::move(problems);
  return system;
}

bool is_nonlinear(const System& system) { return std::ranges::any_of(system.elements(), has_laws); }

spatial::Pose end_in_ground(const std::vector<Body>& bodies, const End& end) {
  if (!end.body) return {end.at, end.axes};
  const spatial::Pose& body = bodies[*end.body].pose;
  return {body.position + body.rotation * end.at, body.rotation * end.axes};
}

Span span(const std::vector<Body>& bodies, const End& n, const End& k) {
  const spatial::Pose at_n = end_in_ground(bodies, n);
  const spatial::Pose at_k = end_in_ground(bodies, k);
  return {at_k.rotation.transpose() * (at_k.position - at_n.position), at_n.rotation.transpose() * at_k.rotation};
}

}  // namespace trivet::model
