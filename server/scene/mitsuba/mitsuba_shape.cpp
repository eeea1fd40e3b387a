#include "scene/mitsuba/mitsuba_shape.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scene/mesh/mesh.h"
#include "scene/mesh/mesh_io.h"
#include "scene/mitsuba/mitsuba_emitter.h"
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
  return {shape.attribute("id").value(), placement, !!bsdf, materials.read(bsdf),
          emitter ? parseEmitter(file, emitter) : Emission{}};
}

Mesh loadMesh(const std::string& type, const std::string& path, bool flip_v) {
  if (type == "rectangle") return makeRectangle();
  if (type == "cube") return makeCube();
  if (type == "disk") return makeDisk();
  Mesh mesh = type == "obj" ? loadObj(path) : loadPly(path);
  if (flip_v)
    for (Vec2& uv : mesh.uvs) uv.y = 1 - uv.y;
  return mesh;
}

std::string nameOf(const Common& common, const std::string& type, const std::string& path) {
  if (!common.name.empty()) return common.name;
  const std::string stem = std::filesystem::path(path).stem().string();
  return stem.empty() ? type : stem;
}

bool isFinite(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](Vec3 p) { return std::isfinite(dot(p, p)); });
}

void readMesh(const XmlFile& file, pugi::xml_node shape, const std::string& type, MaterialReader& materials,
              FileLoads& loads, Scene& scene) {
  Properties properties(file, shape);
  const Common common = parseCommon(file, shape, properties, materials, scene.origin);
  const bool is_file = type == "obj" || type == "ply";
  const std::string path = is_file ? file.locate(shape, properties.text("filename")) : "";
  const bool face_normals = !is_file || properties.flag("face_normals", false);
  const bool flip_v = is_file && properties.flag("flip_tex_coords", type == "obj");
  properties.finish();
  const std::size_t index = scene.meshes.size();
  const std::string name = nameOf(common, type, path);
  scene.meshes.emplace_back().name = name;
  loads.add(file.errorsAt(shape), [=, &meshes = scene.meshes] {
    Mesh mesh = loadMesh(type, path, flip_v);
    placeMesh(mesh, common.placement, face_normals);
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
  properties.finish();
  const Vec3 placed = toFloat(mapPoint(common.placement, center));
  const float size = static_cast<float>(radius);
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(dot(placed, placed)))
    throw file.error(shape, "a sphere needs a radius above 0 and a centre within reach of float numbers");
  scene.spheres.push_back({common.name.empty() ? "sphere" : common.name, placed, size, common.material,
                           common.emission.radiance, common.emission.strength});
}

}  // namespace

void readShape(const XmlFile& file, pugi::xml_node shape, MaterialReader& materials, FileLoads& loads,
               Scene& scene) {
  const std::string type = supportedType(file, shape, {"obj", "ply", "rectangle", "cube", "disk", "sphere"});
  if (type == "sphere") {
    readSphere(file, shape, materials, scene);
  } else {
    readMesh(file, shape, type, materials, loads, scene);
  }
}

}  // namespace saccade
