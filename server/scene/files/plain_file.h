// Plain files, read without waiting: a FIFO or a device of that name is an error. All throw SceneError, which
// names the file.
#pragma once

#include <cstddef>
#include <string>

namespace saccade {

// All bytes; more than `max_bytes` are an error.
std::string readFile(const std::string& path, std::size_t max_bytes);
// The first bytes, at most `max_bytes`.
std::string readBeginning(const std::string& path, std::size_t max_bytes);
// For a reader that opens the file itself.
std::size_t plainFileSize(const std::string& path);

}  // namespace saccade
