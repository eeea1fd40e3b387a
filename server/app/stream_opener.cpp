#include "app/stream_opener.h"

#include <algorithm>

#include "app/refusal.h"
#include "app/stream_cost.h"
#include "stream/control_server.h"

namespace saccade {
namespace {

constexpr int kIdBytes = 8;  // random: who is not told of a stream cannot subscribe to its topics

bool isPaced(const v1::OpenStream& request) {
  return request.timing().clock() == v1::CLOCK_PACED;
}

// Who paces itself by the clock never waits for its client: such streams cannot hold each other up.
bool mayShare(const v1::OpenStream& request) {
  return isPaced(request) && request.delivery() != v1::DELIVERY_LOSSLESS;
}

v1::StreamOpened describe(const ResolvedStream& resolved, const Stream& stream, std::uint64_t epoch,
                          int channels) {
  v1::StreamOpened opened;
  opened.set_stream_id(stream.session->id());
  opened.set_token(stream.session->token());
  opened.set_epoch(epoch);
  *opened.mutable_resolved() = resolved.request;
  opened.set_frames(resolved.frames);
  opened.set_luminance_p01(stream.feed->luminanceP01());
  opened.set_luminance_p50(stream.feed->luminanceP50());
  opened.set_px_per_frame_p50(stream.feed->pixelSpeed().p50);
  opened.set_px_per_frame_p99(stream.feed->pixelSpeed().p99);
  opened.set_channels(static_cast<std::uint32_t>(channels));
  if (resolved.expected) *opened.mutable_expected() = *resolved.expected;
  if (resolved.simpler) *opened.mutable_simpler() = *resolved.simpler;
  if (!stream.session->broadcast()) return opened;
  for (std::uint32_t i = 0; i < stream.session->sensors(); ++i) opened.add_topics(stream.session->topic(i));
  return opened;
}

}  // namespace

StreamOpener::StreamOpener(SceneCache& scenes, const MeasuredTables& tables, TilePool& pool, Budget& budget,
                           StreamRegistry& streams, Transports transports, Totals& totals, ClientLog& log,
                           std::uint64_t epoch)
    : scenes_(scenes),
      tables_(tables),
      pool_(pool),
      budget_(budget),
      streams_(streams),
      transports_(transports),
      totals_(totals),
      log_(log),
      epoch_(epoch) {}

void StreamOpener::open(const v1::OpenStream& request, const std::string& user,
                        std::function<void(v1::Reply)> answer) {
  std::lock_guard lock(mutex_);
  if (stopped_) throw Refusal(v1::CODE_UNAVAILABLE, {}, "the server is stopping");
  std::erase_if(opening_,
                [](auto& one) { return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
  opening_.push_back(std::async(std::launch::async, [this, request, user, answer = std::move(answer)] {
    v1::Reply reply;
    try {
      *reply.mutable_open_stream() = openNow(request, user);
      *reply.mutable_status() = okStatus();
    } catch (...) {
      *reply.mutable_status() = statusOfException();
    }
    answer(std::move(reply));
  }));
}

void StreamOpener::stop() {
  std::lock_guard lock(mutex_);
  stopped_ = true;  // and so nobody else uses `opening_` any more
}

bool StreamOpener::wait(Signal::Clock::time_point deadline) {
  return std::all_of(opening_.begin(), opening_.end(),
                     [&](auto& one) { return one.wait_until(deadline) == std::future_status::ready; });
}

v1::StreamOpened StreamOpener::openNow(const v1::OpenStream& request, const std::string& user) {
  ResolvedStream resolved = resolve(request, scenes_.library().list(), tables_);
  checkAlone(resolved.request, budget_.limits());
  boundEvents(resolved, budget_.limits());
  Stream stream;
  stream.reserved = budget_.take(user, sharesOf(resolved, budget_.limits()));
  const auto whole = scenes_.get(resolved.request.scene());
  fitTo(whole->description(), resolved);
  const auto scene = scenes_.get(resolved.request.scene(), resolved.without);
  stream.user = user;
  stream.request = resolved.request;
  openFeed(resolved, *whole, scene, stream);
  log_.info(user, "stream " + stream.session->id() +
                      " opened: " + resolved.request.ShortDebugString().substr(0, 500));
  return describe(resolved, stream, epoch_, resolved.feed.monochrome ? 1 : scene->channels());
}

// What takes time is done before anybody has to wait for this one: a measurement, the first frame of a feed.
void StreamOpener::openFeed(const ResolvedStream& resolved, const RenderScene& whole,
                            const std::shared_ptr<const RenderScene>& scene, Stream& stream) {
  Trajectory path = resolveTrajectory(resolved, whole, scenes_.library());
  const CpuCost frame = isMeasured(resolved) ? measureFrame(scene, path, resolved, pool_) : CpuCost{};
  const CpuCost sensors{0, frame.sensors, 0, frame.longest};  // of who joins a feed that runs
  const auto running = findFeed(resolved);
  admit(resolved, running ? sensors : frame, running.get());
  const auto own = running ? nullptr : makeFeed(resolved, path, scene);
  std::lock_guard admitting(admitting_);
  stream.feed = findFeed(resolved);
  if (stream.feed) {
    admit(resolved, stream.frame_cost = sensors, stream.feed.get());
    if (connect(resolved, stream)) return streams_.add(stream);
  }
  admit(resolved, stream.frame_cost = frame, nullptr);
  stream.feed = own ? own : makeFeed(resolved, std::move(path), scene);
  connect(resolved, stream);
  share(resolved, stream.feed);  // only now: it cannot have ended before its own stream joined
  streams_.add(stream);
}

bool StreamOpener::isMeasured(const ResolvedStream& resolved) const {
  return isPaced(resolved.request) && budget_.limits()[Limit::kCpu] > 0;
}

void StreamOpener::admit(const ResolvedStream& resolved, const CpuCost& frame,
                         const FeedRunner* joined) const {
  if (!isMeasured(resolved)) return;
  checkPace(resolved.request.timing(), frame, streams_.load(joined), cpuSupply(pool_), budget_.limits());
}

std::shared_ptr<FeedRunner> StreamOpener::findFeed(const ResolvedStream& resolved) {
  if (!mayShare(resolved.request)) return nullptr;
  std::lock_guard lock(mutex_);
  std::erase_if(shared_, [](const auto& entry) { return entry.second.expired(); });
  const auto found = shared_.find(resolved.feedKey());
  return found == shared_.end() ? nullptr : found->second.lock();
}

std::shared_ptr<FeedRunner> StreamOpener::makeFeed(const ResolvedStream& resolved, Trajectory path,
                                                   std::shared_ptr<const RenderScene> scene) {
  auto pool = std::make_shared<TilePool>(pool_);
  auto feed = std::make_unique<Feed>(std::move(scene), std::move(path), resolved.feed, *pool);
  const v1::Timing& timing = resolved.request.timing();
  const FeedPace pace{resolved.frames, timing.frame_rate_hz(), timing.speed()};
  return std::make_shared<FeedRunner>(std::move(feed), resolved.feed.width, resolved.feed.height, pace,
                                      std::move(pool), totals_);
}

void StreamOpener::share(const ResolvedStream& resolved, const std::shared_ptr<FeedRunner>& feed) {
  if (!mayShare(resolved.request)) return;
  std::lock_guard lock(mutex_);
  shared_[resolved.feedKey()] = feed;
}

bool StreamOpener::connect(const ResolvedStream& resolved, Stream& stream) {
  const v1::Delivery delivery = resolved.request.delivery();
  WakeFd& transport = delivery == v1::DELIVERY_BROADCAST ? transports_.broadcast : transports_.data;
  stream.session = std::make_shared<Session>(
      randomHex(kIdBytes), delivery, static_cast<std::uint32_t>(resolved.sensors.size()), transport,
      stream.feed->signal(), totals_.traffic, budget_.limits().bytes(Limit::kQueue));
  stream.outlet = std::make_shared<Outlet>(stream.session, resolved, epoch_);
  return stream.feed->add(stream.outlet);
}

}  // namespace saccade
