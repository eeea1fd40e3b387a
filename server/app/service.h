// Answers the calls of the control socket.
#pragma once

#include <functional>
#include <string>

#include "app/stores/scene_lister.h"
#include "app/streams/stream_opener.h"
#include "app/streams/stream_registry.h"
#include "base/worker.h"
#include "stream/control_server.h"

namespace saccade {

class Service {
 public:
  using DescribeServer = std::function<v1::ServerDescription()>;

  // Keeps references. `describe_server` gives the answer to ServerInfo. It must not block.
  Service(const SceneCache& scenes, ResourceQuota& quota, StreamRegistry& streams, StreamOpener& opener,
          ClientLog& log, DescribeServer describe_server);

  // Does not block. `answer` is called once, now or later, on any thread. `peer` is the client; unless it is
  // an admin, it sees only the streams that it has opened.
  void handle(RawRequest request, const Peer& peer, Answer answer);

 private:
  void dispatch(RawRequest request, const Peer& peer, const Answer& answer);
  void open(RawRequest request, const Peer& peer, Answer answer);
  void push(const RawRequest& request, const Answer& answer);
  void getFrame(const v1::GetFrame& call, const Answer& answer);
  void describe(const v1::DescribeStream& call, const Answer& answer);
  void expect(std::size_t bytes, const Answer& answer);
  void fill(const v1::Request& request, const Peer& peer, v1::Reply& reply);
  v1::StreamList listStreams(const Peer& peer, bool all) const;

  ResourceQuota& quota_;
  StreamRegistry& streams_;
  StreamOpener& opener_;
  ClientLog& log_;
  const DescribeServer describe_server_;
  SceneLister scenes_;
  Worker pictures_;  // copies and draws for get_frame, and copies paths for describe_stream
};

}  // namespace saccade
