// The makers of all reconstructions, for the table.
#pragma once

#include <memory>

#include "events/reconstruction.h"

namespace saccade {

std::unique_ptr<Reconstruction> makeDirect(const SensorConfig& config, int width, int height);
std::unique_ptr<Reconstruction> makeComplementary(const SensorConfig& config, int width, int height);
std::unique_ptr<Reconstruction> makeKalman(const SensorConfig& config, int width, int height);

}  // namespace saccade
