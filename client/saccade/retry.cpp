#include "saccade/retry.h"

#include <algorithm>
#include <thread>

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPollInterval{200};  // between two calls of Waiting
constexpr milliseconds kLongestPause{4000};

void pause(milliseconds time, const Waiting& waiting) {
  for (; time.count() > 0; time -= kPollInterval) {
    if (waiting) waiting();
    std::this_thread::sleep_for(std::min(time, kPollInterval));
  }
}

}  // namespace

bool isShortage(const Refused& refused) {
  return refused.code == v1::CODE_UNAVAILABLE || refused.code == v1::CODE_RESOURCE_EXHAUSTED;
}

bool isRestart(const Refused& refused) {
  return refused.code == v1::CODE_UNAVAILABLE && refused.field.empty();
}

void retry(const std::function<void(milliseconds)>& attempt, const Patience& patience) {
  const auto fail = [&](const std::exception& fault) {
    if (std::chrono::steady_clock::now() >= patience.until) throw;
    if (patience.failed) patience.failed(fault);
  };
  for (milliseconds deadline = ControlClient::kDeadline;; deadline *= 2) {
    try {
      return attempt(deadline);
    } catch (const NoAnswer& silence) {
      fail(silence);
    } catch (const Refused& refused) {
      if (!patience.mayPass(refused)) throw;
      fail(refused);
    }
    pause(std::min(deadline / 12, kLongestPause), patience.waiting);
  }
}

}  // namespace saccade::client
