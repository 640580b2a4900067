// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/condensed_solid.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/project/elements/element_cache.h"
#include "trivet/project/elements/solid_states.h"

namespace trivet::project {

namespace {

/// The 12×12 after a deflection z along an axis e about points at the distance of the undeformed element: N' is z e
/// from N, rigidly, u_N = u_N' − θ_N × z e. The force turns with that arm.
elements::Matrix12 with_undeformed_arm(const elements::Matrix12& stiffness, Eigen::Index axis, double force, double z) {
  const Eigen::Index a = (axis + 1) % 3, b = (axis + 2) % 3;
  elements::Matrix12 moved = elements::Matrix12::Identity();
  moved(a, 3 + b) = -z;
  moved(b, 3 + a) = z;
  elements::Matrix12 found = moved.transpose() * stiffness * moved;
  found(3 + a, 3 + a) -= force * z;
  found(3 + b, 3 + b) -= force * z;
  return found;
}

/// The state turned by half a turn about e3, which changes the sign of its deflection across.
elements::StiffnessOverDeflection::State mirrored(const elements::StiffnessOverDeflection::State& state) {
  elements::Vector12 turn;
  turn << -1, -1, 1, -1, -1, 1, -1, -1, 1, -1, -1, 1;
  return {-state.deflection, -state.force, turn.asDiagonal() * state.stiffness * turn.asDiagonal()};
}

/// Does a cubic rise everywhere? Its slope is a parabola between two knots.
bool rises(const elements::KnotCurve& curve) {
  constexpr int per_interval = 16;
  const std::vector<double>& x = curve.knots();
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (int s = 0; s <= per_interval; ++s)
      if (!(curve.at(x[i] + (x[i + 1] - x[i]) * s / per_interval).slope > 0)) return false;
  return true;
}

}  // namespace

namespace {

/// Is nonlinear = true, without keys that go against it?
bool reads_nonlinear(TableReader& reader) {
  const bool wanted = reader.boolean("nonlinear").value_or(false);
  if (reader.has("range") && !wanted) {
    reader.also_known({"range"});
    reader.error("range", "a range without nonlinear = true", "it is that of the computed force",
                 "add it, or remove both");
  }
  if (!wanted) return false;
  if (reader.has("preload"))
    reader.error("preload", "a preload beside nonlinear = true", "a nonlinear mount finds its own compression at rest",
                 "remove the preload, and give gravity");
  if (reader.has("stiffness_factor"))
    reader.error("stiffness_factor", "stiffness_factor beside nonlinear = true",
                 "its large deformations are not scaled", "change the material");
  if (reader.has("scale"))
    reader.error("scale", "scale beside nonlinear = true", "its large deformations are not scaled",
                 "change the material");
  return true;
}

constexpr double compressed = 0.25;  // of the rubber, by default

}  // namespace

std::optional<Stroke> read_stroke(TableReader& reader, std::optional<double> rubber) {
  if (!reads_nonlinear(reader)) return std::nullopt;
  const auto range = reader.numbers("range", Quantity::length);
  if (!range && !rubber) {
    if (!reader.has("range"))
      reader.missing("range", R"(give the deflections of K along e3 that occur: range = ["-8 mm", "3 mm"])");
    return std::nullopt;
  }
  constexpr double drawn = 0.1;
  if (!range) return Stroke{-compressed * *rubber, drawn * *rubber};
  if (range->size() == 2 && (*range)[0] < 0 && (*range)[1] > 0 && (!rubber || (*range)[0] > -*rubber))
    return Stroke{(*range)[0], (*range)[1]};
  reader.error("range",
               range->size() == 2 ? fmt::format("{:.6g} to {:.6g} m", (*range)[0], (*range)[1])
                                  : fmt::format("{} numbers", range->size()),
               "two deflections of K along e3: in compression (negative, less than the thickness of the rubber) and in "
               "tension (positive)",
               R"(for instance range = ["-8 mm", "3 mm"])");
  return std::nullopt;
}

std::optional<Stroke> read_stroke_of_bush(TableReader& reader, double wall) {
  if (!reads_nonlinear(reader)) return std::nullopt;
  const auto range = reader.numbers("range", Quantity::length);
  if (!range) return Stroke{-compressed * wall, compressed * wall, 0, true};
  if (range->size() == 2 && (*range)[0] == -(*range)[1] && (*range)[1] > 0 && (*range)[1] < wall)
    return Stroke{(*range)[0], (*range)[1], 0, true};
  reader.error("range",
               range->size() == 2 ? fmt::format("{:.6g} to {:.6g} m", (*range)[0], (*range)[1])
                                  : fmt::format("{} numbers", range->size()),
               fmt::format("a bush is the same both ways along e1: −a and a, less than its wall of {:.6g} m", wall),
               R"(for instance range = ["-3 mm", "3 mm"])");
  return std::nullopt;
}

void add_stroke(const Stroke& stroke, TableReader& reader, const std::string& key, const MeshedSolid& meshed,
                model::Element& element) {
  const Eigen::Index along_k = 6 + stroke.axis;
  using State = elements::StiffnessOverDeflection::State;
  std::vector<State> states = {{0, 0, element.law.nominal_stiffness}};
  double arm = 0;
  const auto add = [&](double deflection, int steps) {
    fem::Preload load;
    load.value(stroke.axis) = deflection;
    const std::string place = content_key(fmt::format("{} {} {:.17g} {}", key, stroke.axis == 2 ? "along" : "across",
                                                      deflection, steps)),
                      not_found = place + "-none";  // is found out once, because it takes as long
    if (cached_numbers(not_found)) return false;
    const std::variant<LoadedSolid, std::string> under = solid_under(place, meshed, load, steps);
    const auto* there = std::get_if<LoadedSolid>(&under);
    if (!there || there->negative_eigenvalues > 0 || !(there->stiffness(along_k, along_k) > 0)) {
      keep_numbers(not_found, {0});
      return false;
    }
    const double force = there->force(along_k);
    if (stroke.axis == 2) arm = there->distance - deflection;
    const State state{deflection, force, with_undeformed_arm(there->stiffness, stroke.axis, force, deflection)};
    states.insert(deflection < 0 ? states.begin() : states.end(), state);
    if (stroke.is_symmetric) states.insert(states.begin(), mirrored(state));
    return true;
  };
  const auto place = [](double end, int i, int count) { return i == count ? end : end * i / count; };
  constexpr int in_compression = 5;
  const int in_tension = stroke.is_symmetric ? in_compression : 3;
  for (int i = 1; !stroke.is_symmetric && i <= in_compression && add(place(stroke.from, i, in_compression), i); ++i) {
  }
  for (int i = 1; i <= in_tension && add(place(stroke.to, i, in_tension), i); ++i) {
  }
  const State &first = states.front(), &last = states.back();
  for (const auto& [reached, next] :
       {std::pair{first.deflection, stroke.from / in_compression}, std::pair{last.deflection, stroke.to / in_tension}})
    if (reached == 0) {
      reader.error("nonlinear", "no equilibrium at " + foundation::prefixed(next, "m"),
                   "the deformed solid must be in equilibrium", "give a smaller range, or check the material");
      return;
    }
  std::vector<double> deflections, forces, slopes;
  for (const State& state : states) {
    deflections.push_back(state.deflection);
    forces.push_back(state.force);
    slopes.push_back(state.stiffness(along_k, along_k));
  }
  elements::ForceCurve curve;
  curve.force = elements::KnotCurve(deflections, forces, slopes);
  curve.rises = rises(curve.force);
  curve.is_limited = true;
  const double undeformed = element.law.nominal_stiffness(along_k, along_k);
  element.facts.push_back(
      {"large deformations",
       fmt::format(
           "finite elements from {}, {} to {}, {} along e{}; {:.4g} and {:.4g} times as stiff there as undeformed",
           foundation::prefixed(first.deflection, "m"), foundation::prefixed_exactly(first.force, "N", 5),
           foundation::prefixed(last.deflection, "m"), foundation::prefixed_exactly(last.force, "N", 5),
           stroke.axis + 1, slopes.front() / undeformed, slopes.back() / undeformed)});
  if (first.deflection > stroke.from || last.deflection < stroke.to)
    reader.problems()
        .warning(
            reader.path() + ".nonlinear",
            fmt::format("equilibrium in {} only", foundation::prefixed_range(first.deflection, last.deflection, "m")),
            "beyond, the mesh finds none, or the solid buckles", "give a range within it")
        .origin = reader.content().origin;
  element.over_deflection.emplace(states, stroke.axis, arm);
  constexpr double middle = 0.5;
  element.nonlinear_parts.push_back(
      {stroke.axis, middle, {elements::ElasticForce(curve), elements::ElasticForce(elements::PolynomialForce{{-1}})}});
  element.allow_residual = true;  // of the force on the way
  model::set_linear_law_at(0, element);
}

namespace {

void add_error_facts(const fem::SolidStiffness& s, model::Element& element) {
  element.facts.push_back(
      {"found by", fmt::format("finite elements: {} elements, {} unknowns", s.elements, s.unknowns)});
  if (s.relative_error.isZero(0)) {
    element.facts.push_back({"estimated error of the mesh", "not estimated: level 1 has no coarser mesh"});
    return;
  }
  std::string errors;
  static constexpr std::array<const char*, 6> words = {"shear x", "shear y", "axial", "tilt x", "tilt y", "torsion"};
  for (int j = 0; j < 6; ++j)
    errors += fmt::format("{}{} {:.2g} %", j ? ", " : "", words[j], 100 * s.relative_error(6 + j, 6 + j));
  element.facts.push_back({"estimated error of the mesh", errors});
  const elements::Vector12 scale = s.stiffness.diagonal().cwiseSqrt();
  element.evidence =
      model::Evidence{s.relative_error.cwiseProduct(scale * scale.transpose()), "estimated error of the mesh", {}};
}

}  // namespace

std::optional<Compression> read_compression(TableReader& reader) {
  const Node* table = reader.table("preload");
  if (!table) return std::nullopt;
  TableReader preload(*table, reader.path() + ".preload", reader.problems());
  const auto by = preload.number("compression", Quantity::length), with = preload.number("force", Quantity::force);
  if (preload.has("compression") == preload.has("force"))
    preload.error("force", preload.has("force") ? "compression and force" : "neither compression nor force",
                  "a preload is one of them, positive in compression", "give one");
  preload.finish();
  if (with) return Compression{*with, true};
  if (by) return Compression{*by, false};
  return std::nullopt;
}

void read_large_strain(TableReader& reader, fem::Material& material) {
  const auto mooney = reader.numbers("mooney_rivlin", Quantity::pressure),
             yeoh = reader.numbers("yeoh", Quantity::pressure);
  const double bulk = material.bulk_modulus;
  if (mooney && mooney->size() == 2) material = {.c10 = (*mooney)[0], .c01 = (*mooney)[1], .bulk_modulus = bulk};
  else if (mooney)
    reader.error("mooney_rivlin", fmt::format("{} numbers", mooney->size()), "it has two constants: [c10, c01]",
                 "give two");
  if (yeoh && yeoh->size() == 3)
    material = {.c10 = (*yeoh)[0], .c20 = (*yeoh)[1], .c30 = (*yeoh)[2], .bulk_modulus = bulk};
  else if (yeoh)
    reader.error("yeoh", fmt::format("{} numbers", yeoh->size()), "it has three constants: [c10, c20, c30]",
                 "give three");
  if (mooney && yeoh) reader.error("yeoh", "mooney_rivlin and yeoh", "a rubber has one law", "keep one of them");
  reader.add(fem::check(material),
             {{"shear_modulus",
               mooney     ? "mooney_rivlin"
                   : yeoh ? "yeoh"
                          : "material"},
              {"bulk_modulus", "material"}});
}

std::string constants_text(const fem::Material& m) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", m.c10, m.c01, m.c20, m.c30, m.bulk_modulus);
}

ElementLength condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                        const std::optional<Compression>& compression, const std::optional<Stroke>& stroke,
                        model::Element& element) {
  const std::size_t before = reader.errors();
  try {
    std::optional<Solid> solid;  // meshed once, and only if a result is not in the cache
    const MeshedSolid meshed = [&]() -> const Solid& {
      if (!solid) solid = make();
      return *solid;
    };
    if (!compression) {
      const fem::SolidStiffness s = free_solid(key, meshed);
      element.law.nominal_stiffness = s.stiffness;
      add_error_facts(s, element);
      if (stroke) add_stroke(*stroke, reader, key, meshed, element);
      return std::nullopt;
    }
    fem::Preload load;
    load.value(2) = -compression->value;
    load.is_load[2] = compression->is_force;
    const std::variant<LoadedSolid, std::string> under =
        solid_under(content_key(fmt::format("{} preload {:.17g} {}", key, compression->value, compression->is_force)),
                    meshed, load, fem::PreloadOptions().steps);
    if (const auto* failure = std::get_if<std::string>(&under)) throw foundation::NotComputable(*failure);
    const LoadedSolid& found = std::get<LoadedSolid>(under);
    element.law.nominal_stiffness = found.stiffness;
    element.law.preload = found.force;
    element.facts.push_back({"found by", "finite elements, linearised about its preload"});
    element.facts.push_back({"compressed by", foundation::prefixed_exactly(-found.deflection, "m", 6)});
    element.facts.push_back(
        {"preload",
         fmt::format("{} of compression", foundation::prefixed_exactly(-(*element.law.preload)(8), "N", 6))});
    if (found.negative_eigenvalues > 0)
      reader.error("preload", fmt::format("{} negative pivots", found.negative_eigenvalues),
                   "a mount that has buckled between its plates carries no load", "lower the preload");
    return found.distance;
  } catch (const foundation::InvalidInput& reason) {
    if (reader.errors() == before)  // the mesher reports more
      reader.error(reader.has("step") ? "step" : "type", reason.what(), "the solid cannot be condensed",
                   "correct the solid, its plates or its mesh");
  } catch (const foundation::NotComputable& reason) {
    reader.error(compression ? "preload" : "type", reason.what(), "a static equilibrium under the preload must exist",
                 "lower the preload, or check the solid and its plates");
  }
  return std::nullopt;
}

}  // namespace trivet::project
