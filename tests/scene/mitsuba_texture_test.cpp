#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

// The texture of a material at the uv of a mesh.
float shown(const Scene& scene, Vec2 uv) {
  const SurfaceColor& c = scene.materials.at(0).reflectance;
  return scene.textures.at(static_cast<std::size_t>(c.texture))
      .sample({uv.x * c.uv_scale.x + c.uv_offset.x, uv.y * c.uv_scale.y + c.uv_offset.y}, 0)
      .x;
}

class MitsubaTexture : public testing::Test {
 protected:
  MitsubaTexture() {
    files_.write("a flag.ppm", "P3 1 2 255  255 255 255  0 0 0");  // white over black
    // One triangle whose first vertex has v = 0.25.
    files_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nvt 1 0.25\nvt 0 1\nf 1/1 2/2 3/3\n");
    files_.write(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float u\nproperty float v\nelement face 1\nproperty list uchar int "
        "vertex_indices\nend_header\n0 0 0 0 0.25\n1 0 0 1 0.25\n0 1 0 0 1\n3 0 1 2\n");
  }
  Scene load(const std::string& shape, const std::string& properties = {}, const std::string& map = {}) {
    return loadBody(files_, "<shape type='" + shape + "'><string name='filename' value='a." + shape + "'/>" +
                                properties +
                                "<bsdf type='diffuse'><texture name='reflectance' type='bitmap'>"
                                "<string name='filename' value='a flag.ppm'/>" +
                                map + "</texture></bsdf></shape>");
  }
  Scratch files_;
};

// Mitsuba's v = 0 is the top row of a picture; of OBJ files it turns v round.
TEST_F(MitsubaTexture, PicturesStandAsInMitsuba) {
  const auto first = [](const Scene& scene) { return shown(scene, scene.meshes[0].uvs[0]); };
  EXPECT_EQ(first(load("obj")), 0);
  EXPECT_EQ(first(load("ply")), 1);
  EXPECT_EQ(first(load("obj", "<boolean name='flipTexCoords' value='false'/>")), 1);
  EXPECT_EQ(first(load("ply", "<boolean name='flip_tex_coords' value='true'/>")), 0);
  EXPECT_EQ(first(load("ply", "", "<float name='vscale' value='-1'/>")), 0);
}

TEST_F(MitsubaTexture, BothWaysToMapCoordinatesAgree) {
  const Scene old = load("ply", "",
                         "<float name='uscale' value='2'/><float name='vscale' value='3'/>"
                         "<float name='uoffset' value='0.5'/><float name='voffset' value='0.25'/>");
  const Scene now = load("ply", "",
                         "<transform name='to_uv'><scale x='2' y='3'/>"
                         "<translate x='0.5' y='0.25'/></transform>");
  for (const Scene* scene : {&old, &now}) {
    const SurfaceColor& c = scene->materials[0].reflectance;
    EXPECT_FLOAT_EQ(c.uv_scale.x, 2);
    EXPECT_FLOAT_EQ(c.uv_offset.x, 0.5f);
    EXPECT_FLOAT_EQ(c.uv_scale.y, -3);  // 1 - (3 v + 0.25): from the bottom
    EXPECT_FLOAT_EQ(c.uv_offset.y, 0.75f);
  }
}

TEST_F(MitsubaTexture, CheckerboardsKeepMitsubasOwnCoordinates) {
  const Scene scene =
      loadBody(files_,
               "<shape type='obj'><string name='filename' value='a.obj'/><bsdf type='conductor'>"
               "<texture name='specularReflectance' type='checkerboard'><float name='vscale' "
               "value='80'/><rgb name='color0' value='0.8, 0.8, 0.8'/></texture></bsdf></shape>",
               "0.5.0");
  const SurfaceColor& board = scene.materials[0].specular;
  EXPECT_EQ(board.kind, SurfaceColor::Kind::kCheckerboard);
  EXPECT_FLOAT_EQ(board.uv_scale.y, 80);
  EXPECT_FLOAT_EQ(board.color0.x, 0.8f);
  EXPECT_FLOAT_EQ(board.color1.x, 0.2f);
  EXPECT_FLOAT_EQ(scene.meshes[0].uvs[0].y, 0.75f);
}

TEST_F(MitsubaTexture, GammaOneAndRawLeaveValuesAsTheyAre) {
  files_.write("a flag.ppm", "P3 1 1 255  128 128 128");
  const auto value = [&](const std::string& map) { return shown(load("ply", "", map), {0, 0}); };
  EXPECT_FLOAT_EQ(value("<float name='gamma' value='1'/>"), 128 / 255.f);
  EXPECT_FLOAT_EQ(value("<boolean name='raw' value='true'/>"), 128 / 255.f);
  EXPECT_FLOAT_EQ(value("<string name='filterType' value='ewa'/>"),
                  value("<float name='gamma' value='-1'/>"));
  EXPECT_NEAR(value(""), 0.2159, 1e-4);  // sRGB 128, linear
}

TEST_F(MitsubaTexture, AFileIsReadOnce) {
  const std::string texture =
      "<texture name='reflectance' type='bitmap'><string name='filename' value='a flag.ppm'/></texture>";
  const Scene scene = loadBody(files_, "<shape type='cube'><bsdf type='diffuse'>" + texture +
                                           "</bsdf></shape><shape type='disk'><bsdf type='diffuse'>" +
                                           texture + "</bsdf></shape>");
  EXPECT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.textures.size(), 1u);
}

TEST_F(MitsubaTexture, FaultsAreErrors) {
  const auto error = [&](const std::string& map) { return errorOf([&] { load("ply", "", map); }); };
  expectContains(error("<float name='gamma' value='2.2'/>"), "scene.xml:3: a gamma of 2.2");
  expectContains(error("<string name='wrapMode' value='clamp'/>"), "'clamp' is not supported");
  expectContains(error("<transform name='to_uv'><rotate z='1' angle='30'/></transform>"),
                 "scale and translate");
}

}  // namespace
}  // namespace saccade
