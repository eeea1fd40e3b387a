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
};

struct SurfaceStart {
  PathStart path;
  DiffuseBase base;
  float albedo = 0;                 // luminance
  std::uint32_t carrier = kNoBody;  // the body that carries it and its light, see SlidingSurfaces
};

// A start at a plain surface: a lane of PlainSurfaces.
struct PlainStart {
  PlainStart() = default;
  PlainStart(const PlainSurfaces& s, int lane, std::uint32_t carrier)
      : point(s.point.at(lane)),
        geometric_normal(s.geometric_normal.at(lane)),
        shading_normal(s.shading_normal.at(lane)),
        reflectance(s.reflectance.at(lane)),
        offset(s.offset[lane]),
        albedo(s.albedo[lane]),
        width(s.width[lane]),
        carrier(carrier) {}
  void put(int lane, PlainSurfaces& s) const {
    s.point.set(lane, point), s.geometric_normal.set(lane, geometric_normal);
    s.shading_normal.set(lane, shading_normal), s.reflectance.set(lane, reflectance);
    s.offset[lane] = offset, s.albedo[lane] = albedo, s.width[lane] = width;
  }

  Vec3 point, geometric_normal, shading_normal;
  Rgb reflectance;
  float offset = 0, albedo = 0, width = 0;
  std::uint32_t carrier = kNoBody;  // likewise
};

// The starts of a frame's points, by index. Each is one of both. Tiles are filled by several threads.
class SurfaceStarts {
 public:
  // `plain_only`: there is no start of another kind.
  SurfaceStarts() = default;
  SurfaceStarts(SurfaceStarts&& other) { *this = std::move(other); }
  SurfaceStarts& operator=(SurfaceStarts&& other) {
    plain_.swap(other.plain_), others_.swap(other.others_), is_plain_.swap(other.is_plain_);
    carried_.swap(other.carried_);
    any_ = other.any_.load(), any_of_others_ = other.any_of_others_.load();
    any_near_shadow_ = other.any_near_shadow_.load();
    return *this;
  }
  // `deforms`: a body does.
  void resize(std::size_t points, bool plain_only, bool deforms) {
    carried_.resize(deforms ? points : 0);
    plain_.resize(points), is_plain_.resize(points), others_.resize(plain_only ? 0 : points);
    any_ = any_of_others_ = any_near_shadow_ = false;
  }
  void set(std::size_t i, const PlainStart& start) { plain_[i] = start, is_plain_[i] = true; }
  void set(std::size_t i, const SurfaceStart& start) { others_[i] = start, is_plain_[i] = false; }
  // The place of a start on a body that deforms.
  void setCarried(std::size_t i, const ShapePoint& on) { carried_[i] = on; }
  // Tells of a tile whether any of its starts may get paths, whether SurfacePoint::isUncacheable() is true of
  // some, and SurfacePoint::near_shadow.
  void setAny(bool paths, bool of_others, bool near_shadow) {
    if (paths) any_ = true;
    if (of_others) any_of_others_ = true;
    if (near_shadow) any_near_shadow_ = true;
  }
  // Since resize().
  bool any() const { return any_; }
  bool anyOfOthers() const { return any_of_others_; }
  bool anyNearShadow() const { return any_near_shadow_; }

  bool isPlain(std::size_t i) const { return is_plain_[i]; }
  const PlainStart& plain(std::size_t i) const { return plain_[i]; }
  const SurfaceStart& other(std::size_t i) const { return others_[i]; }
  DiffuseBase base(std::size_t i) const {
    return isPlain(i) ? DiffuseBase{plain_[i].reflectance, true} : others_[i].base;
  }
  std::uint32_t carrier(std::size_t i) const { return isPlain(i) ? plain_[i].carrier : others_[i].carrier; }
  // Where it is on its carrier. Of one that keeps its form only the body is set.
  ShapePoint carried(std::size_t i) const {
    return carried_.empty() ? ShapePoint::ofBody(carrier(i)) : carried_[i];
  }
  float albedo(std::size_t i) const { return isPlain(i) ? plain_[i].albedo : others_[i].albedo; }

 private:
  std::vector<PlainStart> plain_;
  std::vector<SurfaceStart> others_;
  std::vector<char> is_plain_;
  std::vector<ShapePoint> carried_;  // empty where no body deforms
  std::atomic<bool> any_ = false, any_of_others_ = false, any_near_shadow_ = false;
};

}  // namespace saccade
