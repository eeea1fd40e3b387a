// Events as columns, as HDF5 and NumPy files have them: four, two more with labels, and one with objects.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/common/polarity.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

inline constexpr std::uint64_t kColumnBatch = 1 << 16;  // events

struct EventColumns {
  std::vector<std::int64_t> t_us, x, y, p;     // equally many of each
  std::vector<std::int64_t> source, artefact;  // as many, or none of an event without labels
  std::vector<std::int64_t> object;            // likewise, without objects

  // Replaces `events` by these. `before`: events of the file before them. Throws FileFault with the event at
  // fault if a number is not one of an event, or of a time beyond 292 years.
  void toEvents(const std::string& path, std::uint64_t before, Events& events);

 private:
  [[noreturn]] void fail(const std::string& path, std::uint64_t before, std::size_t i) const;
  void addLabels(const std::string& path, std::uint64_t before, Events& events) const;
  void addObjects(const std::string& path, std::uint64_t before, Events& events) const;

  PolarityScale polarities_;
};

// Which columns of labels a file has. Events have labels where both are there.
struct LabelColumns {
  bool source = false, artefact = false;

  bool both() const { return source && artefact; }
  std::string alone() const;  // what is passed over: the one without the other; empty: none
};

// A side of the image, where 0 stands for not known; throws FileFault.
std::uint32_t toSide(const std::string& path, const std::string& name, std::int64_t pixels);

}  // namespace saccade::client
