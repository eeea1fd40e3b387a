#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/request/refusal.h"
#include "app/request/resolve.h"

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
  v1::Sensor other;
  resolveSensor(other, 1, 1);
  EXPECT_NE(sensor.seed(), other.seed());
}

}  // namespace
}  // namespace saccade
