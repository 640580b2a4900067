// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

/// A reason for which curves of combinations have no margins.
struct NoCurves {
  std::string reason;
};

design::PackedDesign packed_or_reason(const CaseVector& of, const model::System& system) {
  design::PackedOrReason found = of.pack(system);
  if (!found.design) throw NoCurves{found.reason};
  return std::move(*found.design);
}

}  // namespace

MountCurves::MountCurves(const MountCombinations& all) : all_(all) {
  try {
    for (const project::Case* variant : all.cases()) add_case(*variant);
    const bool any = std::ranges::any_of(cases_, [](const Case& one) { return !one.packed.results().empty(); });
    if (!any) cases_.clear();
    reason_ = difference_from_assembled();
  } catch (const NoCurves& no_curves) {
    reason_ = no_curves.reason;
  } catch (const foundation::NotComputable& refused) {
    reason_ = refused.what();
  }
  if (!reason_.empty()) cases_.clear();
}

void MountCurves::add_case(const project::Case& variant) {
  const foundation::Progress silent;
  const CaseContext context(variant.system, silent);
  foundation::Problems warnings;
  std::vector<RequirementResult> results = requirement_values(context, variant.analyses, warnings);
  std::erase_if(results,
                [](const RequirementResult& one) { return requirement_row(one.kind).packed != PackedPart::curve; });
  Case one{CaseVector(variant, variant.analyses, results), {}, {}, {}};
  if (!results.empty()) {
    if (!one.packed.reason().empty()) throw NoCurves{one.packed.reason()};
    design::PackedDesign given = packed_or_reason(one.packed, variant.system);
    for (std::size_t c = 0; c < all_.choices().size(); ++c) {
      std::vector<Eigen::VectorXd>& changes = one.changes.emplace_back();
      for (std::size_t m = 0; m < all_.choices()[c].mounts.size(); ++m)
        changes.emplace_back(packed_or_reason(one.packed, all_.system_with(variant, c, m)).entries - given.entries);
    }
    one.given = std::move(given.entries);
  }
  cases_.push_back(std::move(one));
}

Eigen::VectorXd MountCurves::sum(const Case& one, std::size_t combination) const {
  Eigen::VectorXd entries = one.given;
  for (std::size_t c = 0; c < one.changes.size(); ++c) entries += one.changes[c][all_.mount(combination, c)];
  return entries;
}

std::string MountCurves::difference_from_assembled() const {
  constexpr double tolerance = 1e-11;  // of the scale of an entry: sums over the choices
  for (std::size_t v = 0; v < cases_.size(); ++v) {
    if (cases_[v].packed.results().empty()) continue;
    for (const std::size_t combination : all_.spread_combinations()) {
      const design::PackedDesign exact = packed_or_reason(cases_[v].packed, all_.system(*all_.cases()[v], combination));
      const Eigen::VectorXd difference = sum(cases_[v], combination) - exact.entries;
      if (!(difference.cwiseAbs().array() <= tolerance * exact.scales.array()).all())
        return "the loads or results of a combination are no sum over its mounts";
    }
  }
  return "";
}

std::vector<double> MountCurves::margins(const std::vector<std::size_t>& combinations,
                                         const foundation::Progress& progress) const {
  return least_margins(combinations, false, progress);
}

std::vector<double> MountCurves::isolation_margins(const std::vector<std::size_t>& combinations,
                                                   const foundation::Progress& progress) const {
  return least_margins(combinations, true, progress);
}

std::vector<double> MountCurves::least_margins(const std::vector<std::size_t>& combinations, bool of_isolations,
                                               const foundation::Progress& progress) const {
  std::vector<double> result(combinations.size(), foundation::infinity);
  constexpr std::size_t piece = 256;  // their matrices fit in the cache
  foundation::parallel_for(
      combinations.size(), {.size = piece, .progress = progress, .task = "amplitudes and peaks"},
      [&](std::size_t first, std::size_t last) {
        for (const Case& one : cases_) {
          if (one.packed.results().empty()) continue;
          Eigen::MatrixXd entries(to_index(last - first), one.given.size());
          for (std::size_t i = first; i < last; ++i)
            entries.row(to_index(i - first)) = sum(one, combinations[i]).transpose();
          const Eigen::ArrayXXd margins = curve_margins(one.packed, one.packed.unpacked(std::move(entries))).margins;
          for (std::size_t r = 0; r < one.packed.results().size(); ++r) {
            const bool counts = !of_isolations || one.packed.results()[r].kind == RequirementKind::isolation;
            for (std::size_t i = first; counts && i < last; ++i)
              if (const double margin = margins(to_index(i - first), to_index(r)); !std::isnan(margin))
                result[i] = std::min(result[i], margin);
          }
        }
      });
  return result;
}

}  // namespace trivet::study
