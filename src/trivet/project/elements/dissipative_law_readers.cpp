// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/law_readers.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "trivet/project/elements/law_numbers.h"
#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {

std::optional<elements::DampingForce> read_damping_curve(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  const Quantity quadratic =
      is_rotation ? Quantity::damping_moment_per_velocity_squared : Quantity::damping_force_per_velocity_squared;
  if (reader.has("quadratic") || reader.has("quadratics")) {
    elements::QuadraticDamping law;
    if (reader.has("quadratic") && reader.has("quadratics"))
      reader.error("quadratics", "quadratic and quadratics", "one coefficient, or one for each sense",
                   "remove one of them");
    law.above = law.below = reader.number("quadratic", quadratic).value_or(0);
    if (const auto both = reader.numbers("quadratics", quadratic)) {
      if (both->size() == 2) {
        law.above = (*both)[0];
        law.below = (*both)[1];
      } else {
        reader.error("quadratics", fmt::format("{} numbers", both->size()),
                     "two are expected: for positive and for negative rates", "complete or shorten the list");
      }
    }
    const bool may_feed = reader.boolean("allow_active").value_or(false);
    for (const double c : {law.above, law.below})
      if (c < 0 && !may_feed) {
        reader.error(reader.has("quadratic") ? "quadratic" : "quadratics", fmt::format("{:.6g}", c),
                     "a damper does not feed energy: it is ≥ 0", "correct its sign, or set allow_active = true");
        break;
      }
    return reader.errors() == before ? std::optional<elements::DampingForce>(law) : std::nullopt;
  }
  elements::DampingCurve law;
  const elements::Interpolation interpolation = read_interpolation(reader);
  const auto points =
      read_curve_points(reader, "velocity", "force", velocity_quantity(is_rotation), force_quantity(is_rotation));
  const bool may_feed = reader.boolean("allow_active").value_or(false);
  if (!points || reader.errors() > before) return std::nullopt;
  for (std::size_t i = 0; i < points->x.size(); ++i)
    if (points->x[i] * points->y[i] < 0 && !may_feed) {
      reader.error(reader.has("rows") ? "rows" : "file",
                   fmt::format("row {}: a force of {:.6g} at a velocity of {:.6g}", i + 1, points->y[i], points->x[i]),
                   "a damper does not feed energy: both have the same sign",
                   "correct the sign, or set allow_active = true");
      return std::nullopt;
    }
  law.force = elements::KnotCurve(points->x, points->y, interpolation);
  return law;
}

elements::ScalarLaws read_friction(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  elements::ScalarLaws laws;
  reader.also_known({"slip", "breakaway", "stiffness", "sliders", "berg", "lugre"});
  int given = 0;
  for (const char* law : {"slip", "sliders", "berg", "lugre"}) given += static_cast<int>(reader.has(law));
  if (given != 1) {
    reader.error("", given == 0 ? "no law" : "several laws", "friction is one of slip, sliders, berg and lugre",
                 R"(for instance friction = {slip = "40 N", stiffness = "400 N/mm"})");
    return {};
  }
  if (reader.has("slip")) {
    const double slip = read_positive(reader, "slip", force_quantity(is_rotation)),
                 breakaway = reader.number("breakaway", force_quantity(is_rotation)).value_or(slip);
    if (reader.errors() == before && breakaway < slip)
      reader.error("breakaway", fmt::format("{:.6g}, below slip {:.6g}", breakaway, slip),
                   "the static limit of friction is at least the kinetic one, slip", "correct one of them");
    if (reader.has("stiffness"))
      laws.emplace_back(elements::HystereticForce(
          elements::Slider{read_positive(reader, "stiffness", stiffness_quantity(is_rotation)), slip, breakaway}));
    else laws.emplace_back(elements::HystereticForce(elements::CoulombFriction{slip, breakaway}));
  } else {
    for (const char* key : {"stiffness", "breakaway"})
      if (reader.has(key))
        reader.error(key, fmt::format("{} beside another law", key), "it belongs to slip", "remove it");
  }
  if (reader.has("sliders"))
    if (const auto pairs = read_pairs(reader, "sliders", stiffness_quantity(is_rotation), force_quantity(is_rotation)))
      for (Eigen::Index i = 0; i < pairs->rows(); ++i) {
        const elements::Slider law{(*pairs)(i, 0), (*pairs)(i, 1)};
        if (!(law.stiffness > 0 && law.slip > 0))
          reader.error("sliders", fmt::format("row {}: {:.6g}, {:.6g}", i + 1, law.stiffness, law.slip),
                       "[stiffness, slip] are both > 0", "correct the row");
        laws.emplace_back(elements::HystereticForce(law));
      }
  if (const Node* table = reader.table("berg")) {
    TableReader berg(*table, reader.path() + ".berg", reader.problems());
    elements::BergFriction law;
    law.force = read_positive(berg, "force", force_quantity(is_rotation));
    law.deflection = read_positive(berg, "deflection", travel_quantity(is_rotation));
    berg.finish();
    laws.emplace_back(elements::HystereticForce(law));
  }
  if (const Node* table = reader.table("lugre")) {
    TableReader bristles(*table, reader.path() + ".lugre", reader.problems());
    if (const auto law = read_lugre(bristles, is_rotation)) laws.emplace_back(*law);
    bristles.finish();
  }
  return reader.errors() == before ? laws : elements::ScalarLaws();
}

std::optional<elements::RubbingFriction> read_rubbing_friction(TableReader& reader) {
  const std::size_t before = reader.errors();
  elements::RubbingFriction law;
  law.coefficient = read_positive(reader, "coefficient", Quantity::pure);
  law.stiffness = read_positive(reader, "stiffness", Quantity::force_per_length);
  constexpr double usual = 2;
  if (reader.errors() == before && law.coefficient > usual)
    reader.problems()
        .warning(reader.path() + ".coefficient", fmt::format("{:.6g}", law.coefficient),
                 "dry steel has about 0.2 to 0.8, rubber up to about 1", "give a fraction, not percent")
        .origin = reader.content().origin;
  return reader.errors() == before ? std::optional(law) : std::nullopt;
}

std::optional<elements::PayneForce> read_payne(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  elements::PayneForce law;
  law.stiffness = reader.required_number("stiffness", stiffness_quantity(is_rotation));
  law.loss = reader.required_number("loss", stiffness_quantity(is_rotation));
  for (const auto& [key, value] : {std::pair{"stiffness", law.stiffness}, std::pair{"loss", law.loss}})
    if (!(value >= 0))
      reader.error(key, fmt::format("{:.6g}", value),
                   "rubber is stiffer at small amplitudes and feeds no energy: both are ≥ 0", "correct its sign");
  law.amplitude = read_positive(reader, "amplitude", travel_quantity(is_rotation));
  law.exponent = reader.number("exponent", Quantity::pure).value_or(law.exponent);
  constexpr double highest = 5;
  if (!(law.exponent > 0 && law.exponent <= highest))
    reader.error("exponent", fmt::format("{:.6g}", law.exponent),
                 fmt::format("it is above 0 and at most {:g}; filled rubber has about 0.6", highest), "correct it");
  constexpr double like_a_loss_factor = 3, usual_amplitude = 0.05;
  const auto warn = [&](const char* key, double value, const char* rule, const char* remedy) {
    reader.problems().warning(reader.path() + "." + key, fmt::format("{:.6g}", value), rule, remedy).origin =
        reader.content().origin;
  };
  if (reader.errors() == before && law.loss > 0 && law.loss < like_a_loss_factor &&
      law.stiffness > 100 * like_a_loss_factor)
    warn("loss", law.loss, "it is a stiffness, the largest k'', and not a loss factor", "give it in N/m or N m/rad");
  else if (reader.errors() == before && law.loss > law.stiffness)
    warn("loss", law.loss, "filled rubber loses less than it softens: its largest k'' is below `stiffness`",
         "check both");
  if (reader.errors() == before && law.amplitude > usual_amplitude)
    warn("amplitude", law.amplitude, "filled rubber softens below a few millimetres", "check its unit");
  return reader.errors() == before ? std::optional(law) : std::nullopt;
}

std::optional<elements::LuGreFriction> read_lugre(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  elements::LuGreFriction law;
  law.stiffness = read_positive(reader, "stiffness", stiffness_quantity(is_rotation));
  law.slip = read_positive(reader, "slip", force_quantity(is_rotation));
  law.breakaway = reader.number("breakaway", force_quantity(is_rotation)).value_or(law.slip);
  if (reader.errors() == before && law.breakaway < law.slip)
    reader.error("breakaway", fmt::format("{:.6g}, below slip {:.6g}", law.breakaway, law.slip),
                 "the force of slow slip is at least that of fast slip", "correct one of them");
  reader.also_known({"stribeck_velocity"});
  if (law.has_stribeck_effect() || reader.has("stribeck_velocity"))
    law.stribeck_velocity = read_positive(reader, "stribeck_velocity", velocity_quantity(is_rotation));
  const Quantity damping = is_rotation ? Quantity::damping_moment_per_angle : Quantity::damping_force_per_length;
  law.damping = reader.number("damping", damping).value_or(0);
  law.viscous = reader.number("viscous", damping).value_or(0);
  for (const auto& [key, value] : {std::pair{"damping", law.damping}, std::pair{"viscous", law.viscous}})
    if (!(value >= 0))
      reader.error(key, fmt::format("{:.6g} {}", value, printed_si_unit(damping)),
                   "a damper does not feed energy: it is ≥ 0", "correct its sign");
  const bool may_feed = reader.boolean("allow_active").value_or(false);
  if (reader.errors() > before) return std::nullopt;
  if (const double least = elements::least_passive_viscous(law); law.viscous < least && !may_feed)
    reader.problems()
        .warning(reader.path() + ".viscous", fmt::format("{:.6g} {}", law.viscous, printed_si_unit(damping)),
                 fmt::format("below damping (breakaway/slip − 1) = {:.6g} {}, some motions feed energy", least,
                             printed_si_unit(damping)),
                 "reduce the damping, or set allow_active = true")
        .origin = reader.content().origin;
  return law;
}

std::optional<elements::BoucWen> read_bouc_wen(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  elements::BoucWen law;
  law.stiffness = read_positive(reader, "stiffness", stiffness_quantity(is_rotation));
  law.force = read_positive(reader, "force", force_quantity(is_rotation));
  law.exponent = reader.number("exponent", Quantity::pure).value_or(1);
  law.beta = reader.number("beta", Quantity::pure).value_or(law.beta);
  law.gamma = reader.number("gamma", Quantity::pure).value_or(law.gamma);
  law.asymmetry = reader.number("asymmetry", Quantity::pure).value_or(0);
  const bool may_feed = reader.boolean("allow_active").value_or(false);
  constexpr double highest = 20;
  if (!(law.exponent >= 1 && law.exponent <= highest))
    reader.error("exponent", fmt::format("{:.6g}", law.exponent), fmt::format("it is from 1 to {:g}", highest),
                 "correct it");
  if (!(law.beta > 0 && law.gamma > -law.beta && (law.gamma <= law.beta || may_feed)))
    reader.error(reader.has("gamma") ? "gamma" : "beta", fmt::format("beta {:.6g}, gamma {:.6g}", law.beta, law.gamma),
                 "0 < beta and −beta < gamma ≤ beta: outside, some loops feed energy or have no limit",
                 "correct them, or set allow_active = true for gamma > beta");
  else if (!(2 * std::abs(law.asymmetry) < law.beta + law.gamma && std::abs(law.asymmetry) < law.beta))
    reader.error("asymmetry", fmt::format("{:.6g}", law.asymmetry),
                 fmt::format("2 |asymmetry| < beta + gamma = {:.6g} and |asymmetry| < beta: beyond, the force has no "
                             "limit on one side",
                             law.beta + law.gamma),
                 "reduce it");
  return reader.errors() == before ? std::optional(law) : std::nullopt;
}

}  // namespace trivet::project
