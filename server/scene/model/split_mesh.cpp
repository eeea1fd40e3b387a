#include "scene/model/split_mesh.h"

#include <cstdint>
#include <map>
#include <utility>

namespace saccade {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

class Splitter {
 public:
  explicit Splitter(const Mesh& whole) : whole_(whole), places_(whole.positions.size(), kNone) {}

  Mesh part(const std::vector<MaterialRange>& ranges) {
    Mesh part;
    part.name = whole_.name;
    part.material = ranges.front().material;
    for (const MaterialRange& range : ranges)
      for (std::size_t i = range.begin; i < range.end; ++i) {
        auto triangle = whole_.triangles[i];
        for (std::uint32_t& corner : triangle) corner = placeOf(corner, part);
        part.triangles.push_back(triangle);
      }
    part.positions.push_back({});  // the spare one
    part.positions.shrink_to_fit();
    for (const std::uint32_t corner : taken_) places_[corner] = kNone;
    taken_.clear();
    return part;
  }

 private:
  std::uint32_t placeOf(std::uint32_t corner, Mesh& part) {
    if (places_[corner] != kNone) return places_[corner];
    taken_.push_back(corner);
    part.positions.push_back(whole_.positions[corner]);
    if (!whole_.normals.empty()) part.normals.push_back(whole_.normals[corner]);
    if (!whole_.uvs.empty()) part.uvs.push_back(whole_.uvs[corner]);
    return places_[corner] = static_cast<std::uint32_t>(taken_.size() - 1);
  }

  const Mesh& whole_;
  std::vector<std::uint32_t> places_, taken_;  // of vertices in the part, and those that have one
};

}  // namespace

std::vector<Mesh> splitMesh(Mesh mesh, const std::vector<MaterialRange>& ranges) {
  std::map<int, std::vector<MaterialRange>> by_material;
  for (const MaterialRange& range : ranges)
    if (range.begin < range.end) by_material[range.material].push_back(range);
  if (by_material.size() == 1) {
    mesh.material = by_material.begin()->first;
    std::vector<Mesh> whole;
    whole.push_back(std::move(mesh));
    return whole;
  }
  Splitter splitter(mesh);
  std::vector<Mesh> parts;
  for (const auto& [material, its] : by_material) parts.push_back(splitter.part(its));
  return parts;
}

}  // namespace saccade
