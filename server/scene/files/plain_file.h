// Reads plain files without waiting: a FIFO or a device is an error. All functions throw SceneError, which
// names the file.
#pragma once

#include <cstddef>
#include <string>

namespace saccade {

// The whole file; more than `max_bytes` is an error.
std::string readFile(const std::string& path, std::size_t max_bytes);
// The first bytes, at most `max_bytes`.
std::string readBeginning(const std::string& path, std::size_t max_bytes);
// `bytes` from `offset` on, which the file must have.
std::string readPart(const std::string& path, std::size_t offset, std::size_t bytes);
// The size in bytes, for a reader that opens the file itself.
std::size_t plainFileSize(const std::string& path);

}  // namespace saccade
