#include "client/recording/tum_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <utility>

#include "client/formats/common/units.h"
#include "saccade/stream_fault.h"

namespace saccade::client {
namespace {

constexpr std::size_t kPosePlanes = 7;
const std::string kCameraPoses = "pose", kObjectPoses = "object_poses";

std::string nameOf(const std::string& path, std::uint32_t view) {
  return path + (view == 0 ? "" : ".cam" + std::to_string(view)) + ".tum.txt";
}

// Rows of doubles, with a pose from number `begin` on.
bool hasPoses(const v1::PacketHeader& header, std::size_t begin) {
  return header.element() == v1::ELEMENT_F64 && header.planes() == begin + kPosePlanes;
}

std::string secondsText(std::int64_t t_ns) {
  const std::string micros = std::to_string(t_ns % kNsPerSecond / kNsPerUs);
  return std::to_string(t_ns / kNsPerSecond) + "." + std::string(6 - micros.size(), '0') + micros;
}

// A row of doubles has its pose from number `begin` on.
std::string lineOf(const TruthSample& row, std::size_t begin) {
  std::string line = secondsText(row.t_ns);
  std::array<double, kPosePlanes> pose;
  std::memcpy(pose.data(), row.elements.data() + begin * sizeof(double), sizeof pose);
  for (const double number : pose) {
    std::array<char, 32> digits;
    line += " ";
    line.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  }
  return line + "\n";
}

bool asks(const v1::OpenStream& request, const std::string& channel) {
  return std::ranges::any_of(request.truth(), [&](const v1::Truth& t) { return t.name() == channel; });
}

// Files of the objects that may move, in the order of their rows.
std::vector<std::string> objectNames(const std::string& path, const v1::OpenStream& request) {
  std::vector<std::string> names;
  for (const v1::ObjectMotion& object : request.objects()) {
    if (object.path().has_still() && !request.timing().steerable()) continue;
    std::string part = object.name();
    std::ranges::replace_if(
        part, [](unsigned char c) { return c < ' ' || c == '/'; }, '_');
    const auto name = [&] { return path + ".object-" + part + ".tum.txt"; };
    while (std::ranges::count(names, name()) > 0) part += '_';
    names.push_back(name());
  }
  return names;
}

}  // namespace

std::vector<std::string> tumNames(const std::string& path, const v1::OpenStream& request) {
  std::vector<std::string> names;
  for (const v1::Truth& truth : request.truth())
    if (truth.name() == kCameraPoses) names.push_back(nameOf(path, truth.view()));
  if (asks(request, kObjectPoses)) std::ranges::copy(objectNames(path, request), std::back_inserter(names));
  return names;
}

TumFiles::TumFiles(const std::string& path, const v1::OpenStream& resolved) {
  bool has_objects = false;
  for (int i = 0; i < resolved.truth_size(); ++i) {
    const v1::Truth& truth = resolved.truth(i);
    Channel channel{static_cast<std::uint32_t>(resolved.sensors_size() + i)};
    if (truth.name() == kCameraPoses) channel.files.push_back(start(nameOf(path, truth.view())));
    if (truth.name() == kObjectPoses && !std::exchange(has_objects, true)) {
      channel.begin = 1;
      for (const std::string& name : objectNames(path, resolved)) channel.files.push_back(start(name));
    }
    if (!channel.files.empty()) channels_.push_back(std::move(channel));
  }
}

TumFiles::File TumFiles::start(const std::string& name) {
  return {name, std::make_unique<OutputFile>(name + ".partial")};
}

// The rows of the first frame have the order of the files, and tell the numbers of the objects.
TumFiles::File& TumFiles::fileOf(Channel& channel, const TruthSample& row) {
  if (channel.begin == 0) return channel.files.front();
  double number;
  std::memcpy(&number, row.elements.data(), sizeof number);
  const auto known = std::ranges::find(channel.objects, number);
  const auto place = static_cast<std::size_t>(known - channel.objects.begin());
  if (place == channel.files.size()) throw StreamFault("there are poses of more objects than move");
  if (known == channel.objects.end()) channel.objects.push_back(number);
  return channel.files[place];
}

void TumFiles::add(const DecodedPacket& batch) {
  for (Channel& channel : channels_) {
    if (channel.number != batch.header.sensor() || !hasPoses(batch.header, channel.begin)) continue;
    for (const TruthSample& row : batch.truth)
      fileOf(channel, row).output->append(lineOf(row, channel.begin));
  }
}

void TumFiles::close() {
  for (const Channel& channel : channels_) {
    for (const File& file : channel.files) {
      file.output->close();
      std::filesystem::rename(file.name + ".partial", file.name);
    }
  }
}

}  // namespace saccade::client
