#include "app/streams/newest_interval.h"

#include <spdlog/spdlog.h>

#include <new>
#include <utility>

namespace saccade {
namespace {

NewestInterval::Copy copyOf(const IntensityChange* change) noexcept {
  if (!change) return nullptr;
  try {
    auto copy = std::make_shared<IntensityChange>(change->dI.width(), change->dI.height());
    copy->copyFrom(*change);
    return copy;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

void NewestInterval::ask(const Answer& answer) {
  Copy copy;
  {
    std::lock_guard lock(mutex_);
    if (rendering_) return waiting_.push_back(answer);
    copy = copyOf(newest_);
  }
  answer(copy);
}

void NewestInterval::beginFrame() {
  std::lock_guard lock(mutex_);
  rendering_ = true;
}

void NewestInterval::endFrame(const IntensityChange& change) {
  std::unique_lock lock(mutex_);
  rendering_ = false;
  newest_ = &change;
  answerAll(std::move(lock));
}

void NewestInterval::endFeed() noexcept {
  std::unique_lock lock(mutex_);
  if (std::exchange(rendering_, false)) newest_ = nullptr;  // it may be half overwritten
  answerAll(std::move(lock));
}

// A picture for people must not end the feed, so no fault leaves this.
void NewestInterval::answerAll(std::unique_lock<std::mutex> lock) noexcept {
  const auto waiting = std::exchange(waiting_, {});
  const Copy copy = waiting.empty() ? nullptr : copyOf(newest_);
  lock.unlock();
  for (const Answer& answer : waiting) {
    try {
      answer(copy);
    } catch (const std::exception& fault) {
      spdlog::error("a get_frame cannot be answered: {}", fault.what());
    }
  }
}

}  // namespace saccade
