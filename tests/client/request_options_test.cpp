#include "client/options/request_options.h"

#include <gtest/gtest.h>

#include "client/options/truth_option.h"
#include "request_line.h"
#include "saccade/wire/codec_table.h"
#include "saccade/wire/noise_units.h"

namespace saccade::client {
namespace {

TEST(RequestOptions, AbsentOptionsAreLeftToTheServer) {
  const auto open = openStream("");
  EXPECT_EQ(open.scene(), "cornell-box");
  EXPECT_EQ(open.trajectory().name(), "right");
  EXPECT_EQ(open.view().width(), 240u);
  EXPECT_EQ(open.view().height(), 180u);
  EXPECT_EQ(open.delivery(), v1::DELIVERY_LOSSLESS);
  EXPECT_EQ(open.timing().clock(), v1::CLOCK_FAST);
  ASSERT_EQ(open.sensors_size(), 1);
  EXPECT_FALSE(open.sensors(0).has_threshold() || open.sensors(0).has_bias());
  EXPECT_FALSE(open.quality().has_bounces() || open.view().has_fov_x_deg());
}

TEST(RequestOptions, AnAnimationIsNamed) {
  EXPECT_EQ(openStream("--animation Run").animation(), "Run");
  EXPECT_EQ(openStream("").animation(), "");
}

TEST(RequestOptions, NoiseAndPresetAreThoseOfAllSensors) {
  const auto open =
      openStream("--threshold 0.2,0.4 --preset davis346 --noise leak_hz=0.5 --noise jitter_s=1e-5");
  for (const v1::Sensor& sensor : open.sensors()) {
    EXPECT_EQ(sensor.preset(), "davis346");
    EXPECT_EQ(sensor.noise().leak_hz(), 0.5);
    EXPECT_EQ(sensor.noise().jitter_s(), 1e-5);
    EXPECT_FALSE(sensor.noise().has_shot_hz());
  }
  EXPECT_FALSE(openStream("").sensors(0).has_noise());
  for (const char* wrong : {"leak=1", "leak_hz", "leak_hz=much", "=1"}) {
    EXPECT_NE(faultOf(std::string("--noise ") + wrong).find("mismatch, photoreceptor_hz"), std::string::npos);
  }
}

// In the request 0 means that spp is unset.
TEST(RequestOptions, ANumberOutsideOfItsRangeIsRefused) {
  EXPECT_EQ(faultOf("--spp 0"), "--spp: 0 is outside [1, 65536]");
  EXPECT_EQ(faultOf("--spp 2.5"), "--spp: 2.5 is not a whole number");
  EXPECT_EQ(faultOf("--rate nan"), "--rate: nan is outside [0.1, 100000]");
  EXPECT_EQ(faultOf("--rate fast"), "--rate: 'fast' is not a number");
  EXPECT_EQ(faultOf("--retry-time nan"), "--retry-time: nan is outside [0, 1e+06]");
  for (const std::string option :
       {"--threshold", "--threshold-off", "--bias", "--refractory", "--cutoff", "--max-artefact-odds",
        "--fov", "--rate", "--duration", "--bounces", "--bake-error", "--budget-ms", "--max-false-rate",
        "--turn", "--clearance"}) {
    for (const std::string value : {"-1", "1e300", "nan", "-inf"})
      EXPECT_EQ(faultOf(option + "=" + value).find(option + ": " + value + " is outside ["), 0u)
          << option << " " << value << ": " << faultOf(option + "=" + value);
  }
  EXPECT_EQ(faultOf("--duration 0 --refractory 0 --bounces 0"), "");
}

TEST(RequestOptions, ASizeIsTwoSidesInPixels) {
  const auto open = openStream("--size 40X30");
  EXPECT_EQ(open.view().width(), 40u);
  EXPECT_EQ(open.view().height(), 30u);
  for (const std::string size : {"40", "40x", "0x30", "-4x3", "4.5x3", "4x3x2", "40 x30"})
    EXPECT_EQ(faultOf("--size '" + size + "'").find("--size: '" + size + "' is not WIDTHxHEIGHT"), 0u)
        << size;
  EXPECT_EQ(faultOf("--size 4097x3"), "--size: '4097x3': a side has 1 to 4096 pixels");
}

TEST(RequestOptions, ListsMayHaveCommas) {
  const auto open = openStream("--set alpha=0.5,beta=2 --noise leak_hz=0.5,shot_hz=2 --threshold 0.1,0.2");
  EXPECT_EQ(open.method().params().size(), 2u);
  EXPECT_EQ(open.sensors(1).noise().shot_hz(), 2);
  CLI::App app;
  std::vector<std::string> channels;
  addTruthOption(app, channels);
  app.parse("--truth depth:5,pose --truth imu");
  EXPECT_EQ(channels, (std::vector<std::string>{"depth:5", "pose", "imu"}));
}

TEST(RequestOptions, AFurtherViewHasSensorsOfItsOwn) {
  const auto open = openStream(
      "--size 32x24 --threshold 0.2,0.4 --further-view -0.1,0,-2e-1 --further-view 1,2,3,0,0.5,0,1");
  ASSERT_EQ(open.further_views_size(), 2);
  EXPECT_EQ(open.further_views(0).width(), 32u);
  EXPECT_EQ(open.further_views(0).body_camera().position().x(), -0.1);
  EXPECT_EQ(open.further_views(0).body_camera().position().z(), -0.2);
  EXPECT_FALSE(open.further_views(0).body_camera().has_rotation() || open.view().has_body_camera());
  EXPECT_EQ(open.further_views(1).body_camera().rotation().y(), 0.5);
  ASSERT_EQ(open.sensors_size(), 6);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(open.sensors(i).view(), static_cast<unsigned>(i / 2));
    EXPECT_EQ(open.sensors(i).threshold(), i % 2 == 0 ? 0.2 : 0.4);
  }
  for (const char* bad : {"1,2", "1,2,3,4", "1,2,x", "1,2,3,0,0,0,1,0"})
    EXPECT_NE(faultOf(std::string("--further-view ") + bad).find("--further-view: '"), std::string::npos)
        << bad;
}

TEST(RequestOptions, EachThresholdIsASensor) {
  const auto open = openStream(
      "--threshold 0.2 --threshold 0.4 --threshold-off 0.3 --bias 0.01 --model probabilistic "
      "--start-level zero --reconstruction complementary --cutoff 2");
  ASSERT_EQ(open.sensors_size(), 2);
  EXPECT_EQ(open.sensors(0).threshold(), 0.2);
  EXPECT_EQ(open.sensors(1).threshold(), 0.4);
  EXPECT_EQ(open.sensors(0).threshold_off(), 0.3);
  EXPECT_EQ(open.sensors(1).threshold_off(), 0.3);
  EXPECT_EQ(open.sensors(1).bias(), 0.01);
  EXPECT_EQ(open.sensors(1).model(), v1::EVENT_MODEL_PROBABILISTIC);
  EXPECT_EQ(open.sensors(1).start_level(), v1::START_LEVEL_ZERO);
  EXPECT_EQ(open.sensors(1).reconstruction(), v1::RECONSTRUCTION_COMPLEMENTARY);
  EXPECT_EQ(open.sensors(1).cutoff_hz(), 2);
}

TEST(RequestOptions, AValueDoesNotSwallowTheScene) {
  const auto options = parse("--threshold 0.2 --set alpha=0.5 --trajectory right cornell-box");
  EXPECT_EQ(options.scene, "cornell-box");
}

TEST(RequestOptions, IntervalsFollowMotionInsteadOfARate) {
  const v1::Timing open = openStream("").timing();
  EXPECT_FALSE(open.has_refinement());
  EXPECT_EQ(open.frame_rate_hz() + open.interval_px() + open.max_rate_hz(), 0);
  const v1::Timing timing = openStream("--interval-px 0.5").timing();
  EXPECT_EQ(timing.interval_px(), 0.5);
  EXPECT_EQ(timing.frame_rate_hz(), 0);
  EXPECT_EQ(timing.max_rate_hz(), 0);
  const v1::Timing least = openStream("--min-rate 20").timing();
  EXPECT_EQ(least.frame_rate_hz(), 20);
  EXPECT_EQ(least.interval_px(), 1);
  EXPECT_EQ(openStream("--max-rate 50").timing().max_rate_hz(), 50);
  const v1::Timing bounded = openStream("--interval-px 1 --min-rate 50 --max-rate 2000").timing();
  EXPECT_EQ(bounded.frame_rate_hz(), 50);
  EXPECT_EQ(bounded.max_rate_hz(), 2000);
  EXPECT_FALSE(bounded.has_refinement());
  EXPECT_EQ(openStream("--interval-px 1 --finest-px 0.25").timing().refinement().finest_px(), 0.25);
  EXPECT_EQ(openStream("--rate 50").timing().interval_px(), 0);
  EXPECT_NE(faultOf("--interval-px 1 --rate 50"), "");
  EXPECT_NE(faultOf("--rate 50 --finest-px 0.1"), "");
  EXPECT_NE(faultOf("--rate 50 --min-rate 50"), "");
  EXPECT_NE(faultOf("--rate 50 --max-rate 50"), "");
}

TEST(RequestOptions, RequestHoldsWhatWasGiven) {
  const auto open = openStream(
      "--size 64x48 --fov 50 --rate 250 --duration 1.5 --clock paced --delivery live --method pt --spp 4 "
      "--bounces 0 --set alpha=0.25 --set demodulate=0 --seed 7 --refractory 1e-3");
  EXPECT_EQ(open.view().width(), 64u);
  EXPECT_EQ(open.view().height(), 48u);
  EXPECT_EQ(open.view().fov_x_deg(), 50);
  EXPECT_EQ(open.timing().frame_rate_hz(), 250);
  EXPECT_EQ(open.timing().duration_s(), 1.5);
  EXPECT_EQ(open.timing().clock(), v1::CLOCK_PACED);
  EXPECT_EQ(open.delivery(), v1::DELIVERY_LIVE);
  EXPECT_EQ(open.method().name(), "pt");
  EXPECT_EQ(open.method().spp(), 4u);
  EXPECT_EQ(open.method().params().at("alpha"), 0.25);
  EXPECT_EQ(open.method().params().at("demodulate"), 0);
  EXPECT_TRUE(open.quality().has_bounces());
  EXPECT_EQ(open.quality().bounces(), 0u);
  EXPECT_EQ(open.seed(), 7u);
  EXPECT_EQ(open.sensors(0).refractory_s(), 1e-3);
}

TEST(RequestOptions, ACameraHasIntrinsicsAndDistortion) {
  const auto open =
      openStream("--intrinsics 200,198.5,119,91.25 --distortion radtan:-0.3,0.1,1e-3,-2e-3,0.05");
  EXPECT_FALSE(open.view().has_fov_x_deg());
  EXPECT_EQ(open.view().intrinsics().fx(), 200);
  EXPECT_EQ(open.view().intrinsics().fy(), 198.5);
  EXPECT_EQ(open.view().intrinsics().cx(), 119);
  EXPECT_EQ(open.view().intrinsics().cy(), 91.25);
  const v1::Distortion& lens = open.view().distortion();
  EXPECT_EQ(lens.model(), v1::DISTORTION_MODEL_RADTAN);
  EXPECT_EQ(std::vector<double>(lens.coefficients().begin(), lens.coefficients().end()),
            (std::vector<double>{-0.3, 0.1, 1e-3, -2e-3, 0.05}));
  EXPECT_EQ(openStream("--distortion equidistant:0,0,0,0").view().distortion().model(),
            v1::DISTORTION_MODEL_EQUIDISTANT);
  EXPECT_THROW(openStream("--intrinsics 200,200,119"), std::invalid_argument);
  EXPECT_THROW(openStream("--intrinsics 200,200,119,x"), std::invalid_argument);
  EXPECT_THROW(openStream("--distortion prism:0,0,0,0"), std::invalid_argument);
  EXPECT_THROW(openStream("--distortion radtan:0,,0,0"), std::invalid_argument);
}

TEST(RequestOptions, ABudgetTakesThePlaceOfASetting) {
  const auto within = openStream("--budget-ms 20 --method svgf");
  EXPECT_EQ(within.quality().budget_ms(), 20);
  EXPECT_FALSE(within.quality().has_max_false_rate());
  EXPECT_EQ(within.method().name(), "svgf");
  const auto at_most = openStream("--max-false-rate 0.02 --bounces 3");
  EXPECT_EQ(at_most.quality().max_false_rate(), 0.02);
  EXPECT_FALSE(at_most.quality().has_budget_ms());
  EXPECT_EQ(at_most.quality().bounces(), 3u);
  EXPECT_FALSE(openStream("").quality().has_budget_ms());
  for (const std::string other : {"--spp 2", "--set alpha=0.1", "--max-false-rate 1"}) {
    EXPECT_NE(faultOf("--budget-ms 20 " + other).find("--budget-ms"), std::string::npos) << other;
  }
  for (const std::string other : {"--spp 2", "--set alpha=0.1"}) {
    EXPECT_NE(faultOf("--max-false-rate 1 " + other).find("--max-false-rate"), std::string::npos) << other;
  }
}

TEST(RequestOptions, AModelIsNamedOrLeftToWhatTheEventsNeed) {
  const auto named = openStream("--disable textures --disable masks,specular").quality();
  EXPECT_EQ(std::vector<std::string>(named.disabled_features().begin(), named.disabled_features().end()),
            (std::vector<std::string>{"textures", "masks", "specular"}));
  EXPECT_FALSE(named.has_max_event_change());
  EXPECT_DOUBLE_EQ(openStream("--max-event-change 2.5%").quality().max_event_change(), 0.025);
  for (const std::string text : {"2", "%", "x%", "2%%", "2% "})
    EXPECT_NE(faultOf("--max-event-change '" + text + "'").find("--max-event-change"), std::string::npos)
        << text;
  for (const std::string other : {"--bounces 2", "--disable masks", "--budget-ms 20", "--max-false-rate 1"})
    EXPECT_NE(faultOf("--max-event-change 2% " + other).find("--max-event-change"), std::string::npos)
        << other;
}

TEST(RequestOptions, CodecsAreThoseOfTheTable) {
  EXPECT_EQ(openStream("").codec(), v1::CODEC_UNSPECIFIED);
  for (const CodecInfo* codec : codecTable()) {
    EXPECT_EQ(openStream(std::string("--codec ") + codec->name).codec(), codec->id);
  }
  EXPECT_NE(faultOf("--codec lzw").find("zstd"), std::string::npos);
}

TEST(RequestOptions, TheTimeToRetryIsAMinuteUnlessSet) {
  EXPECT_EQ(parse(kNeeded).retry_time_s, 60);
  EXPECT_EQ(parse(kNeeded + "--retry-time 0").retry_time_s, 0);
  EXPECT_NE(faultOf("--retry-time -1").find("--retry-time"), std::string::npos);
}

TEST(RequestOptions, TheHelpHasAUnitForEachAmountOfNoise) {
  const auto* noise = v1::Noise::descriptor();
  EXPECT_EQ(static_cast<int>(std::size(kNoiseUnits)), noise->field_count());
  for (const NoiseUnit& row : kNoiseUnits) {
    EXPECT_TRUE(noise->FindFieldByName(row.name)) << row.name;
    EXPECT_NE(noiseUnitTexts().find(std::string(row.name) + " (" + row.unit + ")"), std::string::npos);
  }
}

TEST(RequestOptions, FaultsNameTheOption) {
  for (const std::string size : {"64", "64x", "x48", "64x48x", "-1x48", "64 x48"}) {
    EXPECT_NE(faultOf("--size '" + size + "'").find("--size"), std::string::npos) << size;
  }
  for (const std::string param : {"alpha", "alpha=", "=1", "alpha=x", "alpha=1x"}) {
    EXPECT_NE(faultOf("--set " + param).find("--set"), std::string::npos) << param;
  }
  EXPECT_NE(faultOf("--threshold 0.2 --threshold-off 0.1 --threshold-off 0.1").find("--threshold-off"),
            std::string::npos);
  for (const std::string number : {"--seed -1", "--seed 18446744073709551616"})
    EXPECT_NE(faultOf(number).find("is not a whole number from 0 to"), std::string::npos) << number;
  EXPECT_NE(faultOf("--delivery pigeon").find("lossless"), std::string::npos);
  EXPECT_NE(faultOf("--reconstruction magic").find("kalman"), std::string::npos);
}

}  // namespace
}  // namespace saccade::client
