// The feeds that other streams may join.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/feeds/feed_runner.h"
#include "app/feeds/turns.h"
#include "app/request/resolved_stream.h"

namespace saccade {

// Whether the stream runs by the clock.
bool isPaced(const v1::OpenStream& request);

// All members may be called from any thread.
class SharedFeeds {
 public:
  // Waits while another stream is opened that might share its feed with this one, so that the second joins
  // what the first has made. Others wait until the result goes. Throws Cancelled.
  std::shared_ptr<void> takeTurn(const ResolvedStream& stream, const std::stop_token& stop);
  // A feed that runs for an equal request, or nullptr. It may have ended meanwhile.
  std::shared_ptr<FeedRunner> find(const ResolvedStream& stream);
  // Lets others find the feed, if the stream allows it.
  void add(const ResolvedStream& stream, const std::shared_ptr<FeedRunner>& feed);

 private:
  Turns turns_;  // by ResolvedStream::feedKeyOfAnySpeed()
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<FeedRunner>> feeds_;  // by ResolvedStream::feedKey()
};

}  // namespace saccade
