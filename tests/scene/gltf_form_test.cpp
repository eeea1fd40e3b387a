// Skins, morph targets and changes of size in glTF files.
#include <algorithm>
#include <cmath>

#include "scene/gltf_scratch.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
using test::GltfArrays;

std::string track(int node, const std::string& path, int input, int output) {
  return R"("animations":[{"channels":[{"sampler":0,"target":{"node":)" + std::to_string(node) +
         R"(,"path":")" + path + R"("}}],"samplers":[{"input":)" + std::to_string(input) + R"(,"output":)" +
         std::to_string(output) + "}]}]";
}

// The positions of a mesh of its body at a time.
std::vector<Vec3> formAt(const Scene& scene, TimeNs t, std::size_t mesh = 0) {
  const Deformation& d = scene.deformations.at(static_cast<std::size_t>(scene.meshes.at(mesh).deformation));
  NodePoses nodes(scene.nodes);
  MeshForm form;
  setForm(d, nodes, t, form);
  std::vector<Vec3> positions = d.positions, normals = d.normals;
  deform(d, form, positions, normals);
  return positions;
}

void expectNear(Vec3 a, Vec3 b) {
  EXPECT_LT(length(a - b), 1e-5f) << a.x << " " << a.y << " " << a.z;
}

// A bar of two squares from (0, 0) to (2, 1). The joint at (1, 0) turns its outer end by a quarter.
struct Bar {
  Bar() {
    arrays.floats({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}, "VEC3");  // 0
    arrays.whole<std::uint16_t>({0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}, 5123, "SCALAR");
    arrays.whole<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 5121,
                               "VEC4");
    arrays.floats({1, 0, 0, 0, .5f, .5f, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0, 0, 1, 0, 0}, "VEC4");
    arrays.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,   //
                   1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1},  // from the joint at (1, 0)
                  "MAT4");
    arrays.floats({0, 1}, "SCALAR");
    arrays.floats({0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  }
  std::vector<std::string> parts(const std::string& more = {}) const {
    return {
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]}])",
        R"("nodes":[{"mesh":0,"skin":0,"name":"bar","translation":[9,9,9]},
                {"name":"root","children":[2])" +
            more + R"(},{"name":"elbow","translation":[1,0,0]}])",
        R"("skins":[{"joints":[1,2],"inverseBindMatrices":4}])", track(2, "rotation", 5, 6)};
  }
  const float half = std::sqrt(0.5f);
  GltfArrays arrays;
};

// The place of the node itself does not count [glTF 2.0, 3.7.3.3].
TEST(GltfSkin, BendsAtItsJoint) {
  const Scratch files;
  const Bar bar;
  const Scene scene = test::loadGltfOf(files, bar.arrays, bar.parts());
  ASSERT_EQ(scene.motions.size(), 1u);
  EXPECT_EQ(scene.motions[0].name, "bar");
  EXPECT_TRUE(scene.unread.empty() || scene.unread[0].find("skin") == std::string::npos);
  const Vec3d origin = scene.origin;
  EXPECT_EQ(origin, Vec3d{});
  const std::vector<Vec3> rest = formAt(scene, 0s), bent = formAt(scene, 1s);
  for (std::size_t i = 0; i < rest.size(); ++i) expectNear(rest[i], scene.meshes[0].positions[i]);
  expectNear(rest[2], {2, 0, 0});
  expectNear(bent[0], {0, 0, 0});
  expectNear(bent[2], {1, 1, 0});        // (1, 0) from the joint, turned
  expectNear(bent[5], {0, 1, 0});        // (1, 1) from the joint, turned
  expectNear(bent[4], {0.5f, 0.5f, 0});  // the mean of (1, 1) and (0, 0)
  expectNear(formAt(scene, 9s)[2], {1, 1, 0});
}

TEST(GltfSkin, FollowsTheSpaceOfItsJoints) {
  const Scratch files;
  const Bar bar;
  const Scene scene = test::loadGltfOf(files, bar.arrays, bar.parts(R"(,"translation":[0,0,4])"));
  expectNear(scene.meshes[0].positions[2], {2, 0, 4});
  expectNear(formAt(scene, 1s)[2], {1, 1, 4});
}

// The stream's body: its box is that of the beginning, and it stands.
TEST(GltfSkin, IsABodyThatStandsInItsPlace) {
  const Scratch files;
  const Bar bar;
  Scene scene = test::loadGltfOf(files, bar.arrays, bar.parts());
  setBodies(scene, std::array{std::string("bar")});
  EXPECT_TRUE(deforms(scene.meshes[0]));
  const Trajectory path = makeOwnMotion(scene.motions[0], scene, scene.bodies[0]);
  EXPECT_EQ(path.at(0s), (Pose{{1, 0.5, 0}, {}}));
  EXPECT_EQ(path.at(700ms), path.at(0s));
}

TEST(GltfSkin, ThatStandsIsAPlainMesh) {
  const Scratch files;
  const Bar bar;
  std::vector<std::string> parts = bar.parts(R"(,"translation":[0,0,4])");
  parts.pop_back();
  const Scene scene = test::loadGltfOf(files, bar.arrays, parts);
  EXPECT_TRUE(scene.motions.empty() && scene.deformations.empty() && scene.nodes.empty() == false);
  expectNear(scene.meshes[0].positions[2], {2, 0, 4});
}

std::string faultOf(const Bar& bar, const std::string& from, const std::string& to) {
  const Scratch files;
  std::vector<std::string> parts = bar.parts();
  for (std::string& part : parts)
    if (const auto at = part.find(from); at != part.npos) part.replace(at, from.size(), to);
  try {
    test::loadGltfOf(files, bar.arrays, parts);
  } catch (const SceneError& fault) {
    return fault.what();
  }
  return {};
}

// The second set adds the other joint to corner 2, with the same weight.
TEST(GltfSkin, MayHaveMoreThanFourJointsAVertex) {
  const Scratch files;
  Bar bar;
  bar.arrays.whole<std::uint8_t>(std::vector<std::uint8_t>(24), 5121, "VEC4");  // 7: the root
  std::vector<float> weights(24);
  weights[8] = 1;
  bar.arrays.floats(weights, "VEC4");  // 8
  std::vector<std::string> parts = bar.parts();
  parts[0] = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3,
                "JOINTS_1":7,"WEIGHTS_1":8},"indices":1}]}])";
  const Scene scene = test::loadGltfOf(files, bar.arrays, parts);
  const std::vector<Vec3> bent = formAt(scene, 1s);
  expectNear(bent[2], {1.5f, 0.5f, 0});  // the mean of (1, 1) and (2, 0)
  expectNear(bent[5], {0, 1, 0});
  expectNear(bent[4], {0.5f, 0.5f, 0});
  EXPECT_EQ(scene.deformations.at(0).influences.size(), 12u);
}

TEST(GltfSkin, TellsFaults) {
  const auto expectFault = [](const std::string& from, const std::string& to, const std::string& told) {
    const std::string fault = faultOf(Bar(), from, to);
    EXPECT_NE(fault.find(told), std::string::npos) << fault;
  };
  expectFault(R"("joints":[1,2])", R"("joints":[1])", "a vertex has a joint beyond the 1 of the skin");
  expectFault(R"("joints":[1,2])", R"("joints":[])", "has 0 joints");
  expectFault(R"(,"WEIGHTS_0":3)", "", "needs JOINTS_0 and WEIGHTS_0");
  expectFault(R"("JOINTS_0":2)", R"("JOINTS_0":2,"JOINTS_1":2)", "needs JOINTS_0 and WEIGHTS_0");
  expectFault(R"("JOINTS_0":2)", R"("JOINTS_0":2,"JOINTS_1":2,"JOINTS_2":2,"JOINTS_3":2,"JOINTS_4":2)",
              "more than 16 joints a vertex");
  expectFault(R"("inverseBindMatrices":4)", R"("inverseBindMatrices":3)", "where 16 numbers are needed");
  expectFault(R"("skin":0)", R"("skin":7)", "skin");
}

// A triangle with one target, whose corner 1 goes by (0, 0, 2).
struct Morph {
  Morph() : arrays(test::triangle()) {
    arrays.floats({0, 0, 0, 0, 0, 2, 0, 0, 0}, "VEC3");  // 1
    arrays.floats({0, 1, 2}, "SCALAR");                  // 2
    arrays.floats({0, 1, 0}, "SCALAR");                  // 3
    arrays.floats({0, 0, 0, 4, 0, 0, 8, 0, 0}, "VEC3");  // 4
    arrays.floats({1, 1, 1, 2, 2, 2, 1, 1, 1}, "VEC3");  // 5
  }
  static constexpr const char* kMesh =
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}]}])";
  GltfArrays arrays;
};

TEST(GltfMorph, FollowsItsWeights) {
  const Scratch files;
  const Scene scene = test::loadGltfOf(
      files, Morph().arrays,
      {Morph::kMesh, R"("nodes":[{"mesh":0,"name":"it","scale":[3,3,3]}])", track(0, "weights", 2, 3)});
  ASSERT_EQ(scene.motions.size(), 1u);
  expectNear(formAt(scene, 0s)[1], {3, 0, 0});
  expectNear(formAt(scene, 250ms)[1], {3, 0, 1.5f});
  expectNear(formAt(scene, 1s)[1], {3, 0, 6});
  expectNear(formAt(scene, 2250ms)[1], {3, 0, 1.5f});  // it ends as it began, and repeats
}

TEST(GltfMorph, WithoutKeysIsAPlainMesh) {
  const Scratch files;
  const Scene scene =
      test::loadGltfOf(files, Morph().arrays, {Morph::kMesh, R"("nodes":[{"mesh":0,"weights":[0.5]}])"});
  EXPECT_TRUE(scene.deformations.empty());
  expectNear(scene.meshes[0].positions[1], {1, 0, 1});
}

// The body goes as the node does, and its form changes in its place.
TEST(GltfMorph, OfANodeThatMovesKeepsItsPath) {
  const Scratch files;
  const std::string animations =
      R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}},
        {"sampler":1,"target":{"node":0,"path":"weights"}}],
        "samplers":[{"input":2,"output":4},{"input":2,"output":3}]}])";
  Scene scene = test::loadGltfOf(files, Morph().arrays,
                                 {Morph::kMesh, R"("nodes":[{"mesh":0,"name":"it"}])", animations});
  setBodies(scene, std::array{std::string("it")});
  const Trajectory path = makeOwnMotion(scene.motions.at(0), scene, scene.bodies[0]);
  EXPECT_NEAR(path.at(1s).position.x - path.at(0s).position.x, 4, 1e-9);
  expectNear(formAt(scene, 1s)[1], {1, 0, 2});
}

TEST(GltfSize, OfANodeThatGrowsIsADeformation) {
  const Scratch files;
  const Scene scene = test::loadGltfOf(files, Morph().arrays,
                                       {test::kTriangleMesh, test::kTriangleNode, track(0, "scale", 2, 5)});
  ASSERT_EQ(scene.motions.size(), 1u);
  expectNear(formAt(scene, 0s)[1], {1, 0, 0});
  expectNear(formAt(scene, 500ms)[1], {1.5f, 0, 0});
  expectNear(formAt(scene, 1s)[1], {2, 0, 0});
  expectNear(formAt(scene, 2500ms)[1], {1.5f, 0, 0});
}

// A lamp of another size would give other light.
TEST(GltfSize, OfALampStays) {
  const Scratch files;
  const Scene scene =
      test::loadGltfOf(files, Morph().arrays,
                       {R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
          "materials":[{"emissiveFactor":[1,1,1]}])",
                        test::kTriangleNode, track(0, "scale", 2, 5)});
  EXPECT_TRUE(scene.deformations.empty());
  EXPECT_TRUE(std::ranges::any_of(scene.unread, [](const std::string& sentence) {
    return sentence == "the size of it changes in its animation; it keeps its first";
  }));
}

}  // namespace
}  // namespace saccade
