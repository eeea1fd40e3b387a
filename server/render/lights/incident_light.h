// A sample of the light that reaches a point.
#pragma once

#include <cstdint>

#include "base/vec.h"

namespace saccade {

inline constexpr float kShadowEnd = 1 - 1e-4f;  // shadow rays stop just before the light

// Light that reaches a point unless something blocks it.
struct IncidentLight {
  Vec3 direction;                        // to the light, unit
  Vec3 segment;                          // of the shadow ray
  float reach;                           // its end, in lengths of the segment
  Rgb radiance;                          // at strength 1; of a delta light its irradiance at a right angle
  float pdf;                             // per solid angle; delta: the probability of the light; 0: none
  bool delta = false;                    // from one direction, which no sample of a BSDF finds
  std::uint32_t geometry = kNoGeometry;  // of EmbreeScene
  static constexpr std::uint32_t kNoGeometry = 0xffffffffu;
};

// The lights that are sampled.
enum class LightSet {
  kAll,
  kWithExtent,  // those alone that are no delta lights
};
inline constexpr int kLightSets = 2;

}  // namespace saccade
