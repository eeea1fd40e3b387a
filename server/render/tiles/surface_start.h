// Where the paths of a pixel's points start, for SurfaceSamples.
#pragma once

#include <atomic>
#include <vector>

#include "render/primary/primary_block.h"
#include "render/surface/path_start.h"

namespace saccade {

// The directly visible part of a surface that reflects alike into all directions.
struct DiffuseBase {
  Rgb albedo;        // 0: there is none
  bool all = false;  // the surface is nothing else

  bool isUnder() const { return !all && luminance(albedo) > 0; }  // whether it lies under a coat
};

struct SurfaceStart {
  PathStart path;  // once its coat is apart, of the base alone
  DiffuseBase base;
  float albedo = 0;  // luminance; of the coat, too
  Rgb coat;          // Bsdf::specular of a plastic; 0: nothing lies on the base

  // Takes the coat off `path`.
  void setCoatApart() {
    if (hasCoat()) path.surface.bsdf.specular = {};
  }
  bool hasCoat() const { return luminance(coat) > 0; }
  // Where the paths of the coat start.
  PathStart coatPath() const {
    PathStart start = path;
    start.surface.bsdf.diffuse = {}, start.surface.bsdf.specular = coat;
    return start;
  }
};

// A start at a plain surface: a lane of PlainSurfaces.
struct PlainStart {
  PlainStart() = default;
  PlainStart(const PlainSurfaces& s, int lane)
      : point(s.point.at(lane)),
        geometric_normal(s.geometric_normal.at(lane)),
        shading_normal(s.shading_normal.at(lane)),
        reflectance(s.reflectance.at(lane)),
        offset(s.offset[lane]),
        albedo(s.albedo[lane]),
        width(s.width[lane]) {}
  void put(int lane, PlainSurfaces& s) const {
    s.point.set(lane, point), s.geometric_normal.set(lane, geometric_normal);
    s.shading_normal.set(lane, shading_normal), s.reflectance.set(lane, reflectance);
    s.offset[lane] = offset, s.albedo[lane] = albedo, s.width[lane] = width;
  }

  Vec3 point, geometric_normal, shading_normal;
  Rgb reflectance;
  float offset = 0, albedo = 0, width = 0;
};

// The starts of a frame's points, by index. Each is one of both. Tiles are filled by several threads.
class SurfaceStarts {
 public:
  // `plain_only`: there is no start of another kind.
  SurfaceStarts() = default;
  SurfaceStarts(SurfaceStarts&& other) { *this = std::move(other); }
  SurfaceStarts& operator=(SurfaceStarts&& other) {
    plain_.swap(other.plain_), others_.swap(other.others_), is_plain_.swap(other.is_plain_);
    any_ = other.any_.load(), any_of_others_ = other.any_of_others_.load();
    any_coats_ = other.any_coats_.load();
    return *this;
  }
  void resize(std::size_t points, bool plain_only) {
    plain_.resize(points), is_plain_.resize(points), others_.resize(plain_only ? 0 : points);
    any_ = any_of_others_ = any_coats_ = false;
  }
  void set(std::size_t i, const PlainStart& start) { plain_[i] = start, is_plain_[i] = true; }
  void set(std::size_t i, const SurfaceStart& start) { others_[i] = start, is_plain_[i] = false; }
  // Tells of the starts of a tile that there are any, and whether SurfacePoint::isUncacheable() or has_coat
  // is true of some.
  void setAny(bool of_others, bool coats) {
    any_ = true;
    if (of_others) any_of_others_ = true;
    if (coats) any_coats_ = true;
  }
  bool any() const { return any_; }  // since resize()
  bool anyOfOthers() const { return any_of_others_; }
  bool anyCoats() const { return any_coats_; }

  bool isPlain(std::size_t i) const { return is_plain_[i]; }
  const PlainStart& plain(std::size_t i) const { return plain_[i]; }
  const SurfaceStart& other(std::size_t i) const { return others_[i]; }
  DiffuseBase base(std::size_t i) const {
    return isPlain(i) ? DiffuseBase{plain_[i].reflectance, true} : others_[i].base;
  }
  float albedo(std::size_t i) const { return isPlain(i) ? plain_[i].albedo : others_[i].albedo; }

 private:
  std::vector<PlainStart> plain_;
  std::vector<SurfaceStart> others_;
  std::vector<char> is_plain_;
  std::atomic<bool> any_ = false, any_of_others_ = false, any_coats_ = false;
};

}  // namespace saccade
