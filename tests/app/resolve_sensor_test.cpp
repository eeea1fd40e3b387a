#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/request/refusal.h"
#include "app/request/resolve_sensor.h"
#include "events/noise/presets.h"

namespace saccade {
namespace {

std::string faultOf(v1::Sensor sensor) {
  try {
    resolveSensor(sensor, 3, 1);
  } catch (const Refusal& refusal) {
    return refusal.field + ": " + refusal.what();
  }
  return {};
}

// One range, however far outside the value lies.
TEST(ResolveSensor, ARefractoryPeriodHasOneRange) {
  for (const double seconds : {-1.0, 10.1, 500.0, 2000.0, 1e300}) {
    v1::Sensor sensor;
    sensor.set_refractory_s(seconds);
    const std::string fault = faultOf(sensor);
    EXPECT_EQ(fault.find("sensors[3].refractory_s: "), 0) << fault;
    EXPECT_NE(fault.find("is outside [0, 10]"), std::string::npos) << fault;
  }
}

TEST(ResolveSensor, TheEndsOfARangeAreValidAndWhatLiesBeyondIsNot) {
  using Set = void (v1::Sensor::*)(double);
  const struct {
    Set set;
    Range<double> range;
  } rows[] = {{&v1::Sensor::set_threshold, ranges::kThreshold},
              {&v1::Sensor::set_threshold_off, ranges::kThreshold},
              {&v1::Sensor::set_bias, ranges::kBias},
              {&v1::Sensor::set_refractory_s, ranges::kRefractory},
              {&v1::Sensor::set_cutoff_hz, ranges::kCutoff}};
  for (const auto& row : rows) {
    for (const double inside : {row.range.min, row.range.max}) {
      v1::Sensor sensor;
      (sensor.*row.set)(inside);
      EXPECT_EQ(faultOf(sensor), "") << inside;
    }
    for (const double outside : {std::nextafter(row.range.min, -1.0), row.range.max * 1.1, std::nan("")}) {
      v1::Sensor sensor;
      (sensor.*row.set)(outside);
      EXPECT_NE(faultOf(sensor), "") << outside;
    }
  }
}

TEST(ResolveSensor, FillsInWhatIsUnset) {
  v1::Sensor sensor;
  sensor.set_threshold(0.5);
  const SensorConfig config = resolveSensor(sensor, 0, 1);
  EXPECT_EQ(config.threshold_off, 0.5);
  EXPECT_EQ(sensor.threshold_off(), 0.5);
  EXPECT_EQ(sensor.max_events_per_pixel_frame(), 32u);
  EXPECT_EQ(sensor.reconstruction(), v1::RECONSTRUCTION_KALMAN);
  EXPECT_EQ(sensor.start_level(), v1::START_LEVEL_RANDOM);
  EXPECT_TRUE(config.random_start);
  v1::Sensor other;
  resolveSensor(other, 1, 1);
  EXPECT_NE(sensor.seed(), other.seed());
}

TEST(ResolveSensor, WithoutNoiseTheRequestGetsNone) {
  v1::Sensor sensor;
  EXPECT_EQ(resolveSensor(sensor, 0, 1).noise, NoiseConfig{});
  EXPECT_FALSE(sensor.has_noise());
}

TEST(ResolveSensor, EveryFieldOfNoiseIsReadAndChecked) {
  for (const NoiseField& row : noiseFields()) {
    const auto* field = v1::Noise::descriptor()->FindFieldByName(row.name);
    ASSERT_TRUE(field) << row.name;
    for (const double value : {row.range.max, row.range.max * 1.1, std::nan("")}) {
      v1::Sensor sensor;
      sensor.set_model(v1::EVENT_MODEL_STOCHASTIC);
      sensor.mutable_noise()->set_photoreceptor_hz(1);
      sensor.mutable_noise()->GetReflection()->SetDouble(sensor.mutable_noise(), field, value);
      const std::string fault = faultOf(sensor);
      if (value == row.range.max) {
        EXPECT_EQ(fault, "");
        EXPECT_EQ(resolveSensor(sensor, 0, 1).noise.*row.value, value);
      } else {
        EXPECT_EQ(fault.find("sensors[3].noise." + std::string(row.name) + ": "), 0) << fault;
      }
    }
  }
  EXPECT_EQ(v1::Noise::descriptor()->field_count(), static_cast<int>(noiseFields().size()));
}

TEST(ResolveSensor, APresetFillsInWhatIsUnset) {
  const SensorPreset& preset = *findPreset("davis346");
  v1::Sensor sensor;
  sensor.set_preset(preset.name);
  sensor.mutable_noise()->set_leak_hz(0);
  const SensorConfig config = resolveSensor(sensor, 0, 1);
  EXPECT_EQ(config.threshold, preset.threshold);
  EXPECT_EQ(config.threshold_off, preset.threshold_off);
  EXPECT_EQ(seconds(config.refractory), preset.refractory_s);
  EXPECT_EQ(config.noise.leak_hz, 0);
  EXPECT_EQ(config.noise.shot_hz, preset.noise.shot_hz);
  // A resolved request is complete, and resolves to itself.
  EXPECT_EQ(sensor.noise().mismatch(), preset.noise.mismatch);
  v1::Sensor again = sensor;
  resolveSensor(again, 0, 1);
  EXPECT_EQ(again.SerializeAsString(), sensor.SerializeAsString());
}

// DAVIS346: C 14.3 % ON and 22.5 % OFF, by its data sheet; the preset has four digits of them.
TEST(ResolveSensor, AThresholdKeepsTheProportionOfThePreset) {
  const double off_over_on = std::log1p(0.225) / std::log1p(0.143);
  v1::Sensor on;
  on.set_preset("davis346");
  on.set_threshold(0.15);
  const SensorConfig by_on = resolveSensor(on, 0, 1);
  EXPECT_EQ(by_on.threshold, 0.15);
  EXPECT_NEAR(by_on.threshold_off, 0.15 * off_over_on, 5e-4);
  EXPECT_EQ(on.threshold_off(), by_on.threshold_off);

  v1::Sensor off;
  off.set_preset("davis346");
  off.set_threshold_off(0.3);
  EXPECT_NEAR(resolveSensor(off, 0, 1).threshold, 0.3 / off_over_on, 5e-4);

  v1::Sensor both = on;
  both.set_threshold_off(0.4);
  EXPECT_EQ(resolveSensor(both, 0, 1).threshold, 0.15);
  EXPECT_EQ(resolveSensor(both, 0, 1).threshold_off, 0.4);

  v1::Sensor even;  // equal thresholds stay equal, bit for bit
  even.set_preset("imx636");
  even.set_threshold(0.3);
  EXPECT_EQ(resolveSensor(even, 0, 1).threshold_off, 0.3);
}

TEST(ResolveSensor, AnUnknownPresetIsRefusedWithTheNamesOfAll) {
  v1::Sensor sensor;
  sensor.set_preset("davis");
  const std::string fault = faultOf(sensor);
  EXPECT_EQ(fault.find("sensors[3].preset: "), 0) << fault;
  EXPECT_NE(fault.find("dvxplorer, imx636"), std::string::npos) << fault;
}

}  // namespace
}  // namespace saccade
