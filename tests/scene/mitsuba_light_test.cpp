#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

Scene light(const std::string& type, const std::string& properties) {
  const Scratch files;
  files.write("sky.ppm", "P3 2 1 255  255 255 255  0 128 255");
  return loadBody(files, "<emitter type='" + type + "'>" + properties + "</emitter>");
}

std::string lightError(const std::string& type, const std::string& properties) {
  return errorOf([&] { light(type, properties); });
}

// Of a lamp whose radiance is a picture: white, and (0, 128, 255) as bytes.
Scene pictured(const std::string& shape, const std::string& texture = "bitmap",
               const std::string& more = {}) {
  const Scratch files;
  files.write("glow.ppm", "P3 2 1 255  255 255 255  0 128 255");
  return loadBody(files, "<shape type='" + shape + "'><bsdf type='diffuse' id='case'/><emitter type='area'>" +
                             "<texture type='" + texture + "' name='radiance'>" +
                             "<string name='filename' value='glow.ppm'/>" + more +
                             "</texture></emitter></shape><shape type='cube'><ref id='case'/></shape>");
}

// The mesh emits the mean, and the picture says how much of it comes from where.
TEST(MitsubaLight, AnAreaLightMayHaveAPicture) {
  const Scene scene = pictured("rectangle");
  ASSERT_EQ(scene.meshes.size(), 2u);
  const float dark = 0.2158605f, green = (1 + dark) / 2;  // sRGB 128, linear
  expectNear(scene.meshes[0].radiance, {0.5, green, 1}, 1e-5);
  const Material& lamp = scene.materials.at(static_cast<std::size_t>(scene.meshes[0].material));
  ASSERT_EQ(lamp.emission.kind, SurfaceColor::Kind::kBitmap);
  const Texture& picture = scene.textures.at(static_cast<std::size_t>(lamp.emission.texture));
  expectNear(picture.pixels()[0], {2, 1 / green, 1}, 1e-5);
  expectNear(picture.pixels()[1], {0, dark / green, 1}, 1e-4);
  EXPECT_EQ(scene.meshes[1].radiance, Rgb());
  EXPECT_FALSE(isTextured(scene.materials.at(static_cast<std::size_t>(scene.meshes[1].material)).emission));
  EXPECT_NEAR(pictured("rectangle", "bitmap", "<boolean name='raw' value='true'/>").meshes[0].radiance.y,
              (1 + 128. / 255) / 2, 1e-5);
}

TEST(MitsubaLight, ASphereThatEmitsAPictureIsAMesh) {
  const Scene scene = pictured("sphere");
  EXPECT_TRUE(scene.spheres.empty());
  EXPECT_EQ(scene.meshes.at(0).radiance.z, 1);
  expectContains(errorOf([] { pictured("disk", "checkerboard"); }),
                 "the texture type 'checkerboard' is not supported; supported: bitmap");
}

TEST(MitsubaLight, AConstantEnvironmentHasNoPicture) {
  const Scene scene = light("constant", "<rgb name='radiance' value='1, 2, 3'/>");
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->radiance, (Rgb{1, 2, 3}));
  EXPECT_TRUE(scene.environment->picture.pixels.empty());
}

TEST(MitsubaLight, AnEnvmapHasAPictureATurnAndAScale) {
  const Scene scene = light("envmap",
                            "<string name='filename' value='sky.ppm'/><float name='scale' value='4'/>"
                            "<transform name='toWorld'><scale x='-2' y='2' z='2'/><rotate y='1' angle='90'/>"
                            "</transform><float name='samplingWeight' value='2'/>");
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->radiance, (Rgb{4, 4, 4}));
  EXPECT_EQ(scene.environment->picture.width, 2);
  EXPECT_FLOAT_EQ(scene.environment->picture.pixels[1].z, 1);
  EXPECT_NEAR(scene.environment->picture.pixels[1].y, 0.2159, 1e-4);  // sRGB 128, linear
  // x mirrored, then turned from z to x: the picture's +x goes to world +z.
  expectNear(scene.environment->to_world.x, {0, 0, 1}, 1e-9);
  expectNear(scene.environment->to_world.z, {1, 0, 0}, 1e-9);
}

TEST(MitsubaLight, PointLightsStandWhereTheySay) {
  const std::string intensity = "<spectrum name='intensity' value='5'/>";
  for (const std::string place :
       {"<point name='position' x='1' y='2' z='3'/>", "<point name='position' value='1, 2, 3'/>",
        "<transform name='toWorld'><translate x='1' y='2' z='3'/></transform>"}) {
    const Scene scene = light("point", place + intensity);
    ASSERT_EQ(scene.point_lights.size(), 1u);
    EXPECT_EQ(scene.point_lights[0].position, (Vec3{1, 2, 3}));
    EXPECT_EQ(scene.point_lights[0].intensity, (Rgb{5, 5, 5}));
  }
}

// Angles are degrees in the file; the beam is three quarters of the cutoff unless it is given.
TEST(MitsubaLight, SpotLightsShineAlongTheirZAxis) {
  const std::string rest =
      "<rgb name='intensity' value='1, 2, 3'/><transform name='to_world'>"
      "<lookat origin='1, 2, 3' target='1, 0, 3' up='0, 0, 1'/></transform>";
  const Scene scene = light("spot", rest);
  ASSERT_EQ(scene.spot_lights.size(), 1u);
  const SpotLight spot = scene.spot_lights[0];
  EXPECT_EQ(spot.position, (Vec3{1, 2, 3}));
  expectNear(spot.axis, {0, -1, 0}, 1e-7);
  EXPECT_EQ(spot.intensity, (Rgb{1, 2, 3}));
  EXPECT_NEAR(spot.cutoff, 0.34906585, 1e-7);
  EXPECT_NEAR(spot.beam, 0.26179939, 1e-7);
  const Scene wide =
      light("spot", rest + "<float name='cutoffAngle' value='90'/><float name='beamWidth' value='45'/>");
  EXPECT_NEAR(wide.spot_lights[0].cutoff, 1.5707963, 1e-6);
  EXPECT_NEAR(wide.spot_lights[0].beam, 0.78539816, 1e-6);
}

TEST(MitsubaLight, DirectionalLightsGoWhereTheySay) {
  const std::string irradiance = "<rgb name='irradiance' value='1, 0, 2'/>";
  for (const std::string direction :
       {"<vector name='direction' x='0' y='-3' z='0'/>", "<vector name='direction' value='0, -3, 0'/>",
        "<transform name='to_world'><rotate x='1' angle='90'/></transform>"}) {
    const Scene scene = light("directional", direction + irradiance);
    ASSERT_EQ(scene.directional_lights.size(), 1u);
    expectNear(scene.directional_lights[0].direction, {0, -1, 0}, 1e-7);
    EXPECT_EQ(scene.directional_lights[0].irradiance, (Rgb{1, 0, 2}));
  }
}

// By which clients move them.
TEST(MitsubaLight, LampsHaveTheNameOfTheirId) {
  const Scratch files;
  const Scene scene =
      loadBody(files,
               "<shape type='cube'/><emitter type='point' id='bulb'/><emitter type='spot' id='torch'/>"
               "<emitter type='directional' id='sun'/><emitter type='point'/>");
  EXPECT_EQ(scene.point_lights.at(0).name, "bulb");
  EXPECT_EQ(scene.point_lights.at(1).name, "");
  EXPECT_EQ(scene.spot_lights.at(0).name, "torch");
  EXPECT_EQ(scene.directional_lights.at(0).name, "sun");
}

TEST(MitsubaLight, ColouredLightNeedsThreeChannels) {
  EXPECT_EQ(colorChannels(light("constant", "<float name='radiance' value='2'/>")), 1);
  EXPECT_EQ(colorChannels(light("constant", "<rgb name='radiance' value='2, 2, 1'/>")), 3);
  EXPECT_EQ(colorChannels(light("point", "<rgb name='intensity' value='2, 2, 1'/>")), 3);
  EXPECT_EQ(colorChannels(light("directional", "<rgb name='irradiance' value='2, 2, 1'/>")), 3);
  EXPECT_EQ(colorChannels(light("envmap", "<string name='filename' value='sky.ppm'/>")), 3);
}

// As in Mitsuba.
TEST(MitsubaLight, LightIsWhiteUnlessItIsGiven) {
  EXPECT_EQ(light("constant", "").environment->radiance, (Rgb{1, 1, 1}));
  EXPECT_EQ(light("point", "").point_lights.at(0).intensity, (Rgb{1, 1, 1}));
  const Scratch files;
  const Scene lamp =
      loadBody(files, "<shape type='disk'><ref id='lamp'/></shape><emitter type='area' id='lamp'/>");
  EXPECT_EQ(lamp.meshes.at(0).radiance, (Rgb{1, 1, 1}));
}

TEST(MitsubaLight, FaultsAreErrors) {
  expectContains(lightError("envmap", ""), "the emitter needs <string name=\"filename\">");
  expectContains(lightError("envmap", "<string name='filename' value='absent.exr'/>"), "scene.xml:3: ");
  expectContains(lightError("envmap", "<string name='filename' value='absent.exr'/>"), "absent.exr");
  expectContains(
      lightError("envmap", "<string name='filename' value='sky.ppm'/><float name='scale' value='-1'/>"),
      "the scale must be within");
  expectContains(lightError("envmap",
                            "<string name='filename' value='sky.ppm'/><transform name='to_world'>"
                            "<matrix value='1 1 0 0 1 0 0 0 1'/></transform>"),
                 "not shear");
  expectContains(lightError("directional", "<vector name='direction' value='0 0 0'/>"), "must not be 0");
  expectContains(lightError("point", "<float name='intensity' value='1e30'/>"), "'intensity' must be");
  const std::string spot = "<rgb name='intensity' value='1'/>";
  expectContains(lightError("spot", spot + "<float name='cutoff_angle' value='181'/>"),
                 "the cutoff_angle must be within [0, 180] degrees");
  expectContains(lightError("spot", spot + "<float name='beam_width' value='30'/>"),
                 "the beam_width must be at most the cutoff_angle");
  expectContains(lightError("spot", spot + "<texture name='texture' type='bitmap'><string name='filename' "
                                           "value='sky.ppm'/></texture>"),
                 "<texture name=\"texture\"> is not supported");
  const Scratch files;
  const std::string sky = "<emitter type='constant'><float name='radiance' value='1'/></emitter>";
  expectContains(errorOf([&] { loadBody(files, sky + "\n" + sky); }), "scene.xml:4: a second emitter");
}

}  // namespace
}  // namespace saccade
