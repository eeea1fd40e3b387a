// CPU time by stage of a frame, summed over threads.
#pragma once

#include <array>
#include <chrono>

namespace saccade {

enum class Stage { kTrace, kTemporal, kVariance, kAtrous, kModulate, kRefine, kEvents };
inline constexpr std::array<const char*, 7> kStageNames{"trace",    "temporal", "variance", "atrous",
                                                        "modulate", "refine",   "events"};

struct StageTimes {
  std::array<std::chrono::nanoseconds, kStageNames.size()> cpu{};

  std::chrono::nanoseconds& operator[](Stage s) { return cpu[static_cast<std::size_t>(s)]; }
  std::chrono::nanoseconds operator[](Stage s) const { return cpu[static_cast<std::size_t>(s)]; }
  std::chrono::nanoseconds total() const {
    std::chrono::nanoseconds sum{0};
    for (const auto time : cpu) sum += time;
    return sum;
  }
  StageTimes& operator+=(const StageTimes& other) {
    for (std::size_t i = 0; i < cpu.size(); ++i) cpu[i] += other.cpu[i];
    return *this;
  }
};

}  // namespace saccade
