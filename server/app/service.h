// Answers the calls of the control socket.
#pragma once

#include <functional>
#include <string>

#include "app/scene_cache.h"
#include "app/stream_opener.h"
#include "app/stream_registry.h"

namespace saccade {

class Service {
 public:
  // Keeps references. `description` is what ServerInfo answers.
  Service(const SceneCache& scenes, Budget& budget, StreamRegistry& streams, StreamOpener& opener,
          ClientLog& log, v1::ServerDescription description);

  // Does not block; `answer` is called once, perhaps later and from another thread. `user` is who asks:
  // streams are listed to those who opened them.
  void handle(const v1::Request& request, const std::string& user, std::function<void(v1::Reply)> answer);

 private:
  void fill(const v1::Request& request, const std::string& user, v1::Reply& reply);
  v1::SceneList listScenes() const;
  v1::StreamList listStreams(const std::string& user) const;
  v1::FramePicture getFrame(const v1::GetFrame& call) const;

  const SceneCache& scenes_;
  Budget& budget_;
  StreamRegistry& streams_;
  StreamOpener& opener_;
  ClientLog& log_;
  const v1::ServerDescription description_;
};

// The methods there are, as ServerInfo lists them.
void describeMethods(v1::ServerDescription& description);
// The parts of a scene's model that a stream can do without.
void describeParts(v1::ServerDescription& description);

}  // namespace saccade
