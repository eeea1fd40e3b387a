#include "client/formats/common/event_sorter.h"

#include <algorithm>

#include "client/formats/common/event_check.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::size_t kMostHeld = 1 << 22;  // events

bool earlier(const Event& a, const Event& b) {
  return a.t_ns < b.t_ns;
}

}  // namespace

EventSorter::EventSorter(const std::string& path, std::int64_t window_us)
    : path_(path), window_ns_(window_us * kNsPerUs) {}

void EventSorter::push(Events& events) {
  for (const Event& event : events) note(event);
  held_.insert(held_.end(), events.begin(), events.end());
  if (!std::is_sorted(held_.begin(), held_.end(), earlier))
    std::stable_sort(held_.begin(), held_.end(), earlier);
  std::int64_t until_ns;
  if (__builtin_sub_overflow(newest_ns_, window_ns_, &until_ns)) until_ns = INT64_MIN;
  const auto end = std::upper_bound(held_.begin(), held_.end(), Event{until_ns, 0, 0, 0}, earlier);
  events.assign(held_.begin(), end);
  held_.erase(held_.begin(), end);
  if (held_.size() > kMostHeld)
    throw FileFault(path_, "has more than " + std::to_string(kMostHeld) + " events in a window of --sort " +
                               std::to_string(window_ns_ / kNsPerUs) + "; give a shorter one");
}

void EventSorter::finish(Events& events) {
  events.clear();
  events.swap(held_);
}

void EventSorter::note(const Event& event) {
  ++count_;
  if (event.t_ns >= newest_ns_) {
    newest_ns_ = event.t_ns;
    return;
  }
  ++late_;
  const std::int64_t late_ns = newest_ns_ - event.t_ns;
  if (late_ns > window_ns_)
    throw FileFault(path_, "event " + std::to_string(count_) + " is " + textOfUs(late_ns) +
                               " earlier than one before, beyond the window of --sort " +
                               std::to_string(window_ns_ / kNsPerUs));
  longest_ns_ = std::max(longest_ns_, late_ns);
}

}  // namespace saccade::client
