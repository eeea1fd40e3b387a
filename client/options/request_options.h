// The command line of the commands that open a stream, and the request that it makes.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/options/camera_options.h"
#include "client/options/rig_options.h"
#include "client/options/sensor_options.h"
#include "client/options/server_options.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

inline constexpr double kDuration = 0.5;  // seconds

// Options that are not given are left to the server's defaults.
struct RequestOptions {
  ServerOptions server;
  std::string scene;
  std::string trajectory;   // a name, a file, or KIND:SPEED; empty: the server tells what there is
  std::string pose_format;  // a key of poseReaders(), or empty: the server reads the file
  std::optional<double> pose_rate_hz;
  std::optional<double> turn_s;
  std::optional<std::uint64_t> motion_seed;
  std::optional<double> clearance;
  std::vector<std::string> objects;  // NAME=KIND:SPEED, or NAME=FILE
  std::string animation;             // empty: the server's choice
  RigOptions rig;
  std::optional<std::string> start;  // "X,Y,Z" or "X,Y,Z,QX,QY,QZ,QW": T_world_camera
  SensorOptions sensors;
  CameraOptions camera;
  std::optional<double> rate_hz;                                           // unset: intervals follow motion
  std::optional<double> interval_px, finest_px, min_rate_hz, max_rate_hz;  // of these intervals
  std::optional<double> duration_s;  // unset: to the end of a file of poses, or kDuration
  std::string delivery = "lossless", clock = "fast";
  std::string codec;
  double retry_time_s = 60;
  std::string method;
  std::optional<std::uint32_t> spp, bounces;
  bool jitter = false;
  std::optional<double> bake_error, budget_ms, max_false_rate;
  std::string max_event_change;                // "2%"
  std::vector<std::string> disabled_features;  // see `saccade info`
  std::vector<std::string> params;             // name=value
  std::uint64_t seed = 0;
};

// The values in `options` are the defaults.
void addRequestOptions(CLI::App& command, RequestOptions& options);

// Says in the help of a command what --motion may be.
inline constexpr const char* kMotionHelp =
    "Motions: dolly (forward), truck (right), pedestal (up) in scene units per second; pan (right),\n"
    "tilt (up), roll (clockwise), orbit (right), shake (hand-held), random (a smooth path about the\n"
    "start), roam (a smooth path through the free space of the scene) in degrees per second. A negative\n"
    "speed goes the other way, except of shake, random and roam.";

// Each number of the request must lie in its range, which its help says.
void limitRequest(CLI::App& command);

// Whether --trajectory names a file: *.csv, or any file that exists.
bool isTrajectoryFile(const std::string& trajectory);
bool namesPoses(const RequestOptions& options);  // likewise, or it has a --trajectory-format

// Reads the files that `objects` name. Throws std::invalid_argument.
void addObjects(const std::vector<std::string>& objects, v1::OpenStream& open);

// makeTrajectory() reads the trajectory's file. Both throw std::invalid_argument with the option at fault.
v1::Trajectory makeTrajectory(const RequestOptions& options);
v1::OpenStream makeOpenStream(const RequestOptions& options);

}  // namespace saccade::client
