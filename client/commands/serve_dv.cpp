// saccade serve-dv: shows the sensors of a stream to DV and dv-processing as cameras of the network.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "client/commands/commands.h"
#include "client/commands/interrupt.h"
#include "client/commands/progress.h"
#include "client/commands/request_options.h"
#include "client/commands/stream_opening.h"
#include "client/commands/summary.h"
#include "client/dv/dv_server.h"
#include "client/subscription.h"

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kTurn{5};         // how long a viewer waits for its turn while no events come
constexpr milliseconds kPatience{2000};  // for viewers to read the last events
constexpr std::int64_t kNsPerUs = 1000;

struct ServeDvOptions {
  RequestOptions request;
  std::string listen = "127.0.0.1:7777";
  double backlog_mib = 64;
  std::optional<std::int64_t> epoch_us;
};

void tell(const std::string& line) {
  std::fprintf(stderr, "saccade: %s\n", line.c_str());
}

dv::DvServer makeServer(const ServeDvOptions& options, int sensors) {
  try {
    const auto backlog = static_cast<std::size_t>(options.backlog_mib * (1 << 20));
    return dv::DvServer(dv::parseAddress(options.listen), sensors, backlog, tell);
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(std::string("--listen: ") + fault.what());
  }
}

std::int64_t unixTimeUs() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

// Hands the events of a stream to the viewers.
class Relay {
 public:
  // `epoch_us`: Unix time of stream time 0; by default the present time is that of the first events.
  Relay(dv::DvServer& server, std::optional<std::int64_t> epoch_us) : server_(server), epoch_us_(epoch_us) {}

  // Until every sensor has ended, or Ctrl-C.
  void run(Subscription& subscription, int sensors);

 private:
  void pass(const Batch& batch);
  void tellLosses(const Losses& losses);

  dv::DvServer& server_;
  std::optional<std::int64_t> epoch_us_;
  std::uint64_t told_ = 0;  // lost packets
};

void Relay::run(Subscription& subscription, int sensors) {
  for (int ended = 0; ended < sensors && !interrupted();) {
    server_.serve(milliseconds(0));
    const auto batch = subscription.receive(kTurn);
    tellLosses(subscription.losses());
    if (!batch || batch->header.kind() == v1::KIND_HEARTBEAT) continue;
    pass(*batch);
    if (batch->header.kind() == v1::KIND_END) ++ended;
  }
}

void Relay::pass(const Batch& batch) {
  if (!epoch_us_) epoch_us_ = unixTimeUs() - batch.header.t0_ns() / kNsPerUs;
  server_.send(batch.header.sensor(), batch.events, *epoch_us_);
}

void Relay::tellLosses(const Losses& losses) {
  if (losses.packets == told_) return;
  told_ = losses.packets;
  printLosses(stderr, losses);
}

void runServeDv(const ServeDvOptions& options) {
  const v1::OpenStream request = makeOpenStream(options.request);
  dv::DvServer server = makeServer(options, request.sensors_size());
  watchInterrupt();
  zmq::context_t context;
  ControlClient control = connectTo(context, options.request.server);
  StreamHandle stream = openStream(control, request, options.request.trajectory);
  tellOpening(stdout, request, stream.opened());
  const v1::View& view = stream.opened().resolved().view();
  server.listen({view.width(), view.height()});
  for (int sensor = 0; const std::string& name : server.names())
    std::printf("sensor %d: %s\n", sensor++, name.c_str());
  std::fflush(stdout);

  const double retry_s = options.request.retry_time_s;
  Subscription subscription(
      context, stream,
      {.retry_time = milliseconds(std::llround(retry_s * 1e3)),
       .waiting =
           [&server] {
             server.serve(milliseconds(0));
             if (interrupted()) throw StreamFault("interrupted");
           },
       .lost =
           [retry_s](const std::string& loss) { tell(loss + "; trying again for " + timeText(retry_s)); }});
  try {
    Relay(server, options.epoch_us).run(subscription, request.sensors_size());
  } catch (const StreamFault&) {
    if (!interrupted()) throw;
  }
  server.finish(kPatience);
}

}  // namespace

void addServeDvCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("serve-dv", "open a stream and show its sensors to DV as cameras of the network");
  const auto options = std::make_shared<ServeDvOptions>();
  options->request.duration_s = 0;
  options->request.clock = "paced";
  options->request.delivery = "live";
  command
      ->add_option("--listen", options->listen,
                   "ADDRESS:PORT of the first sensor; the next ports are those of further sensors, and 0 "
                   "takes any free ports")
      ->capture_default_str();
  command
      ->add_option("--backlog", options->backlog_mib,
                   "MiB that a slow viewer may leave unread before it is cut")
      ->check(CLI::Range(1.0, 65536.0))
      ->capture_default_str();
  command->add_option(
      "--epoch", options->epoch_us,
      "Unix time in microseconds of stream time 0; by default the first events have the present time");
  addRequestOptions(*command, options->request);
  command->footer(
      std::string(kMotionHelp) +
      "\n\nIn DV, add a module for network input, and give it the address and port that are printed.\n"
      "Exit codes: 0 the stream has ended, or Ctrl-C; 1 the stream or the server failed; 2 wrong usage.\n\n"
      "Example: saccade serve-dv cornell-box --motion orbit --size 128x96 --rate 100");
  command->callback([options] { runServeDv(*options); });
}

}  // namespace saccade::client
