// The feeds that other streams may join.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/feeds/feed_runner.h"
#include "app/request/resolved_stream.h"

namespace saccade {

// Whether the stream runs by the clock.
bool isPaced(const v1::OpenStream& request);

// All members may be called from any thread.
class SharedFeeds {
 public:
  // A feed that runs for an equal request, or nullptr. It may have ended meanwhile.
  std::shared_ptr<FeedRunner> find(const ResolvedStream& stream);
  // Lets others find the feed, if the stream allows it.
  void add(const ResolvedStream& stream, const std::shared_ptr<FeedRunner>& feed);

 private:
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<FeedRunner>> feeds_;  // by ResolvedStream::feedKey()
};

}  // namespace saccade
