#include "app/feeds/turns.h"

#include "base/cancelled.h"

namespace saccade {

std::shared_ptr<void> Turns::take(const std::string& key, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  if (!ended_.wait(lock, stop, [&] { return !taken_.contains(key); })) throw Cancelled();
  taken_.insert(key);
  return {this, [key](Turns* turns) {
            std::lock_guard ending(turns->mutex_);
            turns->taken_.erase(key);
            turns->ended_.notify_all();
          }};
}

}  // namespace saccade
