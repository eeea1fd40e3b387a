// Turns by key: one holder at a time.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>

namespace saccade {

class Turns {
 public:
  // Waits until nobody has the turn of this key. It lasts until the last copy of the result goes, which this
  // must outlive. From any thread. Throws Cancelled as soon as `stop` is requested.
  std::shared_ptr<void> take(const std::string& key, const std::stop_token& stop);

 private:
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::set<std::string> taken_;
};

}  // namespace saccade
