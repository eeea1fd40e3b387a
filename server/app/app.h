// The server: everything it is made of, wired together.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/config.h"
#include "app/keys.h"
#include "app/measured_source.h"
#include "app/service.h"
#include "stream/broadcast_server.h"
#include "stream/control_server.h"
#include "stream/data_server.h"

namespace saccade {

class App {
 public:
  static constexpr std::chrono::seconds kDrainTime{5};

  // Listens and serves. Throws std::runtime_error where that cannot be. `config.threads` >= 1.
  explicit App(const Config& config);
  ~App();  // stop()

  std::string controlEndpoint() const { return control_.endpoint(); }

  void reloadKeys();  // the clients' ones; where that fails the log says so and they stay as they were

  // Ends all streams and sends what is left, for at most kDrainTime. False: a receiver did not take it all,
  // or a scene was not loaded or a frame not done in time; the destructor would wait for these.
  bool stop();

 private:
  v1::ServerDescription describe(const Config& config) const;
  void sweep(std::stop_token stopped);

  const std::uint64_t epoch_;
  const std::optional<ServerKeys> keys_;
  const MeasuredTables tables_;
  TilePool pool_;
  SceneCache scenes_;
  SessionDirectory sessions_;
  ControlServer control_;
  DataServer data_;
  BroadcastServer broadcast_;
  StreamRegistry streams_;
  StreamOpener opener_;
  Service service_;
  std::jthread sweeper_;
  bool stopped_ = false;
};

}  // namespace saccade
