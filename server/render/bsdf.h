// The diffuse BSDF: free functions over lanes, no branches on them.
#pragma once

#include "render/bsdf/sampling.h"
#include "render/bsdf/shading_frame.h"

namespace saccade {

struct DirectionSample {
  Vec3T<Lane> direction;
  Lane pdf;  // per solid angle
};

// Cosine-weighted about the unit vector n: the pdf is cos/pi, so that f * cos / pdf is the albedo.
inline DirectionSample sampleCosine(Vec3T<Lane> n, Lane u1, Lane u2) {
  const Vec3T<Lane> w = cosineHemisphere(u1, u2);
  return {ShadingFrame(n).toWorld(w), cosinePdf(w.z)};
}

// Balance heuristic (Veach 1995).
inline Lane balance(Lane pdf, Lane other) {
  return pdf / (pdf + other);
}

}  // namespace saccade
