// Reads a file of events in windows of time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "client/formats/common/event_check.h"
#include "client/formats/common/reader.h"

namespace saccade::eval {

std::string textOf(const client::ImageSize& size);  // "346x260"

class EventWindows {
 public:
  static constexpr std::size_t kMost = 4'000'000;  // events of one window

  // `size`: of the image, or {} where the file tells it. Throws std::invalid_argument where it does not, or
  // tells another size; and as client::openReader(). `align`: times are counted from the first event.
  EventWindows(const std::string& path, client::ImageSize size, bool align = false);

  const client::ImageSize& size() const { return size_; }
  std::int64_t nextNs();  // the time of the first event that is left; INT64_MAX without any

  // Replaces `events` by those before `end_ns` that were not given yet, in order of time. Throws
  // client::FileFault for events that no sensor of this size sends, and for more than kMost of them.
  void until(std::int64_t end_ns, Events& events);

 private:
  bool refill();

  const std::string path_;
  std::unique_ptr<client::Reader> reader_;
  const client::ImageSize size_;
  client::EventCheck check_;
  std::optional<std::int64_t> zero_ns_;  // what is taken off all times; not yet known without a value
  Events batch_;
  std::size_t taken_ = 0;  // of the batch
  bool ended_ = false;
};

}  // namespace saccade::eval
