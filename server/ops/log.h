// The log: lines of text for people, or of JSON for machines, on stdout. A thread of its own writes them, so
// that whoever reads them, or does not, holds up nobody: where kLogQueue lines wait, the oldest are dropped
// and counted.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace saccade {

// `level` as spdlog names it; `format` "text" or "json":
// {"time":"2026-11-20T20:14:17.123Z","level":"info","message":"..."}
// A message is one line in both, whatever it holds.
void setUpLog(const std::string& level, const std::string& format);

inline constexpr std::chrono::seconds kLogPatience{1};
// Writes what waits, for as long as kLogPatience; false where nobody has read it by then. What is logged
// afterwards is lost. A thread that writes may be left behind: then end the program by std::_Exit().
bool finishLog();

inline constexpr std::size_t kLogQueue = 8192;
std::size_t droppedLogLines();

}  // namespace saccade
