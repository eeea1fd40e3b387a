// The files that bakes are kept in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace saccade {

// The file of a plan with this digest.
std::string bakePath(const std::string& folder, std::uint64_t plan);

// The state that a file keeps, and its digest.
struct KeptBake {
  std::string state;
  std::uint64_t digest;
};

// Nothing where there is no such file. Throws std::runtime_error, which names the file, where it is damaged,
// is that of another plan, or has more than `most_bytes`; it is then not read.
std::optional<KeptBake> readBake(const std::string& path, std::uint64_t plan, std::uint64_t most_bytes);

// Gives a file that cannot be used another name, which it returns. Throws std::runtime_error.
std::string setBakeAside(const std::string& path);

// Returns the digest. A reader finds the old file or the new one, even meanwhile or after a power cut. Makes
// the folder. Throws std::runtime_error.
std::uint64_t writeBake(const std::string& path, std::uint64_t plan, const std::string& state);

// All files of bakes in a folder: also those that were set aside, or are being written. Those that killed
// programs have left are removed.
std::vector<std::string> bakeFiles(const std::string& folder);

}  // namespace saccade
