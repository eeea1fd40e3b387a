// Places in the free space of a scene, which straight lines join.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/roam/surroundings.h"

namespace saccade {

// Places are within so many sights of where the search begins; and of a surface, unless it begins farther
// away. They see landmarks.
inline constexpr double kMostWay = 5, kMostDistance = 1;

struct Place {
  Vec3d at;
  double distance;         // to the nearest surface, at most 1000 sights
  std::size_t parent = 0;  // the line to this one is clear; the root is its own
};

// A place with this clearance: the start, or else one that free straight lines lead to from there. None where
// the search, of bounded length, finds none.
std::optional<Place> findRoot(const FreeSpace& space, Vec3d start, double clearance,
                              const Surroundings& around, std::uint64_t seed);

// How far the roomiest place that such lines lead to is from all surfaces, about; at most kMostDistance.
double roomiest(const FreeSpace& space, Vec3d start, const Surroundings& around, std::uint64_t seed);

// Grows from the root at random: towards what is seen, or within the ball that is known to be free.
std::vector<Place> growTree(const FreeSpace& space, const Place& root, double clearance,
                            const Surroundings& around, std::uint64_t seed);

}  // namespace saccade
