// Resolves the truth channels of a request.
#pragma once

#include <string>

#include "feed/feed_config.h"
#include "saccade/v1/control.pb.h"
#include "truth/truth_config.h"

namespace saccade {

// Checks truth channel `index` and fills in its defaults. Throws Refusal.
TruthConfig resolveTruth(v1::Truth& truth, int index, const FeedConfig& feed, std::uint64_t stream_seed);

// Checks the IMU at `field` and fills in its defaults. Throws Refusal.
ImuConfig resolveImu(v1::Imu& imu, const std::string& field, std::uint64_t seed);

}  // namespace saccade
