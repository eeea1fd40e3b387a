// Reports the progress of a scene that takes long to load.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "scene/files/load_options.h"

namespace saccade {

inline constexpr std::chrono::seconds kSlowLoad{2};

// Calls `tell` with "NAME: 12 of 302 files read" once the load, which begins now, has taken kSlowLoad, and
// after each kSlowLoad more. `now` is the time, for tests.
LoadProgress tellSlowLoad(
    const std::string& name, std::function<void(const std::string&)> tell,
    std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now);

}  // namespace saccade
