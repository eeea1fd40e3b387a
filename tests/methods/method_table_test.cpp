#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "methods/method.h"

namespace saccade {
namespace {

std::string faultOf(const ParamValues& given, std::string& name) {
  ParamValues resolved;
  return resolveParams(*findMethod("event_svgf"), given, resolved, name);
}

TEST(MethodTable, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const MethodInfo& m : methodTable()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_EQ(findMethod(m.name), &m);
  }
  EXPECT_EQ(findMethod("no such method"), nullptr);
  EXPECT_EQ(defaultMethod(true).name, "irradiance_cache");
}

// The memory of `memory_mib` counts in full for large pictures only: small ones could not fill it.
TEST(MethodTable, TellsTheMemoryThatAGridMayTake) {
  constexpr double kMiB = 1 << 20;
  const MethodInfo& cache = *findMethod("irradiance_cache");
  const auto bytes = [&](double memory, double pixels) {
    ParamValues resolved;
    std::string bad_name;
    EXPECT_EQ(resolveParams(cache, {{"memory_mib", memory}}, resolved, bad_name), "");
    return cache.memory(resolved, {pixels, false, false});
  };
  EXPECT_NEAR(bytes(512, 2e5) - bytes(256, 2e5), 256 * kMiB, 1);
  EXPECT_EQ(bytes(512, 1e3), bytes(256, 1e3));
  EXPECT_EQ(bytes(1, 1e6), bytes(2, 1e6)) << "two frames need more";
  const auto more = [&](bool jitter, bool moves) {
    return cache.memory({{"memory_mib", 256}}, {1e5, jitter, moves}) - bytes(256, 1e5);
  };
  EXPECT_GT(more(true, false), 0) << "more points in a pixel";
  EXPECT_GT(more(false, true), 0) << "changes of light";
  EXPECT_GT(more(true, true), more(true, false) + more(false, true));
  EXPECT_EQ(findMethod("event_svgf")->memory({}, {1e5, false, true}), 0);
}

// The seven planes of RELAX's second history, with their borders of 32 pixels.
TEST(MethodTable, TellsTheMemoryOfASecondHistory) {
  for (const auto& [w, h] : {std::pair{640., 480.}, {32., 24.}, {1600., 100.}})
    EXPECT_GE(findMethod("relax")->memory({}, {w * h, false, false}), 7 * 4 * (w + 64) * (h + 64)) << w;
}

TEST(MethodTable, AFormerNameOfAParameterIsRefusedWithTheNewOne) {
  ParamValues resolved;
  std::string bad_name;
  const std::string fault =
      resolveParams(*findMethod("irradiance_cache"), {{"caution", 4}}, resolved, bad_name);
  EXPECT_EQ(fault, "the parameter \"caution\" is named \"noise_weight\" now");
  EXPECT_EQ(bad_name, "caution");
}

TEST(MethodTable, EveryParameterHasAPlaceASourceAndADefaultInItsRange) {
  for (const MethodInfo& m : methodTable()) {
    for (const ParamSpec& p : m.params) {
      EXPECT_LE(p.min, p.fallback) << p.name;
      EXPECT_LE(p.fallback, p.max) << p.name;
      EXPECT_FALSE(p.what.empty() || p.source.empty()) << p.name;
    }
  }
}

// Paper 4.3: correlated methods draw two passes, of which one replays the seeds of the previous frame.
TEST(MethodTable, SaysWhichPassesAMethodNeeds) {
  const auto seedsOf = [](const std::string& name, const ParamValues& given) {
    ParamValues resolved;
    std::string bad_name;
    EXPECT_EQ(resolveParams(*findMethod(name), given, resolved, bad_name), "");
    return findMethod(name)->seeds(resolved);
  };
  EXPECT_EQ(seedsOf("pt", {}), &SeedPlan::independent);
  EXPECT_EQ(seedsOf("svgf", {}), &SeedPlan::independent);
  EXPECT_EQ(seedsOf("pt-correlated", {}), &SeedPlan::correlated);
  EXPECT_EQ(seedsOf("pt-correlated", {{"reconnect", 1}}), &SeedPlan::reconnected);
  EXPECT_EQ(seedsOf("event_svgf", {}), &SeedPlan::correlated);
  EXPECT_EQ(seedsOf("event_svgf", {{"correlated", 0}}), &SeedPlan::independentPairs);
  EXPECT_EQ(seedsOf("event_svgf", {{"motion_aligned", 1}}), &SeedPlan::correlatedAlongMotion);
  EXPECT_EQ(seedsOf("a_svgf", {}), &SeedPlan::correlatedAlongMotion);
  EXPECT_EQ(seedsOf("relax", {}), &SeedPlan::correlated);
  EXPECT_EQ(seedsOf("adaptive_sampling", {}), &SeedPlan::independent);
  for (const char* name : {"pt-correlated", "svgf", "a_svgf", "event_svgf", "relax", "adaptive_sampling"}) {
    EXPECT_EQ(seedsOf(name, {{"independent_numbers", 1}})(7, 3, 2).numbers, NumberKind::kIndependent) << name;
    EXPECT_EQ(seedsOf(name, {})(7, 3, 2).numbers, NumberKind::kEven) << name;
  }
}

TEST(ResolveParams, FillsInThePapersDefaults) {
  ParamValues resolved;
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod("event_svgf"), {{"sigma_n", 64}}, resolved, name), "");
  EXPECT_EQ(resolved.at("sigma_n"), 64);
  EXPECT_NEAR(resolved.at("alpha"), 0.1, 1e-6);
  EXPECT_EQ(resolved.at("iterations"), 4);
}

TEST(ResolveParams, NamesWhatIsWrong) {
  std::string name;
  EXPECT_NE(faultOf({{"sigma", 1}}, name).find("sigma_l_diff"), std::string::npos);  // lists the valid ones
  EXPECT_EQ(name, "sigma");
  for (const double bad : {-1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(faultOf({{"alpha", bad}}, name), "") << bad;
    EXPECT_EQ(name, "alpha");
  }
  EXPECT_NE(faultOf({{"iterations", 2.5}}, name), "");
}

}  // namespace
}  // namespace saccade
