#include "base/names.h"

#include <gtest/gtest.h>

#include <set>

namespace saccade {
namespace {

struct Row {
  const char* name;
  int value;
};
const std::vector<Row> kTable{{"one", 1}, {"two", 2}, {"two", 3}};

TEST(Names, AreJoinedInTheirOrder) {
  EXPECT_EQ(joinNames(std::vector<std::string>{"b", "a"}), "b, a");
  EXPECT_EQ(joinNames(std::set<std::string>{"b", "a"}), "a, b");
  EXPECT_EQ(joinRowNames(kTable), "one, two, two");
  EXPECT_EQ(joinRowNames(std::vector<Row>{}), "none");
}

TEST(Names, FindTheFirstRow) {
  EXPECT_EQ(findRow(kTable, "two"), &kTable[1]);
  EXPECT_EQ(findRow(kTable, "tw"), nullptr);
}

}  // namespace
}  // namespace saccade
