#include "scene/scene_warnings.h"

#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

using Texts = std::vector<std::string>;

const std::string kLamp = "<emitter type='constant'><float name='radiance' value='1'/></emitter>";
const std::string kBsdf = "<bsdf type='diffuse'/>";

std::string mesh(const std::string& file, const std::string& inside = {}) {
  return "<shape type='" + file.substr(file.size() - 3) + "'><string name='filename' value='" + file + "'/>" +
         inside + "</shape>";
}

struct SceneWarnings : testing::Test {
  SceneWarnings() {
    files.write("brown.obj", "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl brown\nf 1 2 3\n");
    files.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    files.write(
        "painted.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
        "z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty "
        "list uchar int vertex_indices\nend_header\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n");
  }
  Texts of(const std::string& body) const { return warningsOf(loadBody(files, body)); }
  Scratch files;
};

TEST_F(SceneWarnings, NameOnceEachFileWhoseMaterialsOrColoursAreNotRead) {
  const Texts told =
      of(kLamp + mesh("brown.obj") + mesh("painted.ply") + mesh("brown.obj") + mesh("plain.obj"));
  ASSERT_EQ(told.size(), 2u);
  expectContains(told[0], files.path("brown.obj") + ": its materials");
  expectContains(told[1], files.path("painted.ply") + ": its colours");
}

TEST_F(SceneWarnings, SayNothingWhereTheSceneGivesTheMaterial) {
  EXPECT_EQ(of(kLamp + mesh("brown.obj", kBsdf) + mesh("painted.ply", kBsdf) + mesh("plain.obj")), Texts{});
}

TEST_F(SceneWarnings, CountTheFilesBeyondAFew) {
  std::string body = kLamp;
  for (int i = 0; i < 20; ++i) {
    const std::string name = "brown" + std::to_string(i) + ".obj";
    files.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl brown\nf 1 2 3\n");
    body += mesh(name);
  }
  const Texts told = of(body);
  ASSERT_EQ(told.size(), 9u);
  EXPECT_EQ(told[8], "the same holds for 12 more mesh files");
}

TEST_F(SceneWarnings, TellOfASceneWithoutLight) {
  EXPECT_EQ(of(mesh("plain.obj")), Texts{"the scene has no light, so that all is black"});
  for (const std::string light :
       {"<emitter type='point'><float name='intensity' value='1'/></emitter>",
        "<emitter type='directional'><float name='irradiance' value='1'/></emitter>"})
    EXPECT_EQ(of(light + mesh("plain.obj")), Texts{});
  const std::string area = "<emitter type='area'><float name='radiance' value='1'/></emitter>";
  EXPECT_EQ(of(mesh("plain.obj", area)), Texts{});
}

}  // namespace
}  // namespace saccade
