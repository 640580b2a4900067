// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <set>

#include "trivet/study/shared/item_order.h"

namespace trivet {
namespace item_order_test {

using study::ItemOrder;

/// The items that a process takes one after another from a part, none of which it or others finish.
std::vector<std::size_t> taken(ItemOrder& order, std::uint64_t owner, std::size_t spared, std::size_t most) {
  std::vector<std::size_t> items;
  while (items.size() < most) {
    const auto item = order.of(owner, spared);
    if (!item) break;
    order.note_taken(*item);
    items.push_back(*item);
  }
  return items;
}

TEST(ItemOrder, TakesOwnItemsFromTheFirst) {
  ItemOrder order(10, {2, 4});  // 1, 5, 9
  order.note_found(5);
  EXPECT_EQ(order.own(), 1);
  order.note_taken(1);
  EXPECT_EQ(order.own(), 9);
  order.note_taken(9);
  EXPECT_EQ(order.own(), std::nullopt);
  EXPECT_EQ(order.missing(), 9);
  EXPECT_FALSE(order.is_over());
}

TEST(ItemOrder, LeavesWhatARunningOwnerComputes) {
  ItemOrder order(10, {1, 2});
  order.note_found(1);  // of 1, 3, 5, 7, 9 the owner computes 3 and 5
  EXPECT_THAT(taken(order, 2, 2, 10), testing::ElementsAre(9, 7));
  EXPECT_THAT(taken(order, 2, 0, 10), testing::ElementsAre(5, 3));
}

TEST(ItemOrder, HelpersOfAStoppedPartComputeDifferentItems) {
  for (const std::uint64_t parts : {3, 4, 8})
    for (const std::size_t count : {1UL, 7UL, 64UL, 1000UL}) {
      std::set<std::size_t> all;
      const std::size_t of_owner = (count + parts - 1) / parts, share = of_owner / (parts - 1);
      for (std::uint64_t number = 2; number <= parts; ++number) {
        ItemOrder order(count, {number, parts});
        for (const std::size_t item : taken(order, 1, 0, share)) EXPECT_TRUE(all.insert(item).second) << item;
        EXPECT_EQ(taken(order, 1, 0, count).size(), of_owner - share);  // and then all others
      }
    }
}

}  // namespace item_order_test
}  // namespace trivet
