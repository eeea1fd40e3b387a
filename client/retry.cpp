#include "client/retry.h"

#include <algorithm>
#include <thread>

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPollInterval{200};  // between two calls of Waiting
constexpr milliseconds kLongestPause{4000};

bool mayPass(v1::Code code) {
  return code == v1::CODE_UNAVAILABLE || code == v1::CODE_RESOURCE_EXHAUSTED;
}

void pause(milliseconds time, const Waiting& waiting) {
  for (; time.count() > 0; time -= kPollInterval) {
    if (waiting) waiting();
    std::this_thread::sleep_for(std::min(time, kPollInterval));
  }
}

}  // namespace

void retry(const std::function<void(milliseconds)>& attempt, std::chrono::steady_clock::time_point until,
           const Waiting& waiting) {
  const auto late = [until] { return std::chrono::steady_clock::now() >= until; };
  for (milliseconds deadline = ControlClient::kDeadline;; deadline *= 2) {
    try {
      return attempt(deadline);
    } catch (const NoAnswer&) {
      if (late()) throw;
    } catch (const Refused& refused) {
      if (!mayPass(refused.code) || late()) throw;
    }
    pause(std::min(deadline / 12, kLongestPause), waiting);
  }
}

}  // namespace saccade::client
