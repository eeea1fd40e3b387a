// Keeps the folder of bakes small.
#pragma once

#include <cstdint>
#include <string>

namespace saccade {

// Notes the use of the file `path`, and removes what killed programs have left beside it. Where there is none
// yet, removes the least recently used bakes of its folder until `needed` more bytes fit into `most`.
void makeRoomForBake(const std::string& path, std::uint64_t most, std::uint64_t needed);

}  // namespace saccade
