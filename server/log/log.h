// The log: lines of text for people, or of JSON for machines, on stdout.
//
// A thread of its own writes them, so that a slow reader delays nobody. When kLogQueue lines wait, the oldest
// are dropped and counted.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace saccade {

// `level` as spdlog names it; `format` "text" or "json". A message takes one line in both, whatever it holds:
// {"time":"2026-11-20T20:14:17.123Z","level":"info","message":"..."}
void setUpLog(const std::string& level, const std::string& format);

inline constexpr std::chrono::seconds kLogTimeout{1};
// Writes the lines that wait, for at most kLogTimeout. False: nobody has read them by then; the writing
// thread still runs, so end the program by std::_Exit(). Later lines are lost.
bool finishLog();

inline constexpr std::size_t kLogQueue = 8192;
std::size_t droppedLogLines();

}  // namespace saccade
