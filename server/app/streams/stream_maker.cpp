#include "app/streams/stream_maker.h"

#include "app/admission/stream_cost.h"
#include "app/feeds/pace.h"
#include "app/request/refusal.h"
#include "app/request/request_memory.h"
#include "app/request/resolve_trajectory.h"
#include "app/streams/stream_opened.h"
#include "base/text_cut.h"
#include "render/world/render_scene.h"
#include "stream/bounded_peers.h"
#include "truth/id_names.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxLogged = 500;  // bytes of a request
constexpr std::chrono::milliseconds kEndOfClosed{200};
constexpr int kIdBytes = 8;  // random, so that nobody can guess the topics of another client's stream

// A stream that joins a feed costs only its own sensors.
CpuCost costOfJoining(const CpuCost& frame) {
  return {0, frame.sensors, 0, frame.longest};
}

// A frame that leaves half of the free threads to streams that join later.
CpuCost withRoom(const CpuCost& frame) {
  return {2 * frame.feed, 2 * frame.sensors, frame.critical_path, frame.longest};
}

// The speed, and its halves down to the least that the request allows.
std::vector<double> speedsOf(const v1::Timing& timing) {
  std::vector<double> speeds{timing.speed()};
  while (timing.min_speed() > 0 && speeds.back() / 2 >= timing.min_speed())
    speeds.push_back(speeds.back() / 2);
  return speeds;
}

// The feed, which holds its share of a limit as long as one of its streams runs.
std::shared_ptr<FeedRunner> holding(std::shared_ptr<FeedRunner> feed, std::shared_ptr<void> share) {
  FeedRunner* const runner = feed.get();
  return {runner, [feed = std::move(feed), share = std::move(share)](FeedRunner*) {}};
}

void checkDelivery(const v1::OpenStream& request) {
  if (request.delivery() == v1::DELIVERY_BROADCAST && !peersAreBounded())
    refuse("delivery", "this saccaded has the system's libzmq, with which it serves no BROADCAST stream");
}

// An event has 20 bits for the number of its object.
void checkObjectIds(const v1::OpenStream& request, const Scene& scene) {
  const std::size_t shapes = scene.meshes.size() + scene.spheres.size();
  if (shapes <= kMaxObject) return;
  for (int i = 0; i < request.sensors_size(); ++i)
    if (request.sensors(i).object_ids())
      refuse("sensors[" + std::to_string(i) + "].object_ids", "the scene has " + std::to_string(shapes) +
                                                                  " shapes, and events tell of at most " +
                                                                  std::to_string(kMaxObject));
}

}  // namespace

v1::StreamOpened StreamMaker::make(v1::OpenStream request, PendingOpen& opening) {
  pending_opens_.setScene(opening, request.scene());
  pending_opens_.begin(opening, "checking the request");
  Stream stream;
  stream.user = opening.peer.user;
  stream.reserved.push_back(reserve(stream.user, {{Limit::kMemory, requestMemory(request), "sensors"}}));
  checkDelivery(request);
  Plan plan{planStream(std::move(request), resources_.scenes.library(), resources_.tables,
                       resources_.quota.limits())};
  ResolvedStream& resolved = plan.resolved;
  stream.reserved.push_back(reserve(stream.user, sharesOf(resolved, resources_.quota.limits())));
  if (!resolved.request.pushed()) loadScenes(plan, resources_.scenes, begin(opening, "loading the scene"));
  if (resolved.request.pushed()) {
    keepRequest(resolved.request, stream);
    stream.reserved.push_back(reserve(stream.user, feedShare(resolved)));
    enter(plan, feeds_.ofClient(resolved), stream);
  } else {
    checkObjectIds(resolved.request, plan.scene->description());
    openFeed(plan, opening, stream);
  }
  resources_.log.info(
      stream.user, "stream " + stream.session->id() + " opened: " + shortText(*stream.request, kMaxLogged));
  const int channels = resolved.request.pushed() || resolved.feed.monochrome ? 1 : plan.scene->channels();
  v1::StreamOpened opened = describeOpened(std::move(resolved), stream, resources_.epoch, channels);
  if (plan.bake) opened.set_bake_digest(plan.bake->digest);
  if (asksForIds(opened.resolved())) *opened.mutable_id_names() = idNames(plan.scene->description());
  return opened;
}

std::vector<Share> StreamMaker::feedShare(const ResolvedStream& stream) const {
  return {{Limit::kMemory, feedMemory(stream, resources_.quota.limits()), "view"}};
}

// Streams that are over give their share back first, and so do closed ones that are about to end.
std::shared_ptr<void> StreamMaker::reserve(const std::string& user, const std::vector<Share>& shares) {
  StreamRegistry& streams = resources_.streams;
  streams.sweep(ChangeNotifier::Clock::now());
  try {
    return resources_.quota.take(user, shares);
  } catch (const LimitReached&) {
    streams.awaitClosed(ChangeNotifier::Clock::now() + kEndOfClosed);
    streams.sweep(ChangeNotifier::Clock::now());
    return resources_.quota.take(user, shares);
  }
}

// The next step of an opening, which may be slow.
BuildContext StreamMaker::begin(PendingOpen& opening, const char* doing) {
  pending_opens_.begin(opening, doing);
  return {opening.stop.get_token(),
          [this, &opening](double share) { pending_opens_.setDone(opening, share); }};
}

// The slow steps, a measurement and the first frame of a feed, come before the lock that others wait for.
void StreamMaker::openFeed(Plan& plan, PendingOpen& opening, Stream& stream) {
  const ResolvedStream& resolved = plan.resolved;
  const Trajectory body =
      resolveTrajectory(resolved, *plan.whole, resources_.scenes.library(), opening.stop.get_token());
  bakeLight(plan, body, resources_.bakes, resources_.pool, begin(opening, "computing light ahead"));
  pending_opens_.begin(opening, "waiting for an equal stream to open");
  const auto turn = shared_.takeTurn(resolved, opening.stop.get_token());
  const auto memory = reserve(stream.user, feedShare(resolved));
  pending_opens_.begin(opening, "measuring the first frames");
  if (keepsPace(resolved)) plan.frame = measure(plan, body, opening);
  chooseSpeed(plan);
  keepRequest(plan.resolved.request, stream);
  const auto running = shared_.find(resolved);
  admit(resolved, running ? costOfJoining(plan.frame) : plan.frame, running.get());
  pending_opens_.begin(opening, "rendering frame 0");
  const auto make = [&] {
    OwnFeed own = feeds_.ofScene(plan.scene, body, resolved, poolFor(opening));
    own.runner = holding(std::move(own.runner), memory);
    return own;
  };
  OwnFeed own = running ? OwnFeed{} : make();
  pending_opens_.begin(opening, "joining the feed");
  while (!enter(plan, own, stream)) own = make();
}

// Enters the stream into the registry, with a feed that runs or else with `own`. Returns false where there is
// neither.
bool StreamMaker::enter(const Plan& plan, const OwnFeed& own, Stream& stream) {
  const ResolvedStream& resolved = plan.resolved;
  std::lock_guard admitting(admitting_);
  stream.feed = shared_.find(resolved);
  bool joined = false;
  if (stream.feed) {
    admit(resolved, stream.frame_cost = costOfJoining(plan.frame), stream.feed.get());
    joined = connect(resolved, stream);
  }
  if (!joined && !own.runner) return false;  // the feed has ended meanwhile
  if (!joined) {
    admit(resolved, stream.frame_cost = plan.frame, nullptr);
    stream.feed = own.runner, stream.steering = own.steering, stream.pushed = own.pushed;
    connect(resolved, stream);
  }
  try {
    shared_.add(resolved, stream.feed);  // only now: its own stream keeps it from ending
    resources_.streams.add(stream);
  } catch (...) {
    stream.session->stop(v1::END_REASON_CLOSED);  // otherwise the feed would wait for it for ever
    throw;
  }
  return true;
}

// For what is done while the stream is opened: an opening can be cancelled.
PoolHandle StreamMaker::poolFor(const PendingOpen& opening) const {
  return {resources_.pool, Priority::kNormal, opening.stop.get_token()};
}

CpuCost StreamMaker::measure(const Plan& plan, const Trajectory& body, const PendingOpen& opening) {
  const std::string key = plan.resolved.costKey();
  if (const auto lately = costs_.find(key, MeasuredCosts::Clock::now())) return *lately;
  const CpuCost cost = measureFrame(plan.scene, body, plan.resolved, poolFor(opening));
  costs_.add(key, cost, MeasuredCosts::Clock::now());
  return cost;
}

// Takes one of the speeds that the request allows. It is that of a feed that runs, else the first that leaves
// room for others to join, else the least. Throws LimitReached where not even that fits.
void StreamMaker::chooseSpeed(Plan& plan) {
  v1::Timing& timing = *plan.resolved.request.mutable_timing();
  const std::vector<double> speeds = speedsOf(timing);
  timing.clear_min_speed();
  for (const double speed : speeds) {
    timing.set_speed(speed);
    if (shared_.find(plan.resolved)) return;
  }
  for (const double speed : speeds) {
    const bool least = speed == speeds.back();
    timing.set_speed(speed);
    try {
      return admit(plan.resolved, least ? plan.frame : withRoom(plan.frame), nullptr);
    } catch (const LimitReached&) {
      if (least) throw;
    }
  }
}

bool StreamMaker::keepsPace(const ResolvedStream& resolved) const {
  return isPaced(resolved.request) && resources_.quota.limits()[Limit::kCpu] > 0;
}

// Throws LimitReached where the threads do not suffice for the pace.
void StreamMaker::admit(const ResolvedStream& resolved, const CpuCost& frame,
                        const FeedRunner* joined) const {
  if (!keepsPace(resolved)) return;
  checkPace(resolved.request.timing(), frame, resources_.streams.load(joined), cpuSupply(resources_.pool),
            resources_.quota.limits());
}

// Makes the stream's session and sink. Returns false where the feed has ended.
bool StreamMaker::connect(const ResolvedStream& resolved, Stream& stream) const {
  const v1::Delivery delivery = resolved.request.delivery();
  WakeFd& transport = delivery == v1::DELIVERY_BROADCAST ? resources_.broadcast : resources_.data;
  stream.session = std::make_shared<Session>(
      randomHex(kIdBytes), delivery,
      static_cast<std::uint32_t>(resolved.sensors.size() + resolved.truth.size()), transport,
      stream.feed->notifier(), resources_.totals.traffic, resources_.quota.limits().bytes(Limit::kQueue),
      resources_.epoch, resources_.clients ? resources_.clients->countsOf(stream.user) : nullptr);
  stream.sink = std::make_shared<StreamSink>(stream.session, resolved, resources_.epoch, stream.user);
  return stream.feed->add(stream.sink);
}

}  // namespace saccade
