// Events as four columns, as HDF5 and NumPy files have them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/readers/reader.h"

namespace saccade::client {

inline constexpr std::uint64_t kColumnBatch = 1 << 16;  // events

struct EventColumns {
  std::vector<std::int64_t> t_us, x, y, p;  // equally many of each

  // Replaces `events` by these. `before`: events of the file before them. Throws FileFault with the event at
  // fault if a number is not one of an event, or of a time beyond 292 years.
  void toEvents(const std::string& path, std::uint64_t before, Events& events) const;
};

// A side of the image, where 0 stands for not known; throws FileFault.
std::uint32_t toSide(const std::string& path, const std::string& name, std::int64_t pixels);

}  // namespace saccade::client
