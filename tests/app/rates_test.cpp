// Requests without a frame rate: intervals follow motion, and the answer says how.
#include <gtest/gtest.h>

#include <functional>

#include "app/request/refusal.h"
#include "app/sequence/stream_plan.h"

namespace saccade {
namespace {

using Open = v1::OpenStream;
using Spoil = std::function<void(Open&)>;

Open request(const Spoil& change = [](Open&) {}) {
  Open r;
  r.set_scene("cornell-box");
  r.mutable_view()->set_width(32), r.mutable_view()->set_height(24);
  r.mutable_trajectory()->set_name("right");
  r.mutable_timing()->set_duration_s(0.1);
  r.add_sensors();
  change(r);
  return r;
}

struct Rates : testing::Test {
  ResolvedStream resolved(const Open& request) {
    StreamPlan plan = planStream(request, scenes.library(), tables, limits);
    if (!plan.resolved.request.pushed()) loadScenes(plan, scenes, {});
    return plan.resolved;
  }
  v1::Timing timing(const Spoil& change) { return resolved(request(change)).request.timing(); }

  Limits limits;
  const MeasuredTables tables{openAccuracySource(""), openSimplificationSource("")};
  SceneCache scenes{std::string(SACCADE_SOURCE_DIR) + "/scenes"};
};

TEST_F(Rates, FollowMotionWhereNoneIsGiven) {
  const ResolvedStream stream = resolved(request());
  const v1::Timing& t = stream.request.timing();
  EXPECT_EQ(t.frame_rate_hz(), 100);
  EXPECT_EQ(t.interval_px(), 1);
  EXPECT_EQ(t.max_rate_hz(), 1000);
  EXPECT_EQ(t.refinement().finest_px(), 1. / 16);
  EXPECT_EQ(stream.frames, 10u);
  EXPECT_TRUE(stream.feed.intervals.followMotion() && stream.feed.refinement);
}

TEST_F(Rates, AreThoseOfTheRequestWhereItHasOne) {
  const v1::Timing whole = timing([](Open& r) { r.mutable_timing()->set_frame_rate_hz(500); });
  EXPECT_EQ(whole.frame_rate_hz(), 500);
  EXPECT_EQ(whole.interval_px(), 0);
  EXPECT_EQ(whole.max_rate_hz(), 0);
  EXPECT_FALSE(whole.has_refinement());
}

TEST_F(Rates, KeepWhatIsGivenOfThem) {
  const v1::Timing given = timing(
      [](Open& r) { r.mutable_timing()->set_interval_px(0.5), r.mutable_timing()->set_max_rate_hz(4000); });
  EXPECT_EQ(given.frame_rate_hz(), 100);
  EXPECT_EQ(given.interval_px(), 0.5);
  EXPECT_EQ(given.max_rate_hz(), 4000);
  const v1::Timing slow = timing([](Open& r) { r.mutable_timing()->set_max_rate_hz(50); });
  EXPECT_EQ(slow.frame_rate_hz(), 50);
}

TEST_F(Rates, HaveWholeFramesAloneWhereTheMethodKnowsNoLightBetween) {
  const auto finest = [&](const Spoil& change) { return timing(change).refinement().finest_px(); };
  EXPECT_EQ(finest([](Open& r) { r.mutable_method()->set_name("event_svgf"); }), 1);
  EXPECT_EQ(finest([](Open& r) { r.mutable_method()->set_name("pt"); }), 1);
  EXPECT_EQ(finest([](Open& r) { r.mutable_quality()->set_jitter(true); }), 1);
}

TEST_F(Rates, FillTheDuration) {
  const auto framesIn = [&](double duration_s) {
    const ResolvedStream stream =
        resolved(request([=](Open& r) { r.mutable_timing()->set_duration_s(duration_s); }));
    EXPECT_NEAR(static_cast<double>(stream.frames) / stream.feed.frame_rate_hz, duration_s,
                1e-9 * duration_s);
    return stream.frames;
  };
  EXPECT_EQ(framesIn(0.07), 7u);
  EXPECT_EQ(framesIn(0.125), 12u);
  EXPECT_EQ(framesIn(0.005), 1u);
  EXPECT_EQ(framesIn(1e-5), 1u);
  EXPECT_EQ(timing([](Open& r) { r.mutable_timing()->set_duration_s(0.07); }).frame_rate_hz(), 100);
  EXPECT_EQ(timing([](Open& r) { r.mutable_timing()->set_duration_s(0); }).frame_rate_hz(), 100);
}

TEST_F(Rates, AreWithinTheLimitOfTheServer) {
  limits[Limit::kFrameRate] = 60;
  const v1::Timing t = timing([](Open&) {});
  EXPECT_EQ(t.frame_rate_hz(), 60);
  EXPECT_EQ(t.max_rate_hz(), 60);
  EXPECT_EQ(timing([](Open& r) { r.mutable_timing()->set_frame_rate_hz(30); }).max_rate_hz(), 0);
  EXPECT_THROW(timing([](Open& r) { r.mutable_timing()->set_max_rate_hz(1000); }), Refusal);
}

// The request that is sent again asks for the same.
TEST_F(Rates, AreToldSuchThatTheRequestCanBeRepeated) {
  const ResolvedStream first = resolved(request()), again = resolved(first.request);
  EXPECT_EQ(first.feedKey(), again.feedKey());
}

TEST_F(Rates, OfPacedStreamsSuitSensorsThatDifferALittle) {
  const auto paced = [&](double threshold, double bias) {
    return resolved(request([=](Open& r) {
      r.mutable_timing()->set_clock(v1::CLOCK_PACED);
      r.mutable_sensors(0)->set_threshold(threshold), r.mutable_sensors(0)->set_bias(bias);
    }));
  };
  const v1::Refinement usual = paced(0.2, 1e-3).request.timing().refinement();
  EXPECT_EQ(usual.threshold(), 0.2);
  EXPECT_EQ(usual.bias(), 1e-3);
  EXPECT_EQ(paced(0.2, 1e-3).feedKey(), paced(0.39, 9e-3).feedKey());
  EXPECT_EQ(paced(0.19, 1e-3).request.timing().refinement().threshold(), 0.1);
  EXPECT_EQ(paced(0.2, 9e-4).request.timing().refinement().bias(), 1e-4);
  EXPECT_EQ(paced(1e-3, 1e-3).request.timing().refinement().threshold(), 1e-3);
}

TEST_F(Rates, AreAskedForWhereTheRequestCountsFrames) {
  const auto expectAsked = [&](const std::string& why, const Spoil& change) {
    try {
      resolved(request(change));
      ADD_FAILURE() << why << " is not refused";
    } catch (const Refusal& refusal) {
      EXPECT_EQ(refusal.field, "timing.frame_rate_hz");
      EXPECT_NE(std::string(refusal.what()).find(why), std::string::npos) << refusal.what();
    }
  };
  expectAsked("LOCKSTEP", [](Open& r) { r.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP); });
  expectAsked("budget_ms", [](Open& r) { r.mutable_quality()->set_budget_ms(10); });
  expectAsked("max_false_rate", [](Open& r) { r.mutable_quality()->set_max_false_rate(0.1); });
  expectAsked("flow_forward", [](Open& r) { r.add_truth()->set_name("flow_forward"); });
  expectAsked("px_per_frame", [](Open& r) {
    r.mutable_trajectory()->mutable_motion()->set_kind(v1::MOTION_KIND_PAN);
    r.mutable_trajectory()->mutable_motion()->set_px_per_frame(0.5);
  });
  expectAsked("pushed", [](Open& r) { r.clear_scene(), r.clear_trajectory(), r.set_pushed(true); });
}

}  // namespace
}  // namespace saccade
