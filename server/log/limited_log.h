// Log lines of one part of the server that its clients cause together, limited as those of one client.
#pragma once

#include <spdlog/common.h>

#include <mutex>
#include <string>

#include "log/client_log.h"

namespace saccade {

class LimitedLog {
 public:
  // Logs a line, cut if it is long. From any thread.
  void write(spdlog::level::level_enum level, const std::string& line);

 private:
  std::mutex mutex_;
  LogLimit limit_;
};

}  // namespace saccade
