// Lamps without extent: points, spots and suns. A point of a surface sees such a lamp in one direction alone,
// so one shadow ray tells its light without noise. Where there are many, rays go to the strongest, and to
// some of the others.
#pragma once

#include <algorithm>
#include <vector>

#include "render/lights/incident_light.h"
#include "render/lights/lamp_picks.h"
#include "render/lights/lamps.h"
#include "scene/scene.h"

namespace saccade {

class DeltaLamps {
 public:
  // `lamps`: of the scene.
  DeltaLamps(const Scene& scene, const Lamps& lamps);

  // Whether there are any that rays are sent to. More than LampPicks::kMost are left to the samples of paths.
  bool getRays() const { return size() > 0 && size() <= LampPicks::kMost; }
  // Whether rays go to all of them.
  bool areFew() const { return size() <= LampPicks::kStrongest; }
  std::size_t size() const { return spots_.size() + suns_.size(); }

  // The light of a lamp at `point`. Its pdf has no meaning.
  IncidentLight at(std::size_t lamp, Vec3 point) const;

  // Where they are many: the share of a lamp's group that was seen from near a place, but for a least part.
  // `seen`: of this place, by LampTree::seenFrom().
  float shareSeen(std::size_t lamp, const LampSight::Shares* seen) const {
    constexpr float kLeast = 0.05f;
    return seen && lamp < groups_.size() ? std::max(kLeast, seen->of[groups_[lamp]]) : 1;
  }

 private:
  std::vector<SpotLight> spots_;  // a point is one that shines everywhere
  std::vector<DirectionalLight> suns_;
  std::vector<std::uint8_t> groups_;  // of spots, at the root of the tree, if they are many
};

}  // namespace saccade
