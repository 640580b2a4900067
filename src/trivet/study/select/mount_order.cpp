// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::study {
namespace {

constexpr std::array order_names = {"margin", "isolation", "price", "mass"};

/// Price or mass of every mount, with the places that it takes: at all places without a choice, and of each choice.
struct OrderedSums {
  double given = 0;
  std::vector<std::vector<double>> options;  ///< per choice and mount
};

class SumReader {
 public:
  SumReader(MountOrder order, const MountCombinations& all) : order_(order), all_(all) {}

  OrderedSums read() {
    OrderedSums sums;
    const project::Case& variant = *all_.cases().front();
    for (const model::Element& element : variant.system.elements())
      if (!is_chosen(element.name)) sums.given += value(element);
    for (std::size_t c = 0; c < all_.choices().size(); ++c) {
      std::vector<double>& options = sums.options.emplace_back();
      for (std::size_t m = 0; m < all_.choices()[c].mounts.size(); ++m) {
        double& sum = options.emplace_back(0);
        const model::System changed = all_.system_with(variant, c, m);
        for (const model::Element& element : changed.elements())
          if (is_of(all_.choices()[c], element.name)) sum += value(element);
      }
    }
    refuse_lacking();
    return sums;
  }

 private:
  [[nodiscard]] const char* word() const { return order_ == MountOrder::price ? "price" : "mass"; }

  static bool is_of(const project::MountChoice& choice, const std::string& element) {
    return std::ranges::find(choice.elements, element) != choice.elements.end();
  }
  [[nodiscard]] bool is_chosen(const std::string& element) const {
    return std::ranges::any_of(all_.choices(),
                               [&](const project::MountChoice& choice) { return is_of(choice, element); });
  }

  double value(const model::Element& element) {
    if (!element.rating) return 0;
    const auto note = [](std::vector<std::string>& list, const std::string& name) {
      if (std::ranges::find(list, name) == list.end()) list.push_back(name);
    };
    const model::Rating& rating = *element.rating;
    if (order_ == MountOrder::mass) {
      if (!rating.mass) note(lacking_, foundation::quoted(rating.mount));
      return rating.mass.value_or(0);
    }
    if (!rating.price) {
      note(lacking_, foundation::quoted(rating.mount));
      return 0;
    }
    note(currencies_, rating.price->currency);
    return rating.price->amount;
  }

  void refuse_lacking() const {
    if (!lacking_.empty())
      throw foundation::InvalidInput(std::string("select by ") + word() + ": the catalogue gives no " + word() +
                                     " of " + foundation::comma_separated(lacking_) +
                                     "; add it to the catalogue, or name choices without these mounts");
    if (currencies_.size() > 1)
      throw foundation::InvalidInput("select by price: prices in " + foundation::comma_separated(currencies_) +
                                     "; give all in one currency");
  }

  MountOrder order_;
  const MountCombinations& all_;
  std::vector<std::string> lacking_, currencies_;
};

void require_isolation(const MountCombinations& all) {
  const bool any = std::ranges::any_of(all.cases(), [](const project::Case* variant) {
    return variant->analyses.requirements && !variant->analyses.requirements->isolation.empty();
  });
  if (!any)
    throw foundation::InvalidInput(
        "select by isolation: no isolation is required; add isolation = {at = \"1480 rpm\", least = \"80 %\"} to "
        "[requirements]");
}

}  // namespace

const char* name(MountOrder order) { return order_names[static_cast<std::size_t>(order)]; }

MountOrder mount_order(const std::string& word) {
  const auto found = std::ranges::find(order_names, word);
  if (found != order_names.end()) return static_cast<MountOrder>(found - order_names.begin());
  throw foundation::InvalidInput("select by " + foundation::quoted(word) +
                                 ": combinations are ranked by margin, isolation, price or mass");
}

double order_key(MountOrder order, const MountDesign& design) {
  switch (order) {
    case MountOrder::isolation:
      return design.isolation_share.value_or(foundation::infinity);
    case MountOrder::price:
      return design.price ? design.price->amount : foundation::infinity;
    case MountOrder::mass:
      return design.mass.value_or(foundation::infinity);
    case MountOrder::margin:
      break;
  }
  return 0;
}

std::vector<double> order_keys(MountOrder order, const MountCombinations& all, const MountCurves& curves,
                               const std::vector<std::size_t>& combinations, const foundation::Progress& progress) {
  std::vector<double> keys(combinations.size(), 0);
  if (order == MountOrder::margin) return keys;
  if (order == MountOrder::isolation) {
    require_isolation(all);
    if (curves.empty()) return keys;
    const std::vector<double> margins = curves.isolation_margins(combinations, progress);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = std::isinf(margins[i]) ? 0 : 1 / margins[i];
    return keys;
  }
  const OrderedSums sums = SumReader(order, all).read();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    keys[i] = sums.given;
    for (std::size_t c = 0; c < sums.options.size(); ++c) keys[i] += sums.options[c][all.mount(combinations[i], c)];
  }
  return keys;
}

}  // namespace trivet::study
