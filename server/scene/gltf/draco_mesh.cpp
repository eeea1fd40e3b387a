#include "scene/gltf/draco_mesh.h"

#include <draco/compression/decode.h>

#include <cmath>
#include <cstring>

#include "scene/files/limits.h"

namespace saccade {
namespace {

std::unique_ptr<draco::Mesh> decode(const JsonNode& coded, std::string_view bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  std::string fault;
  try {
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (decoded.ok()) return std::move(decoded).value();
    fault = decoded.status().error_msg_string();
  } catch (const std::exception& damage) {  // a number of entries that no memory holds
    fault = damage.what();
  }
  throw coded.error("its bytes are damaged: " + fault);
}

// Entries of T, which are `N` floats; empty where the mesh has no such attribute.
template <class T, int N>
std::vector<T> attribute(const JsonNode& coded, const draco::Mesh& mesh, const std::string& name) {
  const auto id = coded.at("attributes").find(name.c_str());
  if (!id) return {};
  const draco::PointAttribute* found = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id->size()));
  if (!found) throw id->error("there is no such attribute in the compressed mesh");
  std::vector<T> values(mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    float v[N] = {};
    const draco::AttributeValueIndex at = found->mapped_index(draco::PointIndex(i));
    const bool good = at.value() < found->size() && found->ConvertValue<float, N>(at, v);
    for (const float part : v)
      if (!good || !std::isfinite(part)) throw id->error("a value is damaged");
    std::memcpy(&values[i], v, sizeof v);
  }
  static_assert(sizeof(T) == N * sizeof(float));
  return values;
}

}  // namespace

DracoMesh::DracoMesh(const JsonNode& coded, const GltfBuffers& buffers)
    : coded_(coded), decoded_(decode(coded, buffers.view(coded.at("bufferView").size()).bytes)) {}

DracoMesh::~DracoMesh() = default;

Mesh DracoMesh::mesh(const UvSets& uv_sets) const {
  Mesh mesh;
  mesh.positions = attribute<Vec3, 3>(coded_, *decoded_, "POSITION");
  mesh.normals = attribute<Vec3, 3>(coded_, *decoded_, "NORMAL");
  mesh.uvs = attribute<Vec2, 2>(coded_, *decoded_, texCoord(uv_sets.first));
  if (uv_sets.second) mesh.second_uvs = attribute<Vec2, 2>(coded_, *decoded_, texCoord(*uv_sets.second));
  for (std::uint32_t i = 0; i < decoded_->num_faces(); ++i) {
    const auto& face = decoded_->face(draco::FaceIndex(i));
    const std::array<std::uint32_t, 3> corners{face[0].value(), face[1].value(), face[2].value()};
    for (const std::uint32_t corner : corners)
      if (corner >= mesh.positions.size()) throw coded_.error("a triangle has a corner that is no vertex");
    mesh.triangles.push_back(corners);
  }
  if (mesh.triangles.empty()) throw coded_.error("has no triangle");
  return mesh;
}

std::vector<float> DracoMesh::fours(const std::string& name) const {
  std::vector<float> numbers;
  for (const auto& four : attribute<std::array<float, 4>, 4>(coded_, *decoded_, name))
    numbers.insert(numbers.end(), four.begin(), four.end());
  return numbers;
}

}  // namespace saccade
