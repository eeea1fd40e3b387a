#include "eval/bench/arguments.h"

#include "scene/scratch.h"

namespace saccade::eval {
namespace {

// The errors for arguments that are not valid.
template <class Read, class Argument>
std::string faultOf(Read read, const Argument& argument) {
  try {
    read(argument);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "no fault";
}

void expectRange(const std::string& text, int first, int last) {
  const FrameRange range = parseFrameRange(text);
  EXPECT_EQ(range.first, first) << text;
  EXPECT_EQ(range.last, last) << text;
}

TEST(ParseFrameRange, IsARangeOrOneFrame) {
  expectRange("17:21", 17, 21);
  expectRange("3:3", 3, 3);
  expectRange("5", 5, 5);
  expectRange("1:1000000", 1, 1'000'000);
}

TEST(ParseFrameRange, NamesTheFlagAndWhatWouldBeValid) {
  for (const char* text :
       {"", ":", "0", "0:3", "3:2", "a", "3:", ":3", "1:2x", "1:2:3", " 1:2", "1: 2", "-1:2", "+1:2", "1.5",
        "1000001", "1:1000001", "1:99999999999999999999", "99999999999999999999"}) {
    const std::string fault = faultOf(parseFrameRange, text);
    for (const std::string part : {"--frames", "1 <= A <= B <= 1000000"}) expectContains(fault, part);
    EXPECT_TRUE(fault.ends_with("not " + std::string(text))) << fault;
  }
}

TEST(ParseSize, IsWidthAndHeight) {
  const Size size = parseSize("640x16384");
  EXPECT_EQ(size.width, 640);
  EXPECT_EQ(size.height, 16384);
}

TEST(ParseSize, NamesTheFlagAndWhatWouldBeValid) {
  for (const char* text : {"", "x", "640", "640x", "x480", "640x480x", "640X480", "640 x480", "0x480",
                           "640x-1", "640x16385", "99999999999999999999x1"}) {
    const std::string fault = faultOf(parseSize, text);
    for (const std::string part : {"--size", "from 1 to 16384"}) expectContains(fault, part);
    EXPECT_TRUE(fault.ends_with("not " + std::string(text))) << fault;
  }
}

TEST(FrameRange, HasAFirstHalf) {
  EXPECT_EQ(FrameRange({17, 21}).firstHalf().last, 19);
  EXPECT_EQ(FrameRange({21, 21}).firstHalf().last, 21);
  EXPECT_EQ(FrameRange({20, 21}).firstHalf().first, 20);
}

TEST(ParseSetting, IsAMethodAtItsPaths) {
  const Setting setting = parseSetting("--baselines", "svgf:as_falcor=1@4");
  EXPECT_EQ(setting.method.text, "svgf:as_falcor=1");
  EXPECT_EQ(setting.spp, 4);
  EXPECT_EQ(setting.text(), "svgf:as_falcor=1@4");
  const auto read = [](const std::string& text) { parseSetting("--baselines", text); };
  for (const char* text : {"svgf", "svgf@", "svgf@0", "svgf@2x", "@", "svgf@65537"})
    for (const std::string part : {"--baselines", "METHOD@SPP", text})
      expectContains(faultOf(read, text), part);
  expectContains(faultOf(read, "event_svgf@3"), "event_svgf@3: the paths must be even");
  expectContains(faultOf(read, "svfg@2"), "svgf");  // what there is
}

TEST(CheckSpp, RefusesPathsThatTwoPassesCannotShare) {
  for (const int spp : {1, 2, 3}) EXPECT_NO_THROW(checkSpp(parseMethod("pt"), spp));
  const MethodSpec method = parseMethod("event_svgf:alpha=0.2");
  EXPECT_NO_THROW(checkSpp(method, 2));
  const std::string fault = faultOf([](const MethodSpec& m) { checkSpp(m, 3); }, method);
  for (const std::string part : {"--spp", "even", "event_svgf:alpha=0.2", "not 3"})
    expectContains(fault, part);
}

TEST(CheckOutputFile, NamesTheFormatsAndRefusesAMissingFolder) {
  const std::string folder = testing::TempDir();
  EXPECT_NO_THROW(checkOutputFile(folder + "x.exr", {".exr", ".png"}));
  EXPECT_NO_THROW(checkOutputFile("x.png", {".exr", ".png"}));
  const auto of = [](const std::string& path) {
    return faultOf([](const std::string& p) { checkOutputFile(p, {".exr", ".png"}); }, path);
  };
  for (const char* path : {"x.foo", "x", ".exr"}) expectContains(of(path), "known are .exr, .png");
  expectContains(of(folder + "no-such-folder/x.exr"), "no-such-folder");
}

TEST(ParseTolerance, IsAPercentage) {
  EXPECT_DOUBLE_EQ(parseTolerance("2%"), 0.02);
  EXPECT_DOUBLE_EQ(parseTolerance("0.5%"), 0.005);
  EXPECT_DOUBLE_EQ(parseTolerance("100%"), 1);
  for (const char* text : {"2", "%", "0%", "-1%", "100.1%", "nan%", "2%%", " 2%", "2 %"})
    EXPECT_THROW(parseTolerance(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace saccade::eval
