// The truth channels, one file each.
#pragma once

#include "truth/truth_source.h"

namespace saccade {

std::unique_ptr<TruthSource> makeDepth(const TruthConfig& config);
std::unique_ptr<TruthSource> makePose(const TruthConfig& config);

}  // namespace saccade
