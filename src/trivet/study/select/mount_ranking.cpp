// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_selection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"

namespace trivet::study {
namespace {

/// Round-off does not choose among equal margins.
double nine_digits(double margin) {
  if (!std::isfinite(margin) || margin == 0) return margin;
  const double unit = std::pow(10, std::floor(std::log10(margin)) - 8);
  return std::round(margin / unit) * unit;
}

}  // namespace

MountRanking::MountRanking(const MountCombinations& all, const MountCurves& curves,
                           std::vector<std::size_t> combinations, Judge judge, const foundation::Progress& progress)
    : all_(all),
      curves_(curves),
      list_(std::move(combinations)),
      judge_(std::move(judge)),
      progress_(progress),
      sums_(all.bounds(list_, progress)),
      has_curves_(list_.size(), false),
      order_(list_.size()) {
  for (const MountCombinations::Bound& bound : sums_) bounds_.push_back(bound.margin);
  Combinations left;
  for (std::size_t i = 0; i < sums_.size(); ++i)
    if (sums_[i].failed == MountTest::none) left.push_back(i);
  lower(left);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const bool curve_fails = sums_[i].failed == MountTest::none && bounds_[i] < 1;
    ++failed_[static_cast<std::size_t>(curve_fails ? MountTest::curves : sums_[i].failed)];
  }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) { return sums_[a].margin > sums_[b].margin; });
}

void MountRanking::lower(const Combinations& batch) {
  if (curves_.empty()) return;
  Combinations unknown;
  std::ranges::copy_if(batch, std::back_inserter(unknown),
                       [&](std::size_t combination) { return !has_curves_[combination]; });
  std::vector<std::size_t> numbers;
  for (const std::size_t place : unknown) numbers.push_back(list_[place]);
  const std::vector<double> margins = curves_.margins(numbers, progress_);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    bounds_[unknown[i]] = std::min(bounds_[unknown[i]], margins[i]);
    has_curves_[unknown[i]] = true;
  }
  curve_count_ += unknown.size();
}

std::vector<MountDesign> MountRanking::best_of(const Combinations& ordered, std::size_t most) {
  constexpr std::size_t lowered_together = 256, judged_together = 16;
  Combinations found, waiting;  // waiting: a heap by `bounds_`, the highest first
  const auto by_margin = [&](std::size_t a, std::size_t b) {
    const double margin_a = nine_digits(judged_.at(a).margin), margin_b = nine_digits(judged_.at(b).margin);
    return margin_a != margin_b ? margin_a > margin_b : a < b;
  };
  const auto by_bound = [&](std::size_t a, std::size_t b) {
    return bounds_[a] != bounds_[b] ? bounds_[a] < bounds_[b] : a > b;
  };
  std::size_t next = 0;
  const auto may_be_among_them = [&](double bound) {
    return found.size() < most || judged_.at(found.back()).margin * (1 - same_margin) <= bound;
  };
  for (;;) {
    const double unseen = next < ordered.size() ? sums_[ordered[next]].margin : -1;
    if (unseen >= 0 && (waiting.empty() || bounds_[waiting.front()] < unseen)) {
      if (!may_be_among_them(unseen)) break;
      const std::size_t end = std::min(ordered.size(), next + lowered_together);
      const Combinations batch(ordered.begin() + static_cast<std::ptrdiff_t>(next),
                               ordered.begin() + static_cast<std::ptrdiff_t>(end));
      lower(batch);
      next = end;
      for (const std::size_t combination : batch) {
        waiting.push_back(combination);
        std::push_heap(waiting.begin(), waiting.end(), by_bound);
      }
      continue;
    }
    Combinations batch;
    const std::size_t size = found.size() < most ? most - found.size() : judged_together;
    while (batch.size() < size && !waiting.empty() && bounds_[waiting.front()] >= unseen &&
           may_be_among_them(bounds_[waiting.front()])) {
      std::pop_heap(waiting.begin(), waiting.end(), by_bound);
      batch.push_back(waiting.back());
      waiting.pop_back();
    }
    if (batch.empty()) break;
    judge(batch);
    found.insert(found.end(), batch.begin(), batch.end());
    std::ranges::stable_sort(found, by_margin);
    if (found.size() > most) found.resize(most);
  }
  std::vector<MountDesign> designs;
  for (const std::size_t combination : found) designs.push_back(judged_.at(combination));
  return designs;
}

std::vector<MountDesign> MountRanking::first_that_hold(MountOrder by, std::size_t most) {
  constexpr std::size_t judged_together = 16;
  std::vector<double> keys = order_keys(by, all_, curves_, list_, progress_);
  for (double& key : keys) key = nine_digits(key);
  Combinations waiting;
  for (const std::size_t combination : order_)
    if (bounds_[combination] >= 1) waiting.push_back(combination);
  std::ranges::stable_sort(waiting, [&](std::size_t a, std::size_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : bounds_[a] > bounds_[b];
  });
  const auto key_of = [&](std::size_t combination) { return nine_digits(order_key(by, judged_.at(combination))); };
  const auto comes_first = [&](std::size_t a, std::size_t b) {
    if (key_of(a) != key_of(b)) return key_of(a) < key_of(b);
    const double margin_a = nine_digits(judged_.at(a).margin), margin_b = nine_digits(judged_.at(b).margin);
    return margin_a != margin_b ? margin_a > margin_b : a < b;
  };
  Combinations found;
  const auto may_be_among_them = [&](std::size_t combination) {
    if (found.size() < most || keys[combination] < key_of(found.back())) return true;
    return keys[combination] == key_of(found.back()) &&
        bounds_[combination] >= judged_.at(found.back()).margin * (1 - same_margin);
  };
  for (std::size_t next = 0; next < waiting.size();) {
    Combinations batch;
    for (; next < waiting.size() && batch.size() < judged_together; ++next)
      if (may_be_among_them(waiting[next])) batch.push_back(waiting[next]);
    judge(batch);
    std::ranges::copy_if(batch, std::back_inserter(found),
                         [&](std::size_t combination) { return judged_.at(combination).met; });
    std::ranges::stable_sort(found, comes_first);
    if (found.size() > most) found.resize(most);
  }
  std::vector<MountDesign> designs;
  for (const std::size_t combination : found) designs.push_back(judged_.at(combination));
  return designs;
}

std::vector<MountDesign> MountRanking::best_with_each(std::size_t choice) {
  std::vector<Combinations> with(all_.choices()[choice].mounts.size());
  for (const std::size_t combination : order_) with[all_.mount(list_[combination], choice)].push_back(combination);
  std::vector<MountDesign> designs;
  for (const Combinations& ordered : with) designs.push_back(best_of(ordered, 1).front());
  return designs;
}

void MountRanking::judge(const Combinations& batch) {
  Combinations missing;
  std::ranges::copy_if(batch, std::back_inserter(missing),
                       [&](std::size_t combination) { return !judged_.contains(combination); });
  std::vector<MountDesign> designs(missing.size());
  foundation::parallel_for(missing.size(), {.progress = progress_, .task = "all requirements"},
                           [&](std::size_t first, std::size_t last) {
                             for (std::size_t i = first; i < last; ++i) designs[i] = judge_(list_[missing[i]]);
                           });
  for (std::size_t i = 0; i < missing.size(); ++i) {
    constexpr double round_off = 1e-6;
    if (designs[i].margin > bounds_[missing[i]] * (1 + round_off))
      throw foundation::NotComputable(
          "select: the bound of a combination is below its margin, so that the best could be missed; judge the "
          "combinations in question with trivet verdict, and report this model to the authors");
    judged_.emplace(missing[i], std::move(designs[i]));
  }
}

}  // namespace trivet::study
