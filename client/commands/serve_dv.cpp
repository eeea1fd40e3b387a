// saccade serve-dv: shows the sensors of a stream to DV and dv-processing as cameras of the network.
#include <cstdio>
#include <memory>
#include <optional>
#include <set>

#include "client/commands/commands.h"
#include "client/commands/dv_relay.h"
#include "client/commands/stream_opening.h"
#include "client/formats/common/units.h"
#include "client/options/help_formatter.h"
#include "client/options/option_range.h"
#include "client/options/request_options.h"
#include "client/terminal/console.h"
#include "client/terminal/interrupt.h"
#include "client/terminal/progress.h"

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPatience{2000};  // for viewers to read the last events

struct ServeDvOptions {
  RequestOptions request;
  std::string listen = "127.0.0.1:7777";
  double backlog_mib = 64;
  std::optional<std::int64_t> epoch_us;
};

void tell(const std::string& line) {
  print(stderr, "saccade: %s\n", line.c_str());
}

dv::DvServer makeServer(const ServeDvOptions& options, int sensors) {
  try {
    const auto backlog = static_cast<std::size_t>(options.backlog_mib * (1 << 20));
    return dv::DvServer(dv::parseAddress(options.listen), sensors, backlog, tell);
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(std::string("--listen: ") + fault.what());
  }
}

// Viewers are served while a lost server is awaited, too.
Subscription::RetryPolicy retryPolicy(dv::DvServer& server, double retry_s) {
  const auto waiting = [&server] {
    server.serve(milliseconds(0));
    throwIfInterrupted();
  };
  const auto lost = [retry_s](const std::string& loss) {
    tell(loss + "; trying again for " + timeText(retry_s));
  };
  return {.retry_time = millisecondsOf(retry_s), .waiting = waiting, .lost = lost};
}

void runServeDv(const ServeDvOptions& options) {
  const v1::OpenStream request = makeOpenStream(options.request);
  dv::DvServer server = makeServer(options, request.sensors_size());
  watchInterrupt();
  zmq::context_t context;
  ControlClient control = connectTo(context, options.request.server);
  StreamHandle stream =
      openStream(control, {request, options.request.trajectory, options.request.retry_time_s});
  tellOpening(stdout, request, stream.opened());
  const v1::View& view = stream.opened().resolved().view();
  server.listen({view.width(), view.height()});
  for (int sensor = 0; const std::string& name : server.names())
    print("sensor %d: %s\n", sensor++, name.c_str());
  std::fflush(stdout);

  Subscription subscription(context, stream, retryPolicy(server, options.request.retry_time_s));
  try {
    DvRelay(server, options.epoch_us).run(subscription, request.sensors_size());
  } catch (const StreamFault&) {
    server.finish(kPatience);
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
      ->capture_default_str();
  limitTo(*command, "--backlog", Range<double>{1, 65536});
  command->add_option(
      "--epoch", options->epoch_us,
      "Unix time in microseconds of stream time 0; by default the first events have the present time");
  addRequestOptions(*command, options->request);
  std::set<std::string> common = commonRequestOptions();
  common.insert("--listen");
  showInHelp(*command, common);
  command->footer(
      std::string(kMotionHelp) +
      "\n\nIn DV, add a module for network input, and give it the address and port that are printed.\n"
      "Exit codes: 0 the stream has ended, or Ctrl-C; 1 the stream or the server failed; 2 wrong usage.\n\n"
      "Example: saccade serve-dv cornell-box --motion orbit --size 128x96 --rate 100");
  command->callback([options] { runServeDv(*options); });
}

}  // namespace saccade::client
