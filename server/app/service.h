// Answers the calls of the control socket.
#pragma once

#include <functional>
#include <string>

#include "app/streams/scene_lister.h"
#include "app/streams/stream_opener.h"
#include "app/streams/stream_registry.h"
#include "base/worker.h"
#include "stream/control_server.h"

namespace saccade {

class Service {
 public:
  using Answer = std::function<void(v1::Reply)>;

  // Keeps references. `description` is what ServerInfo answers.
  Service(const SceneCache& scenes, ResourceQuota& quota, StreamRegistry& streams, StreamOpener& opener,
          ClientLog& log, v1::ServerDescription description);

  // Does not block; `answer` is called once, perhaps later and from another thread. `peer` is who asks:
  // streams are listed to those who opened them.
  void handle(RawRequest request, const Peer& peer, Answer answer);

 private:
  void hand(RawRequest request, const Peer& peer, const Answer& answer);
  void open(RawRequest request, const Peer& peer, Answer answer);
  void getFrame(const v1::GetFrame& call, Answer answer);
  void fill(const v1::Request& request, const Peer& peer, v1::Reply& reply);
  v1::StreamList listStreams(const std::string& user) const;

  ResourceQuota& quota_;
  StreamRegistry& streams_;
  StreamOpener& opener_;
  ClientLog& log_;
  const v1::ServerDescription description_;
  SceneLister scenes_;
  Worker packer_;  // of pictures
};

// The methods there are, as ServerInfo lists them.
void describeMethods(v1::ServerDescription& description);
// The parts of a scene's model that a stream can do without.
void describeParts(v1::ServerDescription& description);

}  // namespace saccade
