// SPDX-License-Identifier: MIT
//
// Small tools of the core: loops in slices, a queue, a sort, draws, and numbers in messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>
#include <regex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/bucket_queue.h"
#include "base/number_text.h"
#include "base/random.h"
#include "base/sliced_loop.h"
#include "base/sorting.h"

namespace gvd {
namespace {

TEST(NumberText, IsThatOfSevenSignificantDigits) {
  for (const double number :
       {0.0,           1.0,        -1.0,      10.0,      0.25,       -0.1,  1.25,    99.5,
        1234567.0,     12345678.0, 9999999.4, 9999999.6, 1e-3,       1e-4,  1.5e-5,  -1e-9,
        9.99999996e-5, 1.0000011,  3e6,       1.5e9,     6.02214e23, 1e300, 2.5e-300}) {
    char expected[64];
    std::snprintf(expected, sizeof expected, "%.7g", number);
    EXPECT_EQ(numberText(number), std::regex_replace(expected, std::regex("e([+-])0"), "e$1"));
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(numberText(infinity), "Infinity");
  EXPECT_EQ(numberText(-infinity), "-Infinity");
  EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "NaN");
}

TEST(DrawIndex, FindsPositiveValuesEvenIfTheirSumIsSubnormal) {
  std::mt19937_64 random(1);
  const std::vector<double> sums = cumulative(std::vector<double>{0, 5e-324, 0});
  for (int i = 0; i < 100; ++i) EXPECT_EQ(drawIndex(random, sums), 1);
}

TEST(SlicedLoop, TakesABudgetThatIsOverdrawnForOneThatIsUsedUp) {
  SlicedLoop loop;
  std::vector<int> visited;
  long budget = -5;
  EXPECT_FALSE(loop.run(4, budget, 2, [&](int i) { visited.push_back(i); }));
  EXPECT_EQ(budget, -5);
  budget = 1;
  EXPECT_FALSE(loop.run(4, budget, 2, [&](int i) { visited.push_back(i); }));
  budget = 1;
  EXPECT_TRUE(loop.run(4, budget, 2, [&](int i) { visited.push_back(i); }));
  EXPECT_EQ(visited, (std::vector<int>{0, 1, 2, 3}));
}

TEST(BucketQueue, GivesItemsByDistanceAndThoseOfABucketAsTheyCame) {
  BucketQueue queue(10);
  const auto add = [&](int item, double distance) { queue.add(item, queue.bucketOf(distance)); };
  const auto takeAll = [&] {
    std::vector<int> items;
    while (queue.advance()) {
      items.push_back(queue.take());
      if (items.back() == 3) {
        EXPECT_NEAR(queue.front(), 0.7, 1e-12);
        add(6, 0.2);  // before the rest of the current bucket
        add(9, 0.25);
        add(7, 0.75);
        add(8, 1e5);
      }
      if (items.back() == 9) add(10, 0.71);
    }
    return items;
  };
  for (int round = 0; round < 2; ++round) {
    add(1, 0.71);
    add(2, 3e4);  // most buckets before this one have no items
    add(3, 0.72);
    add(4, 0.05);
    add(5, 6.35);  // bucket 63, the last of the first 64
    EXPECT_EQ(takeAll(), (std::vector<int>{4, 1, 3, 6, 9, 7, 10, 5, 2, 8}));
    EXPECT_EQ(queue.front(), 0);
  }
}

TEST(BucketQueue, KnowsTheItemsAfterTheNext) {
  BucketQueue queue(1);
  for (int item = 0; item < 3; ++item) queue.add(item, 5);
  queue.add(3, 6);
  ASSERT_TRUE(queue.advance());
  EXPECT_EQ(queue.ahead(0), 0);
  EXPECT_EQ(queue.ahead(2), 2);
  EXPECT_EQ(queue.ahead(3), std::nullopt);
}

TEST(SortStably, SortsAsTheStandardLibraryDoes) {
  std::mt19937_64 random(1);
  for (const int count : {0, 1, 2, 3, 10, 1000}) {
    std::vector<std::pair<int, std::string>> items;
    for (int i = 0; i < count; ++i)
      items.emplace_back(static_cast<int>(random() % 20), std::to_string(i));
    const auto isBefore = [](const auto& a, const auto& b) { return a.first < b.first; };
    auto expected = items;
    std::stable_sort(expected.begin(), expected.end(), isBefore);
    sortStably(std::span(items), isBefore);
    EXPECT_EQ(items, expected);
  }
}

}  // namespace
}  // namespace gvd
