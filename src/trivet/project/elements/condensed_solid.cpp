// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/condensed_solid.h"

#include <fmt/format.h>

#include <array>

#include "trivet/fem/preload.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/elements/element_cache.h"

namespace trivet::project {
namespace {

/// Change it whenever meshes or kernels change, so that older results in the cache are not used.
constexpr const char* method = "finite elements 1";

std::vector<double> numbers_of(const fem::SolidStiffness& s) {
  std::vector<double> numbers(s.stiffness.data(), s.stiffness.data() + 144);
  numbers.insert(numbers.end(), s.relative_error.data(), s.relative_error.data() + 144);
  numbers.insert(numbers.end(), {s.rigid_residual, double(s.unknowns), double(s.elements)});
  return numbers;
}

fem::SolidStiffness solid_stiffness(const std::vector<double>& numbers) {
  fem::SolidStiffness s;
  s.stiffness = Eigen::Map<const elements::Matrix12>(numbers.data());
  s.relative_error = Eigen::Map<const elements::Matrix12>(numbers.data() + 144);
  s.rigid_residual = numbers[288];
  s.unknowns = static_cast<int>(numbers[289]);
  s.elements = static_cast<int>(numbers[290]);
  return s;
}

std::vector<double> numbers_of(const fem::PreloadedStiffness& p) {
  std::vector<double> numbers(p.stiffness.data(), p.stiffness.data() + 144);
  numbers.insert(numbers.end(), p.preload.data(), p.preload.data() + 12);
  numbers.insert(numbers.end(), p.arm.data(), p.arm.data() + 3);
  numbers.insert(numbers.end(), {p.motion(2), double(p.negative_eigenvalues)});
  return numbers;
}

/// Numbers of an earlier run from the cache, or computed ones.
template <typename Make, typename Compute>
std::vector<double> cached_or_computed(const std::string& key, std::size_t count, const Make& make,
                                       const Compute& numbers) {
  if (const auto kept = cached_numbers(key); kept && kept->size() == count) return *kept;
  std::vector<double> found = numbers(make());
  keep_numbers(key, found);
  return found;
}

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
    errors += fmt::format("{}{} {:.2g} %", j ? ", " : "", words[to_size(j)], 100 * s.relative_error(6 + j, 6 + j));
  element.facts.push_back({"estimated error of the mesh", errors});
  const elements::Vector12 scale = s.stiffness.diagonal().cwiseSqrt();
  element.evidence =
      model::Evidence{s.relative_error.cwiseProduct(scale * scale.transpose()), "estimated error of the mesh", {}};
}

/// The 12×12 after a deflection z along e3 about points at the distance of the undeformed element: N' is at (0, 0, z)
/// from N, rigidly, u_N = u_N' + θ_N × (0, 0, −z). The force turns with that arm.
elements::Matrix12 with_undeformed_arm(const elements::Matrix12& stiffness, double force, double z) {
  elements::Matrix12 moved = elements::Matrix12::Identity();  // u_N = u_N' + θ_N × (0, 0, −z)
  moved(0, 4) = -z;
  moved(1, 3) = z;
  elements::Matrix12 found = moved.transpose() * stiffness * moved;
  found(3, 3) -= force * z;
  found(4, 4) -= force * z;
  return found;
}

/// The element after a deflection along e3: its stiffness and the force of K on it.
std::vector<double> after_deflection(const Solid& solid, double deflection, int steps) {
  fem::Preload load;
  load.value(2) = deflection;
  const fem::PreloadedStiffness found =
      fem::preloaded_stiffness(solid.mesh, solid.materials, solid.frame, load, {.steps = steps});
  if (!found.converged || found.negative_eigenvalues > 0)
    return std::vector<double>(161, 0.0);  // none: it has no stiffness
  return numbers_of(found);
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

/// Its force along e3 over the stroke, and its 12×12 about each state, from finite elements at a few deflections.
void add_stroke(TableReader& reader, const std::string& key, const std::function<const Solid&()>& meshed,
                const Stroke& stroke, model::Element& element) {
  constexpr Eigen::Index along_k = 8;
  using State = elements::StiffnessOverDeflection::State;
  std::vector<State> states = {{0, 0, element.law.nominal_stiffness}};
  double arm = 0;
  const auto add = [&](double deflection, int steps) {
    const std::vector<double> p =
        cached_or_computed(content_key(fmt::format("{} along {:.17g} {}", key, deflection, steps)), 161, meshed,
                           [&](const Solid& solid) { return after_deflection(solid, deflection, steps); });
    const elements::Matrix12 found = Eigen::Map<const elements::Matrix12>(p.data());
    if (!(found(along_k, along_k) > 0)) return false;
    const double force = p[144 + along_k];
    arm = p[158] - deflection;
    states.insert(deflection < 0 ? states.begin() : states.end(),
                  State{deflection, force, with_undeformed_arm(found, force, deflection)});
    return true;
  };
  constexpr int in_compression = 5, in_tension = 3;
  for (int i = 1; i <= in_compression && add(stroke.from * i / in_compression, i); ++i) {
  }
  for (int i = 1; i <= in_tension && add(stroke.to * i / in_tension, i); ++i) {
  }
  const State &first = states.front(), &last = states.back();
  for (const auto& [reached, next] :
       {std::pair{first.deflection, stroke.from / in_compression}, std::pair{last.deflection, stroke.to / in_tension}})
    if (reached == 0) {
      reader.error("nonlinear", fmt::format("no equilibrium at {:.6g} m", next),
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
       fmt::format("finite elements from {:.4g} m, {:.5g} N to {:.4g} m, {:.5g} N along e3; {:.4g} and {:.4g} times as "
                   "stiff there as undeformed",
                   first.deflection, first.force, last.deflection, last.force, slopes.front() / undeformed,
                   slopes.back() / undeformed)});
  if (first.deflection > stroke.from || last.deflection < stroke.to)
    reader.problems()
        .warning(reader.path() + ".nonlinear",
                 fmt::format("equilibrium from {:.6g} to {:.6g} m only", first.deflection, last.deflection),
                 "beyond, the mesh finds none, or the solid buckles", "give a range within it")
        .origin = reader.content().origin;
  element.over_deflection.emplace(states, arm);
  constexpr int along = 2;
  constexpr double middle = 0.5;
  element.nonlinear_parts.push_back(
      {along, middle, {elements::ElasticForce(curve), elements::ElasticForce(elements::PolynomialForce{{-1}})}});
  element.allow_residual = true;  // of the force on the way
  model::set_linear_law_at(0, element);
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

std::optional<Stroke> read_stroke(TableReader& reader, std::optional<double> rubber) {
  const bool wanted = reader.boolean("nonlinear").value_or(false);
  const auto range = reader.numbers("range", Quantity::length);
  if (range && !wanted) {
    reader.error("range", "a range without nonlinear = true", "it is that of the computed force",
                 "add it, or remove both");
    return std::nullopt;
  }
  if (!wanted) return std::nullopt;
  if (reader.has("preload"))
    reader.error("preload", "a preload beside nonlinear = true", "a nonlinear mount finds its own compression at rest",
                 "remove the preload, and give gravity");
  if (reader.has("stiffness_factor"))
    reader.error("stiffness_factor", "stiffness_factor beside nonlinear = true",
                 "its large deformations are not scaled", "change the material");
  if (reader.has("scale"))
    reader.error("scale", "scale beside nonlinear = true", "its large deformations are not scaled",
                 "change the material");
  if (!range && !rubber) {
    if (!reader.has("range"))
      reader.missing("range", R"(give the deflections of K along e3 that occur: range = ["-8 mm", "3 mm"])");
    return std::nullopt;
  }
  constexpr double compressed = 0.25, drawn = 0.1;
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

std::string solid_key(const std::string& description, const std::vector<std::string>& files) {
  return content_key(std::string(method) + " " + description, files);
}

ElementLength condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                        const std::optional<Compression>& compression, const std::optional<Stroke>& stroke,
                        model::Element& element) {
  const std::size_t before = reader.errors();
  try {
    std::optional<Solid> solid;  // meshed once, and only if a result is not in the cache
    const auto meshed = [&]() -> const Solid& {
      if (!solid) solid = make();
      return *solid;
    };
    if (!compression) {
      const fem::SolidStiffness s = solid_stiffness(cached_or_computed(
          key + "-free", 291,
          [&] {
            const Solid& it = meshed();
            return it.coarse ? fem::condense(it.mesh, *it.coarse, it.refinement, it.materials, it.frame)
                             : fem::condense(it.mesh, it.materials, it.frame);
          },
          [](const fem::SolidStiffness& found) { return numbers_of(found); }));
      element.law.nominal_stiffness = s.stiffness;
      add_error_facts(s, element);
      if (stroke) add_stroke(reader, key, meshed, *stroke, element);
      return std::nullopt;
    }
    const std::string preload_key =
        content_key(fmt::format("{} preload {:.17g} {}", key, compression->value, compression->is_force));
    const std::vector<double> p = cached_or_computed(
        preload_key, 161,
        [&] {
          const Solid& it = meshed();
          fem::Preload load;
          load.value(2) = -compression->value;
          load.is_load[2] = compression->is_force;
          fem::PreloadedStiffness found = fem::preloaded_stiffness(it.mesh, it.materials, it.frame, load);
          if (!found.converged) throw foundation::NotComputable(found.failure_reason);
          return found;
        },
        [](const fem::PreloadedStiffness& found) { return numbers_of(found); });
    element.law.nominal_stiffness = Eigen::Map<const elements::Matrix12>(p.data());
    element.law.preload = elements::Vector12(Eigen::Map<const elements::Vector12>(p.data() + 144));
    element.facts.push_back({"found by", "finite elements, linearised about its preload"});
    element.facts.push_back({"compressed by", fmt::format("{:.6g} m", -p[159])});
    element.facts.push_back({"preload", fmt::format("{:.6g} N of compression", -(*element.law.preload)(8))});
    if (p[160] > 0)
      reader.error("preload", fmt::format("{} negative pivots", p[160]),
                   "a mount that has buckled between its plates carries no load", "lower the preload");
    return p[158];
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
