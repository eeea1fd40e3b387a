// saccade events: makes events of the frames of somebody else's video.
#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "client/commands/commands.h"
#include "client/commands/record_stream.h"
#include "client/frames/frame_source.h"
#include "client/frames/natural_order.h"
#include "client/options/help_formatter.h"
#include "client/options/option_range.h"
#include "client/options/recording_options.h"
#include "client/options/request_text.h"
#include "client/options/sensor_options.h"
#include "client/terminal/console.h"

namespace saccade::client {
namespace {

struct EventsOptions {
  std::vector<std::string> frames;
  std::string size, transfer;
  double rate_hz = 0;
  SensorOptions sensors;
  std::uint64_t seed = 0;
  RecordingOptions recording;
  ServerOptions server;
};

std::optional<Transfer> transferOf(const std::string& name) {
  if (name.empty()) return std::nullopt;
  return name == "srgb" ? Transfer::kSrgb : Transfer::kLinear;
}

// A shell sorts names as text.
void warnOfFallingNumbers(const std::vector<std::string>& frames) {
  const auto falls = std::adjacent_find(frames.begin(), frames.end(), numberFalls);
  if (falls == frames.end()) return;
  print(stderr,
        "saccade: warning: '%s' comes before '%s', and frames are taken as they are given; a folder's are in "
        "the order of their numbers\n",
        falls->c_str(), std::next(falls)->c_str());
}

std::unique_ptr<FrameSource> openFrames(const EventsOptions& options) {
  const std::optional<Transfer> transfer = transferOf(options.transfer);
  warnOfFallingNumbers(options.frames);
  const ImageSize size = options.size.empty() ? ImageSize{} : parseSize("--size", options.size);
  try {
    if (options.size.empty()) return openPictures(options.frames, transfer);
    return openRawFrames(options.frames, size.width, size.height, transfer.value_or(Transfer::kLinear));
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(std::string("FRAMES: ") + fault.what());
  }
}

v1::OpenStream makeRequest(const EventsOptions& options, const FrameSource& frames) {
  v1::OpenStream request;
  request.set_pushed(true);
  request.mutable_view()->set_width(static_cast<std::uint32_t>(frames.width()));
  request.mutable_view()->set_height(static_cast<std::uint32_t>(frames.height()));
  request.mutable_timing()->set_frame_rate_hz(options.rate_hz);
  if (const auto count = frames.frames())
    request.mutable_timing()->set_duration_s(static_cast<double>(*count - 1) / options.rate_hz);
  request.set_seed(options.seed);
  addSensors(options.sensors, request);
  return request;
}

void runEvents(const EventsOptions& options) {
  const auto frames = openFrames(options);
  RecordJob job = makeJob(options.recording, makeRequest(options, *frames));
  job.frames = frames.get();
  recordStream(options.server, job);
}

void addFrameOptions(CLI::App& command, EventsOptions& o) {
  command.option_defaults()->group("Frames");
  command
      .add_option("frames", o.frames,
                  "pictures of equal size, such as EXR and PNG, in the order given, or folders of them, in "
                  "the order of "
                  "the numbers in their names; with --size raw files, or - for the standard input")
      ->type_name("FRAMES")
      ->required();
  command.add_option("--rate", o.rate_hz, "frames per second")->required();
  command.add_option("--size", o.size,
                     "WIDTHxHEIGHT: the frames are float32, little-endian, row by row, one after the other");
  command
      .add_option(
          "--transfer", o.transfer,
          "how numbers stand for light: linear or srgb. Unset: srgb for whole numbers, linear for others")
      ->check(CLI::IsMember({"linear", "srgb"}));
  command.add_option("--seed", o.seed, "seed of all random numbers")->capture_default_str();
}

}  // namespace

void addEventsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("events", "make events of the frames of a video");
  const auto options = std::make_shared<EventsOptions>();
  addRecordingOptions(*command, options->recording);
  addFrameOptions(*command, *options);
  addSensorOptions(*command, options->sensors);
  command->option_defaults()->group("Server");
  addServerOptions(*command, options->server);
  limitSensors(*command);
  limitTo(*command, "--rate", ranges::kFrameRate);
  showInHelp(*command, {"--output", "--force", "--preview", "--rate", "--size", "--transfer", "--threshold",
                        "--threshold-off", "--bias", "--preset", "--seed", "--control"});
  command->footer(
      "The brightness of a pixel changes linearly between two frames. No frames are interpolated: an edge "
      "should move by at most\na pixel per frame. White of a PNG is the luminance 1; --bias is in that "
      "unit. Alpha lies\nover black.\n\n"
      "Examples: saccade events frames/ --rate 240 -o events.h5\n"
      "          ffmpeg -i a.mp4 -f rawvideo -pix_fmt grayf32le - |\n"
      "            saccade events - --size 640x480 --rate 240 --transfer srgb -o events.h5");
  command->callback([options] { runEvents(*options); });
}

}  // namespace saccade::client
