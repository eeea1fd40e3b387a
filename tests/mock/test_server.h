// A server in this process, on free ports.
#pragma once

#include "app/app.h"
#include "mock/mock_client.h"
#include "mock/mock_subscriber.h"

namespace saccade {

class TestServer {
 public:
  // `scenes`: a folder; empty: the project's own. `accuracy`, `simplification`: files of tables; empty: none.
  explicit TestServer(int threads = 1, const std::string& scenes = {}, const std::string& accuracy = {},
                      const std::string& simplification = {});
  explicit TestServer(const Config& config, const MockKeys& keys = {});

  MockClient& client() { return client_; }
  MockSubscriber dataSubscriber() { return MockSubscriber(info_.data_endpoint()); }
  MockSubscriber broadcastSubscriber(const v1::StreamOpened& s) { return {info_.broadcast_endpoint(), s}; }
  // SUB to any topics, though no stream may have them.
  MockSubscriber broadcastSubscriber(const std::vector<std::string>& topics) {
    v1::StreamOpened stream;
    for (const auto& topic : topics) stream.add_topics(topic);
    return broadcastSubscriber(stream);
  }
  // Opens, attaches with ample credit and receives until the END of every channel.
  std::map<std::uint32_t, Packets> run(const v1::OpenStream& request);
  App& app() { return app_; }

 private:
  App app_;
  MockClient client_;
  v1::ServerDescription info_;
};

// Free ports, one thread, the project's scenes, any pace, and a log of warnings only.
Config testConfig();

// The Cornell box at 32 x 24, 20 frame intervals of 2 ms, LOSSLESS and FAST, one sensor with a low threshold.
v1::OpenStream tinyRequest();

}  // namespace saccade
