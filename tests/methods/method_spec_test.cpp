#include "methods/method_spec.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace saccade {
namespace {

TEST(MethodSpec, ReadsNameAndSettings) {
  const MethodSpec spec = parseMethod("event_svgf:alpha=0.25:iterations=3");
  EXPECT_EQ(spec.name, "event_svgf");
  EXPECT_EQ(spec.text, "event_svgf:alpha=0.25:iterations=3");
  EXPECT_EQ(spec.params.at("alpha"), 0.25);
  EXPECT_EQ(spec.params.at("sigma_n"), 128);
}

TEST(MethodSpec, KnowsWhichBudgetsWork) {
  EXPECT_FALSE(parseMethod("event_svgf").takes(1));
  EXPECT_TRUE(parseMethod("event_svgf").takes(2));
  EXPECT_TRUE(parseMethod("svgf").takes(1));
}

TEST(MethodSpec, NamesWhatIsWrong) {
  for (const char* text :
       {"", "nothing", "svgf:alpha", "svgf:alpha=", "svgf:alpha=x", "svgf:alpha=7", "svgf:beta=1"}) {
    EXPECT_THROW(parseMethod(text), std::runtime_error) << text;
  }
  try {
    parseMethod("svgf:alpha=7");
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find("alpha"), std::string::npos) << fault.what();
  }
}

}  // namespace
}  // namespace saccade
