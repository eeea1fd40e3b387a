// Streams that do without parts of a scene's model, by name or by what the events need.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "app/admission/limits.h"
#include "app/request/resolve.h"
#include "base/cpu_name.h"
#include "mock/bad_request.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

const std::string kBox = "cornell-box", kTextured = "textured-cornell-box";

class Simplification : public testing::Test {
 protected:
  std::string table(const std::string& cpu = cpuName()) const {
    return files_.write("simplification.csv",
                        "# cpu=\"" + cpu + "\" size=64x48 threshold=0.2\n" +
                            "scene,bounces,disabled,cpu_ms,false_events,missed_events,changed,noise\n" +
                            kTextured + ",3,,20,0,0,0,0\n" + kTextured + ",2,,16,0.01,0.01,0.02,0\n" +
                            kTextured + ",2,textures+mip_filtering,12,0.1,0.1,0.25,0\n" + kTextured +
                            ",0,textures+mip_filtering,8,0.4,0.2,0.75,0\n");
  }
  const std::string settings_ = "cpu=\"" + cpuName() + "\" size=64x48 threshold=0.2";

 private:
  const Scratch files_;
};

v1::OpenStream textured() {
  v1::OpenStream request = tinyRequest();
  request.set_scene(kTextured);
  return request;
}
v1::OpenStream needing(double tolerance) {
  v1::OpenStream request = textured();
  request.mutable_quality()->set_max_event_change(tolerance);
  return request;
}
v1::OpenStream without(std::initializer_list<const char*> parts) {
  v1::OpenStream request = textured();
  for (const char* part : parts) request.mutable_quality()->add_disabled_features(part);
  return request;
}

std::vector<std::string> leftOut(const v1::StreamOpened& opened) {
  const auto& names = opened.resolved().quality().disabled_features();
  return {names.begin(), names.end()};
}

constexpr auto kInvalid = v1::CODE_INVALID_ARGUMENT;
const auto kNothing = [](v1::OpenStream&) {};

// clang-format off
const std::vector<BadRequest> kBadSimplifications{
    {needing(0), kNothing, kInvalid, "quality.max_event_change", "0 is outside"},
    {needing(1.01), kNothing, kInvalid, "quality.max_event_change", "1.01 is outside"},
    {needing(std::numeric_limits<double>::quiet_NaN()), kNothing, kInvalid, "quality.max_event_change", "nan"},
    {needing(0.1), [](auto& r) { r.mutable_quality()->set_budget_ms(5); }, kInvalid, "quality.max_event_change", "not both"},
    {needing(0.1), [](auto& r) { r.mutable_quality()->set_max_false_rate(1); }, kInvalid, "quality.max_event_change", "not both"},
    {needing(0.1), [](auto& r) { r.mutable_quality()->set_bounces(3); }, kInvalid, "quality.bounces", "leave it out"},
    {needing(0.1), [](auto& r) { r.mutable_quality()->add_disabled_features("masks"); }, kInvalid, "quality.disabled_features", "leave it out"},
    {needing(0.1), [](auto& r) { r.set_scene(kBox); }, v1::CODE_UNAVAILABLE, "quality.max_event_change", "measured are: " + kTextured + "; `saccade-eval simplification`"},
    {without({"textures", "wings"}), kNothing, kInvalid, "quality.disabled_features[1]",
     "textures, specular, bump_maps, masks, environment, mip_filtering"},
};
// clang-format on

TEST_F(Simplification, ABadOneIsRefusedWithItsField) {
  TestServer server(1, {}, {}, table());
  expectRefused(server, kBadSimplifications);
}

TEST_F(Simplification, TheFastestThatKeepsThemIsChosenAndTold) {
  TestServer server(1, {}, {}, table());
  const auto bounces = [&](double tolerance) {
    return server.client().open(needing(tolerance)).resolved().quality().bounces();
  };
  EXPECT_EQ(bounces(0.019), 3u);
  EXPECT_EQ(bounces(0.02), 2u);
  EXPECT_EQ(bounces(1), 0u);
  const v1::StreamOpened opened = server.client().open(needing(0.3));
  EXPECT_FALSE(opened.resolved().quality().has_max_event_change());
  EXPECT_EQ(leftOut(opened), (std::vector<std::string>{"textures", "mip_filtering"}));
  EXPECT_EQ(opened.simplification().model(), "2 bounces, without textures, mip_filtering");
  EXPECT_DOUBLE_EQ(opened.simplification().changed(), 0.25);
  EXPECT_DOUBLE_EQ(opened.simplification().time(), 12 / 20.0);
  EXPECT_EQ(opened.simplification().measured_on(), settings_);
  EXPECT_FALSE(server.client().open(textured()).has_simplification());
}

TEST_F(Simplification, GiveTheEventsOfTheRequestTheyResolveTo) {
  TestServer server(2, {}, {}, table());
  const std::string bytes = comparableBytes(server.run(needing(0.3))[0]);
  v1::OpenStream same = without({"mip_filtering", "textures"});
  same.mutable_quality()->set_bounces(2);
  EXPECT_EQ(bytes, comparableBytes(server.run(same)[0]));
  EXPECT_EQ(bytes, comparableBytes(server.run(server.client().open(needing(0.3)).resolved())[0]));
  same.mutable_quality()->clear_disabled_features();
  EXPECT_NE(bytes, comparableBytes(server.run(same)[0]));
}

TEST_F(Simplification, ArePartOfAFeedOnlyByWhatTheyLeaveOut) {
  const SceneEntry scene = SceneLibrary(SACCADE_SOURCE_DIR "/scenes").find("cornell-box").value();
  const MeasuredTables tables{openAccuracySource({}), openSimplificationSource(table())};
  const auto key = [&](const v1::OpenStream& r) { return resolve(r, scene, tables).feedKey(); };
  v1::OpenStream same = without({"textures", "mip_filtering"});
  same.mutable_quality()->set_bounces(2);
  EXPECT_EQ(key(needing(0.3)), key(same));
  EXPECT_EQ(key(needing(0.4)), key(same));
  EXPECT_NE(key(needing(0.02)), key(same));
  EXPECT_EQ(key(without({"mip_filtering", "textures", "textures"})),
            key(without({"textures", "mip_filtering"})));
  EXPECT_NE(key(without({"textures"})), key(textured()));
}

TEST_F(Simplification, AFeatureThatTheSceneLacksIsNotLeftOut) {
  TestServer server(1);
  EXPECT_EQ(leftOut(server.client().open(without({"masks", "textures", "specular"}))),
            std::vector<std::string>{"textures"});
}

TEST_F(Simplification, ScenesAreSharedByThePartsTheyDoWithout) {
  SceneCache scenes(SACCADE_SOURCE_DIR "/scenes");
  const auto get = [&](const std::string& name, const SceneFeatures& disabled) {
    return scenes.vary(name, scenes.get(name), {disabled});
  };
  const auto plain = get(kTextured, {SceneFeature::kTextures});
  EXPECT_EQ(get(kTextured, {SceneFeature::kTextures}), plain);
  EXPECT_EQ(get(kTextured, {}), scenes.get(kTextured));
  EXPECT_NE(get(kTextured, {SceneFeature::kMipFiltering}), plain);
  EXPECT_NE(get(kBox, {SceneFeature::kTextures}), plain);
}

TEST_F(Simplification, OnlySoManySimplifiedScenesAreInMemory) {
  constexpr unsigned kMost = 3;
  Limits limits;
  limits[Limit::kReducedScenes] = kMost;
  SceneCache scenes(SACCADE_SOURCE_DIR "/scenes", limits);
  const auto setOf = [](unsigned bits) {
    SceneFeatures parts;
    for (const SceneFeatureInfo& info : featureTable())
      if (bits & (1u << static_cast<unsigned>(info.feature))) parts.insert(info.feature);
    return parts;
  };
  const auto whole = scenes.get(kBox);
  const auto get = [&](const SceneFeatures& disabled) { return scenes.vary(kBox, whole, {disabled}); };
  std::vector<SceneCache::ScenePtr> in_use;
  for (unsigned bits = 1; bits <= kMost; ++bits) in_use.push_back(get(setOf(bits)));
  const SceneFeatures next = setOf(kMost + 1);
  EXPECT_THROW(get(next), LimitReached);
  EXPECT_EQ(get(setOf(1)), in_use[0]);
  in_use.pop_back();
  EXPECT_NE(get(next), nullptr);
}

TEST_F(Simplification, TheServerTellsWhetherItHasThem) {
  TestServer server(1, {}, {}, table());
  const v1::ServerDescription told = server.client().server();
  EXPECT_EQ(told.simplification().unavailable(), "");
  EXPECT_EQ(told.simplification().measured_on(), settings_);
  ASSERT_EQ(told.simplification().scenes_size(), 1);
  EXPECT_EQ(told.simplification().scenes(0), kTextured);
  ASSERT_EQ(told.scene_features_size(), static_cast<int>(featureTable().size()));
  EXPECT_EQ(told.scene_features(0).name(), "textures");
}

TEST_F(Simplification, WithoutATableOrWithOneOfAnotherProcessorThereAreNone) {
  for (const auto& [path, why] : {std::pair{std::string(), std::string("no simplification table")},
                                  {table("Zilog Z80"), "Zilog Z80, not "}}) {
    TestServer server(1, {}, {}, path);
    const v1::Status status = server.client().tryOpen(needing(0.1));
    EXPECT_EQ(status.code(), v1::CODE_UNAVAILABLE);
    EXPECT_EQ(status.field(), "quality.max_event_change");
    EXPECT_NE(status.message().find(why), std::string::npos) << status.message();
    EXPECT_NE(status.message().find("`saccade-eval simplification`"), std::string::npos) << status.message();
    EXPECT_EQ(server.client().server().simplification().unavailable(), status.message());
  }
}

TEST_F(Simplification, ASceneThatIsLoadedSaysWhatItNeeds) {
  TestServer server(1);
  const auto needs = [&](const std::string& scene) {
    v1::Request request;
    request.mutable_list_scenes();
    const v1::Reply reply = server.client().call(request);
    for (const v1::SceneInfo& info : reply.list_scenes().scenes())
      if (info.name() == scene) return info.stats();
    return std::string("absent");
  };
  EXPECT_EQ(needs(kTextured), "");
  server.client().open(textured());
  expectContains(needs(kTextured), "1 texture");
  EXPECT_EQ(needs(kBox), "");
}

}  // namespace
}  // namespace saccade
