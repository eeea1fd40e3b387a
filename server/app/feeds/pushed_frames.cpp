#include "app/feeds/pushed_frames.h"

#include "app/admission/limits.h"
#include "frame/plane_bytes.h"

namespace saccade {
namespace {

constexpr double kPushRetrySeconds = 0.1;

void checkIntensity(const ImageF& frame) {
  const auto [least, most] = ranges::kPushedIntensity;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const float I = frame.at(x, y);
      if (I >= least && I <= most) continue;  // no text for the name of each pixel
      checkRange("intensity[" + std::to_string(y * frame.width() + x) + "]", I, ranges::kPushedIntensity);
    }
  }
}

}  // namespace

PushedFrames::PushedFrames(int width, int height, double frame_rate_hz, FrameIndex frames,
                           std::size_t most_waiting)
    : width_(width),
      height_(height),
      frame_rate_hz_(frame_rate_hz),
      frames_(frames),
      most_waiting_(most_waiting),
      changes_{IntensityChange(width, height), IntensityChange(width, height)} {}

FrameIndex PushedFrames::push(std::string_view intensity) {
  std::unique_lock lock(mutex_);
  checkRoom();
  lock.unlock();
  ImageF frame = read(intensity);
  lock.lock();
  checkRoom();
  if (pushed_ == 0) {
    changes_[0].I_now = std::move(frame);
  } else {
    waiting_.push_back(std::move(frame));
  }
  return pushed_++;
}

// With the lock.
void PushedFrames::checkRoom() const {
  if (frames_ > 0 && pushed_ > frames_)
    throw Refusal(v1::CODE_NOT_FOUND, "stream_id", "no frame of the stream is left");
  if (waiting_.size() >= most_waiting_) {
    throw LimitReached(Limit::kPushes, {}, std::to_string(most_waiting_) + " frames wait", kPushRetrySeconds);
  }
}

ImageF PushedFrames::read(std::string_view intensity) const {
  const std::size_t bytes = static_cast<std::size_t>(width_) * height_ * sizeof(float);
  if (intensity.size() != bytes) {
    refuse("intensity", "a frame of this stream has " + std::to_string(bytes) + " bytes, not " +
                            std::to_string(intensity.size()));
  }
  ImageF frame(width_, height_);
  readPlane(intensity, frame);
  checkIntensity(frame);
  return frame;
}

bool PushedFrames::ready() const {
  std::lock_guard lock(mutex_);
  return !waiting_.empty();
}

const std::vector<FeedInterval>& PushedFrames::step(const PoolHandle&) {
  IntensityChange& change = changes_[(frame_ + 1) % 2];
  const ImageF& before = changes_[frame_ % 2].I_now;
  change.frame = ++frame_;
  change.t0 = frameTime(frame_ - 1, frame_rate_hz_);
  change.t1 = frameTime(frame_, frame_rate_hz_);
  change.I_prev.copyFrom(before);
  {
    std::lock_guard lock(mutex_);
    change.I_now = std::move(waiting_.front());
    waiting_.pop_front();
  }
  for (int y = 0; y < height_; ++y) {
    const float *now = change.I_now.row(y), *prev = change.I_prev.row(y);
    float* dI = change.dI.row(y);
    for (int x = 0; x < width_; ++x) dI[x] = now[x] - prev[x];
  }
  intervals_.clear();
  intervals_.push_back({change, {}});
  return intervals_;
}

}  // namespace saccade
