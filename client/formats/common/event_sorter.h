// Puts events in order of time that are out of order within a window, as cameras and simulators write them.
#pragma once

#include <cstdint>
#include <string>

#include "client/formats/common/reader.h"

namespace saccade::client {

class EventSorter {
 public:
  // `path` for errors; `window_us` > 0.
  EventSorter(const std::string& path, std::int64_t window_us);

  // Takes a batch, and replaces it by the events that no later one can precede. Events of one time keep their
  // order. Throws FileFault for an event that is late by more than the window, and where more than 4,194,304
  // events are in the window.
  void push(Events& events);
  void finish(Events& events);  // replaces `events` by the last ones

  std::uint64_t late() const { return late_; }            // events that had one of a later time before them
  std::int64_t longestNs() const { return longest_ns_; }  // how late they were at most

 private:
  void note(const Event& event);

  const std::string path_;
  const std::int64_t window_ns_;
  Events held_;
  std::int64_t newest_ns_ = INT64_MIN, longest_ns_ = 0;
  std::uint64_t count_ = 0, late_ = 0;
};

}  // namespace saccade::client
