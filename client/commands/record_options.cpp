#include "client/commands/record_options.h"

#include "client/commands/commands.h"
#include "client/writers/writer.h"
#include "wire/codec_table.h"

namespace saccade::client {
namespace {

std::vector<std::string> codecNames() {
  std::vector<std::string> names;
  for (const CodecInfo* codec : codecTable()) names.emplace_back(codec->name);
  return names;
}

std::string checkPng(const std::string& path) {
  return path.ends_with(".png") ? "" : "'" + path + "' is no .png file";
}

}  // namespace

void addRecordOptions(CLI::App& command, RecordOptions& o) {
  addServerOptions(command, o.server);
  command.add_option("scene", o.scene, "name of a scene, see `saccade list`")->required();
  CLI::Option* trajectory = command.add_option(
      "--trajectory", o.trajectory,
      "a trajectory of the scene, or a TUM or ESIM file (*.csv, or any file that is there)");
  CLI::Option* motion =
      command
          .add_option(
              "--motion", o.motion,
              "KIND:SPEED from the scene's own camera, or KIND:SPEEDpx in pixels per frame, see below")
          ->excludes(trajectory);
  command.add_option("--turn", o.turn_s, "seconds after which the motion turns back, 0: never")
      ->needs(motion);
  command.add_option("--motion-seed", o.motion_seed, "of shake")->needs(motion);
  command.add_option("-o,--output", o.output, "file to write, by its extension: " + writerNames())
      ->required();
  command
      .add_option("--threshold", o.thresholds,
                  "contrast threshold C, in natural log units; give it again for another sensor")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option("--threshold-off", o.thresholds_off, "C of OFF events: one for all sensors, or one each")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--bias", o.bias, "I_eps, in scene luminance");
  command.add_option("--refractory", o.refractory_s, "seconds a pixel is blind after an event");
  command.add_option("--model", o.model, "event model")
      ->check(CLI::IsMember({"accumulating", "probabilistic"}));
  command
      .add_option(
          "--reconstruction", o.reconstruction,
          "which change of brightness the sensors believe: direct the difference alone, the others draw it "
          "towards the picture; default: kalman")
      ->check(CLI::IsMember({"direct", "complementary", "kalman"}));
  command.add_option("--cutoff", o.cutoff_hz, "Hz below which complementary believes the primal picture");
  command.add_option("--size", o.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  command.add_option("--fov", o.fov_x_deg, "horizontal field of view, degrees");
  command.add_option("--rate", o.rate_hz, "frames per second of stream time")->capture_default_str();
  command.add_option("--duration", o.duration_s, "seconds of stream time; 0: until Ctrl-C")
      ->capture_default_str();
  command
      .add_option("--delivery", o.delivery,
                  "when this client is slow: wait for it, drop the oldest, drop any")
      ->check(CLI::IsMember({"lossless", "live", "broadcast"}))
      ->capture_default_str();
  command.add_option("--clock", o.clock, "as fast as can be, or in step with the wall clock")
      ->check(CLI::IsMember({"fast", "paced"}))
      ->capture_default_str();
  command.add_option("--codec", o.codec, "how events are compressed on the way; default: none")
      ->check(CLI::IsMember(codecNames()));
  command
      .add_option("--retry-time", o.retry_time_s,
                  "seconds to try again where the connection or the server is lost; 0: never")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_option("--method", o.method, "see `saccade info`");
  CLI::Option* spp = command.add_option("--spp", o.spp, "paths per pixel and frame");
  CLI::Option* bounces = command.add_option("--bounces", o.bounces, "indirect bounces");
  CLI::Option* disable =
      command
          .add_option("--disable", o.disabled_features,
                      "part of the scene's model to do without, see `saccade info`; may be given again")
          ->allow_extra_args(false)
          ->delimiter(',');
  command.add_flag("--jitter", o.jitter, "paths start all over the pixel: fine texture and edges alias less");
  CLI::Option* set =
      command.add_option("--set", o.params, "NAME=NUMBER, a parameter of the method; may be given again")
          ->allow_extra_args(false);
  CLI::Option* max_event_change =
      command
          .add_option("--max-event-change", o.max_event_change,
                      "let the server do without what changes at most so many of the events, such as 2%")
          ->excludes(bounces)
          ->excludes(disable);
  CLI::Option* budget =
      command
          .add_option("--budget-ms", o.budget_ms,
                      "let the server choose the most accurate setting within these CPU ms per frame")
          ->excludes(spp)
          ->excludes(set)
          ->excludes(max_event_change);
  command
      .add_option("--max-false-rate", o.max_false_rate,
                  "let it choose the fastest with at most so many false events per pixel-frame")
      ->excludes(spp)
      ->excludes(set)
      ->excludes(max_event_change)
      ->excludes(budget);
  command.add_option("--seed", o.seed, "of all random numbers")->capture_default_str();
  command
      .add_option("--preview", o.preview,
                  "PNG of brightness, its change and the latest events, a third of the way through")
      ->check(CLI::Validator(checkPng, "FILE.png"));
  sayRanges(command);
  command.footer(
      "Motions: dolly:0.2 (forward), truck (right), pedestal (up), in scene units per second;\n"
      "pan:-15 (right), tilt (up), roll (clockwise), orbit (right), shake (hand-held), in degrees\n"
      "per second. A negative speed goes the other way.\n\n"
      "What has no default here is left to the server. A lossless recording outlives its server: it goes on\n"
      "where it was with one that comes within the time to retry. Exit codes: 0 recorded, 1 the stream or "
      "the\n"
      "server failed, 2 wrong usage. Until it is complete, the file is called FILE.partial.\n\n"
      "saccade record cornell-bunny --trajectory right --size 240x180 -o events.csv --preview events.png");
}

}  // namespace saccade::client
