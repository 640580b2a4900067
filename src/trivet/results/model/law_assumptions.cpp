// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/law_assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/results/format/in_documents.h"

namespace trivet::results {
namespace {

using Assumption = LawAssumption;

/// By the type in the project file.
constexpr std::array assumptions_of_types = {
    Assumption{"matrix", "the given numbers: linear, the same at every frequency and amplitude"},
    Assumption{"bushing",
               "six springs along and about its axes that do not couple at its elastic centre; linear, without "
               "mass"},
    Assumption{"three_springs", "three springs through one point, none about it; linear, without mass"},
    Assumption{"damper", "a force proportional to the velocity along its line; no stiffness, no mass"},
    Assumption{"imported",
               "the matrix of another program, condensed onto two ends and otherwise unchanged, with the "
               "assumptions made there"},
    Assumption{"measured",
               "linear, fitted to the readings by least squares: holds at the load, amplitude, speed and "
               "temperature of the test"},
    Assumption{"table",
               "linear at each frequency, at the load and amplitude of the measurement; never beyond the table"},
    Assumption{"air_spring",
               "from a table: linear at each frequency, never beyond it; from pressure, volume and area: a "
               "gas with one exponent on a piston of constant area"},
    Assumption{"wire_rope",
               "from a table: linear at each frequency, at the amplitude of the measurement; otherwise a "
               "spring with dry friction along or about each axis, each by itself"},
    Assumption{"hydromount",
               "chambers and columns of fluid as single springs and masses; the play of the decoupler and "
               "quadratic losses act in nonlinear analyses, else the decoupler is open"},
    Assumption{"coil_spring",
               "the wire as an elastic rod in bending, torsion, extension and shear; active coils do not "
               "touch, dead coils are rigid; small motions about the preload"},
    Assumption{"rubber_disc",
               "isotropic, nearly incompressible rubber bonded to rigid plates; small strain, apart from a "
               "preload computed by finite elements"},
    Assumption{"rubber_block",
               "isotropic, nearly incompressible rubber bonded to rigid plates; small strain, apart from "
               "a preload computed by finite elements"},
    Assumption{"rubber_bush",
               "isotropic, nearly incompressible rubber bonded to rigid sleeves; small strain, apart from "
               "a preload computed by finite elements"},
    Assumption{"sandwich",
               "layers of bonded rubber in series with rigid plates between them; small strain, apart from a "
               "preload computed by finite elements"},
    Assumption{"solid_mount",
               "finite elements of an isotropic solid, static: no mass, no contact, no slip; bonded faces "
               "are rigid"},
    Assumption{"beam",
               "straight and uniform, Timoshenko's theory, torsion with free warping, clamped at both ends; its own "
               "bending modes need several beams end to end"},
    Assumption{"link", "ball joints at both ends: stiffness along its axis, and across it by its tension alone"},
    Assumption{"stay", "ball joints at both ends: stiffness along its axis, and across it by its tension alone"},
    Assumption{"stop",
               "no force within its gap; linear analyses have its stiffness in the position of rest, which is none "
               "if it is open there"},
    Assumption{"strut", "forces along the line between its ends, which turns with large motions; no mass"},
    Assumption{"catalogue:NAME", "the numbers of the catalogue, at the load and frequency that its maker states"}};

/// By the place in elements::Damping.
constexpr std::array<Assumption, 5> assumptions_of_damping = {
    {{"", ""},
     {"proportional damping", "B = factor · K: the loss grows with the frequency"},
     {"loss factor", "K(1 + iη), the same at every frequency: harmonic and random motions only, none over time"},
     {"viscous damping", "a force proportional to the velocity, with the same matrix at every frequency and amplitude"},
     {"viscoelastic damping",
      "one linear law of the material for the whole 12×12; no effect of amplitude or "
      "temperature"}}};

constexpr Assumption nonlinear_laws = {
    "nonlinear laws",
    "linear analyses have their stiffness and damping in the position of rest; amplitudes with them are "
    "those of steady motion and of time histories"};

struct UsedLaw {
  std::string law, words;
  std::vector<std::string> elements;
};

void add_law(std::vector<UsedLaw>& list, const std::string& law, const std::string& words, const std::string& element) {
  if (words.empty()) return;
  auto known = std::ranges::find_if(list, [&](const UsedLaw& one) { return one.law == law && one.words == words; });
  if (known == list.end()) known = list.insert(known, {law, words, {}});
  known->elements.push_back(element);
}

/// Of a type of elements; empty for an unknown one.
std::string assumption_of(const std::string& element_type) {
  const std::string type = element_type.starts_with("catalogue:") ? "catalogue:NAME" : element_type;
  const auto found = std::ranges::find_if(assumptions_of_types, [&](const Assumption& one) { return one.law == type; });
  return found == assumptions_of_types.end() ? "" : found->words;
}

/// The law that the mass of some elements is neglected.
UsedLaw massless(const model::Description& description) {
  UsedLaw law{"mass neglected", "", {}};
  double lowest = std::numeric_limits<double>::infinity();
  for (const model::Element& element : description.elements) {
    if (!std::isfinite(element.massless_up_to)) continue;
    lowest = std::min(lowest, element.massless_up_to);
    law.elements.push_back(element.name);
  }
  law.words = fmt::format("valid only below the first natural frequency of the element itself, at least {} Hz",
                          number_text(lowest / foundation::two_pi, 4));
  return law;
}

std::vector<UsedLaw> used_laws(const model::Description& description) {
  std::vector<UsedLaw> list, damping, others;
  for (const model::Element& element : description.elements) {
    if (element.is_foundation) continue;
    add_law(list, element.type, assumption_of(element.type), element.name);
    const Assumption& loss = assumptions_of_damping[element.law.damping.index()];
    add_law(damping, loss.law, loss.words, element.name);
    if (model::has_laws(element)) add_law(others, nonlinear_laws.law, nonlinear_laws.words, element.name);
  }
  if (UsedLaw law = massless(description); !law.elements.empty()) others.push_back(std::move(law));
  for (auto* laws : {&damping, &others}) std::ranges::move(*laws, std::back_inserter(list));
  return list;
}

}  // namespace

std::vector<LawAssumption> law_assumptions() {
  std::vector<LawAssumption> list(assumptions_of_types.begin(), assumptions_of_types.end());
  list.insert(list.end(), assumptions_of_damping.begin() + 1, assumptions_of_damping.end());
  list.push_back(nonlinear_laws);
  return list;
}

Document assumptions_document(const project::Case& variant) {
  const Rows row(used_laws(variant.system.description()));
  Document document;
  document.add(Table{.rows = row.size(),
                     .columns = {row("law", Kind::words, "law", &UsedLaw::law),
                                 row("elements", Kind::words, "of",
                                     [](const UsedLaw& one) { return foundation::comma_separated(one.elements, 8); }),
                                 row("assumes", Kind::words, "what it assumes", &UsedLaw::words)},
                     .forms = for_people});
  return document;
}

}  // namespace trivet::results
