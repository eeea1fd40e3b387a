// Opens streams. This may take seconds, so every request has a thread of its own.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <mutex>
#include <vector>

#include "app/streams/pending_opens.h"
#include "app/streams/stream_maker.h"

namespace saccade {

class StreamOpener {
 public:
  explicit StreamOpener(const StreamResources& resources) : maker_(resources, pending_opens_) {}

  // Does not block. `answer` is called once, on another thread. The caller bounds how many requests are under
  // way. Throws Refusal after stop().
  void open(RawRequest request, const Peer& peer, std::function<void(v1::Reply)> answer);
  PendingOpens& pendingOpens() { return pending_opens_; }
  void stop();  // refuses every further request, and cancels those under way
  // After stop(): waits for the requests under way, and returns whether all were done before `deadline`. The
  // destructor waits for the rest.
  bool wait(ChangeNotifier::Clock::time_point deadline);

 private:
  v1::Reply reply(RawRequest request, PendingOpen& opening);

  PendingOpens pending_opens_;
  StreamMaker maker_;
  std::mutex mutex_;
  std::vector<std::future<void>> under_way_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace saccade
