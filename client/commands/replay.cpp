// saccade replay: renders the stream of a recording again.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/commands/commands.h"
#include "client/commands/record_stream.h"
#include "client/options/recording_options.h"
#include "client/recording/recorded_rig.h"
#include "client/terminal/console.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

struct ReplayOptions {
  ServerOptions server;
  std::string recording;
  OutputOptions output;
};

v1::OpenStream requestOfSensor(const v1::Recording& recording) {
  v1::OpenStream request = recording.request();
  const int sensor = static_cast<int>(recording.sensor());
  request.clear_sensors();
  request.clear_truth();
  *request.add_sensors() = recording.request().sensors(sensor);
  for (const int channel : truthOfSensor(recording.request(), sensor))
    *request.add_truth() = recording.request().truth(channel);
  return request;
}

// The request of the recording, to be rendered as fast as possible and without loss. Unless `all`, of its
// sensor and truth alone.
v1::OpenStream requestOf(const std::string& file, const v1::Recording& recording, bool all) {
  const auto fail = [&](const std::string& what) { throw std::invalid_argument("'" + file + "' " + what); };
  if (!recording.has_request()) fail("does not say what request made the events");
  if (recording.sensor() >= static_cast<std::uint32_t>(recording.request().sensors_size()))
    fail("names a sensor that its request does not have");
  if (recording.request().pushed())
    fail("is of frames that a client sent, which it does not hold: use `saccade events` again");
  if (recording.begin_ns() != recording.time_offset_ns())
    fail("is of a client that joined a running stream, which cannot be repeated");
  v1::OpenStream request = all ? recording.request() : requestOfSensor(recording);
  for (v1::Sensor& sensor : *request.mutable_sensors()) sensor.clear_from_event();
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

// Throws unless the events are the same. `whose`: " of sensor 1" where the recording has several.
void compare(const v1::Recording& then, const v1::Recording& now, const std::string& whose) {
  if (then.lost_events() > 0)
    print("the recording had lost %llu events; they are not compared\n",
          static_cast<unsigned long long>(then.lost_events()));
  if (then.lost_events() > 0 || then.digest() == now.digest()) return;
  throw std::runtime_error(
      "the events" + whose + " are not those of the recording" +
      difference("the server's version", then.server_version(), now.server_version()) +
      difference("the instruction set", then.instruction_set(), now.instruction_set()) +
      difference("the bake", std::to_string(then.bake_digest()), std::to_string(now.bake_digest())));
}

// `now`: by sensor, or of the first of `rig` alone.
void compareAll(const std::vector<v1::Recording>& rig, const std::vector<v1::Recording>& now) {
  if (now.size() == 1) {
    compare(rig.front(), now.front(), "");
  } else {
    for (const v1::Recording& then : rig)
      compare(then, now.at(then.sensor()), " of sensor " + std::to_string(then.sensor()));
  }
  const auto lost = [](const v1::Recording& then) { return then.lost_events() > 0; };
  if (std::none_of(rig.begin(), rig.end(), lost)) print("the events are those of the recording\n");
  if (now.size() > rig.size())
    print("%zu of %zu sensors are compared: the others have no description beside that\n", rig.size(),
          now.size());
}

void runReplay(const ReplayOptions& options) {
  const bool all = options.output.writer().makeJoint != nullptr;
  const std::vector<v1::Recording> rig = readRig(options.recording);
  RecordJob job = makeJob({.output = options.output}, requestOf(options.recording, rig.front(), all));
  job.time_offset_ns = rig.front().time_offset_ns();
  compareAll(rig, recordStream(options.server, job));
}

}  // namespace

void addReplayCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "render the stream of a recording again");
  const auto options = std::make_shared<ReplayOptions>();
  command->add_option("recording", options->recording, "FILE.json, which stands beside each recording")
      ->required();
  addOutputOptions(*command, options->output, "-o,--output");
  command->footer(
      "A .bag, .h5 or .mcap file gets all sensors of the recording. A file of another format gets the one "
      "that FILE.json describes.");
  command->option_defaults()->group("Server");
  addServerOptions(*command, options->server);
  command->callback([options] { runReplay(*options); });
}

}  // namespace saccade::client
