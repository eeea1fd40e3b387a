// Cameras of Mitsuba files, as other programs write them.
#include <cmath>
#include <numbers>

#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scene_warnings.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

const std::string kFilm =
    "<film type='hdrfilm'><integer name='width' value='300'/><integer name='height' value='200'/></film>";
const std::string kLamp = "<emitter type='constant'><float name='radiance' value='1'/></emitter>";

std::string sensor(const std::string& content) {
  return "<sensor type='perspective'>" + content + "</sensor>";
}

Scene load(const std::string& body) {
  return parseMitsubaXml("<scene version='3.0.0'>" + body + "</scene>", "scene.xml");
}

double fovOf(const std::string& content) {
  return load(sensor(content)).fov_x_deg;
}

double degrees(double tangent) {
  return 2 * std::atan(tangent) * 180 / std::numbers::pi;
}

std::string faultOf(const std::string& content) {
  return errorOf([&] { load(sensor(content)); });
}

std::string number(const std::string& name, const std::string& value) {
  return "<float name='" + name + "' value='" + value + "'/>";
}

TEST(MitsubaFov, MayGoAlongTheDiagonal) {
  // 300 by 200 pixels: the diagonal is sqrt(13) / 3 of the width.
  EXPECT_NEAR(fovOf(kFilm + number("fov", "90") + "<string name='fovAxis' value='diagonal'/>"),
              degrees(3 / std::sqrt(13.0)), 1e-9);
}

// A lens of 50 mm before film of 36 x 24 mm, whose shape these pixels have.
TEST(MitsubaFov, IsThatOfALensOf50MmByDefault) {
  EXPECT_NEAR(fovOf(kFilm), degrees(18.0 / 50), 1e-9);
  const std::string focal = "<string name='focal_length' value='";
  EXPECT_NEAR(fovOf(kFilm + focal + "24mm'/>"), degrees(18.0 / 24), 1e-9);
  EXPECT_NEAR(fovOf(kFilm + focal + "24'/>"), degrees(18.0 / 24), 1e-9);
  // Mitsuba's film of 768 x 576 pixels, 4:3, where the file has none.
  EXPECT_NEAR(fovOf(""), degrees(std::hypot(18, 12) / 50 * 4 / 5), 1e-9);
}

TEST(MitsubaFov, Faults) {
  const std::string focal = "<string name='focal_length' value='";
  expectContains(faultOf(number("fov", "40") + focal + "50mm'/>"), "both a fov and a focal_length");
  expectContains(faultOf(focal + "wide'/>"), "such as 50mm");
  expectContains(faultOf(focal + "-3mm'/>"), "such as 50mm");
  expectContains(faultOf(number("fov", "0")), "within (0, 180)");
}

TEST(MitsubaSensor, ThatMirrorsIsTakenUnmirrored) {
  const std::string matrix = "<transform name='to_world'><matrix value='", end = "'/></transform>";
  const Scene plain = load(sensor(matrix + "-1 0 0 1  0 1 0 2  0 0 -1 3  0 0 0 1" + end) + kLamp);
  const Scene mirrored = load(sensor(matrix + "1 0 0 1  0 1 0 2  0 0 -1 3  0 0 0 1" + end) + kLamp);
  EXPECT_EQ(mirrored.T_world_camera.position, (Vec3d{1, 2, 3}));
  for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
    expectNear(rotate(mirrored.T_world_camera.rotation, axis), rotate(plain.T_world_camera.rotation, axis),
               1e-12);
  EXPECT_TRUE(warningsOf(plain).empty());
  ASSERT_EQ(warningsOf(mirrored).size(), 1u);
  expectContains(warningsOf(mirrored)[0], "mirrors the picture");
  expectContains(faultOf(matrix + "1 0.5 0 0  0 1 0 0  0 0 1 0  0 0 0 1" + end), "not shear");
}

TEST(MitsubaSensor, TheFirstOfSeveralIsTheCamera) {
  const Scene scene = load(sensor(number("fov", "30")) + sensor(number("fov", "60")) + kLamp);
  EXPECT_EQ(scene.fov_x_deg, 30);
  ASSERT_EQ(warningsOf(scene).size(), 1u);
  expectContains(warningsOf(scene)[0], "first of 2 sensors");
}

TEST(MitsubaSensor, TheOthersAreTrajectoriesThatStand) {
  const auto at = [](const std::string& x) {
    return "<transform name='to_world'><translate x='" + x + "' y='0' z='0'/></transform>";
  };
  std::string top = sensor(at("2"));
  top.replace(top.find("<sensor"), 7, "<sensor id='top'");
  const Scene scene = load(sensor(at("1")) + top + sensor(at("3")) + kLamp);
  EXPECT_EQ(scene.T_world_camera.position.x, 1);
  ASSERT_EQ(scene.paths.size(), 2u);
  EXPECT_EQ(scene.paths[0].name, "top");
  EXPECT_EQ(scene.paths[0].path.at(TimeNs{5}).position.x, 2);
  EXPECT_EQ(scene.paths[1].name, "sensor_3");
  EXPECT_EQ(scene.paths[1].path.at(TimeNs{0}).position.x, 3);
}

TEST(MitsubaSensor, PropertiesThatChangeNoLightAreAccepted) {
  const Scene scene =
      load(sensor("<hide name='a'/>" + number("principal_point_offset_x", "0") + number("fov", "40") +
                  "<film type='ldrfilm'><integer name='width' value='30'/><integer name='height' value='20'/>"
                  "<string name='filename' value='a.png'/><boolean name='any' value='true'/>" +
                  number("exposure", "2") +
                  "<integer name='crop_width' value='30'/><integer name='cropHeight' value='20'/>"
                  "<integer name='crop_offset_x' value='0'/></film>"));
  EXPECT_EQ(scene.width, 30);
  expectContains(faultOf(number("principal_point_offset_y", "0.1")),
                 "'principal_point_offset_y' is supported at 0 alone");
  expectContains(faultOf("<film type='hdrfilm'><integer name='width' value='30'/>"
                         "<integer name='crop_width' value='20'/></film>"),
                 "'crop_width' is supported at 30 alone");
}

}  // namespace
}  // namespace saccade
