// Denoises each frame by itself with a trained network, as renderers of pictures do. The change is the
// difference of two denoised frames, D[I_t] - D[I_{t-1}] [E (7)].
#pragma once

#include <memory>

#include "methods/method.h"

namespace saccade {

// A trained network. It keeps nothing from frame to frame.
class PictureDenoiser {
 public:
  virtual ~PictureDenoiser() = default;
  // Fills I, of the size of the frame, with I2 of its samples without their noise. Runs on the calling thread
  // alone. Throws std::runtime_error if the network fails.
  virtual void denoise(const Frame& frame, ImageF& I) = 0;
};

// Its variances are 0: a network does not tell them. So one job runs the network, and the threads of a pool
// help no single stream.
class LearnedDenoiser final : public Method {
 public:
  LearnedDenoiser(std::unique_ptr<PictureDenoiser> denoiser, int width, int height);

  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  // Fills I with a denoised frame, and with 0 where the network gives a value < 0 or no finite one.
  std::chrono::nanoseconds denoise(const Frame& frame, const PoolHandle& pool, ImageF& I);

  std::unique_ptr<PictureDenoiser> denoiser_;
  ImageF I_prev_;  // D[I_{t-1}]
};

}  // namespace saccade
