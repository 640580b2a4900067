// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/law_readers.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/project/elements/law_numbers.h"

namespace trivet::project {

/// Of zero coefficients too, so that they can be parameters that begin at 0.
std::optional<elements::PolynomialForce> read_polynomial(TableReader& reader, bool is_rotation) {
  elements::PolynomialForce law;
  law.coefficients = reader.numbers("polynomial", Quantity::pure).value_or(std::vector<double>());
  if (!reader.has("quadratic") && !reader.has("cubic") && law.coefficients.empty()) return std::nullopt;
  if (law.coefficients.size() < 3) law.coefficients.resize(3, 0.0);
  law.coefficients[1] +=
      reader.number("quadratic", is_rotation ? Quantity::moment_per_angle_squared : Quantity::force_per_length_squared)
          .value_or(0);
  law.coefficients[2] +=
      reader.number("cubic", is_rotation ? Quantity::moment_per_angle_cubed : Quantity::force_per_length_cubed)
          .value_or(0);
  while (law.coefficients.size() > 1 && law.coefficients.back() == 0) law.coefficients.pop_back();
  constexpr std::size_t highest = 12;
  if (law.coefficients.size() > highest)
    reader.error("polynomial", fmt::format("degree {}", law.coefficients.size()),
                 fmt::format("at most degree {}", highest), "such a polynomial oscillates between its points");
  return law;
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
  const auto points =
      read_curve_points(inside, "travel", "force", travel_quantity(is_rotation), force_quantity(is_rotation));
  inside.finish();
  if (!points) return std::nullopt;
  const char* source = inside.has("rows") ? "rows" : "file";
  if (points->x.front() != 0) {
    inside.error(source, fmt::format("a travel from {:.6g}", points->x.front()),
                 "it is counted from where the stop closes, and never negative", "begin at [0, 0]");
    return std::nullopt;
  }
  const auto falls = std::ranges::is_sorted_until(points->y);
  if (falls != points->y.end() || !(points->y.back() > 0)) {
    inside.error(source,
                 falls != points->y.end()
                     ? fmt::format("row {}: {:.6g} after {:.6g}", falls - points->y.begin() + 1, *falls, *(falls - 1))
                     : fmt::format("a last force of {:.6g}", points->y.back()),
                 "the force of a stop never falls, and is above 0 in the end",
                 "correct the rows; for other forces take the law curve");
    return std::nullopt;
  }
  return elements::KnotCurve(points->x, points->y, interpolation);
}

}  // namespace

std::optional<elements::GapStop> read_gap_stop(TableReader& reader, bool is_rotation, std::optional<double> ring) {
  const std::size_t before = reader.errors();
  elements::GapStop law;
  const Quantity travel = travel_quantity(is_rotation);
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
  const Quantity per_rate = is_rotation ? Quantity::time_per_angle : Quantity::time_per_length;
  law.dissipation = reader.number("dissipation", per_rate).value_or(0);
  if (!(law.dissipation >= 0))
    reader.error("dissipation", fmt::format("{:.6g} {}", law.dissipation, si_unit(per_rate)),
                 "a stop does not feed energy: it is ≥ 0", "correct its sign");
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
      read_curve_points(reader, "deflection", "force", travel_quantity(is_rotation), force_quantity(is_rotation));
  if (!points || reader.errors() > before) return std::nullopt;
  law.force = elements::KnotCurve(points->x, points->y, interpolation);
  law.rises = std::ranges::is_sorted(points->y);
  return law;
}

}  // namespace trivet::project
