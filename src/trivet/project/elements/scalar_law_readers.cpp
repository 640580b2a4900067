// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/scalar_law_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {

namespace {

/// CurvePoints with ascending x; empty with problems.
struct CurvePoints {
  std::vector<double> x, y;
};

/// The rows of a curve through (0, 0), from the project file or from a CSV file with these columns.
std::optional<CurvePoints> read_points(TableReader& reader, const char* x_column, const char* y_column, Quantity x,
                                       Quantity y) {
  if (reader.has("rows") == reader.has("file")) {
    reader.also_known({"rows", "file"});
    reader.error("", reader.has("rows") ? "rows and file" : "neither rows nor file",
                 fmt::format("a curve has rows [[{}, {}], …] or a CSV file with these columns", x_column, y_column),
                 "give one of them");
    return std::nullopt;
  }
  const char* source = reader.has("rows") ? "rows" : "file";
  const auto pairs =
      reader.has("rows") ? read_pairs(reader, "rows", x, y) : read_pairs_of_file(reader, x_column, y_column);
  if (!pairs) return std::nullopt;
  CurvePoints points;
  double largest = 0;
  for (Eigen::Index i = 0; i < pairs->rows(); ++i) {
    points.x.push_back((*pairs)(i, 0));
    points.y.push_back((*pairs)(i, 1));
    largest = std::max(largest, std::abs(points.y.back()));
    if (i > 0 && !((*pairs)(i, 0) > (*pairs)(i - 1, 0))) {
      reader.error(source, fmt::format("row {}: {:.6g} after {:.6g}", i + 1, (*pairs)(i, 0), (*pairs)(i - 1, 0)),
                   fmt::format("the {} increases from row to row", x_column), "sort the rows and remove repeats");
      return std::nullopt;
    }
  }
  if (points.x.size() < 2) {
    reader.error(source, fmt::format("{} rows", points.x.size()), "a curve has at least two", "complete it");
    return std::nullopt;
  }
  if (!(points.x.front() <= 0 && points.x.back() >= 0)) {
    reader.error(source, fmt::format("a {} from {:.6g} to {:.6g}", x_column, points.x.front(), points.x.back()),
                 "the curve contains 0", "begin at 0, or below it for both senses");
    return std::nullopt;
  }
  const double at_zero = elements::KnotCurve(points.x, points.y, elements::Interpolation::linear).at(0).value;
  constexpr double round_off = 1e-9;
  if (std::abs(at_zero) > round_off * largest) {
    reader.error(source, fmt::format("a {} of {:.6g} at 0", y_column, at_zero), "a curve passes 0 at 0",
                 "describe a preload by `preload` of the element or a constant force");
    return std::nullopt;
  }
  return points;
}

elements::Interpolation read_interpolation(TableReader& reader) {
  const auto word = reader.choice("interpolation", {"linear", "monotone_cubic"});
  return word && *word == "monotone_cubic" ? elements::Interpolation::monotone_cubic : elements::Interpolation::linear;
}

/// A number > 0 that must be there.
double read_positive(TableReader& reader, const char* key, Quantity quantity) {
  const std::size_t before = reader.errors();
  const double value = reader.required_number(key, quantity);
  if (reader.errors() == before && !(value > 0))
    reader.error(key,
                 fmt::format("{:.6g}{}{}", value, quantity == Quantity::pure ? "" : " ", printed_si_unit(quantity)),
                 "it is > 0", "correct it");
  return value;
}

Quantity force_quantity(bool is_rotation) { return is_rotation ? Quantity::moment : Quantity::force; }
Quantity travel_quantity(bool is_rotation) { return is_rotation ? Quantity::angle : Quantity::length; }
Quantity stiffness_quantity(bool is_rotation) {
  return is_rotation ? Quantity::moment_per_angle : Quantity::force_per_length;
}

}  // namespace

std::optional<elements::PolynomialForce> read_polynomial(TableReader& reader, bool is_rotation) {
  if (!reader.has("quadratic") && !reader.has("cubic") && !reader.has("polynomial")) return std::nullopt;
  elements::PolynomialForce law;
  law.coefficients = reader.numbers("polynomial", Quantity::pure).value_or(std::vector<double>());
  if (law.coefficients.size() < 3) law.coefficients.resize(3, 0.0);
  law.coefficients[1] +=
      reader.number("quadratic", is_rotation ? Quantity::moment_per_angle_squared : Quantity::force_per_length_squared)
          .value_or(0);
  law.coefficients[2] +=
      reader.number("cubic", is_rotation ? Quantity::moment_per_angle_cubed : Quantity::force_per_length_cubed)
          .value_or(0);
  while (!law.coefficients.empty() && law.coefficients.back() == 0) law.coefficients.pop_back();
  constexpr std::size_t highest = 12;
  if (law.coefficients.size() > highest)
    reader.error("polynomial", fmt::format("degree {}", law.coefficients.size()),
                 fmt::format("at most degree {}", highest), "such a polynomial oscillates between its points");
  return law.coefficients.empty() ? std::nullopt : std::optional(law);
}

namespace {

/// Force over the travel beyond the gap, in place of a stiffness.
std::optional<elements::KnotCurve> read_curve_of_stop(TableReader& reader, bool is_rotation) {
  const Node* table = reader.table("curve");
  if (!table) return std::nullopt;
  for (const char* other : {"stiffness", "power"}) {
    if (reader.has(other))
      reader.error(other, std::string("curve and ") + other, "the force of a stop is a curve, or stiffness and power",
                   "remove one");
    static_cast<void>(reader.node(other));
  }
  TableReader inside(*table, reader.path() + ".curve", reader.problems());
  const elements::Interpolation interpolation = read_interpolation(inside);
  const auto points = read_points(inside, "travel", "force", travel_quantity(is_rotation), force_quantity(is_rotation));
  inside.finish();
  if (!points) return std::nullopt;
  const char* source = inside.has("rows") ? "rows" : "file";
  if (points->x.front() != 0) {
    inside.error(source, fmt::format("a travel from {:.6g}", points->x.front()),
                 "it is counted from where the stop closes, and never negative", "begin at [0, 0]");
    return std::nullopt;
  }
  if (!std::is_sorted(points->y.begin(), points->y.end()) || !(points->y.back() > 0)) {
    inside.error(source, "a force that falls or vanishes", "a stop pushes more the farther it is compressed",
                 "correct the rows; for other forces take the law curve");
    return std::nullopt;
  }
  return elements::KnotCurve(points->x, points->y, interpolation);
}

}  // namespace

std::optional<elements::GapStop> read_gap_stop(TableReader& reader, bool is_rotation, std::optional<double> ring) {
  const std::size_t before = reader.errors();
  elements::GapStop law;
  const Quantity travel = is_rotation ? Quantity::angle : Quantity::length;
  if (ring) law.gap_above = *ring;
  else if (reader.has("gap") == reader.has("gaps"))
    reader.error(reader.has("gap") ? "gaps" : "", reader.has("gap") ? "gap and gaps" : "neither gap nor gaps",
                 "a stop has a gap in the positive direction, or gaps in both",
                 "gap = \"6 mm\", or gaps = [\"6 mm\", \"9 mm\"]");
  if (const auto gap = ring ? std::nullopt : reader.number("gap", travel)) law.gap_above = *gap;
  if (const auto gaps = ring ? std::nullopt : reader.numbers("gaps", travel)) {
    if (gaps->size() == 2) {
      law.gap_above = (*gaps)[0];
      law.gap_below = (*gaps)[1];
    } else {
      reader.error("gaps", fmt::format("{} numbers", gaps->size()),
                   "two are expected: in the positive and in the negative direction", "complete or shorten the list");
    }
  }
  for (const double gap : {law.gap_above, law.gap_below})
    if (gap < 0)
      reader.error(ring                    ? "ring"
                       : reader.has("gap") ? "gap"
                                           : "gaps",
                   fmt::format("{:.6g} {}", gap, si_unit(travel)), "a gap is ≥ 0",
                   "describe a preloaded stop by its rest position: gravity closes gaps");
  if (reader.has("curve")) {
    law.curve = read_curve_of_stop(reader, is_rotation);
  } else {
    reader.also_known({"curve"});
    law.power = reader.number("power", Quantity::pure).value_or(1);
    if (!(law.power >= 1 && law.power <= 10))
      reader.error("power", fmt::format("{:.6g}", law.power), "it is from 1 (linear) to 10; 1.5 is Hertz's contact",
                   "correct it");
    const Quantity stiffness = law.power != 1 ? Quantity::pure
        : is_rotation                         ? Quantity::moment_per_angle
                                              : Quantity::force_per_length;
    law.stiffness = reader.required_number("stiffness", stiffness);
    if (reader.errors() == before && !(law.stiffness > 0))
      reader.error("stiffness", fmt::format("{:.6g}", law.stiffness), "it is > 0", "correct it");
  }
  law.dissipation = reader.number("dissipation", Quantity::pure).value_or(0);
  if (!(law.dissipation >= 0))
    reader.error("dissipation", fmt::format("{:.6g} s/m", law.dissipation), "a stop does not feed energy: it is ≥ 0",
                 "correct its sign");
  if (ring && reader.has("gap_at"))
    reader.error("gap_at", "gap_at of a ring", "its play is that of the undeformed machine", "remove it");
  const auto gap_at = reader.choice("gap_at", {"unloaded", "rest"});
  law.gaps_at_rest = gap_at && *gap_at == "rest";
  return reader.errors() == before ? std::optional(law) : std::nullopt;
}

std::optional<elements::GasForce> read_gas_force(TableReader& reader) {
  const std::size_t before = reader.errors();
  constexpr double standard_atmosphere = 101325;
  elements::GasForce law;
  law.pressure = read_positive(reader, "pressure", Quantity::pressure);
  law.volume = read_positive(reader, "volume", Quantity::volume);
  law.area = read_positive(reader, "area", Quantity::area);
  law.exponent = reader.number("exponent", Quantity::pure).value_or(1.4);
  law.atmosphere = reader.number("atmosphere", Quantity::pressure).value_or(standard_atmosphere);
  if (!(law.exponent >= 1 && law.exponent <= 2))
    reader.error("exponent", fmt::format("{:.6g}", law.exponent),
                 "it is from 1 (isothermal) over 1.4 (air, adiabatic) to 2", "correct it");
  if (!(law.atmosphere >= 0))
    reader.error("atmosphere", fmt::format("{:.6g} Pa", law.atmosphere), "an absolute pressure is ≥ 0", "correct it");
  if (reader.errors() == before && law.pressure < law.atmosphere)
    reader.problems()
        .warning(reader.path() + ".pressure", fmt::format("{:.6g} Pa", law.pressure),
                 fmt::format("it is absolute, and below that of the atmosphere, {:.6g} Pa", law.atmosphere),
                 "add that of the atmosphere if it is a gauge pressure")
        .origin = reader.content().origin;
  return reader.errors() == before ? std::optional(law) : std::nullopt;
}

std::optional<elements::ForceCurve> read_force_curve(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  elements::ForceCurve law;
  const elements::Interpolation interpolation = read_interpolation(reader);
  const auto beyond = reader.choice("beyond", {"slope", "refuse"});
  law.is_limited = beyond && *beyond == "refuse";
  const auto points =
      read_points(reader, "deflection", "force", travel_quantity(is_rotation), force_quantity(is_rotation));
  if (!points || reader.errors() > before) return std::nullopt;
  law.force = elements::KnotCurve(points->x, points->y, interpolation);
  law.rises = std::is_sorted(points->y.begin(), points->y.end());
  return law;
}

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
      read_points(reader, "velocity", "force", is_rotation ? Quantity::angular_velocity : Quantity::velocity,
                  force_quantity(is_rotation));
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
  reader.also_known({"slip", "breakaway", "stiffness", "sliders", "berg"});
  if (reader.has("lugre")) {
    reader.also_known({"lugre"});
    reader.error("lugre", "within friction", "bristles are a law beside it",
                 R"(write lugre = {stiffness = "400 N/mm", slip = "40 N"} without friction around it)");
    return {};
  }
  const int given = static_cast<int>(reader.has("slip")) + static_cast<int>(reader.has("sliders")) +
      static_cast<int>(reader.has("berg"));
  if (given != 1) {
    reader.error("", given == 0 ? "no law" : "several laws", "friction is one of slip, sliders and berg",
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
    law.stribeck_velocity =
        read_positive(reader, "stribeck_velocity", is_rotation ? Quantity::angular_velocity : Quantity::velocity);
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
