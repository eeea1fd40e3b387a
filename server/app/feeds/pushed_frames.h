// The frames of a stream whose client sends them, and the intervals between these frames.
#pragma once

#include <array>
#include <deque>
#include <mutex>
#include <string_view>
#include <vector>

#include "feed/interval_source.h"
#include "frame/intensity_change.h"

namespace saccade {

class PushedFrames final : public IntervalSource {
 public:
  // `frames`: index of the last frame; 0: there is none. At most `most_waiting` frames wait for step().
  PushedFrames(int width, int height, double frame_rate_hz, FrameIndex frames, std::size_t most_waiting);

  // Takes the next frame: width * height float32, row by row from the top. Returns its index. Throws
  // LimitReached where too many wait, and Refusal where no frame is left; both before it reads the bytes.
  // Throws Refusal for bytes that are no such frame. From any thread.
  FrameIndex push(std::string_view intensity);

  bool ready() const override;
  const std::vector<FeedInterval>& step(const PoolHandle& pool) override;
  StageTimes lastTimes() const override { return {}; }
  std::chrono::nanoseconds lastCriticalPath() const override { return {}; }

 private:
  void checkRoom() const;
  ImageF read(std::string_view intensity) const;

  const int width_, height_;
  const double frame_rate_hz_;
  const FrameIndex frames_;
  const std::size_t most_waiting_;

  mutable std::mutex mutex_;
  std::deque<ImageF> waiting_;
  FrameIndex pushed_ = 0;  // so many frames so far

  // Of the feed's thread; at first also of the push() of frame 0. Frame n is I_now of changes_[n % 2].
  std::array<IntensityChange, 2> changes_;
  FrameIndex frame_ = 0;  // the newest one
  std::vector<FeedInterval> intervals_;
};

}  // namespace saccade
