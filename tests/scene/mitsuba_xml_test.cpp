#include "scene/mitsuba/mitsuba_xml.h"

#include <cmath>
#include <numbers>

#include "scene/scratch.h"

namespace saccade {
namespace {

const std::string kSensor = "<sensor type='perspective'><float name='fov' value='40'/></sensor>";

Scene load(const std::string& body) {
  const Scratch files;
  files.write("folder/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  return loadMitsubaXml(files.write("folder/scene.xml", "<scene version='3.0.0'>" + body + "</scene>"));
}

// Where a transform takes the point (1, 2, 3).
Vec3 mapped(const std::string& steps) {
  const Scene scene = load(kSensor + "<shape type='sphere'><point name='center' x='1' y='2' z='3'/>" +
                           "<transform name='to_world'>" + steps + "</transform></shape>");
  return scene.spheres[0].center;
}

TEST(MitsubaTransform, EachStepMapsAsItSays) {
  expectNear(mapped("<translate x='1' z='-1'/>"), {2, 2, 2}, 1e-6);
  expectNear(mapped("<translate value='1, 0, -1'/>"), {2, 2, 2}, 1e-6);
  expectNear(mapped("<scale value='2'/>"), {2, 4, 6}, 1e-6);
  expectNear(mapped("<rotate z='1' angle='90'/>"), {-2, 1, 3}, 1e-6);
  expectNear(mapped("<rotate value='0 0 5' angle='90'/>"), {-2, 1, 3}, 1e-6);
  expectNear(mapped("<matrix value='0 -1 0 4  1 0 0 5  0 0 1 6  0 0 0 1'/>"), {2, 6, 9}, 1e-6);
  expectNear(mapped("<matrix value='0 -1 0 1 0 0 0 0 1'/>"), {-2, 1, 3}, 1e-6);
  // Looking along -x with y up: left is z, so that (1, 2, 3) is 1 along z, 2 along y, 3 along -x.
  expectNear(mapped("<lookat origin='5,0,0' target='0,0,0' up='0,1,0'/>"), {2, 2, 1}, 1e-6);
}

TEST(MitsubaTransform, StepsApplyInOrder) {
  expectNear(mapped("<translate x='1'/><scale value='2'/>"), {4, 4, 6}, 1e-6);
  expectNear(mapped("<scale value='2'/><translate x='1'/>"), {3, 4, 6}, 1e-6);
}

TEST(MitsubaSensor, AxesTurnFromLeftUpToRightDown) {
  const Scene scene = load(
      "<sensor type='perspective'><float name='fov' value='40'/><transform name='to_world'>"
      "<lookat origin='1,2,3' target='1,2,9' up='0,1,0'/></transform>"
      "<film type='hdrfilm'><integer name='width' value='320'/><integer name='height' value='200'/>"
      "<string name='pixel_format' value='rgb'/><rfilter type='tent'/></film><sampler "
      "type='independent'/></sensor>");
  const Pose camera = scene.T_world_camera;
  expectNear(camera.position, {1, 2, 3}, 1e-12);
  expectNear(rotate(camera.rotation, {1, 0, 0}), {-1, 0, 0}, 1e-12);
  expectNear(rotate(camera.rotation, {0, 1, 0}), {0, -1, 0}, 1e-12);
  expectNear(rotate(camera.rotation, {0, 0, 1}), {0, 0, 1}, 1e-12);
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 200);
}

TEST(MitsubaSensor, FovIsTurnedIntoTheHorizontalOne) {
  const auto fovX = [](const std::string& axis, int width, int height) {
    return load("<sensor type='perspective'><float name='fov' value='40'/>" + axis +
                "<film type='hdrfilm'><integer name='width' value='" + std::to_string(width) +
                "'/><integer name='height' value='" + std::to_string(height) + "'/></film></sensor>")
        .fov_x_deg;
  };
  const auto named = [](const std::string& axis) { return "<string name='fov_axis' value='" + axis + "'/>"; };
  const double wide = 2 * std::atan(2 * std::tan(20 * std::numbers::pi / 180)) * 180 / std::numbers::pi;
  EXPECT_DOUBLE_EQ(fovX("", 200, 100), 40);
  EXPECT_DOUBLE_EQ(fovX(named("x"), 200, 100), 40);
  EXPECT_NEAR(fovX(named("y"), 200, 100), wide, 1e-9);
  EXPECT_NEAR(fovX(named("smaller"), 200, 100), wide, 1e-9);
  EXPECT_DOUBLE_EQ(fovX(named("smaller"), 100, 200), 40);
  EXPECT_DOUBLE_EQ(fovX(named("larger"), 200, 100), 40);
}

TEST(MitsubaXml, ADefaultMayUseAnEarlierOne) {
  const std::string body = "<default name='size' value='2'/><default name='twice' value='$size'/>" + kSensor +
                           "<shape type='sphere'><float name='radius' value='$twice'/></shape>";
  EXPECT_FLOAT_EQ(load(body).spheres[0].radius, 2);
}

TEST(MitsubaXml, SharesMaterialsByReference) {
  const Scene scene = load(kSensor +
                           "<bsdf type='twosided' id='paint'><bsdf type='diffuse'>"
                           "<rgb name='reflectance' value='0.1 0.2, 0.3'/></bsdf></bsdf>"
                           "<shape type='rectangle'><ref id='paint'/></shape>"
                           "<shape type='cube' id='box'><ref id='paint'/></shape>"
                           "<shape type='obj'><string name='filename' value='a.obj'/></shape>");
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "paint");
  EXPECT_TRUE(scene.materials[0].twosided);
  expectNear(scene.materials[0].reflectance.color0, {0.1f, 0.2f, 0.3f}, 1e-7);
  EXPECT_EQ(scene.meshes[1].material, 0);
  EXPECT_EQ(scene.meshes[1].name, "box");
  EXPECT_EQ(scene.meshes[2].name, "a");
  EXPECT_FALSE(scene.materials[1].twosided);
  expectNear(scene.materials[1].reflectance.color0, {0.5f, 0.5f, 0.5f}, 1e-7);
}

TEST(MitsubaXml, WhatHasNoIdIsNamedAfterItsType) {
  const Scene scene = load(kSensor +
                           "<shape type='rectangle'/><shape type='sphere'/><shape type='sphere' id='ball'/>"
                           "<shape type='cube'><bsdf type='twosided'><bsdf type='plastic'/></bsdf></shape>");
  EXPECT_EQ(scene.meshes[0].name, "rectangle");
  EXPECT_EQ(scene.meshes[1].name, "cube");
  EXPECT_EQ(scene.spheres[0].name, "sphere");
  EXPECT_EQ(scene.spheres[1].name, "ball");
  EXPECT_EQ(scene.materials[0].name, "default");
  EXPECT_EQ(scene.materials[1].name, "plastic");
}

TEST(MitsubaXml, MeshesAreSmoothUnlessTheyAskForFaceNormals) {
  const auto normals = [](const std::string& flag) {
    return load(kSensor + "<shape type='obj'><string name='filename' value='a.obj'/>" + flag + "</shape>")
        .meshes[0]
        .normals.size();
  };
  EXPECT_EQ(normals(""), 3u);
  EXPECT_EQ(normals("<boolean name='face_normals' value='true'/>"), 0u);
}

TEST(MitsubaXml, MeshesMayFaceTheOtherWay) {
  const auto mesh = [](const std::string& more) {
    return load(kSensor + "<shape type='obj'><string name='filename' value='a.obj'/>" + more + "</shape>")
        .meshes[0];
  };
  const Mesh plain = mesh(""), turned = mesh("<boolean name='flipNormals' value='true'/>");
  EXPECT_EQ(plain.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(turned.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(plain.normals[0], (Vec3{0, 0, 1}));
  EXPECT_EQ(turned.normals[0], (Vec3{0, 0, -1}));
  EXPECT_EQ(mesh("<boolean name='flip_normals' value='false'/>").triangles, plain.triangles);
}

TEST(MitsubaXml, ReadsEmittersAndCheckerboards) {
  const Scene scene =
      load(kSensor +
           "<texture type='checkerboard' id='board'><float name='color1' value='0.9'/>"
           "<transform name='to_uv'><scale x='4' y='8'/><translate x='0.5'/></transform></texture>"
           "<bsdf type='diffuse' id='b'><ref name='reflectance' id='board'/></bsdf>"
           "<shape type='rectangle'><ref id='b'/>"
           "<emitter type='area'><rgb name='radiance' value='17, 12, 4'/></emitter></shape>"
           "<shape type='sphere'><emitter type='area'><float name='radiance' value='3'/></emitter>"
           "</shape>");
  const SurfaceColor& board = scene.materials[0].reflectance;
  EXPECT_EQ(board.kind, SurfaceColor::Kind::kCheckerboard);
  EXPECT_FLOAT_EQ(board.color0.x, 0.4f);
  EXPECT_FLOAT_EQ(board.color1.y, 0.9f);
  EXPECT_FLOAT_EQ(board.uv_scale.y, 8);
  EXPECT_FLOAT_EQ(board.uv_offset.x, 0.5f);
  expectNear(scene.meshes[0].radiance, {17, 12, 4}, 0);
  expectNear(scene.spheres[0].radiance, {3, 3, 3}, 0);
}

// Mitsuba's depth counts edges of a path, the first two of which are direct light.
TEST(MitsubaXml, TheDepthOfTheIntegratorSaysTheBounces) {
  const auto bounces = [](const std::string& integrator) {
    return load(integrator + "<sensor type='perspective'><float name='fov' value='40'/></sensor>").bounces;
  };
  const auto depth = [&](const std::string& value) {
    return bounces("<integrator type='path'><integer name='maxDepth' value='" + value + "'/></integrator>");
  };
  EXPECT_EQ(depth("13"), 11);
  EXPECT_EQ(depth("2"), 0);
  EXPECT_EQ(depth("1"), 0);
  EXPECT_EQ(depth("-1"), std::nullopt);
  EXPECT_EQ(
      bounces(
          "<default name='deep' value='9'/><integrator type='aov'><string name='aovs' value='dd.y:depth'/>"
          "<integrator type='volpath'><integer name='max_depth' value='$deep'/></integrator></integrator>"),
      7);
  EXPECT_EQ(bounces("<integrator type='path'/>"), std::nullopt);
  EXPECT_EQ(bounces("<integrator type='aov' id='a'><ref id='b'/><ref id='b'/></integrator>"
                    "<integrator type='aov' id='b'><ref id='a'/><ref id='a'/></integrator>"),
            std::nullopt);
  EXPECT_EQ(bounces(""), std::nullopt);
}

// The same scene as it is written for 0.5 and for 3.
TEST(MitsubaXml, BothDialectsSayTheSame) {
  const auto scene = [](const std::string& fov_axis, const std::string& to_world, const std::string& look_at,
                        const std::string& face_normals, const std::string& file_format) {
    return load(
        "<integrator type='path'><integer name='maxDepth' value='9'/></integrator>"
        "<sensor type='perspective'><float name='fov' value='40'/><string name='" +
        fov_axis + "' value='x'/><transform name='" + to_world + "'><" + look_at +
        " origin='1,2,3' target='1,2,9' up='0,1,0'/></transform><film type='hdrfilm'>"
        "<string name='" +
        file_format +
        "' value='openexr'/><boolean name='banner' value='false'/>"
        "<rfilter name='rfilter' type='tent'/></film><sampler type='sobol'/></sensor>"
        "<shape type='obj'><string name='filename' value='a.obj'/><boolean name='" +
        face_normals + "' value='true'/><transform name='" + to_world +
        "'><translate x='5'/></transform></shape>");
  };
  const Scene old = scene("fovAxis", "toWorld", "lookAt", "faceNormals", "fileFormat");
  const Scene now = scene("fov_axis", "to_world", "lookat", "face_normals", "file_format");
  for (const Scene* s : {&old, &now}) {
    EXPECT_EQ(s->T_world_camera.position, (Vec3d{1, 2, 3}));
    EXPECT_EQ(s->meshes[0].positions[0], (Vec3{5, 0, 0}));
    EXPECT_TRUE(s->meshes[0].normals.empty());
  }
}

TEST(MitsubaXml, ObjectsMayHaveNames) {
  const Scene scene =
      load(kSensor +
           "<bsdf type='diffuse' id='a'/><shape type='cube'><ref name='bsdf' id='a'/>"
           "<emitter name='light' type='area'><spectrum name='radiance' value='2'/></emitter></shape>");
  EXPECT_EQ(scene.materials[0].name, "a");
  expectNear(scene.meshes[0].radiance, {2, 2, 2}, 0);
}

TEST(MitsubaXml, LightIsGreyWhereTheWholeSceneIs) {
  const std::string grey = kSensor +
                           "<shape type='rectangle'><emitter type='area'>"
                           "<float name='radiance' value='3'/></emitter></shape>";
  EXPECT_EQ(colorChannels(load(grey)), 1);
  EXPECT_EQ(colorChannels(load(grey + "<shape type='sphere'><bsdf type='diffuse'>"
                                      "<rgb name='reflectance' value='0.1 0.1 0.2'/></bsdf></shape>")),
            3);
}

}  // namespace
}  // namespace saccade
