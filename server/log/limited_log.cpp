#include "log/limited_log.h"

#include <spdlog/spdlog.h>

#include "base/text_cut.h"

namespace saccade {

void LimitedLog::write(spdlog::level::level_enum level, const std::string& line) {
  std::unique_lock lock(mutex_);
  const auto held = limit_.ask({}, LogLimit::Clock::now());
  lock.unlock();
  if (!held) return;
  if (*held > 0) spdlog::warn("{} lines like the next one were held back", *held);
  spdlog::log(level, "{}", cutText(line, kMaxLineBytes));
}

}  // namespace saccade
