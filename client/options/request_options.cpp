#include "client/options/request_options.h"

#include <limits>

#include "client/options/request_text.h"
#include "client/poses/pose_file.h"

namespace saccade::client {
namespace {

// CLI11 reads -1 as the largest number.
template <class T>
std::string checkWhole(const std::string& text) {
  if (parseNumber<T>(text)) return "";
  return "'" + text + "' is not a whole number from 0 to " + std::to_string(std::numeric_limits<T>::max());
}

void addPathOptions(CLI::App& command, RequestOptions& o) {
  command.option_defaults()->group("Camera path");
  command.add_option(
      "--trajectory,--motion", o.trajectory,
      "a name that `saccade list` prints; or a file of poses whose heading names its columns, as EuRoC's "
      "does, or else in TUM format (seconds, blanks) or ESIM format (nanoseconds, commas); or KIND:SPEED "
      "per second, or KIND:SPEEDpx in pixels per frame. "
      "KIND is one of " +
          enumWords<v1::MotionKind>());
  command
      .add_option("--trajectory-format", o.pose_format,
                  "kitti or colmap: the file of poses is KITTI's poses/NN.txt or COLMAP's images.txt")
      ->check(CLI::IsMember(poseReaders()));
  command.add_option(
      "--pose-rate", o.pose_rate_hz,
      "poses per second, for --trajectory-format; of COLMAP, by the numbers in the pictures' names");
  command.add_option("--turn", o.turn_s, "seconds after which KIND:SPEED turns back, 0: never; default 0.2");
  command.add_option(
      "--start", o.start,
      "X,Y,Z[,QX,QY,QZ,QW]: T_world_camera at the start of KIND:SPEED; without it, or without a "
      "rotation, that of the scene's own camera");
  command
      .add_option("--motion-seed", o.motion_seed,
                  "seed of the motions shake:SPEED, random:SPEED and roam:SPEED")
      ->check(checkWhole<std::uint64_t>);
  command.add_option(
      "--clearance", o.clearance,
      "least distance of roam:SPEED to all surfaces, in scene units; by default a twentieth of "
      "the median distance around the start, or less where that leaves no room");
  command
      .add_option("--object", o.objects,
                  "NAME=PATH moves the shapes and lamps of this name: KIND:SPEED per second, with KIND "
                  "one of " +
                      enumWords<v1::ObjectMotionKind>() +
                      ", or a .csv or .txt file of poses as for --trajectory; may be given again")
      ->allow_extra_args(false);
  command.add_option(
      "--animation", o.animation,
      "the animation of a glTF scene that plays alone, by its name in saccade list; by default "
      "that of motion.toml, else all that do not move the same");
}

// Of a command whose options have one, else that of openTiming().
std::string durationDefault(const RequestOptions& o) {
  if (o.duration_s) return " " + CLI::detail::to_string(*o.duration_s);
  return " to the end of a file of poses, and 0.5 with other trajectories";
}

void addStreamOptions(CLI::App& command, RequestOptions& o) {
  command.option_defaults()->group("Stream");
  CLI::Option* rate = command.add_option(
      "--rate", o.rate_hz, "whole frames, so many per second; by default intervals follow the motion");
  command
      .add_option("--interval-px", o.interval_px,
                  "the picture is rendered when it has moved by about so many pixels; default 1")
      ->excludes(rate);
  command
      .add_option("--min-rate", o.min_rate_hz,
                  "least intervals per second; truth and poses come at this rate; default 100")
      ->excludes(rate);
  command.add_option("--max-rate", o.max_rate_hz, "most intervals per second; default 1000")->excludes(rate);
  command
      .add_option("--finest-px", o.finest_px,
                  "pixels that change in between are rendered down to so many pixels of motion; default a "
                  "sixteenth of --interval-px, if the method can; as --interval-px: whole frames alone")
      ->excludes(rate);
  command.add_option("--duration", o.duration_s,
                     "seconds of the stream; 0: until Ctrl-C; by default" + durationDefault(o));
  command
      .add_option("--delivery", o.delivery,
                  "what happens when this client is slow: " + enumWords<v1::Delivery>() +
                      "; with lossless the server waits, live drops the oldest packets, broadcast drops any")
      ->capture_default_str();
  command.add_option("--clock", o.clock, "fast renders as fast as possible, paced keeps to the wall clock")
      ->capture_default_str();
  command.add_option("--codec", o.codec,
                     "compression of the packets: " + enumWords<v1::Codec>() + "; default none");
  command
      .add_option("--retry-time", o.retry_time_s,
                  "seconds to wait for a server that is not up yet, or lost; 0: not at all")
      ->capture_default_str();
  command.add_option("--seed", o.seed, "seed of all random numbers")
      ->check(checkWhole<std::uint64_t>)
      ->capture_default_str();
}

void addQualityOptions(CLI::App& command, RequestOptions& o) {
  command.option_defaults()->group("Rendering");
  command.add_option(
      "--method", o.method,
      "how the change is estimated, see `saccade info`; default irradiance_cache, or event_svgf where a "
      "lamp changes or an object moves");
  CLI::Option* spp = command.add_option("--spp", o.spp, "paths per pixel and frame; default 2");
  CLI::Option* bounces = command.add_option("--bounces", o.bounces, "indirect bounces; default 3");
  CLI::Option* disable =
      command
          .add_option(
              "--disable", o.disabled_features,
              "feature of the scene to leave out, see `saccade info`; may be given again, or several with "
              "commas")
          ->allow_extra_args(false)
          ->delimiter(',');
  command.add_flag("--jitter", o.jitter,
                   "start paths anywhere in the pixel, not at its centre: less aliasing, more time");
  command.add_option("--bake-error", o.bake_error,
                     "let the server compute the light ahead, to this relative error; for "
                     "irradiance_cache");
  CLI::Option* set =
      command
          .add_option("--set", o.params,
                      "NAME=NUMBER, a parameter of the method; may be given again, or several with commas")
          ->allow_extra_args(false)
          ->delimiter(',');
  CLI::Option* max_event_change =
      command
          .add_option(
              "--max-event-change", o.max_event_change,
              "let the server simplify the scene, changing at most this share of the events, such as 2%")
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
      .add_option(
          "--max-false-rate", o.max_false_rate,
          "let the server choose the fastest setting with at most this many false events per pixel and frame")
      ->excludes(spp)
      ->excludes(set)
      ->excludes(max_event_change)
      ->excludes(budget);
}

}  // namespace

void addRequestOptions(CLI::App& command, RequestOptions& o) {
  command.add_option("scene", o.scene, "name of a scene, see `saccade list`")->required();
  addPathOptions(command, o);
  addCameraOptions(command, o.camera);
  addRigOptions(command, o.rig);
  addSensorOptions(command, o.sensors);
  addStreamOptions(command, o);
  addQualityOptions(command, o);
  command.option_defaults()->group("Server");
  addServerOptions(command, o.server);
  limitRequest(command);
}

}  // namespace saccade::client
