// Bounds of the packets that wait for the client of a stream. The transport keeps them, and admission counts
// the memory that they allow.
#pragma once

#include <cstddef>
#include <cstdint>

namespace saccade {

// Default memory of packets that wait, bytes.
inline constexpr std::uint64_t kQueueBytes = 4 << 20;
// Sent packets that stay until they are acknowledged take at most this many times that memory.
inline constexpr std::uint64_t kKeptBounds = 3;

// Larger payloads are counted for as long as a receiver holds them, bytes.
inline constexpr std::size_t kLargePacket = 4 << 20;
// At most so many of a stream are held.
inline constexpr int kMostLargePackets = 4;

}  // namespace saccade
