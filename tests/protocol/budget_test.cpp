// Streams that ask for a time or for an accuracy instead of a setting.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "app/request/resolve.h"
#include "mock/accuracy_file.h"
#include "mock/bad_request.h"

namespace saccade {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                 kInf = std::numeric_limits<double>::infinity();

class Budgets : public testing::Test {
 protected:
  const AccuracyFile file_{testing::TempDir() + "budget_test_" + std::to_string(getpid())};
};

v1::OpenStream within(double budget_ms) {
  v1::OpenStream request = tinyRequest();
  request.mutable_quality()->set_budget_ms(budget_ms);
  return request;
}

v1::OpenStream atMost(double max_false_rate) {
  v1::OpenStream request = tinyRequest();
  request.mutable_quality()->set_max_false_rate(max_false_rate);
  return request;
}

constexpr auto kInvalid = v1::CODE_INVALID_ARGUMENT;
constexpr auto kUnavailable = v1::CODE_UNAVAILABLE;
const auto kNothing = [](v1::OpenStream&) {};

// clang-format off
const std::vector<BadRequest> kBadBudgets{
    {within(0), kNothing, kInvalid, "quality.budget_ms", "0 is outside [0.001"},
    {within(kNan), kNothing, kInvalid, "quality.budget_ms", "nan"},
    {within(kInf), kNothing, kInvalid, "quality.budget_ms", "inf"},
    {atMost(-0.1), kNothing, kInvalid, "quality.max_false_rate", "-0.1 is outside [0,"},
    {atMost(kNan), kNothing, kInvalid, "quality.max_false_rate", "nan"},
    {within(9), [](auto& r) { r.mutable_quality()->set_max_false_rate(1); }, kInvalid, "quality.max_false_rate", "not both"},
    {within(9), [](auto& r) { r.mutable_method()->set_spp(2); }, kInvalid, "method.spp", "leave it out"},
    {within(9), [](auto& r) { (*r.mutable_method()->mutable_params())["alpha"] = 0.1; }, kInvalid, "method.params", "leave it out"},
    {within(9), [](auto& r) { r.mutable_method()->set_name("magic"); }, kInvalid, "method.name", "event_svgf"},
    {within(9), [](auto& r) { r.mutable_quality()->set_bounces(3); }, kInvalid, "quality.bounces", "2 bounces"},
    {within(0.9), kNothing, kInvalid, "quality.budget_ms", "the fastest setting here, pt at 1 spp, takes 1 ms"},
    {within(4), [](auto& r) { r.mutable_method()->set_name("event_svgf"); }, kInvalid, "quality.budget_ms",
     "event_svgf at 2 spp, takes 5 ms"},
    {atMost(0.019), kNothing, kInvalid, "quality.max_false_rate",
     "of event_svgf:iterations=2 at 4 spp, is 0.02 false events"},
    {within(9), [](auto& r) { r.set_scene("textured-cornell-box"); }, kUnavailable, "quality.budget_ms",
     "measured are: cornell-box; `saccade-eval chart`"},
    {atMost(1), [](auto& r) { r.mutable_method()->set_name("pt-correlated"); }, kUnavailable,
     "quality.max_false_rate", "measured are: event_svgf, pt, svgf"},
};
// clang-format on

TEST_F(Budgets, ABadOneIsRefusedWithItsField) {
  TestServer server(1, {}, file_.path());
  expectRefused(server, kBadBudgets);
}

TEST_F(Budgets, TheReplyTellsTheChoiceAndTheExpectedQuality) {
  TestServer server(1, {}, file_.path());
  v1::OpenStream request = within(5);
  request.mutable_quality()->set_bounces(2);
  const v1::StreamOpened opened = server.client().open(request);
  EXPECT_EQ(opened.resolved().method().name(), "event_svgf");
  EXPECT_EQ(opened.resolved().method().spp(), 2u);
  EXPECT_EQ(opened.resolved().method().params().at("iterations"), 4);
  EXPECT_EQ(opened.resolved().quality().bounces(), 2u);
  EXPECT_FALSE(opened.resolved().quality().has_budget_ms());
  EXPECT_EQ(opened.expected().setting(), "event_svgf");
  EXPECT_DOUBLE_EQ(opened.expected().cpu_ms(), 20 / 4.0);
  EXPECT_DOUBLE_EQ(opened.expected().false_rate(), 0.02 * 2);
  EXPECT_DOUBLE_EQ(opened.expected().missed_rate(), 0.03 * 2);
  EXPECT_EQ(opened.expected().measured_on(), file_.settings());
  EXPECT_FALSE(server.client().open(tinyRequest()).has_expected());
}

// Late frames take half as long as the 20 frames that were measured.
TEST(BudgetsOfLongStreams, CountOnLateFrames) {
  const std::string folder = testing::TempDir() + "long_budgets_" + std::to_string(getpid());
  const AccuracyFile file(folder);
  std::ofstream(file.path()) << "# cpu=\"" << cpuName()
                             << "\" size=32x24 bounces=2 threshold=0.2 frames=16:20\n"
                                "scene,method,spp,cpu_ms,small_ms,small_late_ms,false_events,missed_events\n"
                                "cornell-box,pt,1,8,2,1,0.5,0.1\n";
  TestServer server(1, {}, file.path());
  const auto expected = [&](double frames) {
    v1::OpenStream request = within(100);
    request.mutable_timing()->set_duration_s(frames / request.timing().frame_rate_hz());
    return server.client().open(request).expected().cpu_ms();
  };
  EXPECT_NEAR(expected(20), 8, 1e-9);
  EXPECT_NEAR(expected(40), 6, 1e-9);
  EXPECT_NEAR(expected(0), 4, 1e-9);
}

TEST_F(Budgets, CountAllViews) {
  TestServer server(1, {}, file_.path());
  const v1::OpenStream one = within(12);
  v1::OpenStream two = one;
  *two.add_further_views() = two.view();
  EXPECT_EQ(server.client().open(one).expected().setting(), "event_svgf:iterations=2");
  const v1::ExpectedQuality both = server.client().open(two).expected();
  EXPECT_EQ(both.setting(), "event_svgf");
  EXPECT_DOUBLE_EQ(both.cpu_ms(), 2 * 20 / 4.0);
}

TEST_F(Budgets, TheNameOfAMethodRestrictsTheChoice) {
  TestServer server(1, {}, file_.path());
  v1::OpenStream request = atMost(1);
  EXPECT_EQ(server.client().open(request).resolved().method().name(), "pt");
  request.mutable_method()->set_name("svgf");
  const v1::StreamOpened opened = server.client().open(request);
  EXPECT_EQ(opened.expected().setting(), "svgf:as_falcor=1");
  EXPECT_EQ(opened.resolved().method().params().at("as_falcor"), 1);
  EXPECT_FALSE(opened.resolved().quality().has_max_false_rate());
}

// Rates are those of the sensor that fires most easily.
TEST_F(Budgets, TheSmallestThresholdCounts) {
  TestServer server(1, {}, file_.path());
  v1::OpenStream request = atMost(1);
  request.mutable_method()->set_name("svgf");
  const auto rate = [&] { return server.client().open(request).expected().false_rate(); };
  EXPECT_DOUBLE_EQ(rate(), 0.05 * 0.2 / 0.1);
  request.add_sensors()->set_threshold(0.08);
  request.mutable_sensors(1)->set_threshold_off(0.3);
  EXPECT_DOUBLE_EQ(rate(), 0.05 * 0.2 / 0.08);
  request.mutable_sensors(0)->set_threshold_off(0.04);
  EXPECT_DOUBLE_EQ(rate(), 0.05 * 0.2 / 0.04);
}

TEST_F(Budgets, GiveTheEventsOfTheSettingThatWasChosen) {
  TestServer server(2, {}, file_.path());
  const std::string bytes = comparableBytes(server.run(within(20))[0]);
  v1::OpenStream same = tinyRequest();
  same.mutable_method()->set_name("event_svgf");
  same.mutable_method()->set_spp(4);
  (*same.mutable_method()->mutable_params())["iterations"] = 2;
  same.mutable_quality()->set_bounces(2);
  EXPECT_EQ(bytes, comparableBytes(server.run(same)[0]));
  same.mutable_quality()->set_bounces(3);
  EXPECT_NE(bytes, comparableBytes(server.run(same)[0]));
}

TEST_F(Budgets, AreNoPartOfAFeed) {
  const SceneEntry scene = SceneLibrary(SACCADE_SOURCE_DIR "/scenes").find("cornell-box").value();
  const MeasuredTables tables{openAccuracySource(file_.path()), openSimplificationSource({})};
  const auto key = [&](const v1::OpenStream& r) { return resolve(r, scene, tables).feedKey(); };
  v1::OpenStream same = tinyRequest();
  same.mutable_method()->set_name("event_svgf");
  same.mutable_quality()->set_bounces(2);
  EXPECT_EQ(key(within(5)), key(same));
  EXPECT_EQ(key(within(6)), key(same));
  EXPECT_EQ(key(atMost(0.05)), key(same));
  EXPECT_NE(key(within(20)), key(same));
  EXPECT_EQ(key(resolve(within(20), scene, tables).request), key(within(20)));
}

TEST_F(Budgets, TheServerTellsWhetherItHasThem) {
  TestServer server(1, {}, file_.path());
  const v1::BudgetInfo with = server.client().server().budgets();
  EXPECT_EQ(with.unavailable(), "");
  EXPECT_EQ(with.measured_on(), file_.settings());
  ASSERT_EQ(with.scenes_size(), 1);
  EXPECT_EQ(with.scenes(0), "cornell-box");
}

void expectNoBudgets(const std::string& accuracy, const std::string& why) {
  TestServer server(1, {}, accuracy);
  const v1::BudgetInfo info = server.client().server().budgets();
  EXPECT_NE(info.unavailable().find(why), std::string::npos) << info.unavailable();
  EXPECT_NE(info.unavailable().find("saccade-eval chart --quick"), std::string::npos);
  EXPECT_EQ(info.scenes_size(), 0);
  for (const auto& [request, field] :
       {std::pair{within(5), "quality.budget_ms"}, std::pair{atMost(1), "quality.max_false_rate"}}) {
    const v1::Status status = server.client().tryOpen(request);
    EXPECT_EQ(status.code(), v1::CODE_UNAVAILABLE);
    EXPECT_EQ(status.field(), field);
    EXPECT_EQ(status.message(), info.unavailable());
  }
}

TEST(NoBudgets, WithoutATable) {
  expectNoBudgets("", "no table of accuracy");
}

TEST(NoBudgets, FromATableOfAnotherProcessor) {
  const AccuracyFile file(testing::TempDir() + "no_budgets_" + std::to_string(getpid()), "Zilog Z80");
  expectNoBudgets(file.path(), "Zilog Z80, not " + cpuName());
}

}  // namespace
}  // namespace saccade
