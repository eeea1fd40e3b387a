// Materials, textures and lamps of glTF files.
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <numbers>

#include "scene/gltf/two_sides.h"
#include "scene/gltf_scratch.h"
#include "scene/mesh/mesh.h"

namespace saccade {
namespace {

constexpr const char* kShaded =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}])";

// Writes a row of pixels as they are.
void writePng(const std::string& path, int channels, const std::vector<unsigned char>& bytes) {
  OIIO::ImageSpec spec(static_cast<int>(bytes.size()) / channels, 1, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  auto out = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(out->open(path, spec) && out->write_image(OIIO::TypeDesc::UINT8, bytes.data()) && out->close());
}

// A triangle of this material, with pictures colour.png, surface.png and clear.png.
Scene loadMaterial(const std::string& material, const std::string& more = R"("scenes":[])") {
  const Scratch files;
  writePng(files.path("colour.png"), 3, {255, 0, 128, 255, 0, 128});
  writePng(files.path("surface.png"), 3, {200, 51, 255, 100, 51, 255});
  writePng(files.path("clear.png"), 4, {255, 255, 255, 102, 255, 255, 255, 204});
  test::GltfArrays arrays = test::triangle();
  arrays.floats({0, 0, 1, 0, 0, 1}, "VEC2");
  const std::string images = R"("images":[{"uri":"colour.png"},{"uri":"surface.png"},{"uri":"clear.png"}])";
  const std::string textures = R"("textures":[{"source":0},{"source":1},{"source":2}])";
  return test::loadGltfOf(
      files, arrays,
      {kShaded, test::kTriangleNode, images, textures, more, R"("materials":[)" + material + "]"});
}

const std::vector<Rgb>& pixelsOf(const Scene& scene, const SurfaceColor& c) {
  return scene.textures.at(static_cast<std::size_t>(c.texture)).pixels();
}

// glTF 2.0, 5.19 and 5.22.
TEST(GltfMaterial, HasGltfsDefaults) {
  const Scene scene = test::loadTriangle({test::kTriangleNode});
  const Material& m = scene.materials.at(0);
  EXPECT_EQ(m.model.kind, BsdfKind::kMetallicRoughness);
  EXPECT_EQ(m.reflectance.color0, (Rgb{1, 1, 1}));
  EXPECT_EQ(m.metallic_roughness.color0, (Rgb{0, 1, 1}));
  EXPECT_TRUE(m.twosided);
  EXPECT_TRUE(isOpaque(m));
}

TEST(GltfMaterial, TakesFactors) {
  const Scene scene = loadMaterial(R"({"name":"red","doubleSided":true,"pbrMetallicRoughness":
    {"baseColorFactor":[0.5,0.25,0,0.1],"metallicFactor":0.25,"roughnessFactor":0.75}})");
  const Material& m = scene.materials.at(0);
  EXPECT_EQ(m.name, "red");
  EXPECT_EQ(m.reflectance.color0, (Rgb{0.5f, 0.25f, 0}));
  EXPECT_EQ(m.metallic_roughness.color0, (Rgb{0, 0.75f, 0.25f}));
  EXPECT_TRUE(m.twosided && isOpaque(m));  // alpha counts in the modes MASK and BLEND alone
}

// Colours are sRGB, roughness (green) and metalness (blue) linear; all are multiplied by the factors.
TEST(GltfMaterial, MultipliesTexturesByFactors) {
  const Scene scene = loadMaterial(R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1],
    "baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1},"metallicFactor":0.5}})");
  const Material& m = scene.materials.at(0);
  const float linear = static_cast<float>(std::pow((128 / 255.0 + 0.055) / 1.055, 2.4));
  expectNear(pixelsOf(scene, m.reflectance).at(0), {0.5f, 0, linear}, 1e-6);
  expectNear(pixelsOf(scene, m.metallic_roughness).at(0), {0, 0.2f, 0.5f}, 1e-6);
  EXPECT_EQ(scene.meshes.at(0).uvs.size(), 3u);
}

// glTF's v = 0 is the top of the picture, and that of Texture the bottom [KHR_texture_transform].
TEST(GltfMaterial, TurnsTextureCoordinatesUpsideDown) {
  const Scene scene = loadMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
    "extensions":{"KHR_texture_transform":{"scale":[2,4],"offset":[0.5,0.25]}}}}})");
  const SurfaceColor& c = scene.materials.at(0).reflectance;
  const float u = 0.3f, v = 0.1f;
  EXPECT_FLOAT_EQ(u * c.uv_scale.x + c.uv_offset.x, 0.5f + 2 * u);
  EXPECT_FLOAT_EQ(v * c.uv_scale.y + c.uv_offset.y, 1 - (0.25f + 4 * v));
}

// Coordinates turn counter-clockwise in the picture, whose v goes down, so a quarter takes u to -v. The
// exporter of Blender does so, too.
TEST(GltfMaterial, TurnsTextures) {
  const Scene scene = loadMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
    "extensions":{"KHR_texture_transform":{"scale":[2,4],"rotation":1.5707963267948966}}}}})");
  const SurfaceColor& c = scene.materials.at(0).reflectance;
  const float u = 0.3f, v = 0.1f;
  EXPECT_NEAR(u * c.uv_scale.x + v * c.uv_cross.x + c.uv_offset.x, 4 * v, 1e-6f);
  EXPECT_NEAR(v * c.uv_scale.y + u * c.uv_cross.y + c.uv_offset.y, 1 + 2 * u, 1e-6f);
}

TEST(GltfMaterial, OfModeMaskIsCutAtTheThreshold) {
  const std::string base = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":2}})";
  const Scene cut = loadMaterial(R"({"alphaMode":"MASK","alphaCutoff":0.6,)" + base + "}");
  EXPECT_EQ(pixelsOf(cut, cut.materials[0].opacity).at(0).x, 0);
  EXPECT_EQ(pixelsOf(cut, cut.materials[0].opacity).at(1).x, 1);
  const Scene blend = loadMaterial(R"({"alphaMode":"BLEND",)" + base + "}");
  EXPECT_FLOAT_EQ(pixelsOf(blend, blend.materials[0].opacity).at(0).x, 0.4f);
  const Scene opaque = loadMaterial(
      R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[1,1,1,0.5]}})");
  EXPECT_FLOAT_EQ(pixelsOf(opaque, opaque.materials[0].opacity).at(0).x, 0.5f);  // a picture without alpha
}

TEST(GltfMaterial, OfANormalMapIsBumpy) {
  const Scene scene = loadMaterial(R"({"normalTexture":{"index":1,"scale":0.5}})");
  EXPECT_TRUE(isBumpy(scene.materials.at(0)));
  EXPECT_EQ(scene.materials[0].normals_scale, 0.5f);
  expectNear(pixelsOf(scene, scene.materials[0].normals).at(0), {200 / 255.f, 0.2f, 1}, 1e-6);
}

TEST(GltfMaterial, EmitsFactorTimesStrengthTimesTheMeanOfItsTexture) {
  const std::string strength = R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}})";
  const Scene plain = loadMaterial(R"({"emissiveFactor":[1,0.5,0.25],)" + strength + "}");
  EXPECT_EQ(plain.meshes.at(0).radiance, (Rgb{8, 4, 2}));
  EXPECT_FALSE(plain.environment);
  const Scene pictured =
      loadMaterial(R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0},)" + strength + "}");
  EXPECT_FLOAT_EQ(pictured.meshes.at(0).radiance.x, 8);
  EXPECT_EQ(pictured.meshes.at(0).radiance.y, 0);
}

// The mesh emits the mean, and the picture is a factor of it. The base colour has its own picture.
TEST(GltfMaterial, EmitsAsItsTextureSays) {
  const Scene scene = loadMaterial(R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":1},
    "pbrMetallicRoughness":{"baseColorTexture":{"index":1}}})");
  const auto linear = [](double v) { return std::pow((v / 255 + 0.055) / 1.055, 2.4); };
  const double bright = linear(200), dark = linear(100), mean = (bright + dark) / 2;
  EXPECT_NEAR(scene.meshes.at(0).radiance.x, mean, 1e-5);
  const Material& m = scene.materials.at(0);
  EXPECT_NEAR(pixelsOf(scene, m.emission)[0].x, bright / mean, 1e-5);
  EXPECT_NEAR(pixelsOf(scene, m.emission)[1].x, dark / mean, 1e-5);
  EXPECT_NEAR(pixelsOf(scene, m.emission)[1].y, 1, 1e-5);
  EXPECT_NEAR(pixelsOf(scene, m.reflectance)[0].x, bright, 1e-5);
  for (const std::string& told : scene.unread) EXPECT_EQ(told.find("emissive"), told.npos) << told;
}

// As two meshes: the back is behind the front, and faces the other way.
TEST(GltfMaterial, ThatIsDoubleSidedEmitsFromBothSides) {
  const std::string lamp = R"("emissiveFactor":[1,1,1])";
  EXPECT_EQ(loadMaterial("{" + lamp + "}").meshes.size(), 1u);
  const Scene scene = loadMaterial(R"({"doubleSided":true,)" + lamp + "}");
  ASSERT_EQ(scene.meshes.size(), 2u);
  const Mesh& back = scene.meshes[1];
  EXPECT_EQ(back.name, "it");
  EXPECT_EQ(back.radiance, (Rgb{1, 1, 1}));
  EXPECT_NEAR(back.positions[0].z, -1e-4 * std::sqrt(2), 1e-8);
  const auto [a, b, c] = back.triangles.at(0);
  EXPECT_LT(cross(back.positions[b] - back.positions[a], back.positions[c] - back.positions[a]).z, 0);
}

TEST(GltfMaterial, OfAClosedMeshHasNoBackToEmitFrom) {
  Mesh cube = makeCube();  // its faces share no vertex
  placeMesh(cube, {}, true);
  EXPECT_FALSE(isOpen(cube));
  cube.triangles.pop_back();
  EXPECT_TRUE(isOpen(cube));
}

TEST(GltfMaterial, HasTwoSetsOfTextureCoordinates) {
  const Scratch files;
  writePng(files.path("colour.png"), 3, {255, 0, 128, 255, 0, 128});
  test::GltfArrays arrays = test::triangle();
  arrays.floats({0, 0, 1, 0, 0, 1}, "VEC2");
  arrays.floats({0.5f, 0.5f, 1, 0, 0, 1}, "VEC2");
  const auto load = [&](const std::string& sets) {
    return test::loadGltfOf(
        files, arrays,
        {R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_2":1,"TEXCOORD_1":2},"material":0}]}])",
         test::kTriangleNode, R"("images":[{"uri":"colour.png"}],"textures":[{"source":0}])",
         R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":2}},)" + sets +
             "}]"});
  };
  const Scene two = load(R"("normalTexture":{"index":0,"texCoord":1})");
  const Material& m = two.materials.at(0);
  EXPECT_TRUE(isBumpy(m) && m.normals.second_uvs && !m.reflectance.second_uvs);
  EXPECT_EQ(two.meshes.at(0).uvs.at(0).x, 0);
  EXPECT_EQ(two.meshes.at(0).second_uvs.at(0).x, 0.5f);
  const Scene three = load(R"("normalTexture":{"index":0,"texCoord":1},"emissiveFactor":[1,1,1],
                              "emissiveTexture":{"index":0})");
  EXPECT_FALSE(isTextured(three.materials.at(0).emission));
  expectContains(three.unread.at(0), "emissiveTexture is not shown: it has the third set");
  EXPECT_TRUE(load(R"("doubleSided":true)").meshes.at(0).second_uvs.empty());
}

// KHR_materials_specular scales the reflectance at a right angle: 0.04 becomes 0.01.
TEST(GltfMaterial, HasTheIndexOfItsReflectance) {
  const auto reflectance = [](const std::string& extension) {
    const float n = loadMaterial(R"({"extensions":{)" + extension + "}}").materials.at(0).model.ior;
    return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
  };
  EXPECT_NEAR(reflectance(R"("KHR_materials_ior":{"ior":2})"), 1 / 9.f, 1e-6);
  EXPECT_NEAR(reflectance(R"("KHR_materials_specular":{"specularFactor":0.25})"), 0.01f, 1e-6);
}

TEST(GltfMaterial, ThatTransmitsIsGlass) {
  const auto kindOf = [](const std::string& more, const std::string& roughness) {
    return loadMaterial(R"({"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":)" + roughness +
                        R"(},"extensions":{"KHR_materials_transmission":{"transmissionFactor":1})" + more +
                        "}}")
        .materials.at(0)
        .model.kind;
  };
  const std::string volume = R"(,"KHR_materials_volume":{"thicknessFactor":1})";
  EXPECT_EQ(kindOf("", "0"), BsdfKind::kThinDielectric);
  EXPECT_EQ(kindOf(volume, "0"), BsdfKind::kDielectric);
  EXPECT_EQ(kindOf(volume, "0.5"), BsdfKind::kRoughDielectric);
}

std::string lamps(const std::string& light) {
  return R"("extensions":{"KHR_lights_punctual":{"lights":[)" + light + "]}}";
}
constexpr const char* kLampNode = R"("nodes":[{"mesh":0},{"translation":[1,2,3],
  "rotation":[-0.7071067811865476,0,0,0.7071067811865476],"extensions":{"KHR_lights_punctual":{"light":0}}}])";

// A lamp shines along -z of its node: here down.
TEST(GltfLights, AreInCandelaAndLux) {
  const Scene spot = test::loadTriangle({kLampNode, lamps(R"({"type":"spot","color":[1,0.5,0],"intensity":10,
    "spot":{"innerConeAngle":0.2,"outerConeAngle":0.4}})")});
  const SpotLight& s = spot.spot_lights.at(0);
  EXPECT_EQ(s.position, (Vec3{1, 2, 3}));
  expectNear(s.axis, {0, -1, 0}, 1e-6);
  EXPECT_EQ(s.intensity, (Rgb{10, 5, 0}));
  EXPECT_FLOAT_EQ(s.beam, 0.2f);
  EXPECT_FLOAT_EQ(s.cutoff, 0.4f);
  const Scene sun = test::loadTriangle({kLampNode, lamps(R"({"type":"directional","intensity":3})")});
  expectNear(sun.directional_lights.at(0).direction, {0, -1, 0}, 1e-6);
  EXPECT_EQ(sun.directional_lights[0].irradiance, (Rgb{3, 3, 3}));
  EXPECT_FALSE(sun.environment);
}

std::string sky(const std::string& radiance) {
  return R"("scenes":[{"nodes":[0],"extensions":{"SACCADE_sky":{)" + radiance +
         R"(}}}],"extensionsUsed":["SACCADE_sky"])";
}

TEST(GltfLights, OfOurOwnSkyAreEven) {
  const Scene scene = test::loadTriangle({test::kTriangleNode, sky(R"("radiance":[0.5,1,2])")});
  ASSERT_TRUE(scene.environment.has_value());
  EXPECT_EQ(scene.environment->radiance, (Rgb{0.5f, 1, 2}));
  for (const std::string& sentence : scene.unread) EXPECT_EQ(sentence.find("sky"), sentence.npos) << sentence;
  const auto fault = [](const std::string& radiance) {
    return errorOf([&] { test::loadTriangle({test::kTriangleNode, sky(radiance)}); });
  };
  expectContains(fault(R"("radiance":[1,-1,1])"), "the light must be within [0, 1e18]");
  expectContains(fault(R"("radiance":1)"), "is not an array of 3 numbers");
  expectContains(fault(R"("rotation":[0,0,0,0])"), "SACCADE_sky: the rotation has no length");
  expectContains(fault(R"("picture":"absent.exr")"), "SACCADE_sky.picture: ");
}

// A turn by 90 degrees about y brings the picture's -z to -x.
TEST(GltfLights, OfOurOwnSkyMayHaveAPicture) {
  const Scratch files;
  files.write("sky.ppm", "P3 2 1 255 255 0 0 0 0 255");
  const Scene scene = test::loadGltfOf(
      files, test::triangle(),
      {test::kTriangleMesh, test::kTriangleNode,
       sky(R"("picture":"sky.ppm","rotation":[0,0.7071067811865476,0,0.7071067811865476])")});
  ASSERT_TRUE(scene.environment.has_value());
  EXPECT_EQ(scene.environment->radiance, (Rgb{1, 1, 1}));
  EXPECT_EQ(scene.environment->picture.pixels, (std::vector<Rgb>{{1, 0, 0}, {0, 0, 1}}));
  expectNear(mapVector(scene.environment->to_world, {0, 0, -1}), {-1, 0, 0}, 1e-9);
}

// Blender writes watts / (4 pi) times 683, beside radiance in radiant units.
TEST(GltfLights, OfBlenderAreRadiant) {
  const Scratch files;
  const test::GltfArrays arrays = test::triangle();
  files.write("data.bin", arrays.bytes());
  const std::string text = R"({"asset":{"version":"2.0","generator":"Khronos glTF Blender I/O v3.4.50"},)" +
                           std::string(test::kTriangleMesh) + "," + kLampNode + "," +
                           lamps(R"({"type":"point","intensity":2717.5706532941126})") + "," + arrays.json() +
                           "}";
  const Scene scene = loadGltf(files.write("scene.gltf", text), {});
  EXPECT_NEAR(scene.point_lights.at(0).intensity.x, 50 / (4 * std::numbers::pi), 1e-5);
}

// The light is that of a mesh alone, see model_scene_test.
TEST(GltfDefaults, AreASkyASunAndACameraThatSeesAll) {
  const Scene scene = test::loadTriangle({test::kTriangleNode});
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->radiance, (Rgb{0.5f, 0.5f, 0.5f}));
  ASSERT_EQ(scene.directional_lights.size(), 1u);
  EXPECT_EQ(scene.directional_lights[0].irradiance, (Rgb{3, 3, 3}));
  EXPECT_EQ(scene.unread.size(), 2u);
  const Pose to_camera = inverse(scene.T_world_camera);
  const double half_x = std::tan(scene.fov_x_deg * std::numbers::pi / 360), half_y = half_x * 480 / 640;
  for (const Vec3d corner : {Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}) {
    const Vec3d p = rotate(to_camera.rotation, corner) + to_camera.position;
    EXPECT_LT(std::abs(p.x / p.z), half_x);
    EXPECT_LT(std::abs(p.y / p.z), half_y);
  }
}

}  // namespace
}  // namespace saccade
