// The makers of all event models, for the table.
#pragma once

#include <memory>

#include "events/event_model.h"

namespace saccade {

std::unique_ptr<EventModel> makeAccumulating(const SensorConfig& config, int width, int height);
std::unique_ptr<EventModel> makeProbabilistic(const SensorConfig& config, int width, int height);
std::unique_ptr<EventModel> makeStochastic(const SensorConfig& config, int width, int height);

}  // namespace saccade
