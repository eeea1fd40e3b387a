#include "app/stores/scene_cache.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <thread>

#include "app/admission/limits.h"
#include "render/world/render_scene.h"
#include "scene/scratch.h"

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

TEST_F(SceneMemory, ScenesInUseStay) {
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

TEST_F(SceneMemory, TellsWhatIsInUse) {
  SceneCache scenes(kFolder);
  scenes.get(kSecond);
  auto used = scenes.get(kFirst);
  EXPECT_EQ(scenes.inUse().bytes, bytesOf({kFirst}));
  EXPECT_EQ(scenes.inUse().variants, 0);
  const auto simplified = scenes.vary(kFirst, used, {{SceneFeature::kTextures}});
  EXPECT_GT(scenes.inUse().bytes, bytesOf({kFirst}));
  EXPECT_EQ(scenes.inUse().variants, 1);
  used.reset();
  EXPECT_EQ(scenes.inUse().variants, 1);
  EXPECT_GT(scenes.bytes(), scenes.inUse().bytes);
}

TEST_F(SceneMemory, CountsASceneWithoutPartsToo) {
  SceneCache scenes(kFolder, bounded(static_cast<double>(bytesOf({kThird}) * 3 / 2)));
  const auto whole = scenes.get(kThird);
  EXPECT_THROW(scenes.vary(kThird, whole, {{SceneFeature::kMipFiltering}}), LimitReached);
}

// And no other scene is evicted for it.
TEST_F(SceneMemory, ASceneThatNeverFitsIsRefusedForGood) {
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

TEST_F(SceneMemory, ASimplifiedSceneIsBuiltOnceForEachVersionOfTheWhole) {
  SceneCache scenes(kFolder);
  auto whole = scenes.get(kThird);
  EXPECT_EQ(scenes.vary(kThird, whole, {}), whole);
  const SceneFeatures disabled{SceneFeature::kTextures};
  const auto simplified = scenes.vary(kThird, whole, {disabled});
  EXPECT_NE(simplified, whole);
  EXPECT_TRUE(simplified->description().textures.empty());
  EXPECT_EQ(scenes.vary(kThird, whole, {disabled}), simplified);
  SceneCache other(kFolder);
  EXPECT_NE(scenes.vary(kThird, other.get(kThird), {disabled}), simplified);  // of another version
}

TEST_F(SceneMemory, ASceneWithBodiesIsAVariantByTheirNames) {
  SceneCache scenes(kFolder);
  const auto whole = scenes.get(kThird);
  const SceneVariant moving{{}, {"tall_block"}}, plain{{SceneFeature::kTextures}, {"tall_block"}};
  const auto scene = scenes.vary(kThird, whole, moving);
  ASSERT_EQ(scene->description().bodies.size(), 1u);
  EXPECT_EQ(scene->description().bodies[0].name, "tall_block");
  EXPECT_TRUE(whole->description().bodies.empty());
  EXPECT_EQ(scenes.vary(kThird, whole, moving), scene);
  EXPECT_NE(scenes.vary(kThird, whole, {{}, {"light"}}), scene);
  const auto both = scenes.vary(kThird, whole, plain);
  EXPECT_TRUE(both->description().textures.empty());
  EXPECT_EQ(both->description().bodies.size(), 1u);
  EXPECT_NE(scenes.vary(kThird, whole, {{SceneFeature::kTextures}}), both);
}

TEST_F(SceneMemory, ScenesWithBodiesAreBoundedAsSimplifiedOnesAre) {
  Limits limits;
  limits[Limit::kReducedScenes] = 1;
  SceneCache scenes(kFolder, limits);
  const auto whole = scenes.get(kFirst);
  auto used = scenes.vary(kFirst, whole, {{}, {"tall_block"}});
  EXPECT_EQ(scenes.inUse().variants, 1);
  try {
    scenes.vary(kFirst, whole, {{}, {"light"}});
    FAIL();
  } catch (const LimitReached& reached) {
    EXPECT_EQ(reached.field, "objects");
  }
  used.reset();
  EXPECT_NE(scenes.vary(kFirst, whole, {{}, {"light"}}), nullptr);
  EXPECT_EQ(scenes.loads().evicted, 1u);
}

TEST_F(SceneMemory, SimplifiedScenesThatAreInUseAreBounded) {
  Limits limits;
  limits[Limit::kReducedScenes] = 1;
  SceneCache scenes(kFolder, limits);
  const auto whole = scenes.get(kThird);
  auto used = scenes.vary(kThird, whole, {{SceneFeature::kTextures}});
  EXPECT_THROW(scenes.vary(kThird, whole, {{SceneFeature::kMipFiltering}}), LimitReached);
  used.reset();
  EXPECT_NE(scenes.vary(kThird, whole, {{SceneFeature::kMipFiltering}}), nullptr);
  EXPECT_EQ(scenes.loads().evicted, 1u);
}

TEST_F(SceneMemory, WholeScenesAreNoSimplifiedOnes) {
  Limits limits;
  limits[Limit::kReducedScenes] = 0;
  SceneCache scenes(kFolder, limits);
  EXPECT_NE(scenes.get(kFirst), nullptr);
  EXPECT_THROW(scenes.vary(kFirst, scenes.get(kFirst), {{SceneFeature::kTextures}}), LimitReached);
}

TEST_F(SceneMemory, ThreadsThatAskAtOnceShareOneLoad) {
  SceneCache scenes(kFolder);
  std::vector<SceneCache::ScenePtr> got(4);
  {
    std::vector<std::jthread> threads;
    for (auto& one : got) threads.emplace_back([&] { one = scenes.get(kFirst); });
  }
  EXPECT_EQ(scenes.loads().done, 1u);
  for (const auto& one : got) EXPECT_EQ(one, got[0]);
}

// A folder with one scene of one mesh.
class SceneNotes : public testing::Test {
 protected:
  SceneNotes() { spdlog::set_level(spdlog::level::warn); }

  void writeMesh(const std::string& text) { files_.write("mine/a.obj", text); }
  const Scratch files_;
  const std::string file_ =
      files_.write("mine/scene.xml",
                   "<scene><sensor type='perspective'><float name='fov' value='40'/></sensor>"
                   "<shape type='obj'><string name='filename' value='a.obj'/></shape></scene>");
  SceneCache scenes_{files_.path("")};
};

TEST_F(SceneNotes, KeepTheReasonOfAFailureUntilTheSceneLoads) {
  EXPECT_EQ(scenes_.note("mine").failure, "");
  writeMesh("v 0 0\n");
  for (int attempt = 0; attempt < 2; ++attempt) EXPECT_THROW(scenes_.get("mine"), SceneError);
  EXPECT_NE(scenes_.note("mine").failure.find("a.obj:1: "), std::string::npos)
      << scenes_.note("mine").failure;
  EXPECT_EQ(scenes_.loads().failed, 2u);
  writeMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_NE(scenes_.get("mine"), nullptr);
  EXPECT_EQ(scenes_.note("mine").failure, "");
  EXPECT_NE(scenes_.note("mine").stats, "");
}

TEST_F(SceneNotes, WarnOfWhatThePictureLacks) {
  writeMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl brown\nf 1 2 3\n");
  scenes_.get("mine");
  const std::string stats = scenes_.note("mine").stats;
  expectContains(stats, "; warning: " + files_.path("mine/a.obj") + ": its materials (usemtl) are not read");
  expectContains(stats, "; warning: the scene has no light");
}

TEST_F(SceneNotes, AreOfTheFileAsItIsNow) {
  writeMesh("v 0 0\n");
  EXPECT_THROW(scenes_.get("mine"), SceneError);
  std::filesystem::last_write_time(file_, std::filesystem::last_write_time(file_) + std::chrono::seconds(1));
  EXPECT_EQ(scenes_.note("mine").failure, "");
}

TEST_F(SceneNotes, AChangedFileIsAnotherScene) {
  writeMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto before = scenes_.get("mine");
  EXPECT_EQ(scenes_.get("mine"), before);
  std::filesystem::last_write_time(file_, std::filesystem::last_write_time(file_) + std::chrono::seconds(1));
  EXPECT_NE(scenes_.get("mine"), before);
}

}  // namespace
}  // namespace saccade
