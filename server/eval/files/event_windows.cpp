#include "eval/files/event_windows.h"

#include <stdexcept>

namespace saccade::eval {
namespace {

client::ImageSize sizeOf(const std::string& path, const client::ImageSize& in_file,
                         const client::ImageSize& given) {
  if (in_file.width == 0 && given.width == 0)
    throw std::invalid_argument("--size: '" + path + "' does not tell the size of the image");
  if (in_file.width == 0) return given;
  if (given.width != 0 && textOf(in_file) != textOf(given))
    throw std::invalid_argument("--size: '" + path + "' has " + textOf(in_file) + " pixels");
  return in_file;
}

}  // namespace

std::string textOf(const client::ImageSize& size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

EventWindows::EventWindows(const std::string& path, client::ImageSize size, bool align)
    : path_(path),
      reader_(client::openReader(path, {})),
      size_(sizeOf(path, reader_->size(), size)),
      check_(path, size_) {
  if (!align) zero_ns_ = 0;
}

std::int64_t EventWindows::nextNs() {
  return refill() ? batch_[taken_].t_ns : INT64_MAX;
}

// Whether an event is left.
bool EventWindows::refill() {
  while (!ended_ && taken_ == batch_.size()) {
    taken_ = 0;
    ended_ = !reader_->read(batch_);
    check_.check(batch_);
    if (!zero_ns_ && !batch_.empty()) zero_ns_ = batch_.front().t_ns;
    for (Event& e : batch_) e.t_ns -= *zero_ns_;
  }
  return !ended_;
}

void EventWindows::until(std::int64_t end_ns, Events& events) {
  events.clear();
  while (refill() && batch_[taken_].t_ns < end_ns) {
    if (events.size() == kMost)
      throw client::FileFault(
          path_, "more than " + std::to_string(kMost) + " events in one window; take a shorter --window");
    events.push_back(batch_[taken_++]);
  }
}

}  // namespace saccade::eval
