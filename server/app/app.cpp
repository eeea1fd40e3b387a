#include "app/app.h"

#include <malloc.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "app/limit_use.h"
#include "app/metrics.h"
#include "app/request/server_description.h"
#include "base/instruction_set.h"
#include "saccade/wire/protocol.h"
#include "stream/bounded_peers.h"
#include "web/page_files.h"

namespace saccade {
namespace {

// For the log: the names of the list.
ClientLog::NameOf namesOf(const ClientKeys* clients) {
  return [clients](const std::string& key) { return clients ? clients->find(key).name : std::string(); };
}

const HttpAnswer kStopping{.status = 503, .body = "the server is stopping\n"};

}  // namespace

App::App(const Config& config, Opened)
    : epoch_(std::stoull(randomHex(8), nullptr, 16)),
      drain_time_(config.drain_s),
      access_(openAccess(config)),
      clients_(access_.keys ? access_.keys->clients.get() : nullptr),
      tables_{openAccuracySource(config.accuracy), openSimplificationSource(config.simplification)},
      quota_(config.limits),
      client_log_(namesOf(clients_)),
      pool_(config.threads),
      scenes_(config.scenes, config.limits, config.meshes),
      bakes_(config.bakes, config.limits),
      sessions_(epoch_),
      control_({.endpoint = config.control,
                .request_bytes = static_cast<std::int64_t>(config.limits.bytes(Limit::kMessage)),
                .unread_bytes = static_cast<std::int64_t>(config.limits.bytes(Limit::kReplies)),
                .access = access_},
               totals_.requests),
      data_(config.data, sessions_, static_cast<std::int64_t>(config.limits.bytes(Limit::kCredit)), access_),
      broadcast_(config.broadcast, sessions_, access_),
      streams_(sessions_, client_log_, StreamRegistry::Lease(config.lease_s)),
      opener_({scenes_, bakes_, tables_, pool_, quota_, streams_, data_.wake(), broadcast_.wake(), totals_,
               client_log_, clients_, epoch_}),
      service_(scenes_, quota_, streams_, opener_, client_log_, [this] { return describeNow(); }),
      description_(describe(config)) {
  serveHttp(config);
}

App::App(const Config& config) : App(config, Opened{}) {
  started_ = true;
  data_.start();
  broadcast_.start();
  control_.start([this](RawRequest request, const Peer& peer,
                        Answer answer) { service_.handle(std::move(request), peer, std::move(answer)); },
                 [this](const std::string& connection) { opener_.pendingOpens().cancelAllOf(connection); });
  sweeper_ = std::jthread([this](std::stop_token stopped) { sweep(stopped); });
  manager_.tell("READY=1");
  if (!peersAreBounded()) spdlog::warn(kUnboundedPeers);
  spdlog::info("ready: control {} data {} broadcast {} http {} viewer {}, {} threads, {}, scenes in {}",
               control_.endpoint(), data_.endpoint(), broadcast_.endpoint(), httpEndpoint(), viewerUrl(),
               config.threads, instructionSetName(), config.scenes);
}

void App::check(const Config& config) {
  App(config, Opened{});
}

App::~App() {
  stop();
}

void App::reloadKeys() {
  if (!clients_) return;
  try {
    clients_->reload();
    spdlog::info("{} clients may connect", clients_->size());
  } catch (const std::runtime_error& fault) {
    spdlog::error("the keys stay as they were: {}", fault.what());
  }
}

v1::ServerDescription App::describe(const Config& config) const {
  v1::ServerDescription description;
  description.set_version(SACCADE_VERSION);
  description.set_protocol_version(kProtocolVersion);
  description.set_epoch(epoch_);
  description.set_threads(static_cast<std::uint32_t>(config.threads));
  description.set_instruction_set(instructionSetName());
  description.set_data_endpoint(data_.endpoint());
  description.set_broadcast_endpoint(broadcast_.endpoint());
  describeMethods(description);
  describeFeatures(description);
  describeTruth(description);
  describePresets(description);
  describeLimits(config.limits, description);
  *description.mutable_budgets() = tables_.accuracy.info();
  *description.mutable_simplification() = tables_.simplification.info();
  return description;
}

v1::ServerDescription App::describeNow() const {
  v1::ServerDescription description = description_;
  describeUse({.quota = quota_,
               .scenes = scenes_,
               .bakes = bakes_,
               .streams = streams_,
               .pool = pool_,
               .viewers = viewer_ ? viewer_->viewers() : 0},
              description);
  return description;
}

ChangeNotifier::Clock::time_point App::oldestTurn() const {
  return std::min({control_.lastTurn(), data_.lastTurn(), broadcast_.lastTurn()});
}

bool App::alive() const {
  return ChangeNotifier::Clock::now() - oldestTurn() < kStall;
}

HttpPages App::pages() const {
  const auto say = [](bool yes, const char* text) {
    return HttpAnswer{.status = yes ? 200 : 503, .body = text};
  };
  return {
      {"/healthz", [=, this] { return alive() ? say(true, "alive\n") : say(false, "a thread is stuck\n"); }},
      {"/readyz", [=, this] { return ready() ? say(true, "ready\n") : say(false, "stopping\n"); }},
      {"/metrics",
       [this] {
         return HttpAnswer{.type = "text/plain; version=0.0.4; charset=utf-8",
                           .body = metricsText(totals_, streams_, scenes_, clients_,
                                               viewer_ ? viewer_->viewers() : 0, ready())};
       }},
  };
}

void App::serveHttp(const Config& config) {
  const auto keys = openViewer(config, access_);  // which also refuses a viewer without HTTP
  if (config.http == "off") return;
  HttpPages all = pages();
  HttpUpgrades upgrades;
  if (keys) {
    viewer_.emplace(ViewerSettings{.control = reachableHere(control_.endpoint()),
                                   .source = {.data = reachableHere(data_.endpoint()),
                                              .broadcast = reachableHere(broadcast_.endpoint()),
                                              .keys = *keys},
                                   .max_viewers = static_cast<std::size_t>(config.limits[Limit::kViewers]),
                                   .loopback_only = isLoopback(config.http)});
    for (const auto& file : viewerPages())
      all[file.first] = [this, page = file.second] { return stopping_ ? kStopping : page(); };
    HttpUpgrade& viewer = upgrades[ViewerGateway::kPath] = viewer_->upgrade();
    viewer.answer = [this, answer = viewer.answer](const HttpHeader& header) {
      return stopping_ ? kStopping : answer(header);
    };
  }
  http_.emplace(config.http, std::move(all), std::move(upgrades));
}

void App::sweep(std::stop_token stopped) {
  std::mutex mutex;
  std::condition_variable_any tick;
  std::unique_lock lock(mutex);
  auto woken = ChangeNotifier::Clock::now();
  std::uint64_t forgotten = 0;
  while (!stopped.stop_requested()) {
    tick.wait_for(lock, stopped, std::chrono::seconds(1), [] { return false; });
    streams_.sweep(ChangeNotifier::Clock::now());
    // Without it the heap keeps the memory that many streams at once have taken.
    if (std::exchange(forgotten, streams_.forgotten()) != forgotten) malloc_trim(0);
    // Pets the watchdog only if every socket thread has completed a loop since the last tick.
    if (oldestTurn() >= woken) manager_.tell("WATCHDOG=1");
    woken = ChangeNotifier::Clock::now();
    for (WakeFd* loop : {&control_.wake(), &data_.wake(), &broadcast_.wake()}) loop->wake();
  }
}

bool App::stop() {
  if (!started_ || stopping_.exchange(true)) return true;
  manager_.tell("STOPPING=1");
  const auto deadline =
      ChangeNotifier::Clock::now() + std::chrono::duration_cast<ChangeNotifier::Clock::duration>(drain_time_);
  opener_.stop();
  const bool all_taken = streams_.stopAll(deadline);
  const bool all_open = opener_.wait(deadline);
  if (viewer_) viewer_->stop();
  sweeper_ = {};
  control_.stop();
  data_.stop();
  broadcast_.stop();
  return all_open && all_taken;
}

}  // namespace saccade
