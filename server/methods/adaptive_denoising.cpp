#include "methods/adaptive_denoising.h"

#include <algorithm>
#include <cmath>

#include "methods/param_fields.h"

namespace saccade {
namespace {

using P = AdaptiveDenoisingParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table{
      {"threshold", &P::threshold, 0, 10,
       "of events for which parameters are kept or fitted again, log units; 0: every frame is fitted",
       "[ours] that of a sensor by default; published: 0.14, 0.6 or 1, by the scene"},
      {"white", &P::white, 1e-12, 1e12,
       "luminance that counts as 255 in the response, which is linear below 20",
       "[ours] published: pictures of 8 bits"},
      {"radius", &P::radius, 1, 16, "of the window of the regression, pixels: 6 makes 13x13", "published"},
      {"hold", &P::hold, 0, 1,
       "1: a pixel keeps its light until an event, as published; 0: it follows the kept parameters",
       "[ours] sensors of any threshold need the change itself"},
  };
  return table;
}

// Of the range of a feature in the window: further away the kept parameters know next to nothing [ours].
constexpr float kKnown = 0.5f;

// The lin-log response of the published code, which follows v2e: linear below 20 of 255.
constexpr float kKnee = 20, kWhite = 255;
const float kSlope = std::log(kKnee) / kKnee;

float responseTo(float I, float white) {
  const float level = std::clamp(I * (kWhite / white), 0.f, 1e30f);
  return level < kKnee ? level * kSlope : std::log(level);
}
float lightOf(float brightness, float white) {
  const float level = brightness < std::log(kKnee) ? std::max(brightness, 0.f) / kSlope
                                                   : std::exp(std::min(brightness, 69.f));
  return level * (white / kWhite);
}

}  // namespace

MethodInfo AdaptiveDenoising::info() {
  return {"adaptive_denoising",
          "regression of brightness over features, whose parameters are kept until an event may come",
          paramSpecs(fields()), [](const ParamValues&) -> SeedPlanner { return SeedPlan::independent; },
          [](const MethodSetup& setup) -> std::unique_ptr<Method> {
            return std::make_unique<AdaptiveDenoising>(makeParams(fields(), setup.params), setup.width,
                                                       setup.height);
          }};
}

AdaptiveDenoising::AdaptiveDenoising(const P& params, int w, int h)
    : params_(params),
      kept_(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
      samples_(w, h),
      I_prev_(w, h) {}

std::chrono::nanoseconds AdaptiveDenoising::readBrightness(const Frame& frame, const PoolHandle& pool) {
  return pool.forEachRow(frame.height(), [&](int y) {
    for (int x = 0; x < frame.width(); ++x)
      samples_.at(x, y) = responseTo(frame.samples.I2.at(x, y), params_.white);
  });
}

void AdaptiveDenoising::start(const Frame& first, const PoolHandle& pool) {
  readBrightness(first, pool);
  pool.forEachRow(first.height(), [&](int y) {
    for (int x = 0; x < first.width(); ++x) {
      keptAt(x, y) = {fitLocally(first.g, samples_, x, y, params_.radius), featuresAt(first.g, x, y), {}};
      I_prev_.at(x, y) = lightOf(keptAt(x, y).model.a, params_.white);
    }
  });
}

// The published test compares the residuals of the kept parameters, at the features of both frames:
// |res_i - res_p| > tau^2. Weights are kept as well here. Then sum w r = 0 of a regression makes the left
// side (b s)^2, with the change s of the centre's features [ours].
float AdaptiveDenoising::brightness(const FramePair& frames, int x, int y) {
  const GBuffer &g = frames.cur.g, &before = frames.prev.g;
  Kept& kept = keptAt(x, y);
  // World positions are not known. The motion vector tells where the surface of now was in the frame before.
  // The difference of both places is the change of position [ours].
  const auto then = placeAt(before, static_cast<float>(x), static_cast<float>(y), before.z.at(x, y));
  const auto now = placeAt(before, static_cast<float>(x) + g.motion_x.at(x, y),
                           static_cast<float>(y) + g.motion_y.at(x, y), g.z_in_prev.at(x, y));
  RegressionFeatures s = featuresAt(g, x, y);
  for (std::size_t k = 0; k < s.size(); ++k) s[k] -= kept.features[k];
  for (std::size_t k = 0; k < 3; ++k) {
    if (!frames.cur.stands) kept.moved[k] += now[k] - then[k];
    s[s.size() - 3 + k] = kept.moved[k];
  }
  float foretold = 0;
  bool known = true;
  for (std::size_t k = 0; k < s.size(); ++k) {
    foretold += kept.model.b[k] * s[k];
    known &= std::abs(s[k]) <= kKnown * kept.model.range[k];
  }
  const float a = kept.model.a, tau = params_.threshold;
  if (known && std::abs(foretold) <= tau && tau > 0) return params_.hold ? a : a + foretold;
  const LocalModel fitted = fitLocally(g, samples_, x, y, params_.radius);
  if (tau > 0 && std::abs(fitted.a - a) <= tau) return params_.hold ? a : fitted.a;
  kept = {fitted, featuresAt(g, x, y), {}};
  return fitted.a;
}

void AdaptiveDenoising::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                                 StageTimes& times) {
  times[Stage::kModulate] += readBrightness(frames.cur, pool);
  times[Stage::kAtrous] += pool.forEachRow(I_prev_.height(), [&](int y) {
    for (int x = 0; x < I_prev_.width(); ++x) {
      const float now = lightOf(brightness(frames, x, y), params_.white), before = I_prev_.at(x, y);
      out.I_now.at(x, y) = I_prev_.at(x, y) = now;
      out.I_prev.at(x, y) = before, out.dI.at(x, y) = now - before;
    }
  });
}

}  // namespace saccade
