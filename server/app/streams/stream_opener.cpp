#include "app/streams/stream_opener.h"

#include <algorithm>

#include "app/request/refusal.h"
#include "app/request/request_bounds.h"
#include "base/lower_priority.h"

namespace saccade {
namespace {

constexpr const char* kStopping = "the server is stopping";

}  // namespace

void StreamOpener::open(RawRequest request, const Peer& peer, std::function<void(v1::Reply)> answer) {
  std::lock_guard lock(mutex_);
  if (stopped_) throw Refusal(v1::CODE_UNAVAILABLE, {}, kStopping);
  std::erase_if(under_way_,
                [](auto& one) { return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
  auto opening = pending_opens_.add(peer, request.id);
  under_way_.push_back(std::async(std::launch::async, [this, request = std::move(request), answer,
                                                       opening = std::move(opening)]() mutable {
    lowerPriority();
    v1::Reply done = reply(std::move(request), *opening);
    opening.reset();
    answer(std::move(done));
  }));
}

void StreamOpener::stop() {
  std::lock_guard lock(mutex_);
  stopped_ = true;  // from here on open() leaves under_way_ alone
  pending_opens_.cancelAll();
}

bool StreamOpener::wait(ChangeNotifier::Clock::time_point deadline) {
  return std::all_of(under_way_.begin(), under_way_.end(),
                     [&](auto& one) { return one.wait_until(deadline) == std::future_status::ready; });
}

v1::Reply StreamOpener::reply(RawRequest raw, PendingOpen& opening) {
  v1::Reply reply;
  try {
    v1::Request request = parseRequest(raw.message.bytes);
    raw.message = {};
    *reply.mutable_open_stream() = maker_.make(std::move(*request.mutable_open_stream()), opening);
    *reply.mutable_status() = okStatus();
  } catch (const Cancelled&) {
    reply.clear_open_stream();
    *reply.mutable_status() = stopped_ ? makeStatus(v1::CODE_UNAVAILABLE, kStopping)
                                       : makeStatus(v1::CODE_CANCELLED, "the request was cancelled");
  } catch (...) {
    reply.clear_open_stream();
    *reply.mutable_status() = statusOfException();
  }
  return reply;
}

}  // namespace saccade
