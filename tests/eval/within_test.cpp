#include "eval/bench/within.h"

#include <gtest/gtest.h>

namespace saccade::eval {
namespace {

AccuracyTable table() {
  AccuracyTable t;
  t.width = 100, t.height = 50, t.threshold = 0.2;
  t.rows = {{"box", parseMethod("svgf:as_falcor=1"), 4, 18.25, 0.0125, 0.25},
            {"box", parseMethod("pt"), 1, 4, 0.5, 0.125, 3, 1},  // by its own size and frames
            {"ball", parseMethod("pt"), 1, 30, 0.75, 0.25}};
  return t;
}

TEST(Within, ReadsMillisecondsAndPercent) {
  EXPECT_EQ(parseWithin("20ms").budget_ms, 20);
  EXPECT_FALSE(parseWithin("20ms").max_false_rate);
  EXPECT_EQ(parseWithin("0.5ms").budget_ms, 0.5);
  EXPECT_EQ(parseWithin("2%").max_false_rate, 0.02);
  EXPECT_FALSE(parseWithin("2%").budget_ms);
  EXPECT_EQ(parseWithin("0%").max_false_rate, 0);
}

TEST(Within, NamesBothFormsOfALimit) {
  for (const char* text : {"", "20", "ms", "%", "20 ms", " 20ms", "20ms ", "20s", "2%%", "-1ms", "-2%",
                           "nanms", "infms", "inf%", "0x2ms", "2ms%"}) {
    try {
      parseWithin(text);
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& fault) {
      const std::string told = fault.what();
      EXPECT_NE(told.find("\"" + std::string(text) + "\""), std::string::npos) << told;
      EXPECT_NE(told.find("20ms"), std::string::npos) << told;
      EXPECT_NE(told.find("2%"), std::string::npos) << told;
    }
  }
}

TEST(Within, AnswersForEachScene) {
  EXPECT_EQ(answerWithin(table(), parseWithin("20ms")),
            "ball: nothing; the fastest setting here, pt at 1 spp, takes 30 ms\n"
            "box: svgf:as_falcor=1 at 4 spp: 18.2 ms, 0.0125 false and 0.25 missed events per pixel-frame\n");
  EXPECT_EQ(answerWithin(table(), parseWithin("50%")),
            "ball: nothing; the lowest rate here, of pt at 1 spp, is 0.75 false events per pixel-frame\n"
            "box: pt at 1 spp: 4 ms, 0.5 false and 0.125 missed events per pixel-frame\n");
}

}  // namespace
}  // namespace saccade::eval
