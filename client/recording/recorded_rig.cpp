#include "client/recording/recorded_rig.h"

#include <google/protobuf/util/message_differencer.h>

#include <filesystem>

#include "client/recording/recording_file.h"
#include "client/recording/sidecar.h"

namespace saccade::client {
namespace {

// `text` with the ending `next` in place of `end`; empty where it ends otherwise.
std::string withEnd(const std::string& text, const std::string& end, const std::string& next) {
  return text.ends_with(end) ? text.substr(0, text.size() - end.size()) + next : "";
}

// The names of the description of sensor `other` beside `file`, which describes sensor `own`.
std::vector<std::string> namesOf(const std::string& file, std::uint32_t own, std::uint32_t other) {
  const std::string extension = std::filesystem::path(withEnd(file, ".json", "")).extension();
  const auto joint = [](std::uint32_t sensor) { return sidecarOf(nameOfSensor("", sensor)); };
  const auto numbered = [&](std::uint32_t sensor) {
    return sidecarOf("-" + std::to_string(sensor) + extension);
  };
  return {withEnd(file, joint(own), joint(other)), withEnd(file, numbered(own), numbered(other))};
}

}  // namespace

std::vector<v1::Recording> readRig(const std::string& file) {
  using google::protobuf::util::MessageDifferencer;
  std::vector<v1::Recording> rig{readSidecar(file)};
  const v1::OpenStream request = rig.front().request();
  for (int sensor = 0; sensor < request.sensors_size(); ++sensor) {
    const auto other = static_cast<std::uint32_t>(sensor), own = rig.front().sensor();
    if (other == own) continue;
    for (const std::string& name : namesOf(file, own, other)) {
      if (name.empty() || !std::filesystem::exists(name)) continue;
      const v1::Recording found = readSidecar(name);
      const bool same = found.sensor() == other && found.end_ns() == rig.front().end_ns() &&
                        MessageDifferencer::Equals(found.request(), request);
      if (same) rig.push_back(found);
    }
  }
  return rig;
}

}  // namespace saccade::client
