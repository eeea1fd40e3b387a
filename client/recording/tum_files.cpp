#include "client/recording/tum_files.h"

#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::size_t kPosePlanes = 7;

std::string nameOf(const std::string& path, std::uint32_t view) {
  return path + (view == 0 ? "" : ".cam" + std::to_string(view)) + ".tum.txt";
}

std::string secondsText(std::int64_t t_ns) {
  const std::string micros = std::to_string(t_ns % kNsPerSecond / kNsPerUs);
  return std::to_string(t_ns / kNsPerSecond) + "." + std::string(6 - micros.size(), '0') + micros;
}

std::string lineOf(const TruthSample& sample) {
  std::string line = secondsText(sample.t_ns);
  std::array<double, kPosePlanes> pose;
  std::memcpy(pose.data(), sample.elements.data(), sizeof pose);
  for (const double number : pose) {
    std::array<char, 32> digits;
    line += " ";
    line.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  }
  return line + "\n";
}

bool isPose(const v1::PacketHeader& header) {
  return header.element() == v1::ELEMENT_F64 && header.planes() == kPosePlanes;
}

}  // namespace

std::vector<std::string> tumNames(const std::string& path, const v1::OpenStream& request) {
  std::vector<std::string> names;
  for (const v1::Truth& truth : request.truth())
    if (truth.name() == "pose") names.push_back(nameOf(path, truth.view()));
  return names;
}

TumFiles::TumFiles(const std::string& path, const v1::OpenStream& resolved) {
  for (int i = 0; i < resolved.truth_size(); ++i) {
    const v1::Truth& truth = resolved.truth(i);
    if (truth.name() != "pose") continue;
    const std::string name = nameOf(path, truth.view());
    channels_.push_back({static_cast<std::uint32_t>(resolved.sensors_size() + i), name,
                         std::make_unique<OutputFile>(name + ".partial")});
  }
}

void TumFiles::add(const DecodedPacket& batch) {
  for (const Channel& channel : channels_) {
    if (channel.number != batch.header.sensor() || !isPose(batch.header)) continue;
    for (const TruthSample& sample : batch.truth) channel.file->append(lineOf(sample));
  }
}

void TumFiles::close() {
  for (const Channel& channel : channels_) {
    channel.file->close();
    std::filesystem::rename(channel.name + ".partial", channel.name);
  }
}

}  // namespace saccade::client
