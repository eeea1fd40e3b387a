// The server: makes all its components and connects them.
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
#include "log/client_log.h"
#include "ops/http_server.h"
#include "ops/service_manager.h"
#include "stream/broadcast_server.h"
#include "stream/control_server.h"
#include "stream/data_server.h"
#include "stream/endpoint.h"
#include "web/viewer_gateway.h"

namespace saccade {

class App {
 public:
  static constexpr std::chrono::seconds kStall{10};  // a socket thread without a loop for so long has failed

  // Listens and serves. Throws std::runtime_error where it cannot. `config.threads` >= 1.
  explicit App(const Config& config);
  ~App();  // stop()

  // All of that but the serving: makes what a server needs, and listens, for a moment. Throws likewise.
  static void check(const Config& config);

  std::string controlEndpoint() const { return control_.endpoint(); }
  std::string viewerUrl() const { return viewer_ ? reachableHere(httpEndpoint()) + "/" : "off"; }
  std::string httpEndpoint() const { return http_ ? http_->endpoint() : "off"; }

  void reloadKeys();  // reads the clients' keys again; on a fault it logs it and keeps the old ones

  bool alive() const;  // every socket thread has completed a loop within kStall
  bool ready() const { return started_ && !stopping_; }  // streams may be opened

  // Ends all streams and sends the packets that are left, for at most `config.drain_s`. False: a receiver has
  // not taken all of them, or a frame or a scene being loaded was not done in time. The destructor waits for
  // frames and scenes.
  bool stop();

 private:
  struct Opened {};
  App(const Config& config, Opened);  // listens, and does not serve yet

  v1::ServerDescription describe(const Config& config) const;
  v1::ServerDescription describeNow() const;  // with what is used of the limits
  HttpPages pages() const;
  void serveHttp(const Config& config);
  void sweep(std::stop_token stopped);
  // When the socket thread that is furthest behind completed its last loop.
  ChangeNotifier::Clock::time_point oldestTurn() const;

  const std::uint64_t epoch_;
  const std::chrono::duration<double> drain_time_;
  const Access access_;
  ClientKeys* const clients_;  // of `access_`; null without keys
  const MeasuredTables tables_;
  ResourceQuota quota_;
  Totals totals_;
  ClientLog client_log_;
  TilePool pool_;
  SceneCache scenes_;
  BakeStore bakes_;
  SessionDirectory sessions_;
  ControlServer control_;
  DataServer data_;
  BroadcastServer broadcast_;
  StreamRegistry streams_;
  StreamOpener opener_;
  Service service_;
  const v1::ServerDescription description_;  // without that
  const ServiceManager manager_;
  std::jthread sweeper_;
  std::atomic<bool> started_ = false, stopping_ = false;
  std::optional<ViewerGateway> viewer_;
  std::optional<HttpServer> http_;
};

}  // namespace saccade
