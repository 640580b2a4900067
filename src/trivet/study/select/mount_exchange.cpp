// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_selection.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace trivet::study {
namespace {

/// Combinations of one exchange: with bounds so many that they take a second.
constexpr double most_in_exchange = 1e5, most_in_exchange_without_bounds = 500;
/// So many of the combinations with the same mount everywhere are starts, and of others.
constexpr std::size_t uniform_starts = 2, scattered_starts = 2;

}  // namespace

MountExchange::MountExchange(const MountCombinations& all, const MountCurves& curves, MountRanking::Judge judge,
                             std::size_t most, const foundation::Progress& progress)
    : all_(all), curves_(curves), judge_(std::move(judge)), most_(most), progress_(progress) {}

MountSelection MountExchange::run() {
  for (const std::size_t start : starts()) climb(start);
  MountSelection result;
  add_options(result);
  result.best = std::move(best_);
  forget_repeated_ones();
  result.combinations = seen_.size();
  result.judged = judged_;
  result.curves = curve_count_;
  return result;
}

MountRanking MountExchange::ranking(std::vector<std::size_t> combinations) {
  seen_.insert(seen_.end(), combinations.begin(), combinations.end());
  constexpr std::size_t many = 4000000;
  if (seen_.size() > many) forget_repeated_ones();
  return {all_, curves_, std::move(combinations), judge_, progress_};
}

void MountExchange::forget_repeated_ones() {
  std::ranges::sort(seen_);
  seen_.erase(std::ranges::unique(seen_).begin(), seen_.end());
}

std::vector<MountDesign> MountExchange::best_of(std::vector<std::size_t> combinations, std::size_t most) {
  MountRanking found = ranking(std::move(combinations));
  std::vector<MountDesign> designs = found.best(most);
  judged_ += found.judged_count();
  curve_count_ += found.curve_count();
  return designs;
}

double MountExchange::most_at_once() const {
  return all_.without_bounds().empty() ? most_in_exchange : most_in_exchange_without_bounds;
}

/// The best of the same mounts everywhere, in lists of different lengths at the same share of their length; and of many
/// others.
std::vector<std::size_t> MountExchange::starts() {
  std::size_t longest = 0;
  for (const project::MountChoice& choice : all_.choices()) longest = std::max(longest, choice.mounts.size());
  std::vector<std::size_t> uniform;
  for (std::size_t m = 0; m < longest; ++m) {
    std::size_t combination = 0;
    for (std::size_t c = 0; c < all_.choices().size(); ++c) {
      const std::size_t last = all_.choices()[c].mounts.size() - 1;
      combination = all_.with(combination, c, longest == 1 ? 0 : m * last / (longest - 1));
    }
    uniform.push_back(combination);
  }
  std::vector<std::size_t> result;
  for (const MountDesign& design : best_of(uniform, uniform_starts)) result.push_back(number(design));
  const auto looks = static_cast<std::size_t>(most_at_once());
  for (const MountDesign& design : best_of(all_.scattered(looks), scattered_starts))
    if (std::ranges::find(result, number(design)) == result.end()) result.push_back(number(design));
  return result;
}

/// Choices that are exchanged together: neighbours in the order of the file, and of every other one.
std::vector<std::vector<std::size_t>> MountExchange::blocks() const {
  const std::size_t n = all_.choices().size();
  std::vector<std::size_t> in_order(n), alternating;
  std::iota(in_order.begin(), in_order.end(), std::size_t{0});
  for (std::size_t i = 0; i < n; i += 2) alternating.push_back(i);
  for (std::size_t i = 1; i < n; i += 2) alternating.push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (const std::vector<std::size_t>& order : {in_order, alternating})
    for (std::size_t first = 0; first < n; ++first) {
      std::vector<std::size_t> block;
      double count = 1;
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t choice = order[(first + i) % n];
        count *= static_cast<double>(all_.choices()[choice].mounts.size());
        if (count > most_at_once() && !block.empty()) break;
        block.push_back(choice);
      }
      std::ranges::sort(block);
      if (std::ranges::find(result, block) == result.end()) result.push_back(std::move(block));
    }
  return result;
}

/// All combinations that differ in these choices only.
std::vector<std::size_t> MountExchange::exchanges(std::size_t combination,
                                                  const std::vector<std::size_t>& block) const {
  std::vector<std::size_t> result = {combination};
  for (const std::size_t choice : block) {
    std::vector<std::size_t> more;
    for (const std::size_t one : result)
      for (std::size_t m = 0; m < all_.choices()[choice].mounts.size(); ++m) more.push_back(all_.with(one, choice, m));
    result = std::move(more);
  }
  return result;
}

void MountExchange::climb(std::size_t combination) {
  double margin = -1;
  for (bool gained = true; gained;) {
    gained = false;
    for (const std::vector<std::size_t>& block : blocks()) {
      const std::vector<std::size_t> exchanged = exchanges(combination, block);
      const std::vector<MountDesign> designs = best_of(exchanged, most_);
      keep(designs);
      if (designs.front().margin > margin * (1 + same_margin)) {
        margin = designs.front().margin;
        combination = number(designs.front());
        gained = true;
      }
      combination = roomiest(exchanged, combination, margin);
    }
  }
}

/// Of the combinations with this margin the one whose other margins are largest: where two bodies limit it alike, no
/// exchange of the mounts of one of them gains anything before the other has room.
std::size_t MountExchange::roomiest(const std::vector<std::size_t>& combinations, std::size_t reached, double margin) {
  if (!all_.without_bounds().empty()) return reached;
  constexpr std::size_t tried = 4;
  const std::vector<MountCombinations::Bound> bounds = all_.bounds(combinations, progress_);
  std::vector<std::size_t> places;
  double here = 0;
  for (std::size_t i = 0; i < combinations.size(); ++i) {
    if (combinations[i] == reached) here = bounds[i].crowding;
    if (bounds[i].margin >= margin * (1 - same_margin)) places.push_back(i);
  }
  std::erase_if(places, [&](std::size_t i) { return !(bounds[i].crowding < here); });
  std::ranges::sort(places, [&](std::size_t a, std::size_t b) { return bounds[a].crowding < bounds[b].crowding; });
  places.resize(std::min(places.size(), tried));
  for (const std::size_t i : places)
    if (best_of({combinations[i]}, 1).front().margin >= margin * (1 - same_margin)) return combinations[i];
  return reached;
}

/// Adds designs to the best of all exchanges.
void MountExchange::keep(const std::vector<MountDesign>& designs) {
  for (const MountDesign& design : designs)
    if (std::ranges::none_of(best_, [&](const MountDesign& one) { return one.mounts == design.mounts; }))
      best_.push_back(design);
  std::ranges::stable_sort(best_, std::ranges::greater{}, &MountDesign::margin);
  if (best_.size() > most_) best_.resize(most_);
}

std::size_t MountExchange::number(const MountDesign& design) const {
  std::size_t combination = 0;
  for (std::size_t c = 0; c < design.mounts.size(); ++c) combination = all_.with(combination, c, design.mounts[c]);
  return combination;
}

/// Each mount of one choice with the other mounts of the best combination.
void MountExchange::add_options(MountSelection& result) {
  for (std::size_t c = 0; c < all_.choices().size(); ++c) {
    MountRanking found = ranking(exchanges(number(best_.front()), {c}));
    const std::size_t first = result.options.size();
    for (MountDesign& design : found.best_with_each(c))
      result.options.push_back({c, result.options.size() - first, std::move(design)});
    judged_ += found.judged_count();
    std::stable_sort(result.options.begin() + static_cast<std::ptrdiff_t>(first), result.options.end(),
                     [](const MountOption& a, const MountOption& b) { return a.best.margin > b.best.margin; });
  }
}

}  // namespace trivet::study
