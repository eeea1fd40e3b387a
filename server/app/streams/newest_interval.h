// The newest interval of a feed, for get_frame. It is copied only when somebody asks for it.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "frame/intensity_change.h"

namespace saccade {

class NewestInterval {
 public:
  // nullptr: the feed has no frame, or there is no memory for a copy.
  using Copy = std::shared_ptr<const IntensityChange>;
  using Answer = std::function<void(const Copy&)>;

  // Calls `answer` once. While a frame is rendered it waits for that frame and is called on the feed's
  // thread, so it must be quick; otherwise it is called before this returns. From any thread.
  void ask(const Answer& answer);

  // These are for the feed's thread.
  void beginFrame();                             // rendering overwrites the interval
  void endFrame(const IntensityChange& change);  // it is complete; must live as long as this
  void endFeed() noexcept;                       // a frame that was begun does not come

 private:
  void answerAll(std::unique_lock<std::mutex> lock) noexcept;

  std::mutex mutex_;
  const IntensityChange* newest_ = nullptr;
  bool rendering_ = false;
  std::vector<Answer> waiting_;  // for the frame that is rendered
};

}  // namespace saccade
