// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_prices.h"

#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::study {
namespace {

/// Adds up prices in the currency of the first one, and notes the mounts without a price in it.
class Adder {
 public:
  [[nodiscard]] double price(const std::optional<model::Price>& price, const std::string& mount) {
    if (price && currency.empty()) currency = price->currency;
    if (price && price->currency == currency) return price->amount;
    if (std::ranges::find(without_, mount) == without_.end()) without_.push_back(mount);
    return 0;
  }

  void refuse_missing() const {
    if (without_.empty()) return;
    throw foundation::InvalidInput("minimize = \"price\": no price" + (currency.empty() ? "" : " in " + currency) +
                                   " of " + foundation::comma_separated(without_) +
                                   "; add it to the catalogue, or let only mounts with a price take part");
  }

  std::string currency;

 private:
  std::vector<std::string> without_;
};

bool is_chosen(const MountCombinations& all, const std::string& element) {
  return std::ranges::any_of(all.choices(), [&](const project::MountChoice& choice) {
    return std::ranges::find(choice.elements, element) != choice.elements.end();
  });
}

}  // namespace

MountPrices::MountPrices(const MountCombinations& all, const project::Case& variant) : all_(all) {
  Adder adder;
  for (const model::Element& element : variant.system.elements())
    if (element.rating && !is_chosen(all, element.name))
      at_other_places_.amount += adder.price(element.rating->price, "element " + foundation::quoted(element.name));
  for (std::size_t c = 0; c < all.choices().size(); ++c) {
    const project::MountChoice& choice = all.choices()[c];
    std::vector<double>& prices = prices_.emplace_back();
    for (std::size_t m = 0; m < choice.mounts.size(); ++m) {
      double& price = prices.emplace_back(0);
      const model::System system = all.system_with(variant, c, m);
      for (const model::Element& element : system.elements())
        if (std::ranges::find(choice.elements, element.name) != choice.elements.end())
          price +=
              adder.price(element.rating ? element.rating->price : std::nullopt, foundation::quoted(choice.mounts[m]));
    }
  }
  adder.refuse_missing();
  at_other_places_.currency = adder.currency;
}

model::Price MountPrices::of(std::size_t combination) const {
  model::Price sum = at_other_places_;
  for (std::size_t c = 0; c < prices_.size(); ++c) sum.amount += prices_[c][all_.mount(combination, c)];
  return sum;
}

}  // namespace trivet::study
