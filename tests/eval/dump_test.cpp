#include "eval/bench/dump.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "eval/pictures/exr.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

ReferenceChange makeReference() {
  ReferenceFrame prev(2, 1), cur(2, 1);
  prev.a.fill(1), prev.b.fill(2), cur.a.fill(4), cur.b.fill(3);
  return {prev, cur};
}

struct DumpTest : testing::Test {
  Scratch files;
  std::string folder = files.path("dump"), other = files.path("other");
};

TEST_F(DumpTest, OfAReferenceHasItsHalves) {
  writeReference(folder, 21, makeReference());
  const IntensityChange whole = readChange(folder, 21);
  EXPECT_EQ(whole.dI.at(1, 0), 2);
  EXPECT_EQ(whole.I_prev.at(1, 0), 1.5);
  const auto halves = readHalves(folder, 21);
  ASSERT_TRUE(halves);
  EXPECT_EQ(halves->a.dI.at(1, 0), 3);
  EXPECT_EQ(halves->a.I_prev.at(1, 0), 1);
  EXPECT_EQ(halves->b.dI.at(1, 0), 1);
  EXPECT_EQ(halves->b.I_prev.at(1, 0), 2);
}

TEST_F(DumpTest, OfAMethodHasNoHalvesNotEvenThoseOfAReferenceBefore) {
  writeReference(folder, 21, makeReference());
  writeChange(folder, 21, makeReference().change);
  EXPECT_FALSE(readHalves(folder, 21));
  EXPECT_EQ(readChange(folder, 21).dI.at(0, 0), 2);
}

TEST_F(DumpTest, HasTheFeaturesUnderTheirNames) {
  GBuffer g(2, 1);
  g.albedo.fill(0.5f), g.emission.fill(3), g.nx.fill(0.1f), g.ny.fill(0.2f), g.nz.fill(0.3f), g.z.fill(7);
  writeFeatures(folder, 4, g);
  const ExrPicture picture = readExr(folder + "/features_00004.exr");
  const std::map<std::string, float> wanted{{"albedo", 0.5f},   {"emission", 3},    {"normal.x", 0.1f},
                                            {"normal.y", 0.2f}, {"normal.z", 0.3f}, {"Z", 7}};
  ASSERT_EQ(picture.planes.size(), wanted.size());
  for (const auto& [name, value] : wanted) EXPECT_EQ(picture.planes.at(name).at(1, 0), value) << name;
}

TEST_F(DumpTest, FramesInCommonAreSorted) {
  for (const int frame : {7, 100000, 3}) writeChange(folder, frame, makeReference().change);
  for (const int frame : {100000, 8, 7}) writeChange(other, frame, makeReference().change);
  std::ofstream(folder + "/dI_7.exr"), std::ofstream(other + "/dI_7.exr");  // no file of a dump
  EXPECT_EQ(commonFrames(folder, other), (std::vector{7, 100000}));
}

TEST_F(DumpTest, FaultsNameTheFile) {
  writeReference(folder, 1, makeReference());
  const auto fault = [&](auto act) -> std::string {
    try {
      act();
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "none";
  };
  std::filesystem::create_directories(other);
  expectContains(fault([&] { commonFrames(folder, other); }), other);
  std::filesystem::copy_file(folder + "/dI_00001.exr", other + "/halves_00001.exr");
  expectContains(fault([&] { readHalves(other, 1); }), "halves_00001.exr has no channel ");
  std::filesystem::rename(folder + "/halves_00001.exr", folder + "/dI_00001.exr");
  expectContains(fault([&] { readChange(folder, 1); }), "dI_00001.exr has no channel Y");
}

}  // namespace
}  // namespace saccade::eval
