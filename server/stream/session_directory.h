// The streams that transports may serve, by id. All members may be called from any thread.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "stream/session.h"

namespace saccade {

class SessionDirectory {
 public:
  explicit SessionDirectory(std::uint64_t epoch = 0) : epoch_(epoch) {}

  std::uint64_t epoch() const { return epoch_; }  // of the server
  void add(std::shared_ptr<Session> session);
  void remove(const std::string& id);

  std::shared_ptr<Session> find(const std::string& id) const;  // null if there is none
  std::vector<std::shared_ptr<Session>> all() const;

 private:
  const std::uint64_t epoch_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Session>> sessions_;
};

}  // namespace saccade
