#include "scene/model/model_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "scene/library/scene_library.h"
#include "scene/scene_warnings.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

const std::string kTwo =
    "mtllib paint.mtl\nv 0 0 0\nv 4 0 0\nv 0 2 0\nv 4 2 -1\nvt 0 0\nvt 1 0\nvt 0 1\n"
    "usemtl red\nf 1/1 2/2 3/3\nusemtl lamp\nf 2/1 4/2 3/3\nusemtl red\nf 1/1 3/3 4/2\n";
const std::string kFace = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kPaint =
    "# two\nnewmtl red\nKa 1 1 1\nKd 0.8 0.1 0.1\nKs 0 0 0\nNs 98\nillum 2\n\n"
    "newmtl lamp\nKd 0\nKe 5 4 3\nNi 1.5\nd 0.5\n";

struct ModelScene : testing::Test {
  Scene obj(const std::string& text, const std::string& mtl) const {
    files.write("thing/paint.mtl", mtl);
    return loadObjScene(files.write("thing/scene.obj", text));
  }
  std::string error(const std::string& mtl) const {
    return errorOf([&] { obj(kTwo, mtl); });
  }
  Scratch files;
};

TEST_F(ModelScene, EachMaterialOfAnObjFileIsAMesh) {
  const Scene s = obj(kTwo, kPaint);
  ASSERT_EQ(s.meshes.size(), 2u);
  ASSERT_EQ(s.materials.size(), 2u);
  EXPECT_EQ(s.materials[0].name, "red");
  EXPECT_EQ(s.materials[0].reflectance.color0, (Rgb{0.8f, 0.1f, 0.1f}));
  EXPECT_EQ(s.materials[0].model.kind, BsdfKind::kDiffuse);
  EXPECT_EQ(s.meshes[0].triangles.size(), 2u);
  EXPECT_EQ(s.meshes[0].positions.size(), 5u);  // four, and the spare one
  EXPECT_EQ(s.meshes[0].uvs[s.meshes[0].triangles[1][1]].y, 1);
  EXPECT_EQ(s.meshes[1].radiance, (Rgb{5, 4, 3}));
  EXPECT_EQ(s.meshes[1].positions[s.meshes[1].triangles[0][1]], (Vec3{4, 2, -1}));
  EXPECT_FLOAT_EQ(s.materials[1].opacity.color0.x, 0.5f);
  for (const Mesh& mesh : s.meshes) EXPECT_EQ(mesh.name, "scene");
  EXPECT_EQ(s.name, "thing");
}

TEST_F(ModelScene, ALampInTheFileReplacesTheDefaultLight) {
  EXPECT_FALSE(obj(kTwo, kPaint).environment);
  EXPECT_EQ(obj(kTwo, kPaint).unread.size(), 1u);
  const Scene dark = obj(kTwo, "newmtl red\nnewmtl lamp\n");
  EXPECT_EQ(dark.environment->radiance, (Rgb{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(dark.directional_lights.size(), 1u);
  expectContains(dark.unread.at(1), "the file has no light");
}

// A highlight of exponent 98 is as wide as that of a Beckmann surface of alpha 0.1414.
TEST_F(ModelScene, AHighlightIsThatOfRoughPlastic) {
  const Material m = obj(kTwo, "newmtl red\nKs 0.5 0.5 0.5\nNs 98\n").materials.at(0);
  EXPECT_EQ(m.model.kind, BsdfKind::kRoughPlastic);
  EXPECT_NEAR(m.model.alpha, 0.141421, 1e-6);
  EXPECT_EQ(m.specular.color0, (Rgb{0.5f, 0.5f, 0.5f}));
}

TEST_F(ModelScene, PicturesLieBesideTheMaterials) {
  files.write("thing/my maps/red one.ppm", "P3 2 1 255  255 0 0  0 0 255");
  const Scene s = obj(kTwo,
                      "newmtl red\nmap_Kd -s 1 1 1 -clamp on my maps\\red one.ppm\nnewmtl lamp\nmap_Kd "
                      "my maps/red one.ppm\n");
  ASSERT_EQ(s.textures.size(), 1u);
  EXPECT_EQ(s.textures[0].pixels()[1], (Rgb{0, 0, 1}));
  EXPECT_EQ(s.materials[0].reflectance.kind, SurfaceColor::Kind::kBitmap);
  expectContains(s.unread.at(0), "paint.mtl: not read: -clamp, -s");
  expectContains(error("\nnewmtl red\nmap_Kd absent.png\n"), "paint.mtl:3: ");
  expectContains(error("\nnewmtl red\nmap_Kd absent.png\n"), "absent.png");
}

TEST_F(ModelScene, MaterialsThatAreNowhereAreGreyAndTold) {
  const Scene s = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nmtllib none.mtl\nusemtl blue\nf 3 2 1\n", "");
  ASSERT_EQ(s.materials.size(), 2u);
  for (const Material& m : s.materials) EXPECT_EQ(m.reflectance.color0, (Rgb{0.5f, 0.5f, 0.5f}));
  expectContains(s.unread.at(0), "none.mtl is absent: its materials are grey");
  expectContains(s.unread.at(1), "no file of materials has these, which are grey: blue");
  const Scene bumpy = obj(kTwo, "newmtl red\nmap_Bump b.png\nnewmtl lamp\nKe 1\nPr 0.5\n");
  expectContains(bumpy.unread.at(0), "paint.mtl: not read: Pr, map_Bump");
}

TEST_F(ModelScene, FaultsOfMaterialsNameTheLine) {
  expectContains(error("Kd 1 1 1\n"), "paint.mtl:1: a newmtl must come before 'Kd'");
  expectContains(error("newmtl red\nKd 1 2 1\n"), "paint.mtl:2: Kd: '2' is not a number from 0 to 1");
  expectContains(error("newmtl red\nKe -1 0 0\n"), "paint.mtl:2: Ke: '-1' is not a number from 0");
  expectContains(error("newmtl red\nd -halo 1\n"), "paint.mtl:2: d: '-halo'");
  expectContains(error("newmtl red\nKd spectral a.rfl\n"), "paint.mtl:2: Kd: 'spectral'");
  expectContains(error("newmtl red\nmap_Kd\n"), "paint.mtl:2: the map names no file");
}

TEST_F(ModelScene, MaterialsOfAPathThatLeadsNowhereLieBesideTheMesh) {
  const Scene s =
      obj("mtllib C:\\models\\paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n", kPaint);
  EXPECT_EQ(s.materials.at(0).reflectance.color0, (Rgb{0.8f, 0.1f, 0.1f}));
}

TEST_F(ModelScene, MaterialsAreBounded) {
  std::string libraries, uses = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (int i = 0; i < 65; ++i) libraries += "mtllib " + std::to_string(i) + ".mtl\n";
  for (int i = 0; i < 65536; ++i) uses += "usemtl " + std::to_string(i) + "\n";
  expectContains(errorOf([&] { obj(libraries + kTwo, kPaint); }), "more than 64 files of materials");
  expectContains(errorOf([&] { obj(uses, kPaint); }), "more than 65536 materials");
}

TEST_F(ModelScene, NothingOutsideOfTheScenesIsRead) {
  const Scratch other;
  const std::string secret = other.write("secret.mtl", kPaint);
  LoadOptions confined;
  confined.confined_to = {files.path("")};
  const auto error = [&](const std::string& text) {
    return errorOf([&] { loadObjScene(files.write("thing/scene.obj", text), confined); });
  };
  const Scene s =
      loadObjScene(files.write("thing/scene.obj", "mtllib " + secret + "\nusemtl red\n" + kFace), confined);
  expectContains(s.unread.at(0), "thing/secret.mtl is absent");
  std::filesystem::create_symlink(secret, files.path("thing/secret.mtl"));
  expectContains(error("mtllib secret.mtl\n" + kFace), "leads out of the folder of the scenes");
  files.write("thing/paint.mtl", "newmtl red\nmap_Kd " + other.write("a.ppm", "P3 1 1 255 1 1 1") + "\n");
  expectContains(error(kTwo), "leads out of the folder of the scenes");
  expectContains(errorOf([&] { loadPlyScene(other.write("a.ply", "ply"), confined); }), "leads out");
}

// All corners are within the picture, and one of them is near its edge.
TEST_F(ModelScene, TheDefaultCameraSeesAllOfIt) {
  for (const auto& [width, depth] : {std::pair("1", "1"), {"1000", "1"}, {"1", "50"}}) {
    std::string text;
    for (const std::string x : {"0", width})
      text += "v " + x + " 5 0\nv " + x + " 6 0\nv " + x + " 5 " + depth + "\n";
    const Scene s = obj(text + "f 1 2 3\nf 4 5 6\n", "");
    const double half = std::tan(s.fov_x_deg * std::numbers::pi / 360);
    double widest = 0;
    for (const Mesh& mesh : s.meshes)
      for (std::size_t i = 0; i + 1 < mesh.positions.size(); ++i) {
        const Vec3d p = rotate(conjugate(s.T_world_camera.rotation),
                               toDouble(mesh.positions[i]) - s.T_world_camera.position);
        ASSERT_GT(p.z, 0);
        widest = std::max(widest, std::max(std::abs(p.x), std::abs(p.y) * s.width / s.height) / p.z / half);
      }
    EXPECT_LT(widest, 1) << width;
    EXPECT_GT(widest, 0.5) << width;
  }
}

TEST(ModelLibrary, AFolderWithAMeshIsAScene) {
  const Scratch files;
  files.write(
      "all/ball/model.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n");
  files.write("all/two/scene.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  files.write("all/two/model.obj", "not read");
  const SceneLibrary library(files.path("all"));
  const auto entries = library.list();
  ASSERT_EQ(entries.size(), 2u);
  for (const SceneEntry& entry : entries) {
    EXPECT_EQ(entry.unavailable, "");
    expectContains(entry.description, "a mesh before a default camera");
  }
  EXPECT_EQ(entries[0].objects.at(0).name, "model");
  const auto told = warningsOf(library.load("ball"));
  ASSERT_EQ(told.size(), 3u);
  expectContains(told[0], "model.ply: its colours are not read");
  expectContains(told[1], "the file has no camera");
  EXPECT_EQ(library.load("two").meshes.at(0).triangles.size(), 1u);
}

}  // namespace
}  // namespace saccade
