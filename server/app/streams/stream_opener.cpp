#include "app/streams/stream_opener.h"

#include <algorithm>

#include "app/admission/limits.h"
#include "app/admission/stream_cost.h"
#include "app/request/refusal.h"
#include "app/request/request_bounds.h"
#include "app/request/request_memory.h"
#include "app/streams/stream_opened.h"
#include "base/lower_priority.h"
#include "base/text_cut.h"

namespace saccade {
namespace {

constexpr const char* kStopping = "the server is stopping";
constexpr std::size_t kMaxLogged = 500;  // bytes of a request
constexpr std::chrono::milliseconds kEndOfClosed{200};
constexpr int kIdBytes = 8;  // random: who is not told of a stream cannot subscribe to its topics

bool isPaced(const v1::OpenStream& request) {
  return request.timing().clock() == v1::CLOCK_PACED;
}

// Who paces itself by the clock never waits for its client: such streams cannot hold each other up.
bool mayShare(const v1::OpenStream& request) {
  return isPaced(request) && request.delivery() != v1::DELIVERY_LOSSLESS;
}

// Of who joins a feed that runs: its own sensors.
CpuCost costOfJoining(const CpuCost& frame) {
  return {0, frame.sensors, 0, frame.longest};
}

}  // namespace

StreamOpener::StreamOpener(SceneCache& scenes, const MeasuredTables& tables, TilePool& pool,
                           ResourceQuota& quota, StreamRegistry& streams, Transports transports,
                           Totals& totals, ClientLog& log, std::uint64_t epoch)
    : scenes_(scenes),
      tables_(tables),
      pool_(pool),
      quota_(quota),
      streams_(streams),
      transports_(transports),
      totals_(totals),
      log_(log),
      epoch_(epoch) {}

void StreamOpener::open(RawRequest request, const Peer& peer, std::function<void(v1::Reply)> answer) {
  std::lock_guard lock(mutex_);
  if (stopped_) throw Refusal(v1::CODE_UNAVAILABLE, {}, kStopping);
  std::erase_if(opening_,
                [](auto& one) { return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
  auto opening = openings_.add(peer, request.id);
  opening_.push_back(std::async(std::launch::async, [this, request = std::move(request), answer,
                                                     opening = std::move(opening)]() mutable {
    lowerPriority();
    v1::Reply reply;
    *reply.mutable_status() = openNow(std::move(request), *opening, *reply.mutable_open_stream());
    if (reply.status().code() != v1::CODE_OK) reply.clear_open_stream();
    opening.reset();
    answer(std::move(reply));
  }));
}

void StreamOpener::stop() {
  std::lock_guard lock(mutex_);
  stopped_ = true;  // and so nobody else uses `opening_` any more
  openings_.cancelAll();
}

bool StreamOpener::wait(ChangeNotifier::Clock::time_point deadline) {
  return std::all_of(opening_.begin(), opening_.end(),
                     [&](auto& one) { return one.wait_until(deadline) == std::future_status::ready; });
}

v1::Status StreamOpener::openNow(RawRequest raw, Opening& opening, v1::StreamOpened& opened) {
  try {
    v1::Request request = parseRequest(raw.bytes);
    raw.bytes = {};
    opened = openStream(std::move(*request.mutable_open_stream()), opening);
    return okStatus();
  } catch (const Cancelled&) {
    return stopped_ ? makeStatus(v1::CODE_UNAVAILABLE, kStopping)
                    : makeStatus(v1::CODE_CANCELLED, "the request was cancelled");
  } catch (...) {
    return statusOfException();
  }
}

v1::StreamOpened StreamOpener::openStream(v1::OpenStream request, Opening& opening) {
  openings_.setScene(opening, request.scene());
  openings_.begin(opening, "checking the request");
  ResolvedStream resolved = resolve(std::move(request), scenes_.library().list(), tables_);
  checkAlone(resolved.request, quota_.limits());
  boundEvents(resolved, quota_.limits());
  Stream stream;
  stream.reserved = reserve(opening.peer.user, resolved);
  openings_.begin(opening, "loading the scene");
  const auto whole = scenes_.get(resolved.request.scene());
  fitTo(whole->description(), resolved);
  const auto scene = scenes_.get(resolved.request.scene(), resolved.disabled_features);
  stream.user = opening.peer.user;
  stream.request = withoutLongPath(resolved.request);
  openFeed(resolved, *whole, scene, opening, stream);
  log_.info(stream.user, "stream " + stream.session->id() +
                             " opened: " + cutText(stream.request.ShortDebugString(), kMaxLogged));
  const int channels = resolved.feed.monochrome ? 1 : scene->channels();
  return describeOpened(std::move(resolved), stream, epoch_, channels);
}

// Streams that are over have no places any more, and closed ones are about to end.
std::shared_ptr<void> StreamOpener::reserve(const std::string& user, const ResolvedStream& resolved) {
  std::vector<Share> shares = sharesOf(resolved, quota_.limits());
  shares.push_back({Limit::kMemory, pathMemory(resolved.request.trajectory()), "trajectory"});
  streams_.sweep(ChangeNotifier::Clock::now());
  try {
    return quota_.take(user, shares);
  } catch (const LimitReached&) {
    streams_.awaitClosed(ChangeNotifier::Clock::now() + kEndOfClosed);
    streams_.sweep(ChangeNotifier::Clock::now());
    return quota_.take(user, shares);
  }
}

// What takes time is done before anybody has to wait for this one: a measurement, the first frame of a feed.
void StreamOpener::openFeed(const ResolvedStream& resolved, const RenderScene& whole,
                            const std::shared_ptr<const RenderScene>& scene, Opening& opening,
                            Stream& stream) {
  const Trajectory path = resolveTrajectory(resolved, whole, scenes_.library());
  openings_.begin(opening, "measuring the first frames");
  const CpuCost frame = isMeasured(resolved) ? measure(resolved, path, scene, opening) : CpuCost{};
  const auto running = findFeed(resolved);
  admit(resolved, running ? costOfJoining(frame) : frame, running.get());
  openings_.begin(opening, "rendering frame 0");
  auto own = running ? nullptr : makeFeed(resolved, path, scene, opening);
  openings_.begin(opening, "joining the feed");
  while (!enter(resolved, frame, own, stream)) own = makeFeed(resolved, path, scene, opening);
}

bool StreamOpener::enter(const ResolvedStream& resolved, const CpuCost& frame,
                         const std::shared_ptr<FeedRunner>& own, Stream& stream) {
  std::lock_guard admitting(admitting_);
  stream.feed = findFeed(resolved);
  bool joined = false;
  if (stream.feed) {
    admit(resolved, stream.frame_cost = costOfJoining(frame), stream.feed.get());
    joined = connect(resolved, stream);
  }
  if (!joined && !own) return false;  // it has ended meanwhile
  if (!joined) {
    admit(resolved, stream.frame_cost = frame, nullptr);
    stream.feed = own;
    connect(resolved, stream);
  }
  try {
    share(resolved, stream.feed);  // only now: it cannot have ended before its own stream joined
    streams_.add(stream);
  } catch (...) {
    stream.session->stop(v1::END_REASON_CLOSED);  // else its feed would wait for ever
    throw;
  }
  return true;
}

CpuCost StreamOpener::measure(const ResolvedStream& resolved, const Trajectory& path,
                              std::shared_ptr<const RenderScene> scene, const Opening& opening) const {
  TilePool pool = pool_;
  pool.setStop(opening.stop.get_token());
  return measureFrame(std::move(scene), path, resolved, pool);
}

bool StreamOpener::isMeasured(const ResolvedStream& resolved) const {
  return isPaced(resolved.request) && quota_.limits()[Limit::kCpu] > 0;
}

void StreamOpener::admit(const ResolvedStream& resolved, const CpuCost& frame,
                         const FeedRunner* joined) const {
  if (!isMeasured(resolved)) return;
  checkPace(resolved.request.timing(), frame, streams_.load(joined), cpuSupply(pool_), quota_.limits());
}

std::shared_ptr<FeedRunner> StreamOpener::findFeed(const ResolvedStream& resolved) {
  if (!mayShare(resolved.request)) return nullptr;
  std::lock_guard lock(mutex_);
  std::erase_if(shared_, [](const auto& entry) { return entry.second.expired(); });
  const auto found = shared_.find(resolved.feedKey());
  return found == shared_.end() ? nullptr : found->second.lock();
}

std::shared_ptr<FeedRunner> StreamOpener::makeFeed(const ResolvedStream& resolved, Trajectory path,
                                                   std::shared_ptr<const RenderScene> scene,
                                                   const Opening& opening) const {
  auto pool = std::make_shared<TilePool>(pool_);
  pool->setStop(opening.stop.get_token());
  auto feed = std::make_unique<Feed>(std::move(scene), std::move(path), resolved.feed, *pool);
  pool->setStop({});  // from here on the stream ends by being closed
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
      stream.feed->notifier(), totals_.traffic, quota_.limits().bytes(Limit::kQueue), epoch_);
  stream.sink = std::make_shared<StreamSink>(stream.session, resolved, epoch_);
  return stream.feed->add(stream.sink);
}

}  // namespace saccade
