#include "scene/files/slow_load.h"

#include <utility>

namespace saccade {

LoadProgress tellSlowLoad(const std::string& name, std::function<void(const std::string&)> tell,
                          std::function<std::chrono::steady_clock::time_point()> now) {
  auto next = now() + kSlowLoad;
  return [name, next, tell = std::move(tell), now = std::move(now)](int done, int total) mutable {
    if (now() < next) return;
    next = now() + kSlowLoad;
    tell(name + ": " + std::to_string(done) + " of " + std::to_string(total) + " files read");
  };
}

}  // namespace saccade
