#include "truth/id_names.h"

#include <algorithm>
#include <map>

#include "base/text_cut.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// cutText() adds dots, and a number of a shape has at most ten digits.
constexpr std::size_t kMaxCut = kMaxIdNameBytes - std::string_view("..._4294967295").size();

class NameList {
 public:
  // `body`: of a shape; all shapes of a body have one name, and the number of the first.
  void add(const std::string& name, int body = kStands) {
    names_.push_back(cutText(name, kMaxCut));
    int& uses = uses_[names_.back()];
    if (body == kStands || uses == 0) ++uses;
  }
  // Returns how many are left out.
  std::uint32_t give(google::protobuf::RepeatedPtrField<std::string>& out) const {
    const std::size_t count = std::min(names_.size(), kMaxIdNames);
    for (std::size_t i = 0; i < count; ++i)
      out.Add(names_[i] + (uses_.at(names_[i]) == 1 ? "" : "_" + std::to_string(i + 1)));
    return static_cast<std::uint32_t>(names_.size() - count);
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, int> uses_;
};

}  // namespace

bool asksForIds(const v1::OpenStream& request) {
  return std::ranges::any_of(request.truth(), [](const v1::Truth& t) { return tellsObjects(t.name()); }) ||
         std::ranges::any_of(request.sensors(), [](const v1::Sensor& sensor) { return sensor.object_ids(); });
}

v1::IdNames idNames(const Scene& scene) {
  NameList objects, materials;
  for (const Mesh& mesh : scene.meshes) objects.add(mesh.name, mesh.body);
  for (const Sphere& sphere : scene.spheres) objects.add(sphere.name, sphere.body);
  for (const Body& body : scene.bodies)
    if (!body.has_shapes) objects.add(body.name);
  for (const Material& material : scene.materials) materials.add(material.name);
  v1::IdNames names;
  names.set_further_objects(objects.give(*names.mutable_objects()));
  names.set_further_materials(materials.give(*names.mutable_materials()));
  return names;
}

}  // namespace saccade
