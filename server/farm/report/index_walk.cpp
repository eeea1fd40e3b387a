#include "farm/report/index_walk.h"

#include <system_error>
#include <utility>

namespace saccade::farm {

IndexWalk::IndexWalk(const std::filesystem::path& file) {
  const auto type = std::filesystem::symlink_status(file).type();
  there_ = type != std::filesystem::file_type::not_found;
  sound_ = type == std::filesystem::file_type::regular;
  if (!sound_) return;
  file_.emplace(file);
  advance();
}

void IndexWalk::advance() {
  try {
    has_line_ = file_->next(line_);
  } catch (const std::system_error&) {
    has_line_ = sound_ = false;
  }
}

std::optional<std::string> IndexWalk::take(std::uint64_t number) {
  if (!has_line_ || !line_.starts_with("{\"number\":\"" + std::to_string(number) + "\"")) return std::nullopt;
  std::string line = std::exchange(line_, {}) + "\n";
  advance();
  return line;
}

}  // namespace saccade::farm
