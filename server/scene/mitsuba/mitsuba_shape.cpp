#include "scene/mitsuba/mitsuba_shape.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scene/files/limits.h"
#include "scene/mesh/creases.h"
#include "scene/mesh/mesh.h"
#include "scene/mesh/mesh_io.h"
#include "scene/mitsuba/mitsuba_emitter.h"
#include "scene/mitsuba/mitsuba_round.h"
#include "scene/mitsuba/mitsuba_transform.h"
#include "scene/mitsuba/xml_properties.h"

namespace saccade {
namespace {

// The properties that shapes of all types have.
struct Common {
  std::string name;
  Affine placement;  // in the scene's axes
  bool has_bsdf;
  int material;
  Emission emission;
};

Common parseCommon(const XmlFile& file, pugi::xml_node shape, Properties& properties,
                   MaterialReader& materials, Vec3d origin) {
  const pugi::xml_node emitter = properties.object("emitter"), bsdf = properties.object("bsdf");
  Affine placement = parseTransform(file, properties.object("transform", "to_world"));
  placement.translation = placement.translation - origin;
  Common common{shape.attribute("id").value(), placement, !!bsdf, materials.read(bsdf), {}};
  if (emitter) common.emission = parseEmitter(file, emitter, materials.textures());
  if (isTextured(common.emission.picture))
    common.material = materials.addEmitting(common.material, common.emission.picture);
  return common;
}

// A mesh in a file.
struct MeshFile {
  std::string path;
  int index;    // of the meshes in it
  bool flip_v;  // of texture coordinates
};

MeshFile readMeshFile(const XmlFile& file, pugi::xml_node shape, const std::string& type,
                      Properties& properties) {
  const std::string path = file.locate(shape, properties.text("filename"));
  if (type != "serialized") return {path, 0, properties.flag("flip_tex_coords", type == "obj")};
  const double index = properties.number("shape_index", 0);
  if (!(index >= 0 && index <= kMaxTriangles) || index != std::floor(index))
    throw file.error(shape, "the shape_index must be a whole number from 0");
  return {path, static_cast<int>(index), false};
}

Mesh loadMeshFile(const std::string& type, const MeshFile& file) {
  Mesh mesh = type == "obj"   ? loadObj(file.path)
              : type == "ply" ? loadPly(file.path)
                              : loadSerialized(file.path, file.index);
  if (file.flip_v)
    for (Vec2& uv : mesh.uvs) uv.y = 1 - uv.y;
  return mesh;
}

// The angle in degrees at which faces have a crease between them; none: the normals are those of the file.
std::optional<double> readCrease(const XmlFile& file, pugi::xml_node shape, bool face_normals,
                                 Properties& properties) {
  constexpr double kNone = -1;
  const double degrees = properties.number("max_smooth_angle", kNone);
  if (degrees == kNone) return {};
  if (!(degrees >= 0 && degrees <= 180))
    throw file.error(shape, "the max_smooth_angle must be within [0, 180] degrees");
  if (face_normals) throw file.error(shape, "there is no max_smooth_angle beside face_normals");
  return degrees;
}

Mesh makeMesh(const std::string& type) {
  if (isRound(type)) return makeRound(type);
  return type == "rectangle" ? makeRectangle() : type == "cube" ? makeCube() : makeDisk();
}

std::string nameOf(const Common& common, const std::string& type, const MeshFile& file) {
  if (!common.name.empty()) return common.name;
  const std::string stem = std::filesystem::path(file.path).stem().string();
  if (stem.empty()) return type;
  return file.index > 0 ? stem + "@" + std::to_string(file.index) : stem;
}

bool isFinite(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](Vec3 p) { return std::isfinite(dot(p, p)); });
}

void readMesh(const XmlFile& file, pugi::xml_node shape, const std::string& type, MaterialReader& materials,
              FileLoads& loads, Scene& scene) {
  Properties properties(file, shape);
  Common common = parseCommon(file, shape, properties, materials, scene.origin);
  common.placement = common.placement * readRound(file, shape, type, properties);
  const bool is_file = type == "obj" || type == "ply" || type == "serialized";
  const MeshFile mesh_file = is_file ? readMeshFile(file, shape, type, properties) : MeshFile{};
  const bool face_normals = is_file ? properties.flag("face_normals", false) : !isRound(type);
  const auto crease = is_file ? readCrease(file, shape, face_normals, properties) : std::optional<double>();
  const bool flip_normals = properties.flag("flip_normals", false);
  properties.finish();
  const std::size_t index = scene.meshes.size();
  const std::string name = nameOf(common, type, mesh_file);
  scene.meshes.emplace_back().name = name;
  loads.add(file.errorsAt(shape), [=, &meshes = scene.meshes] {
    Mesh mesh = is_file ? loadMeshFile(type, mesh_file) : makeMesh(type);
    if (crease) splitAtCreases(mesh, common.placement, *crease);
    placeMesh(mesh, common.placement, face_normals);
    if (flip_normals) turnRound(mesh);
    if (!isFinite(mesh)) throw SceneError("a vertex of the shape is too far away for float numbers");
    if (common.has_bsdf) mesh.unread.clear();
    mesh.name = name;
    mesh.material = common.material;
    mesh.radiance = common.emission.radiance;
    mesh.strength = common.emission.strength;
    meshes[index] = std::move(mesh);
  });
}

// The factor by which the map scales all lengths.
double uniformScale(const XmlFile& file, pugi::xml_node at, const Affine& map) {
  const double scale = length(map.x), tolerance = 1e-4 * scale;
  const bool uniform =
      std::abs(length(map.y) - scale) < tolerance && std::abs(length(map.z) - scale) < tolerance &&
      std::abs(dot(map.x, map.y)) < tolerance * scale && std::abs(dot(map.y, map.z)) < tolerance * scale &&
      std::abs(dot(map.z, map.x)) < tolerance * scale;
  if (!uniform) throw file.error(at, "a sphere must be scaled by the same factor in all directions");
  return scale;
}

void readSphere(const XmlFile& file, pugi::xml_node shape, MaterialReader& materials, Scene& scene) {
  Properties properties(file, shape);
  const Common common = parseCommon(file, shape, properties, materials, scene.origin);
  const Vec3d center = properties.vector("center").value_or(Vec3d{});
  const double radius = properties.number("radius", 1) * uniformScale(file, shape, common.placement);
  properties.neutral("flip_normals", false);
  properties.finish();
  const Vec3 placed = toFloat(mapPoint(common.placement, center));
  const float size = static_cast<float>(radius);
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(dot(placed, placed)))
    throw file.error(shape, "a sphere needs a radius above 0 and a centre within reach of float numbers");
  scene.spheres.push_back({common.name.empty() ? "sphere" : common.name, placed, size, common.material,
                           common.emission.radiance, common.emission.strength});
}

// Whether a sphere is a mesh: it faces inwards, or emits a picture.
bool needsMesh(const XmlFile& file, pugi::xml_node sphere) {
  return Properties(file, sphere).flag("flip_normals", false) ||
         hasTexture(file, Properties(file, sphere).object("emitter"));
}

}  // namespace

void readShape(const XmlFile& file, pugi::xml_node shape, MaterialReader& materials, FileLoads& loads,
               Scene& scene) {
  const std::string type = supportedType(
      file, shape, {"obj", "ply", "serialized", "rectangle", "cube", "disk", "cylinder", "sphere"});
  if (type == "sphere" && !needsMesh(file, shape)) {
    readSphere(file, shape, materials, scene);
  } else {
    readMesh(file, shape, type, materials, loads, scene);
  }
}

}  // namespace saccade
