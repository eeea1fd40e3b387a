// The files that bakes are kept in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace saccade {

// The file of a plan with this digest.
std::string bakePath(const std::string& folder, std::uint64_t plan);

// The state that a file keeps, and its digest.
struct KeptBake {
  std::string state;
  std::uint64_t digest;
};

// Nothing where there is no such file. Throws std::runtime_error, which names the file, where it is damaged
// or is that of another plan.
std::optional<KeptBake> readBake(const std::string& path, std::uint64_t plan);

// Returns the digest. Whoever reads meanwhile finds the old file or the new one. Makes the folder. Throws
// std::runtime_error.
std::uint64_t writeBake(const std::string& path, std::uint64_t plan, const std::string& state);

}  // namespace saccade
