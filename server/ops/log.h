// The log: lines of text for people, or of JSON for machines, on stdout. A thread of its own writes them, so
// that whoever reads them, or does not, holds up nobody: where kLogQueue lines wait, the oldest are dropped
// and counted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace saccade {

// `level` as spdlog names it; `format` "text" or "json":
// {"time":"2026-11-20T20:14:17.123Z","level":"info","message":"..."}
void setUpLog(const std::string& level, const std::string& format);
// Writes what waits. Nothing may be logged afterwards.
void finishLog();

inline constexpr std::size_t kLogQueue = 8192;
std::size_t droppedLogLines();

// In quotes, with escapes. What is no UTF-8 becomes U+FFFD.
std::string quoteJson(std::string_view text);

}  // namespace saccade
