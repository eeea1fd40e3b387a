#include <map>

#include "eval/bench/model_search.h"

#include <gtest/gtest.h>

namespace saccade::eval {
namespace {

const SceneModel kWhole{2, {}};

// A world in which every feature and bounce has a cost and an effect. Effects add up.
struct World {
  std::map<SceneFeature, std::pair<double, double>> parts;  // cpu_ms, changed
  double bounce_ms = 1, bounce_changed = 0.1;
  std::vector<SceneModel> asked = {};

  MeasuredModel measure(const SceneModel& model) {
    asked.push_back(model);
    MeasuredModel m{.scene = "box", .model = model, .cpu_ms = 20};
    m.cpu_ms -= bounce_ms * (kWhole.bounces - model.bounces);
    m.changed += bounce_changed * (kWhole.bounces - model.bounces);
    for (const SceneFeature part : model.disabled_features)
      m.cpu_ms -= parts[part].first, m.changed += parts[part].second;
    return m;
  }
  // The models that were measured besides the whole one and each single simplification.
  std::vector<SceneModel> combinations() {
    SceneFeatures there;
    for (const auto& [part, effect] : parts) there.insert(part);
    const MeasuredModel whole = measure(kWhole);
    std::vector<MeasuredModel> simpler;
    for (const SceneModel& model : simplerByOne(kWhole, there)) simpler.push_back(measure(model));
    asked.clear();
    const auto all = withCombinations(whole, simpler, [&](const SceneModel& m) { return measure(m); });
    EXPECT_EQ(all.front().model, kWhole);
    EXPECT_EQ(all.size(), 1 + simpler.size() + asked.size());
    return asked;
  }
};

TEST(ModelSearch, LeavesOutEachPartAloneAndBounceAfterBounce) {
  EXPECT_EQ(simplerByOne(kWhole, {SceneFeature::kMasks, SceneFeature::kTextures}),
            (std::vector<SceneModel>{
                {1, {}}, {0, {}}, {2, {SceneFeature::kTextures}}, {2, {SceneFeature::kMasks}}}));
  EXPECT_TRUE(simplerByOne({0, {}}, {}).empty());
}

TEST(ModelSearch, AddsWhatChangesLeastFirst) {
  World world{
      {{SceneFeature::kTextures, {1, 0.3}}, {SceneFeature::kMasks, {1, 0.05}}}};  // one bounce 0.1, both 0.2
  const SceneFeatures masks{SceneFeature::kMasks};
  EXPECT_EQ(world.combinations(),
            (std::vector<SceneModel>{
                {1, masks}, {0, masks}, {0, {SceneFeature::kTextures, SceneFeature::kMasks}}}));
}

TEST(ModelSearch, FewerBouncesAloneAreKnownAlready) {
  EXPECT_TRUE(World{{}}.combinations().empty());
}

TEST(ModelSearch, AFeatureThatSavesNoTimeStays) {
  World world{{{SceneFeature::kMipFiltering, {-1, 0.01}}, {SceneFeature::kMasks, {0, 0.02}}}};
  EXPECT_TRUE(world.combinations().empty());
}

TEST(ModelSearch, EndsWhereMoreThanAllEventsChange) {
  World world{{{SceneFeature::kTextures, {1, 0.6}},
               {SceneFeature::kMasks, {1, 0.7}},
               {SceneFeature::kSpecular, {1, 0.9}}}};
  EXPECT_EQ(world.combinations(),
            (std::vector<SceneModel>{{0, {SceneFeature::kTextures}},
                                     {0, {SceneFeature::kTextures, SceneFeature::kMasks}}}));
}

}  // namespace
}  // namespace saccade::eval
