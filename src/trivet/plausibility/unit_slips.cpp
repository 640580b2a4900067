// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/plausibility/unit_slips.h"
#include "trivet/foundation/significant_digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet::plausibility {
namespace {

/// What is usual for a machine on mounts, 20 g … 200 t. Oddness is ½ (ln(distance to the range) / width)², a natural
/// logarithm of likelihood: one scale for all features.
struct Range {
  const char* words;
  const char* unit;
  double from, to, width;
  const char* kind_below;
  const char* kind_above;

  [[nodiscard]] constexpr bool has_both_ends() const { return from > 0 && to < open; }
  static constexpr double open = 1e9;
};
constexpr Range density_range{"mass / size³", "kg/m³", 3, 15000, 0.8, "density", "density"};
constexpr Range spread_range{"RMS distance of the mounts from the centre of mass / RMS distance of the mass from it",
                             "",
                             0.15,
                             8,
                             0.6,
                             "spread of mounts",
                             "spread of mounts"};
constexpr Range lever_range{"√(rotational / translational stiffness) / RMS distance of the mass from its centre",
                            "",
                            0.1,
                            8,
                            0.6,
                            "spread of mounts",
                            "spread of mounts"};
constexpr Range reach_range{"distance of points and forces from the centre of mass / RMS distance of the mass",
                            "",
                            0,
                            10,
                            0.6,
                            "points",
                            "points"};
constexpr Range frequency_range{
    "natural frequency of translation", "Hz", 0.8, 120, 0.45, "natural frequency", "natural frequency"};
constexpr Range lowest_range{"lowest natural frequency", "Hz", 0.2, Range::open, 0.45, "natural frequency",
                             "natural frequency"};
constexpr Range highest_range{"highest natural frequency", "Hz", 0, 2000, 0.45, "natural frequency",
                              "natural frequency"};
constexpr Range sag_range{
    "static deflection under its weight / its size", "", 1e-4, 0.3, 1.1, "natural frequency", "sag"};
constexpr Range floor_range{"stiffness of the mounts / that of the modes of their foundation", "", 0, 1, 1.0, "", ""};
constexpr Range damping_range{"damping ratio", "", 5e-4, 1.5, 0.9, "", ""};

/// A slip is rare: its correction must explain this much oddness [nats].
constexpr double price_of_slip = 5;
/// Oddness that is reported although no slip explains it [nats].
constexpr double odd_alone = 7;
/// Oddness of an analysis in a range without a resonance [nats].
constexpr double price_of_missed_window = 4.8;
/// Frequencies this far outside a window still count as in it.
constexpr double window_margin = 1.3;
/// Prefers the middle of a range if several slips lead into it [nats].
constexpr double tilt = 0.02;

constexpr Slip slips[] = {
    {.kind = "mass", .words = "the number was meant in grams", .mass = 1e-3},
    {.kind = "mass", .words = "the number was meant in tonnes", .mass = 1e3},
    {.kind = "inertia", .words = "the number was meant in kg cm²", .inertia = 1e-4},
    {.kind = "inertia", .words = "the number was meant in kg mm²", .inertia = 1e-6},
    {.kind = "inertia", .words = "the number was meant in g cm²", .inertia = 1e-7},
    {.kind = "inertia", .words = "the number was meant in g mm²", .inertia = 1e-9},
    {.kind = "inertia", .words = "the number was meant in t m²", .inertia = 1e3},
    {.kind = "center of mass", .words = "the number was meant in millimetres", .centre = 1e-3},
    {.kind = "center of mass", .words = "the number was meant in centimetres", .centre = 1e-2},
    {.kind = "places", .words = "the number was meant in millimetres", .places = 1e-3},
    {.kind = "places", .words = "the number was meant in centimetres", .places = 1e-2},
    {.kind = "points", .words = "the number was meant in millimetres", .points = 1e-3},
    {.kind = "points", .words = "the number was meant in centimetres", .points = 1e-2},
    {.kind = "viscous damping", .words = "the number is in N s/m and its unit N s/mm a slip", .damping = 1e-3},
    {.kind = "stiffness", .words = "the number was meant in N/mm", .stiffness = 1e3},
    {.kind = "stiffness", .words = "the number is in N/m and its unit N/mm a slip", .stiffness = 1e-3},
    {.kind = "stiffness per degree", .words = "given in N m/deg", .rotation = 180 / std::numbers::pi},
};

double outside(const std::optional<double>& value, const Range& range) {
  if (!value) return 0;
  if (!(*value > 0)) return 0;
  if (*value < range.from) return std::log(range.from / *value);
  return *value > range.to ? std::log(*value / range.to) : 0;
}

double oddness_of(const std::optional<double>& value, const Range& range) {
  const double distance = outside(value, range) / range.width;
  return 0.5 * distance * distance;
}

struct Judged {
  const std::optional<double> Features::* value;
  const Range* range;
};
constexpr Judged judged[] = {
    {&Features::density, &density_range},  {&Features::spread, &spread_range},
    {&Features::lever, &lever_range},      {&Features::reach, &reach_range},
    {&Features::sag, &sag_range},          {&Features::frequency, &frequency_range},
    {&Features::over_floor, &floor_range}, {&Features::damping_ratio, &damping_range},
};

/// Features of the whole body on its elements. One odd mount changes them much: they count only if no slip explains the
/// oddness.
constexpr Judged extremes[] = {{&Features::lowest, &lowest_range}, {&Features::highest, &highest_range}};

double missed_windows(const Features& found, const std::vector<Window>& windows) {
  if (windows.empty() || !found.lowest || !found.highest) return 0;
  const auto missed = std::ranges::count_if(windows, [&](const Window& w) {
    const double from = w.from / (2 * std::numbers::pi) / window_margin,
                 to = w.to / (2 * std::numbers::pi) * window_margin;
    return *found.highest < from || *found.lowest > to;
  });
  return price_of_missed_window * static_cast<double>(missed) / static_cast<double>(windows.size());
}

double tilt_penalty(const Features& found) {
  double sum = 0;
  for (const Judged& j : judged) {
    const auto& value = found.*(j.value);
    if (!value || !(*value > 0) || !j.range->has_both_ends()) continue;
    const double off =
        std::log(*value / std::sqrt(j.range->from * j.range->to)) / std::log(j.range->to / j.range->from);
    sum += tilt * off * off;
  }
  return sum;
}

/// The element with the most viscous damping.
const Attachment* most_damped(const BodyPicture& picture) {
  const auto most = std::ranges::max_element(picture.attachments, {}, &Attachment::viscous);
  return most != picture.attachments.end() && most->viscous > 0 ? &*most : nullptr;
}

Eigen::Vector3d farthest_point(const BodyPicture& picture) {
  Eigen::Vector3d farthest_attachment = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : picture.points)
    if (point.norm() > farthest_attachment.norm()) farthest_attachment = point;
  return farthest_attachment;
}

bool applies(const Slip& slip, const BodyPicture& picture) {
  const bool any_typed =
      std::ranges::any_of(picture.attachments, [](const Attachment& a) { return a.typed && a.elastic(); });
  const bool any_place = std::ranges::any_of(picture.attachments, [](const Attachment& a) { return !a.at.isZero(0); });
  if (slip.mass != 1 || slip.inertia != 1) return !picture.from_solids;
  if (slip.centre != 1) return !picture.from_solids && !picture.mass.centre.isZero(0);
  if (slip.stiffness != 1 || slip.rotation != 1) return any_typed;
  if (slip.damping != 1) return most_damped(picture) != nullptr;
  if (slip.points != 1) return farthest_point(picture).norm() > 0;
  return any_place;
}

/// "natural frequency of translation 0.31 Hz (usual 0.8 … 120)", the oddest first.
std::string odd_words(const Features& found, const std::vector<Window>& windows) {
  std::vector<std::pair<double, std::string>> odd;
  const auto add = [&](const Judged& j) {
    const auto& value = found.*(j.value);
    if (outside(value, *j.range) <= 0) return;
    const std::string unit = *j.range->unit ? std::string(" ") + j.range->unit : "";
    const std::string usual = j.range->has_both_ends()
        ? fmt::format("usual {:.6g} … {:.6g}", j.range->from, j.range->to)
        : j.range->from > 0 ? fmt::format("usual from {:.6g}", j.range->from)
                            : fmt::format("usual up to {:.6g}", j.range->to);
    odd.emplace_back(oddness_of(value, *j.range), fmt::format("{} {:.3g}{} ({})", j.range->words, *value, unit, usual));
  };
  for (const Judged& j : judged) add(j);
  for (const Judged& j : extremes) add(j);
  std::ranges::sort(odd, [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < odd.size() && i < most; ++i) text += (i > 0 ? ", " : "") + odd[i].second;
  if (missed_windows(found, windows) > 0)
    text += fmt::format("{}natural frequencies {:.3g} … {:.3g} Hz outside the requested range",
                        text.empty() ? "" : ", ", *found.lowest, *found.highest);
  return text;
}

const Attachment* first_typed(const BodyPicture& picture) {
  for (const Attachment& a : picture.attachments)
    if (a.typed && a.elastic()) return &a;
  return nullptr;
}

/// The farthest attachment: if a single place is wrong, it is this one.
const Attachment* farthest_attachment(const BodyPicture& picture) {
  const Attachment* best = nullptr;
  for (const Attachment& a : picture.attachments)
    if (!best || (a.at - picture.mass.centre).norm() > (best->at - picture.mass.centre).norm() * (1 + 1e-9)) best = &a;
  return best;
}

const char* key_of_stiffness(const std::string& type) {
  if (type == "bushing" || type == "three_springs") return ".translation";
  return type == "matrix" || type == "link" || type == "stay" ? ".stiffness" : "";
}

std::string key_of_place(const model::System& system, const Attachment& a, std::size_t body) {
  return system.elements()[a.element].k.body == body ? ".at" : ".from_at";
}

Suspicion of_slip(const model::System& system, const BodyPicture& picture, const Slip& slip) {
  const model::Body& body = system.bodies()[picture.body];
  Suspicion s;
  s.kind = slip.kind;
  s.subject = "bodies." + body.name;
  if (slip.mass != 1) {
    s.subject += ".mass";
    s.finding = fmt::format("{:.6g} kg", body.mass.mass);
    s.probable = fmt::format("it would be {:.6g} kg if {}", slip.mass * body.mass.mass, slip.words);
  } else if (slip.inertia != 1) {
    const double xx = picture.inertia_about_pole ? spatial::inertia_about_pole(body.mass)(0, 0)
                                                 : body.mass.inertia_about_centre(0, 0);
    s.subject += ".inertia";
    s.finding = fmt::format("xx = {:.6g} kg m²", xx);
    s.probable = fmt::format("xx would be {:.6g} kg m² if {}", slip.inertia * xx, slip.words);
  } else if (slip.centre != 1) {
    s.subject += ".center_of_mass";
    s.finding = fmt::format("{} from the pole", foundation::prefixed_exactly(body.mass.centre.norm(), "m", 6));
    s.probable = fmt::format("it would be {} if {}",
                             foundation::prefixed_exactly(slip.centre * body.mass.centre.norm(), "m", 6), slip.words);
  } else if (slip.points != 1) {
    const double distance = farthest_point(picture).norm();
    s.finding = fmt::format("a point or force {} from the pole", foundation::prefixed_exactly(distance, "m", 6));
    s.probable =
        fmt::format("it would be {} if {}", foundation::prefixed_exactly(slip.points * distance, "m", 6), slip.words);
  } else if (slip.damping != 1) {
    const Attachment& a = *most_damped(picture);
    s.subject = "elements." + system.elements()[a.element].name + ".damping";
    s.finding = fmt::format("{} (sum of three directions)", foundation::prefixed_exactly(a.viscous, "N s/m", 6));
    s.probable = fmt::format("it would be {} if {}", foundation::prefixed_exactly(slip.damping * a.viscous, "N s/m", 6),
                             slip.words);
  } else if (slip.rotation != 1) {
    const Attachment& a = *first_typed(picture);
    const model::Element& element = system.elements()[a.element];
    const double mean = a.own_rotation.trace() / 3;
    s.subject = "elements." + element.name +
        (key_of_stiffness(element.type) == std::string(".translation") ? ".rotation" : key_of_stiffness(element.type));
    s.finding = fmt::format("{} (mean of three directions)", foundation::prefixed_exactly(mean, "N m/rad", 6));
    s.probable = fmt::format("it would be {} if {}", foundation::prefixed_exactly(slip.rotation * mean, "N m/rad", 6),
                             slip.words);
  } else if (slip.stiffness != 1) {
    const Attachment& a = *first_typed(picture);
    const model::Element& element = system.elements()[a.element];
    s.subject = "elements." + element.name + key_of_stiffness(element.type);
    const double mean = a.translation.trace() / 3;
    s.finding = fmt::format("{} (mean of three directions)", foundation::prefixed_exactly(mean, "N/m", 6));
    s.probable = fmt::format("it would be {} if {}; check the other elements of \"{}\" too",
                             foundation::prefixed_exactly(slip.stiffness * mean, "N/m", 6), slip.words, body.name);
  } else {
    const Attachment& a = *farthest_attachment(picture);
    s.subject = "elements." + system.elements()[a.element].name + key_of_place(system, a, picture.body);
    s.finding = fmt::format("{} from the centre of mass",
                            foundation::prefixed_exactly((a.at - picture.mass.centre).norm(), "m", 6));
    s.probable = fmt::format("it would be {} if {}; check the other elements of \"{}\" too",
                             foundation::prefixed_exactly((slip.places * a.at - picture.mass.centre).norm(), "m", 6),
                             slip.words, body.name);
  }
  return s;
}

Suspicion of_feature(const model::System& system, const BodyPicture& picture, const Features& found) {
  const Judged* worst = &judged[0];
  for (const Judged& j : judged)
    if (*j.range->kind_above &&
        oddness_of(found.*(j.value), *j.range) > oddness_of(found.*(worst->value), *worst->range))
      worst = &j;
  for (const Judged& j : extremes)
    if (oddness_of(found.*(j.value), *j.range) > oddness_of(found.*(worst->value), *worst->range)) worst = &j;
  const double value = *(found.*(worst->value));
  Suspicion s;
  s.kind = value < worst->range->from ? worst->range->kind_below : worst->range->kind_above;
  s.subject = "bodies." + system.bodies()[picture.body].name;
  s.finding =
      fmt::format("{} {:.3g}{}{}", worst->range->words, value, *worst->range->unit ? " " : "", worst->range->unit);
  s.probable = "no single unit error explains it: check its mass, inertia, places and stiffnesses";
  return s;
}

}  // namespace

double oddness(const Features& found) {
  double sum = 0;
  for (const Judged& j : judged) sum += oddness_of(found.*(j.value), *j.range);
  return sum;
}

std::optional<BodyVerdict> judge(const model::System& system, const BodyPicture& picture,
                                 const std::vector<Window>& windows) {
  const Features as_typed = features(picture, {});
  const double now = oddness(as_typed) + missed_windows(as_typed, windows);
  // Damping alone says little about the machine, and stiff mounts on a soft floor may be bolts.
  double alone = oddness(as_typed) - oddness_of(as_typed.damping_ratio, damping_range) -
      oddness_of(as_typed.over_floor, floor_range);
  for (const Judged& j : extremes) alone += oddness_of(as_typed.*(j.value), *j.range);
  if (now <= price_of_slip && alone <= odd_alone) return std::nullopt;
  const Slip* best = nullptr;
  double best_oddness = now - price_of_slip;
  for (const Slip& slip : slips) {
    if (!applies(slip, picture)) continue;
    const Features undone = features(picture, slip);
    if (!undone.possible) continue;
    const double then = oddness(undone) + missed_windows(undone, windows) + tilt_penalty(undone);
    if (then < best_oddness) {
      best_oddness = then;
      best = &slip;
    }
  }
  if (!best && alone <= odd_alone) return std::nullopt;
  BodyVerdict verdict{picture.body, best ? of_slip(system, picture, *best) : of_feature(system, picture, as_typed),
                      std::nullopt};
  if (best) verdict.slip = *best;
  verdict.suspicion.rule = odd_words(as_typed, windows);
  return verdict;
}

}  // namespace trivet::plausibility
