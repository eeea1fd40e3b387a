// The log: lines of text for people, or of JSON for machines, on stdout.
#pragma once

#include <string>
#include <string_view>

namespace saccade {

// `level` as spdlog names it; `format` "text" or "json":
// {"time":"2026-11-20T20:14:17.123Z","level":"info","message":"..."}
void setUpLog(const std::string& level, const std::string& format);

// In quotes, with escapes. What is no UTF-8 becomes U+FFFD.
std::string quoteJson(std::string_view text);

}  // namespace saccade
