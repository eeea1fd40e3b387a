#include "farm/recipe/permutation.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace saccade::farm {
namespace {

TEST(Permutation, GivesEachPlaceOnce) {
  for (const std::uint64_t count : {1u, 2u, 3u, 4u, 5u, 16u, 17u, 1000u, 1024u, 1025u}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t place = shuffled(i, count, 3);
      EXPECT_LT(place, count);
      places.insert(place);
    }
    EXPECT_EQ(places.size(), count);
  }
}

// Of 1000 numbers, the first hundred places have about ten of each hundred. The sum of squares over the
// expected count is chi-square with 9 degrees of freedom. It is beyond 34 once in 10,000.
TEST(Permutation, MixesWell) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    std::vector<int> from(10);
    for (std::uint64_t i = 0; i < 1000; ++i)
      if (shuffled(i, 1000, seed) < 100) ++from[i / 100];
    double chi_square = 0;
    for (const int count : from) chi_square += (count - 10.0) * (count - 10.0) / 10;
    EXPECT_LT(chi_square, 34);
    EXPECT_GT(chi_square, 0.5);  // a plain shift would be even
  }
}

TEST(Permutation, DependsOnTheSeed) {
  int same = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) same += shuffled(i, 1000, 1) == shuffled(i, 1000, 2);
  EXPECT_LT(same, 20);
}

}  // namespace
}  // namespace saccade::farm
