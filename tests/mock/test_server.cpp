#include "mock/test_server.h"

#include <spdlog/spdlog.h>

namespace saccade {
namespace {

Config configFor(int threads, const std::string& scenes, const std::string& accuracy,
                 const std::string& simplification) {
  Config config = testConfig();
  config.threads = threads;
  if (!scenes.empty()) config.scenes = scenes;
  config.accuracy = accuracy;
  config.simplification = simplification;
  return config;
}

}  // namespace

Config testConfig() {
  spdlog::set_level(spdlog::level::warn);
  Config config;
  config.control = config.data = config.broadcast = "tcp://127.0.0.1:*";
  config.threads = 1;
  config.limits[Limit::kCpu] = 0;  // a build with sanitizers may be too slow for any pace
  config.scenes = SACCADE_SOURCE_DIR "/scenes";
  return config;
}

TestServer::TestServer(int threads, const std::string& scenes, const std::string& accuracy,
                       const std::string& simplification)
    : TestServer(configFor(threads, scenes, accuracy, simplification)) {}

TestServer::TestServer(const Config& config, const MockKeys& keys)
    : app_(config), client_(app_.controlEndpoint(), keys), info_(client_.server()) {}

std::map<std::uint32_t, Packets> TestServer::run(const v1::OpenStream& request) {
  const v1::StreamOpened stream = client_.open(request);
  MockSubscriber subscriber = dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  return subscriber.receiveAll(request.sensors_size() + request.truth_size());
}

v1::OpenStream tinyRequest() {
  v1::OpenStream request;
  request.set_scene("cornell-box");
  request.mutable_view()->set_width(32);
  request.mutable_view()->set_height(24);
  request.mutable_trajectory()->set_name("right");
  request.mutable_timing()->set_frame_rate_hz(500);
  request.mutable_timing()->set_duration_s(0.04);
  request.set_seed(7);
  request.add_sensors()->set_threshold(0.1);
  return request;
}

}  // namespace saccade
