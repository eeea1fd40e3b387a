#include "eval/bench/compared_methods.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "methods/method_spec.h"

namespace saccade::eval {
namespace {

TEST(ComparedMethods, AreAllOfTheTableAndSvgfTwice) {
  const std::vector<std::string> compared = comparedMethods();
  EXPECT_EQ(compared.size(), methodTable().size() + 1);
  for (const MethodInfo& method : methodTable())
    EXPECT_EQ(std::count(compared.begin(), compared.end(), method.name), 1) << method.name;
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "svgf:as_falcor=1"), 1);
}

// The difference has a tolerance in event_svgf, not in svgf; path tracing has none at all.
TEST(LuminanceSweep, SetsEveryToleranceThatAMethodHas) {
  const std::vector<std::string> sweep = luminanceSweep({"1", "40"});
  for (const char* text : {"event_svgf:sigma_l=1:sigma_l_diff=1", "event_svgf:sigma_l=40:sigma_l_diff=40",
                           "svgf:sigma_l=1", "svgf:sigma_l=40"})
    EXPECT_EQ(std::count(sweep.begin(), sweep.end(), text), 1) << text;
  for (const std::string& text : sweep) {
    EXPECT_NO_THROW(parseMethod(text)) << text;
    EXPECT_NE(parseMethod(text).name, "pt");
  }
}

}  // namespace
}  // namespace saccade::eval
