#include "client/options/imu_options.h"

#include <map>
#include <stdexcept>

#include "client/calibration/calibration_reader.h"
#include "client/options/request_text.h"

namespace saccade::client {
namespace {

constexpr double kStandardGravity = 9.81;  // m/s^2, as the server's default

using Setter = void (v1::Imu::*)(double);
const std::map<std::string, Setter>& setters() {
  static const std::map<std::string, Setter> table{{"rate_hz", &v1::Imu::set_rate_hz},
                                                   {"accelerometer_noise", &v1::Imu::set_accelerometer_noise},
                                                   {"gyroscope_noise", &v1::Imu::set_gyroscope_noise},
                                                   {"accelerometer_walk", &v1::Imu::set_accelerometer_walk},
                                                   {"gyroscope_walk", &v1::Imu::set_gyroscope_walk}};
  return table;
}

std::string settingNames() {
  std::string names;
  for (const auto& [name, setter] : setters()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

void set(const std::string& setting, v1::Imu& imu) {
  const auto [name, number] = splitAt(setting, '=');
  const auto setter = setters().find(name);
  const auto value = parseNumber<double>(number);
  if (setter == setters().end() || !value)
    throw std::invalid_argument("--imu: '" + setting +
                                "' is neither FILE.yaml nor KEY=NUMBER, with KEY one of " + settingNames());
  (imu.*setter->second)(*value);
}

void readSettings(const std::vector<std::string>& settings, v1::Imu& imu) {
  for (const std::string& setting : settings) {
    if (setting.find('=') != std::string::npos || !setting.ends_with(".yaml")) {
      set(setting, imu);
      continue;
    }
    try {
      imu.MergeFrom(readImuCalibration(setting));
    } catch (const std::invalid_argument& fault) {
      throw std::invalid_argument(std::string("--imu: ") + fault.what());
    }
  }
}

void setGravity(const ImuOptions& options, v1::Imu& imu) {
  std::vector<double> g;
  if (!options.gravity.empty()) {
    g = parseNumbers(options.gravity);
    if (g.size() != 3) throw std::invalid_argument("--gravity: '" + options.gravity + "' is not X,Y,Z");
  } else if (!options.up.empty()) {
    g.assign(3, 0);
    g[static_cast<std::size_t>(options.up.back() - 'x')] =
        options.up.front() == '-' ? kStandardGravity : -kStandardGravity;
  } else {
    return;
  }
  v1::Vector3& gravity = *imu.mutable_gravity();
  gravity.set_x(g[0]), gravity.set_y(g[1]), gravity.set_z(g[2]);
}

}  // namespace

void addImuOptions(CLI::App& command, ImuOptions& o) {
  command.option_defaults()->group("IMU");
  command
      .add_option(
          "--imu", o.settings,
          "an imu.yaml of Kalibr, or KEY=NUMBER; may be given again, or several with commas. KEY is one "
          "of " +
              settingNames() + ", in the units of Kalibr")
      ->allow_extra_args(false)
      ->delimiter(',');
  CLI::Option* up = command.add_option("--up", o.up, "axis of the world that gravity points away from")
                        ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
  command.add_option("--gravity", o.gravity, "X,Y,Z in m/s^2, in world axes")->excludes(up);
}

void setImu(const ImuOptions& options, std::optional<double> metres_per_unit, v1::OpenStream& open) {
  v1::Imu imu;
  readSettings(options.settings, imu);
  setGravity(options, imu);
  bool found = false;
  for (v1::Truth& truth : *open.mutable_truth()) {
    if (truth.name() != "imu") continue;
    found = true;
    *truth.mutable_imu() = imu;
    if (metres_per_unit) truth.mutable_imu()->set_metres_per_unit(*metres_per_unit);
  }
  if (!found && (!options.settings.empty() || !options.gravity.empty() || !options.up.empty()))
    throw std::invalid_argument("--imu, --gravity and --up go with --truth imu");
}

}  // namespace saccade::client
