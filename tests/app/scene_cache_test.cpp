#include "app/streams/scene_cache.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "app/admission/limits.h"

namespace saccade {
namespace {

constexpr const char *kFirst = "cornell-box", *kSecond = "cornell-bunny", *kThird = "textured-cornell-box";
const std::string kFolder = SACCADE_SOURCE_DIR "/scenes";

class SceneMemory : public testing::Test {
 protected:
  SceneMemory() { spdlog::set_level(spdlog::level::warn); }

  static std::uint64_t bytesOf(const std::vector<std::string>& names) {
    SceneCache all(kFolder);
    for (const auto& name : names) all.get(name);
    return all.bytes();
  }
  static Limits bounded(double bytes) {
    Limits limits;
    limits[Limit::kScenes] = bytes / (1 << 20);
    return limits;
  }
};

TEST_F(SceneMemory, TheLeastRecentlyUsedMakesRoom) {
  SceneCache scenes(kFolder, bounded(static_cast<double>(bytesOf({kFirst, kSecond, kThird}) - 1)));
  for (const char* name : {kFirst, kSecond, kFirst}) scenes.get(name);
  EXPECT_EQ(scenes.loads().done, 2u);
  scenes.get(kThird);
  EXPECT_EQ(scenes.loads().evicted, 1u);
  EXPECT_EQ(scenes.bytes(), bytesOf({kFirst, kThird}));
  scenes.get(kFirst);
  EXPECT_EQ(scenes.loads().done, 3u);  // it was still there
}

TEST_F(SceneMemory, WhatIsInUseStays) {
  const std::uint64_t both = bytesOf({kFirst, kSecond});
  SceneCache scenes(kFolder, bounded(static_cast<double>(both - 1)));
  auto used = scenes.get(kFirst);
  try {
    scenes.get(kSecond);
    FAIL();
  } catch (const LimitReached& reached) {
    EXPECT_EQ(reached.limit, "scenes");
    EXPECT_EQ(reached.field, "scene");
    EXPECT_GT(reached.retry_after_s, 0);
  }
  EXPECT_EQ(scenes.get(kFirst), used);
  used.reset();
  EXPECT_NE(scenes.get(kSecond), nullptr);
  EXPECT_EQ(scenes.bytes(), bytesOf({kSecond}));
}

TEST_F(SceneMemory, CountsASceneWithoutPartsToo) {
  SceneCache scenes(kFolder, bounded(static_cast<double>(bytesOf({kThird}) * 3 / 2)));
  EXPECT_THROW(scenes.get(kThird, {SceneFeature::kMipFiltering}), LimitReached);
}

// And no other scene is evicted for it.
TEST_F(SceneMemory, WhatNeverFitsIsRefusedForGood) {
  SceneCache scenes(kFolder, bounded(static_cast<double>(bytesOf({kFirst}))));
  scenes.get(kFirst);
  try {
    scenes.get(kSecond);
    FAIL();
  } catch (const LimitReached& reached) {
    EXPECT_EQ(reached.retry_after_s, 0);
  }
  EXPECT_EQ(scenes.loads().evicted, 0u);
}

}  // namespace
}  // namespace saccade
