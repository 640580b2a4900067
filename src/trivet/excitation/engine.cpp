// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {
namespace {

using std::numbers::pi;
constexpr double accepted_angle = 0.01 * pi / 180;  // crank angles are given in degrees with two digits

std::vector<int> usual_firing_order(const EngineLayout& layout) {
  static const std::map<int, std::vector<int>> in_line = {
      {2, {1, 2}},          {3, {1, 3, 2}},          {4, {1, 3, 4, 2}},
      {5, {1, 2, 4, 5, 3}}, {6, {1, 5, 3, 6, 2, 4}}, {8, {1, 6, 2, 5, 8, 3, 7, 4}}};
  if (layout.cylinders == 1) return {1};
  const auto usual = in_line.find(layout.cylinders);
  if (layout.kind != EngineLayout::Kind::in_line || layout.strokes != 4 || usual == in_line.end())
    throw foundation::InvalidInput(
        fmt::format("engine: {} cylinders without a firing order; only in-line engines of 1 … 6 or 8 cylinders with "
                    "four strokes have a default one; list the cylinders as they fire: firing_order = [1, 2, …]",
                    layout.cylinders));
  return usual->second;
}

void require_permutation(std::vector<int> order, int count) {
  std::ranges::sort(order);
  bool complete = order.size() == to_size(count);
  for (std::size_t i = 0; complete && i < order.size(); ++i) complete = order[i] == static_cast<int>(i) + 1;
  if (!complete)
    throw foundation::InvalidInput(
        fmt::format("engine: the firing order must name each of the {} cylinders once", count));
}

}  // namespace

foundation::Problems check(const Engine& engine, const std::string& subject) {
  foundation::Problems problems;
  const auto not_negative = [&](const char* name, double value, const char* unit) {
    if (!(value >= 0) || !std::isfinite(value))
      problems.error(subject + "." + name, fmt::format("{:.6g} {}", value, unit), "it must be ≥ 0", "correct it");
  };
  if (!(engine.crank_radius > 0) || !std::isfinite(engine.crank_radius))
    problems.error(subject + ".crank_radius", fmt::format("{:.6g} m", engine.crank_radius), "it must be > 0",
                   "half of the stroke");
  if (!(engine.rod_ratio > 0 && engine.rod_ratio < 1))
    problems.error(subject + ".rod_ratio", fmt::format("{:.6g}", engine.rod_ratio),
                   "crank radius over length of the rod must be > 0 and < 1", "0.2 to 0.35 is usual");
  not_negative("oscillating_mass", engine.oscillating_mass, "kg");
  not_negative("rotating_mass", engine.rotating_mass, "kg");
  not_negative("counterweight", engine.counterweight, "kg m");
  if (engine.strokes != 2 && engine.strokes != 4)
    problems.error(subject + ".strokes", fmt::format("{}", engine.strokes), "an engine has 2 or 4 strokes",
                   "correct it");
  if (engine.cylinders.empty())
    problems.error(subject, "no cylinder", "an engine has at least one cylinder", "list the cylinders");
  for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
    const Cylinder& c = engine.cylinders[i];
    const std::string name = fmt::format("{}.cylinders[{}]", subject, i + 1);
    for (const double number : {c.position, c.bank_angle, c.crank_angle})
      if (!std::isfinite(number))
        problems.error(name, fmt::format("{}", number), "positions and angles must be finite", "correct it");
    if (std::isinf(c.firing_angle))
      problems.error(name, fmt::format("firing angle {}", c.firing_angle), "it must be finite", "correct it");
    if (!std::isfinite(c.firing_angle + c.crank_angle + c.bank_angle)) continue;
    const double from_top = std::remainder(c.firing_angle + c.crank_angle - c.bank_angle, 2 * pi);
    if (std::abs(from_top) > accepted_angle)
      problems.error(name,
                     fmt::format("at the firing angle of {:.6g}° its crank is {:.4g}° from top dead centre",
                                 c.firing_angle * 180 / pi, from_top * 180 / pi),
                     "firing angle + crank angle − bank angle is a multiple of 360°", "correct one of the three");
  }
  return problems;
}

std::vector<Cylinder> evenly_firing_cylinders(const EngineLayout& layout) {
  const bool two_banks = layout.kind != EngineLayout::Kind::in_line;
  if (layout.cylinders < 1 || (two_banks && layout.cylinders % 2 != 0))
    throw foundation::InvalidInput(fmt::format("engine: {} cylinders{}", layout.cylinders,
                                               two_banks ? ", two banks need an even number" : ", must be ≥ 1"));
  if (layout.strokes != 2 && layout.strokes != 4)
    throw foundation::InvalidInput(fmt::format("engine: {} strokes, must be 2 or 4", layout.strokes));
  for (const double number : {layout.bank_angle, layout.spacing, layout.bank_offset})
    if (!std::isfinite(number))
      throw foundation::InvalidInput(fmt::format("engine: {} in its layout, must be finite", number));
  const std::vector<int> order = layout.firing_order.empty() ? usual_firing_order(layout) : layout.firing_order;
  require_permutation(order, layout.cylinders);
  const double between_banks = layout.kind == EngineLayout::Kind::boxer ? pi : two_banks ? layout.bank_angle : 0;
  const int in_bank = two_banks ? layout.cylinders / 2 : layout.cylinders;
  std::vector<Cylinder> cylinders(to_size(layout.cylinders));
  for (int i = 0; i < layout.cylinders; ++i) {
    Cylinder& c = cylinders[i];
    const bool second = i >= in_bank;
    c.bank_angle = (second ? -0.5 : 0.5) * between_banks;
    c.position = (0.5 * (in_bank - 1) - i % in_bank) * layout.spacing +
        (two_banks ? (second ? -0.5 : 0.5) * layout.bank_offset : 0);
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    Cylinder& c = cylinders[order[k] - 1];
    c.firing_angle = static_cast<double>(k) * layout.strokes * pi / layout.cylinders;
    c.crank_angle = std::remainder(c.bank_angle - c.firing_angle, 2 * pi);
  }
  return cylinders;
}

}  // namespace trivet::excitation
