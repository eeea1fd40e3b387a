#include "client/options/field_options.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

TEST(FieldOptions, AFieldHasTheOptionThatFillsItIn) {
  EXPECT_EQ(optionOf("sensors[1].threshold"), "--threshold");
  EXPECT_EQ(optionOf("sensors[0].threshold_off"), "--threshold-off");
  EXPECT_EQ(optionOf("sensors[12].noise.leak_hz"), "--noise");
  EXPECT_EQ(optionOf("trajectory.motion.turn_s"), "--turn");
  EXPECT_EQ(optionOf("trajectory.motion.start.position.x"), "--start");
  EXPECT_EQ(optionOf("trajectory.motion.clearance"), "--clearance");
  EXPECT_EQ(optionOf("trajectory.name"), "--trajectory");
  EXPECT_EQ(optionOf("objects[1].path.motion.speed"), "--object");
  EXPECT_EQ(optionOf("animation"), "--animation");
  EXPECT_EQ(optionOf("method.params[\"alpha\"]"), "--set");
  EXPECT_EQ(optionOf("view.distortion.coefficients[0]"), "--distortion");
  EXPECT_EQ(optionOf("view.width"), "--size");
}

TEST(FieldOptions, OtherFieldsHaveNone) {
  for (const char* field : {"", "sensors", "sensors[0].seed", "steer", "truthful"})
    EXPECT_EQ(optionOf(field), "") << field;
}

}  // namespace
}  // namespace saccade::client
