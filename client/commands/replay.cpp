// saccade replay: renders the stream of a recording again.
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "client/commands/commands.h"
#include "client/commands/console.h"
#include "client/commands/recording_options.h"
#include "client/recording/sidecar.h"

namespace saccade::client {
namespace {

struct ReplayOptions {
  ServerOptions server;
  std::string recording;
  OutputOptions output;
};

// The request for the one sensor of the recording, to be rendered as fast as possible and without loss.
v1::OpenStream requestOf(const std::string& file, const v1::Recording& recording) {
  const auto fail = [&](const std::string& what) { throw std::invalid_argument("'" + file + "' " + what); };
  if (!recording.has_request()) fail("does not say what request made the events");
  if (recording.sensor() >= static_cast<std::uint32_t>(recording.request().sensors_size()))
    fail("names a sensor that its request does not have");
  if (recording.request().pushed())
    fail("is of frames that a client sent, which it does not hold: use `saccade events` again");
  if (recording.begin_ns() != recording.time_offset_ns())
    fail("is of a client that joined a running stream, which cannot be repeated");
  v1::OpenStream request = recording.request();
  const v1::Sensor sensor = request.sensors(static_cast<int>(recording.sensor()));
  request.clear_sensors();
  *request.add_sensors() = sensor;
  request.mutable_sensors(0)->clear_from_event();
  for (v1::Truth& truth : *request.mutable_truth()) truth.clear_from_sample();
  request.mutable_timing()->set_duration_s((recording.end_ns() - recording.time_offset_ns()) / 1e9);
  request.mutable_timing()->set_clock(v1::CLOCK_FAST);
  request.set_delivery(v1::DELIVERY_LOSSLESS);
  return request;
}

// "; it was made with avx512, this server has avx2", or nothing.
std::string difference(const std::string& what, const std::string& then, const std::string& now) {
  return then == now ? "" : "; " + what + " was '" + then + "' and is '" + now + "'";
}

void compare(const v1::Recording& then, const v1::Recording& now) {
  if (then.lost_events() > 0) {
    print("the recording had lost %llu events; they are not compared\n",
          static_cast<unsigned long long>(then.lost_events()));
    return;
  }
  if (then.digest() == now.digest()) {
    print("the events are those of the recording\n");
    return;
  }
  throw std::runtime_error(
      "the events are not those of the recording" +
      difference("the server's version", then.server_version(), now.server_version()) +
      difference("the instruction set", then.instruction_set(), now.instruction_set()) +
      difference("the bake", std::to_string(then.bake_digest()), std::to_string(now.bake_digest())));
}

void runReplay(const ReplayOptions& options) {
  const v1::Recording recording = readSidecar(options.recording);
  RecordJob job = makeJob({.output = options.output}, requestOf(options.recording, recording));
  job.time_offset_ns = recording.time_offset_ns();
  compare(recording, recordStream(options.server, job));
}

}  // namespace

void addReplayCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "render the stream of a recording again");
  const auto options = std::make_shared<ReplayOptions>();
  command->add_option("recording", options->recording, "FILE.json, which stands beside each recording")
      ->required();
  addOutputOptions(*command, options->output, "-o,--output");
  command->option_defaults()->group("Server");
  addServerOptions(*command, options->server);
  command->callback([options] { runReplay(*options); });
}

}  // namespace saccade::client
