// Counts of all streams together since the server started. Any thread adds to them.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "methods/stage_times.h"
#include "stream/request_counts.h"
#include "stream/traffic.h"

namespace saccade {

struct Totals {
  std::atomic<std::uint64_t> frames = 0;  // rendered; a frame of a shared feed counts once
  std::atomic<std::uint64_t> events = 0;
  std::array<std::atomic<std::int64_t>, kStageNames.size()> stage_cpu_ns{};
  Traffic traffic;
  RequestCounts requests;

  void add(const StageTimes& times) {
    for (std::size_t i = 0; i < times.cpu.size(); ++i) stage_cpu_ns[i] += times.cpu[i].count();
  }
};

}  // namespace saccade
