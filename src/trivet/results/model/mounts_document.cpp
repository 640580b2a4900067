// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/mounts_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "trivet/assembly/assembled.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/format/preload_words.h"
#include "trivet/results/model/model_words.h"
#include "trivet/study/analyses/load_case.h"

namespace trivet::results {
namespace {

constexpr double dynamic_frequency = 10 * foundation::two_pi;  // [rad/s]

/// Least and largest value of several mounts.
struct Spread {
  std::optional<double> least, largest;
  void add(double value) {
    least = std::min(least.value_or(value), value);
    largest = std::max(largest.value_or(value), value);
  }
};

/// Elements with the same properties.
struct MountKind {
  std::vector<std::string> names;
  std::string type, mount, damping;
  std::array<double, 3> stiffness{};                   ///< static, without the stiffening of rubber in vibration [N/m]
  std::array<std::optional<double>, 3> dynamic{};      ///< Re D(ω), if it differs from `stiffness` [N/m]
  std::array<std::optional<double>, 3> loss_factor{};  ///< Im D(ω) / Re D(ω)
  Spread load, across, deflection, utilisation;
};

bool is_close(double a, double b) {
  constexpr double digits = 1e-9;  // nine, as many as results have
  return std::abs(a - b) <= digits * std::max(std::abs(a), std::abs(b));
}

bool is_close(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || is_close(*a, *b));
}

bool is_same_kind(const MountKind& a, const MountKind& b) {
  for (std::size_t j = 0; j < 3; ++j)
    if (!is_close(a.stiffness[j], b.stiffness[j]) || !is_close(a.dynamic[j], b.dynamic[j]) ||
        !is_close(a.loss_factor[j], b.loss_factor[j]))
      return false;
  return a.type == b.type && a.mount == b.mount && a.damping == b.damping;
}

MountKind kind_of(const model::Element& element) {
  MountKind kind{.names = {element.name},
                 .type = element.type,
                 .mount = element.rating ? element.rating->mount : "",
                 .damping = damping_words(element.law.damping)};
  const elements::Matrix12 stiffness = elements::stiffness(element.law);
  std::optional<elements::Matrix12c> dynamic;
  try {
    dynamic = elements::dynamic_stiffness(element.law, dynamic_frequency);
  } catch (const foundation::NotComputable&) {  // outside the range of a tabulated law
  }
  constexpr double round_off = 1e-12;  // of the stiffest axis: along the others the element has none
  const double least = round_off * stiffness.diagonal().segment<3>(6).cwiseAbs().maxCoeff();
  for (int j = 0; j < 3; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    const double at_rest = stiffness(6 + j, 6 + j) / element.stiffening;
    kind.stiffness[axis] = std::abs(stiffness(6 + j, 6 + j)) > least ? at_rest : 0;
    if (!dynamic) continue;
    const std::complex<double> value = (*dynamic)(6 + j, 6 + j);
    if (!is_close(value.real(), at_rest) && std::abs(value.real()) > least) kind.dynamic[axis] = value.real();
    if (value.real() > least) kind.loss_factor[axis] = value.imag() / value.real();
  }
  return kind;
}

/// Mounts at rest; none if nothing loads the machine, or if they cannot be computed, for this reason.
std::vector<study::MountAtRest> mounts_at_rest(const model::System& system, std::string& reason) {
  if (!system.description().gravity && system.description().constant_forces.empty()) return {};
  try {
    return study::mounts_at_rest(system, assembly::assemble(system));
  } catch (const foundation::NotComputable& refused) {
    reason = refused.what();
    return {};
  }
}

std::vector<MountKind> kinds_of(const model::System& system, std::string& reason) {
  const std::vector<study::MountAtRest> at_rest = mounts_at_rest(system, reason);
  std::vector<MountKind> kinds;
  for (const model::Element& element : system.elements()) {
    if (element.is_foundation) continue;
    MountKind one = kind_of(element);
    auto kind = std::ranges::find_if(kinds, [&](const MountKind& known) { return is_same_kind(known, one); });
    if (kind == kinds.end()) kind = kinds.insert(kinds.end(), std::move(one));
    else kind->names.push_back(element.name);
    const auto rest = std::ranges::find(at_rest, element.name, &study::MountAtRest::name);
    if (rest == at_rest.end()) continue;
    kind->load.add(rest->compression);
    kind->across.add(rest->across);
    kind->deflection.add(rest->deflection);
    if (rest->utilisation) kind->utilisation.add(*rest->utilisation);
  }
  return kinds;
}

/// "6 × front left, front right, …"
std::string name_words(const MountKind& kind) {
  constexpr std::size_t most = 6;
  std::string words;
  for (std::size_t i = 0; i < std::min(most, kind.names.size()); ++i) words += (i ? ", " : "") + kind.names[i];
  if (kind.names.size() > most) words += " … " + kind.names.back();
  return kind.names.size() == 1 ? words : fmt::format("{} × {}", kind.names.size(), words);
}

/// "5.1 kN", or "5.1 kN … 7.4 kN" of mounts that differ.
std::string spread_words(const Spread& spread, const DisplayUnit& unit) {
  if (!spread.least) return "–";
  const std::string from = value_text(*spread.least, unit), to = value_text(*spread.largest, unit);
  return from == to ? from : from + " … " + to;
}

}  // namespace

Document mounts_document(const project::Case& variant) {
  std::string not_at_rest;
  std::vector<MountKind> kinds = kinds_of(variant.system, not_at_rest);
  Document document;
  if (kinds.empty()) return document;
  const auto any = [&](auto has) { return std::ranges::any_of(kinds, has); };
  const bool is_dynamic = any([](const MountKind& k) {
    return std::ranges::any_of(k.dynamic, [](const auto& value) { return value.has_value(); });
  });
  const bool has_maker = any([](const MountKind& k) { return !k.mount.empty(); });
  const bool has_load = any([](const MountKind& k) { return k.load.least.has_value(); });
  const bool has_utilisation = any([](const MountKind& k) { return k.utilisation.least.has_value(); });
  const DisplayUnit newton = display_unit(variant.display, "N"), metre = display_unit(variant.display, "m");
  const Rows row(std::move(kinds));
  Table table{.rows = row.size(), .records = true, .one_prefix = true, .forms = for_people};
  const auto add = [&](Column column) { table.columns.push_back(std::move(column)); };
  add(row("names", Kind::words, "mounts", name_words));
  add(row("type", Kind::words, "type", &MountKind::type));
  if (has_maker) add(row("mount", Kind::words, "maker's mount", &MountKind::mount));
  constexpr std::array axes = {"x", "y", "z"};
  for (std::size_t j = 0; j < 3; ++j)
    add(row("stiffness", Kind::quantity, fmt::format("k {}", axes[j]),
            [j](const MountKind& k) { return k.stiffness[j]; }, {.unit = "N/m", .digits = 4}));
  if (is_dynamic)
    for (std::size_t j = 0; j < 3; ++j)
      add(row("dynamic", Kind::quantity, fmt::format("k {} at 10 Hz", axes[j]),
              [j](const MountKind& k) { return k.dynamic[j] ? k.dynamic[j] : std::optional(k.stiffness[j]); },
              {.unit = "N/m", .digits = 4}));
  add(row("damping", Kind::words, "damping", &MountKind::damping));
  add(row("loss", Kind::number, "loss factor z at 10 Hz", [](const MountKind& k) { return k.loss_factor[2]; },
          {.digits = 3}));
  if (has_load) {
    add(row("load", Kind::words, "compression at rest",
            [=](const MountKind& k) { return spread_words(k.load, newton); }));
    add(row("across", Kind::words, "across at rest",
            [=](const MountKind& k) { return spread_words(k.across, newton); }));
    add(row("deflection", Kind::words, "deflection at rest",
            [=](const MountKind& k) { return spread_words(k.deflection, metre); }));
  }
  if (has_utilisation)
    add(row("utilisation", Kind::share, "utilisation", [](const MountKind& k) { return k.utilisation.largest; }));
  document.add(std::move(table));
  document.add(Sentence{.parts = {"k: static stiffness against displacement of end K along its axes, end N held",
                                  is_dynamic ? "; at 10 Hz the real part of the dynamic stiffness. " : ". ",
                                  has_load ? "Compression is along the axis of the mount, negative in tension. " : "",
                                  has_load ? preload_words(variant.system) : "",
                                  has_utilisation ? "Utilisation: largest static load over the maker's limit." : ""},
                        .place = Sentence::Place::note});
  if (!not_at_rest.empty())
    document.add(Sentence{.parts = {"No loads at rest: " + not_at_rest}, .place = Sentence::Place::note});
  return document;
}

}  // namespace trivet::results
