// Compressed meshes of glTF files, as the encoders of the same libraries write them.
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "scene/gltf_scratch.h"

namespace saccade {
namespace {

// A fan of `count` triangles around the origin.
struct Fan {
  explicit Fan(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const double angle = 0.1 * i;
      positions.push_back(toFloat({std::cos(angle), std::sin(angle), 0.5}));
      if (i > 1) indices.insert(indices.end(), {0, i - 1, i});
    }
  }
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> indices;
};

// A buffer view of compressed bytes. Its uncompressed buffer is absent, as files of gltfpack have it.
std::string view(std::size_t offset, std::size_t bytes, std::size_t stride, std::size_t count,
                 const std::string& mode) {
  return R"({"buffer":1,"byteLength":)" + std::to_string(stride * count) +
         R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" + std::to_string(offset) +
         R"(,"byteLength":)" + std::to_string(bytes) + R"(,"byteStride":)" + std::to_string(stride) +
         R"(,"count":)" + std::to_string(count) + R"(,"mode":")" + mode + R"("}}})";
}

// Names of one file of a fan, compressed by meshoptimizer.
std::string writeMeshopt(const Scratch& files, const Fan& fan, const std::string& damage = {}) {
  const std::size_t vertices = fan.positions.size(), corners = fan.indices.size();
  std::string bytes(meshopt_encodeVertexBufferBound(vertices, sizeof(Vec3)), '\0');
  const std::size_t first =
      meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(),
                                 fan.positions.data(), vertices, sizeof(Vec3));
  bytes.resize(first);
  std::string more(meshopt_encodeIndexBufferBound(corners, vertices), '\0');
  more.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(more.data()), more.size(),
                                        fan.indices.data(), corners));
  bytes += more;
  bytes.replace(0, damage.size(), damage);
  files.write("data.bin", bytes);
  const std::string total = std::to_string(bytes.size());
  return files.write(
      "scene.gltf",
      test::gltf({R"("extensionsRequired":["EXT_meshopt_compression"])", test::kTriangleNode,
                  R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])",
                  R"("buffers":[{"uri":"data.bin","byteLength":)" + total + R"(},{"byteLength":999}])",
                  "\"bufferViews\":[" + view(0, first, sizeof(Vec3), vertices, "ATTRIBUTES") + "," +
                      view(first, more.size(), 4, corners, "TRIANGLES") + "]",
                  R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
                      std::to_string(vertices) +
                      R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
                      std::to_string(corners) + "}]"}));
}

TEST(GltfCompressed, ByMeshoptimizerIsRead) {
  const Scratch files;
  const Fan fan(40);
  const Mesh mesh = loadGltf(writeMeshopt(files, fan), {}).meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), fan.positions.size() + 1);
  for (std::size_t i = 0; i < fan.positions.size(); ++i) EXPECT_EQ(mesh.positions[i], fan.positions[i]);
  EXPECT_EQ(mesh.triangles.size() * 3, fan.indices.size());
}

TEST(GltfCompressed, ByMeshoptimizerAndDamagedIsRefused) {
  const Scratch files;
  expectContains(errorOf([&] { loadGltf(writeMeshopt(files, Fan(40), "damaged"), {}); }),
                 "its bytes are damaged");
}

// Attributes of a triangle, as positions and four of joints and weights each.
struct SkinnedTriangle {
  std::array<Vec3, 3> positions{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  std::array<std::array<std::uint8_t, 4>, 3> joints{{{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}}};
  std::array<std::array<float, 4>, 3> weights{{{1, 0, 0, 0}, {1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}}};
};

// The numbers of its attributes are 0, 1 and 2.
std::string dracoBytes(const SkinnedTriangle& t) {
  using draco::GeometryAttribute;
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int all[] = {builder.AddAttribute(GeometryAttribute::POSITION, 3, draco::DT_FLOAT32),
                     builder.AddAttribute(GeometryAttribute::GENERIC, 4, draco::DT_UINT8),
                     builder.AddAttribute(GeometryAttribute::GENERIC, 4, draco::DT_FLOAT32)};
  const auto set = [&](int attribute, const auto& v) {
    builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(0), &v[0], &v[1], &v[2]);
  };
  set(all[0], t.positions), set(all[1], t.joints), set(all[2], t.weights);
  const auto mesh = builder.Finalize();
  draco::ExpertEncoder encoder(*mesh);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {buffer.data(), buffer.size()};
}

// Its second joint stands a unit higher than its bind says.
TEST(GltfCompressed, ByDracoASkinBends) {
  const Scratch files;
  const std::string bytes = dracoBytes(SkinnedTriangle()), length = std::to_string(bytes.size());
  files.write("data.bin", bytes);
  const Scene scene = loadGltf(
      files.write(
          "scene.gltf",
          test::gltf({R"("nodes":[{"mesh":0,"skin":0,"name":"it"},{},{"translation":[0,0,1]}])",
                      R"("skins":[{"joints":[1,2]}])",
                      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},
                  "indices":3,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,
                  "attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}}}}]}])",
                      R"("buffers":[{"uri":"data.bin","byteLength":)" + length + "}]",
                      R"("bufferViews":[{"buffer":0,"byteLength":)" + length + "}]",
                      R"("accessors":[{"componentType":5126,"type":"VEC3","count":3},
                  {"componentType":5121,"type":"VEC4","count":3},{"componentType":5126,"type":"VEC4","count":3},
                  {"componentType":5125,"type":"SCALAR","count":3}])"})),
      {});
  const Mesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 p = mesh.positions[i];
    EXPECT_NEAR(p.z, p.x > 0.5f ? 1 : p.y > 0.5f ? 0.5 : 0, 1e-3) << p.x << " " << p.y;
  }
}

std::string dracoBytes(const Fan& fan) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(fan.indices.size() / 3));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t i = 0; i + 3 <= fan.indices.size(); i += 3)
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(static_cast<std::uint32_t>(i / 3)),
                                      &fan.positions[fan.indices[i]], &fan.positions[fan.indices[i + 1]],
                                      &fan.positions[fan.indices[i + 2]]);
  const auto mesh = builder.Finalize();
  draco::ExpertEncoder encoder(*mesh);
  encoder.SetAttributeQuantization(positions, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {buffer.data(), buffer.size()};
}

std::string writeDraco(const Scratch& files, const std::string& bytes) {
  files.write("data.bin", bytes);
  const std::string length = std::to_string(bytes.size());
  return files.write(
      "scene.gltf",
      test::gltf({R"("extensionsRequired":["KHR_draco_mesh_compression"])", test::kTriangleNode,
                  R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"extensions":
                  {"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}}}]}])",
                  R"("buffers":[{"uri":"data.bin","byteLength":)" + length + "}]",
                  R"("bufferViews":[{"buffer":0,"byteLength":)" + length + "}]",
                  R"("accessors":[{"componentType":5126,"type":"VEC3","count":40},
                  {"componentType":5125,"type":"SCALAR","count":117}])"}));
}

// In 14 bits of the extent.
TEST(GltfCompressed, ByDracoIsRead) {
  const Scratch files;
  const Fan fan(40);
  const Mesh mesh = loadGltf(writeDraco(files, dracoBytes(fan)), {}).meshes.at(0);
  EXPECT_EQ(mesh.triangles.size() * 3, fan.indices.size());
  for (std::size_t i = 0; i + 1 < mesh.positions.size(); ++i) {
    float nearest = 1;
    for (const Vec3 p : fan.positions) nearest = std::min(nearest, length(p - mesh.positions[i]));
    EXPECT_LT(nearest, 2.f / (1 << 14)) << i;
  }
}

TEST(GltfCompressed, ByDracoAndDamagedIsRefused) {
  const Scratch files;
  const std::string bytes = dracoBytes(Fan(40));
  expectContains(errorOf([&] { loadGltf(writeDraco(files, bytes.substr(0, bytes.size() / 2)), {}); }),
                 "its bytes are damaged");
}

}  // namespace
}  // namespace saccade
