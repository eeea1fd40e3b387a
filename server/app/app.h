// The server: everything it is made of, wired together.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/config/config.h"
#include "app/config/keys.h"
#include "app/request/measured_source.h"
#include "app/service.h"
#include "ops/client_log.h"
#include "ops/http_server.h"
#include "ops/service_manager.h"
#include "stream/broadcast_server.h"
#include "stream/control_server.h"
#include "stream/data_server.h"

namespace saccade {

class App {
 public:
  static constexpr std::chrono::seconds kStall{10};  // a thread that has stood still so long has failed

  // Listens and serves. Throws std::runtime_error where that cannot be. `config.threads` >= 1.
  explicit App(const Config& config);
  ~App();  // stop()

  std::string controlEndpoint() const { return control_.endpoint(); }
  std::string httpEndpoint() const { return http_ ? http_->endpoint() : "off"; }

  void reloadKeys();  // the clients' ones; where that fails the log says so and they stay as they were

  bool alive() const;                        // every socket's thread has gone around within kStall
  bool ready() const { return !stopping_; }  // streams may be opened

  // Ends all streams and sends what is left, for at most `config.drain_s`. False: a receiver did not take it
  // all, or a scene was not loaded or a frame not done in time; the destructor would wait for these.
  bool stop();

 private:
  v1::ServerDescription describe(const Config& config) const;
  HttpPages pages() const;
  void sweep(std::stop_token stopped);
  ChangeNotifier::Clock::time_point oldestTurn() const;  // of the sockets' threads

  const std::uint64_t epoch_;
  const std::chrono::duration<double> drain_time_;
  const Access access_;
  const MeasuredTables tables_;
  ResourceQuota quota_;
  Totals totals_;
  ClientLog client_log_;
  TilePool pool_;
  SceneCache scenes_;
  SessionDirectory sessions_;
  ControlServer control_;
  DataServer data_;
  BroadcastServer broadcast_;
  StreamRegistry streams_;
  StreamOpener opener_;
  Service service_;
  const ServiceManager manager_;
  std::jthread sweeper_;
  std::atomic<bool> stopping_ = false;
  std::optional<HttpServer> http_;
};

}  // namespace saccade
