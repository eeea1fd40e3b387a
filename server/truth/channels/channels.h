// The truth channels, one file each.
#pragma once

#include "truth/truth_source.h"

namespace saccade {

std::unique_ptr<TruthSource> makeDepth(const TruthConfig& config);
std::unique_ptr<TruthSource> makeImu(const TruthConfig& config);
std::unique_ptr<TruthSource> makePose(const TruthConfig& config);
std::unique_ptr<TruthSource> makeDistance(const TruthConfig& config);
std::unique_ptr<TruthSource> makeNormals(const TruthConfig& config);
std::unique_ptr<TruthSource> makeIntensity(const TruthConfig& config);
std::unique_ptr<TruthSource> makeBrightness(const TruthConfig& config);
std::unique_ptr<TruthSource> makeFlowBackward(const TruthConfig& config);
std::unique_ptr<TruthSource> makeFlowForward(const TruthConfig& config);
std::unique_ptr<TruthSource> makeVelocity(const TruthConfig& config);
std::unique_ptr<TruthSource> makeFrame(const TruthConfig& config);    // 8 bits
std::unique_ptr<TruthSource> makeFrame16(const TruthConfig& config);  // 16 bits
std::unique_ptr<TruthSource> makeIds(const TruthConfig& config);

}  // namespace saccade
