// Nodes and meshes of glTF files.
#include <cmath>
#include <numbers>

#include "scene/gltf_scratch.h"

namespace saccade {
namespace {

using test::GltfArrays;

Scene loadPart(const GltfArrays& arrays, const std::string& part) {
  const Scratch files;
  return test::loadGltfOf(files, arrays,
                          {R"("meshes":[{"primitives":[)" + part + "]}]", test::kTriangleNode});
}

std::vector<std::array<std::uint32_t, 3>> trianglesOf(const GltfArrays& arrays, const std::string& part) {
  return loadPart(arrays, part).meshes.at(0).triangles;
}

GltfArrays fivePoints() {
  GltfArrays arrays;
  arrays.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3");
  return arrays;
}

TEST(GltfMesh, WithoutIndicesTakesVerticesInOrder) {
  const Scene scene = test::loadTriangle({test::kTriangleNode});
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.name, "it");
  EXPECT_EQ(mesh.positions.size(), 4u);  // and the spare one
  EXPECT_EQ(mesh.positions[1], (Vec3{1, 0, 0}));
  EXPECT_TRUE(mesh.normals.empty());  // flat, as glTF asks
}

TEST(GltfMesh, TakesIndicesOfAllSizes) {
  for (const int component : {5121, 5123, 5125}) {
    GltfArrays arrays = fivePoints();
    if (component == 5121) arrays.whole<std::uint8_t>({2, 0, 1}, component, "SCALAR");
    if (component == 5123) arrays.whole<std::uint16_t>({2, 0, 1}, component, "SCALAR");
    if (component == 5125) arrays.whole<std::uint32_t>({2, 0, 1}, component, "SCALAR");
    EXPECT_EQ(trianglesOf(arrays, R"({"attributes":{"POSITION":0},"indices":1})").at(0),
              (std::array<std::uint32_t, 3>{2, 0, 1}));
  }
}

// glTF 2.0, 3.7.2.1.
TEST(GltfMesh, MakesTrianglesOfStripsAndFans) {
  using Three = std::array<std::uint32_t, 3>;
  EXPECT_EQ(trianglesOf(fivePoints(), R"({"attributes":{"POSITION":0},"mode":5})"),
            (std::vector<Three>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
  EXPECT_EQ(trianglesOf(fivePoints(), R"({"attributes":{"POSITION":0},"mode":6})"),
            (std::vector<Three>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST(GltfMesh, LeavesOutPointsAndLines) {
  const Scene scene =
      loadPart(fivePoints(), R"({"attributes":{"POSITION":0},"mode":1},{"attributes":{"POSITION":0}})");
  EXPECT_EQ(scene.meshes.size(), 1u);
  expectContains(scene.unread.at(0), "points and lines of it");
}

TEST(GltfMesh, TakesEveryThirdNumberOfAStride) {
  GltfArrays arrays;
  std::string bytes;
  for (const float x : {0.f, 1.f, 2.f})
    for (const float v : {x, x * x, 0.f, 99.f}) bytes.append(reinterpret_cast<const char*>(&v), 4);
  arrays.raw(bytes, 5126, "VEC3", 3, R"(,"byteStride":16)");
  EXPECT_EQ(loadPart(arrays, R"({"attributes":{"POSITION":0}})").meshes.at(0).positions[2], (Vec3{2, 4, 0}));
}

// KHR_mesh_quantization: whole numbers as they are, or as fractions of the largest.
TEST(GltfMesh, TakesQuantisedPositions) {
  GltfArrays arrays;
  arrays.whole<std::int16_t>({0, 0, 0, 300, 0, 0, 0, -32768, 32767}, 5122, "VEC3");
  arrays.whole<std::int16_t>({0, 0, 0, 300, 0, 0, 0, -32768, 32767}, 5122, "VEC3", R"(,"normalized":true)");
  EXPECT_EQ(loadPart(arrays, R"({"attributes":{"POSITION":0}})").meshes.at(0).positions[2],
            (Vec3{0, -32768, 32767}));
  const Vec3 fraction = loadPart(arrays, R"({"attributes":{"POSITION":1}})").meshes.at(0).positions[1];
  EXPECT_FLOAT_EQ(fraction.x, 300 / 32767.f);
  EXPECT_EQ(loadPart(arrays, R"({"attributes":{"POSITION":1}})").meshes.at(0).positions[2], (Vec3{0, -1, 1}));
}

// Values of a sparse accessor stand in place of those of its view, or of zeros.
TEST(GltfMesh, SetsSparseValues) {
  for (const bool zeros : {false, true}) {
    GltfArrays arrays = test::triangle();
    arrays.whole<std::uint8_t>({1, 2}, 5121, "SCALAR");
    const std::string places = std::to_string(arrays.lastView());
    arrays.floats({7, 0, 0, 0, 9, 0}, "VEC3");
    const std::string base = zeros ? "" : R"("bufferView":0,)";
    arrays.accessor(
        base +
        R"("componentType":5126,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":)" +
        places + R"(,"componentType":5121},"values":{"bufferView":)" + std::to_string(arrays.lastView()) +
        "}}");
    const Mesh mesh = loadPart(arrays, R"({"attributes":{"POSITION":3}})").meshes.at(0);
    EXPECT_EQ(mesh.positions[0], (Vec3{0, 0, 0}));
    EXPECT_EQ(mesh.positions[1], (Vec3{7, 0, 0}));
    EXPECT_EQ(mesh.positions[2], (Vec3{0, 9, 0}));
  }
}

// A child is scaled, then turned, then moved, and then as its parent.
TEST(GltfNodes, MultiplyTransformsDownTheTree) {
  const double half = std::sqrt(0.5);
  const std::string nodes = R"("nodes":[{"children":[1],"translation":[10,0,0],"rotation":[0,0,)" +
                            std::to_string(half) + "," + std::to_string(half) +
                            R"(]},{"mesh":0,"scale":[2,3,4],"translation":[1,0,0]}])";
  const Mesh mesh = test::loadTriangle({nodes}).meshes.at(0);
  expectNear(mesh.positions[0], {10, 1, 0}, 1e-5);  // (1, 0, 0), turned by 90 degrees about z
  expectNear(mesh.positions[1], {10, 3, 0}, 1e-5);
  expectNear(mesh.positions[2], {7, 1, 0}, 1e-5);
}

TEST(GltfNodes, TakeMatricesByColumns) {
  const Mesh mesh =
      test::loadTriangle({R"("nodes":[{"mesh":0,"matrix":[0,2,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]}])"})
          .meshes.at(0);
  EXPECT_EQ(mesh.positions[1], (Vec3{5, 8, 7}));
  EXPECT_EQ(mesh.positions[2], (Vec3{4, 6, 7}));
}

// A mirror turns a triangle round, so that its front stays its front [glTF 2.0, 3.7.4].
TEST(GltfNodes, KeepTheFrontOfWhatTheyMirror) {
  const Mesh mesh = test::loadTriangle({R"("nodes":[{"mesh":0,"scale":[-1,1,1]}])"}).meshes.at(0);
  const auto [a, b, c] = mesh.triangles.at(0);
  const Vec3 n = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
  EXPECT_GT(n.z, 0);
}

TEST(GltfNodes, HaveNamesOfTheirOwn) {
  const Scene scene =
      test::loadTriangle({R"("nodes":[{"mesh":0,"name":"a"},{"mesh":0,"name":"a"},{"mesh":0}])"});
  EXPECT_EQ(scene.meshes.at(0).name, "a");
  EXPECT_EQ(scene.meshes.at(1).name, "a@1");
  EXPECT_EQ(scene.meshes.at(2).name, "node 2");
}

TEST(GltfNodes, OfTheDefaultSceneAreRead) {
  const std::string nodes = R"("nodes":[{"mesh":0,"name":"a"},{"mesh":0,"name":"b"}])";
  EXPECT_EQ(test::loadTriangle({nodes}).meshes.size(), 2u);
  const Scene scene = test::loadTriangle({nodes, R"("scenes":[{"nodes":[0]},{"nodes":[1]}],"scene":1)"});
  EXPECT_EQ(scene.meshes.at(0).name, "b");
  EXPECT_EQ(scene.meshes.size(), 1u);
}

// One file, as text with base64 and as binary, gives one scene.
TEST(GltfFile, HoldsItsBuffersItself) {
  const Scratch files;
  const GltfArrays arrays = test::triangle();
  const std::string parts = std::string(test::kTriangleMesh) + "," + test::kTriangleNode;
  const std::string base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const std::string text =
      test::gltf({parts, arrays.json(R"("uri":"data:application/octet-stream;base64,)" + base64 + R"(",)")});
  EXPECT_EQ(loadGltf(files.write("a.gltf", text), {}).meshes.at(0).positions[1], (Vec3{1, 0, 0}));

  std::string json = test::gltf({parts, arrays.json("")});
  while (json.size() % 4) json += ' ';
  const auto word = [](std::size_t n) {
    const auto v = static_cast<std::uint32_t>(n);
    return std::string(reinterpret_cast<const char*>(&v), 4);
  };
  const std::string bytes = arrays.bytes();
  const std::string glb = "glTF" + word(2) + word(28 + json.size() + bytes.size()) + word(json.size()) +
                          "JSON" + json + word(bytes.size()) + std::string("BIN\0", 4) + bytes;
  EXPECT_EQ(loadGltf(files.write("a.glb", glb), {}).meshes.at(0).positions[2], (Vec3{0, 1, 0}));
  expectContains(errorOf([&] { loadGltf(files.write("b.glb", glb.substr(0, glb.size() - 1)), {}); }),
                 "ends within a part of the .glb");
}

// Whole numbers are shares, and alpha does not count.
TEST(GltfMesh, HasTheColoursOfItsVertices) {
  const Scratch files;
  GltfArrays arrays = test::triangle();
  arrays.whole<std::uint8_t>({255, 0, 51, 9, 0, 255, 0, 9, 0, 0, 255, 9}, 5121, "VEC4",
                             R"(,"normalized":true)");
  const Scene scene = test::loadGltfOf(
      files, arrays,
      {R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1}}]}])", test::kTriangleNode});
  EXPECT_EQ(scene.meshes.at(0).colors, (std::vector<Rgb>{{1, 0, 0.2f}, {0, 1, 0}, {0, 0, 1}}));
}

}  // namespace
}  // namespace saccade
