#include <cmath>

#include "scene/files/limits.h"
#include "scene/mesh/mesh_io.h"
#include "scene/mitsuba_scratch.h"
#include "scene/serialized_files.h"

namespace saccade {
namespace {

using test::serializedFile;
using test::SerializedLayout;
using test::triangleData;

std::string faultOf(const std::string& bytes, int index = 0) {
  return errorOf([&] { parseSerialized(bytes, "a.serialized", index); });
}

TEST(Serialized, BothVersionsAndPrecisionsSayTheSame) {
  for (const int version : {3, 4}) {
    for (const bool doubles : {false, true}) {
      const SerializedLayout layout{version, doubles};
      const Mesh mesh = parseSerialized(serializedFile(version, {triangleData(layout, 2)}), "b/a.x", 0);
      EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}));
      EXPECT_EQ(mesh.normals[2], (Vec3{0, 0, 1}));
      EXPECT_FLOAT_EQ(mesh.uvs[2].x, 0.25f);
      EXPECT_FLOAT_EQ(mesh.uvs[2].y, 0.75f);
      EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
      EXPECT_TRUE(mesh.unread.empty());
    }
  }
}

TEST(Serialized, MayLackNormalsAndTextureCoordinatesAndHaveColours) {
  const SerializedLayout layout{4, false, false, false, true};
  const Mesh mesh = parseSerialized(serializedFile(4, {triangleData(layout, 2)}), "a.serialized", 0);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uvs.empty());
  EXPECT_EQ(mesh.triangles.size(), 1u);
  expectContains(mesh.unread, "a.serialized: its colours are not read");
}

TEST(Serialized, AnIndexChoosesTheMesh) {
  const Scratch files;
  for (const int version : {3, 4}) {
    const SerializedLayout layout{version};
    const std::string path = files.write(
        "a.serialized",
        serializedFile(version, {triangleData(layout, 1), triangleData(layout, 2), triangleData(layout, 3)}));
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(loadSerialized(path, i).positions[2], (Vec3{0, static_cast<float>(i + 1), 0})) << version;
    expectContains(errorOf([&] { loadSerialized(path, 3); }), "shape_index 3 is not one of its 3 meshes");
  }
}

TEST(Serialized, IsAShapeOfAScene) {
  const Scratch files;
  const SerializedLayout layout;
  files.write("a.serialized", serializedFile(4, {triangleData(layout, 1), triangleData(layout, 2)}));
  const auto shape = [](const std::string& index) {
    return "<shape type='serialized'><string name='filename' value='a.serialized'/>"
           "<integer name='shapeIndex' value='" +
           index + "'/><transform name='toWorld'><scale value='10'/></transform></shape>";
  };
  const Scene scene = loadBody(files, shape("1"));
  EXPECT_EQ(scene.meshes[0].positions[2], (Vec3{0, 20, 0}));
  EXPECT_EQ(scene.meshes[0].name, "a@1");
  const auto fault = [&](const std::string& index) {
    return errorOf([&] { loadBody(files, shape(index)); });
  };
  expectContains(fault("7"), "scene.xml:3: ");
  expectContains(fault("7"), "a.serialized: shape_index 7");
  expectContains(fault("-1"), "must be a whole number from 0");
  expectContains(fault("0.5"), "must be a whole number from 0");
}

TEST(Serialized, FaultsAreErrors) {
  const SerializedLayout layout;
  const std::string good = serializedFile(4, {triangleData(layout, 1)});
  expectContains(faultOf(""), "ends within its header");
  expectContains(faultOf("ply\nformat"), "not a serialized mesh");
  std::string version5 = good;
  version5[2] = 5;
  expectContains(faultOf(version5), "version 5 is not supported; supported: 3, 4");
  expectContains(faultOf(good.substr(0, 30)), "zlib data ends within the mesh");
  std::string faulty = good;
  faulty[5] ^= 1;
  expectContains(faultOf(faulty), "zlib data is faulty");
  expectContains(faultOf(serializedFile(4, {triangleData(layout, 1, 3, 1, 3)})),
                 "triangle 0: a corner is not one of the 3 vertices");
  expectContains(faultOf(serializedFile(4, {triangleData(layout, NAN)})), "is not finite");
  expectContains(faultOf(serializedFile(4, {triangleData({4, true}, 1e300)})), "is not finite");
  expectContains(faultOf(serializedFile(4, {triangleData(layout, 1, 3, 0)})), "no triangles");
  std::string list = serializedFile(4, {triangleData(layout, 1), triangleData(layout, 2)});
  list[list.size() - 8] = 1;  // the second mesh begins 2^32 bytes further on, or so
  expectContains(faultOf(list, 1), "ends within its header");
  expectContains(faultOf(list), "the list of meshes at its end is faulty");
}

TEST(Serialized, AHugeCountEndsWithTheData) {
  const SerializedLayout layout;
  expectContains(faultOf(serializedFile(4, {triangleData(layout, 1, 200'000'000)})), "times as large");
  expectContains(faultOf(serializedFile(4, {triangleData(layout, 1, 1'000'000'000)})),
                 "more than 100000000 triangles");
  expectContains(faultOf(serializedFile(4, {triangleData(layout, 1, 3, 1ull << 60)})),
                 "more than 100000000 triangles");
}

// Zeros compress to a thousandth, and meshes do not.
TEST(Serialized, DataThatGrowsWithoutEndIsAnError) {
  const SerializedLayout layout{4, false, false, false};
  const std::string zeros(12 << 20, '\0');
  std::string data = triangleData(layout, 1, 1 << 20);
  data.insert(data.size() - 48, zeros);
  expectContains(faultOf(serializedFile(4, {data})),
                 "more than " + std::to_string(kMaxMeshBytesPerByte) + " times as large");
}

}  // namespace
}  // namespace saccade
