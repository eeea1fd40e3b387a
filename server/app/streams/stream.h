// A stream of this server: its request, its feed, and its way to the client.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/feeds/feed_runner.h"
#include "app/feeds/pace.h"
#include "app/feeds/pushed_frames.h"
#include "app/feeds/steering.h"
#include "app/feeds/stream_sink.h"
#include "stream/session.h"

namespace saccade {

// Copies share all that is large.
struct Stream {
  std::string user;                               // the public key of its client; empty without keys
  std::shared_ptr<const v1::OpenStream> request;  // resolved; without the keys or the text of its trajectory
  std::size_t request_bytes = 0;                  // of the request, serialized
  std::vector<std::shared_ptr<void>> reserved;    // its shares of the quotas
  CpuCost frame_cost;  // PACED: as measured before it was opened; `feed` is 0 where it joined a feed
  std::shared_ptr<FeedRunner> feed;
  std::shared_ptr<Steering> steering;    // of `feed`, where its client steers it
  std::shared_ptr<PushedFrames> pushed;  // of `feed`, where its client sends the frames
  std::shared_ptr<StreamSink> sink;
  std::shared_ptr<Session> session;
  std::optional<ChangeNotifier::Clock::time_point> closed;  // by its client

  void stop(v1::EndReason reason) const;  // at once, where its feed serves no other stream
  v1::StreamInfo info() const;
  CpuCost load() const;  // of a second; 0 where it keeps no pace or has ended
};

}  // namespace saccade
