// COLMAP's images.txt. A picture has two lines: `ID QW QX QY QZ TX TY TZ CAMERA NAME` with the pose that
// takes the world to the camera, and then its points `X Y POINT3D`, none or more.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "client/formats/text/text_numbers.h"
#include "client/poses/pose_formats.h"
#include "client/poses/pose_lines.h"

namespace saccade::client {
namespace {

constexpr double kMaxSeconds = 9e9;  // of a path, see PROTOCOL.md

struct Picture {
  std::uint64_t number;
  std::string name;
  Vector3 position;
  Quaternion rotation;
};

// The last number in a name without its extension.
std::optional<std::uint64_t> numberIn(std::string_view name) {
  name = name.substr(0, name.rfind('.'));
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t last = name.find_last_of(kDigits);
  if (last == name.npos) return std::nullopt;
  const std::size_t before = name.find_last_not_of(kDigits, last);
  std::string_view digits = name.substr(before + 1, last - before);
  return takeNumber<std::uint64_t>(digits, kEnd);
}

// Inverts a pose from world to camera: T_world_camera.
void invert(Picture& picture) {
  const Matrix3 to_camera = matrixOf(picture.rotation);
  const Vector3 t = picture.position;
  for (std::size_t i = 0; i < 3; ++i)
    picture.position[i] = -(to_camera[0][i] * t[0] + to_camera[1][i] * t[1] + to_camera[2][i] * t[2]);
  for (std::size_t i = 0; i < 3; ++i) picture.rotation[i] = -picture.rotation[i];
}

Quaternion unit(const PoseLines& lines, Quaternion q) {
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(std::abs(length - 1) < 0.01)) lines.fail("a quaternion whose length is not 1");
  for (double& part : q) part /= length;
  return q;
}

Picture readPicture(const PoseLines& lines, const std::vector<std::string_view>& words) {
  if (words.size() < 10) lines.fail("not a picture: ID QW QX QY QZ TX TY TZ CAMERA NAME");
  const auto value = [&](std::size_t i) { return lines.number(words[i]); };
  const std::string name(words.back());
  const auto number = numberIn(name);
  if (!number) lines.fail("the name '" + name.substr(0, 40) + "' has no number that tells its time");
  Picture picture{
      *number, name, {value(5), value(6), value(7)}, unit(lines, {value(2), value(3), value(4), value(1)})};
  invert(picture);
  return picture;
}

// A picture whose line of points was left out would hide the next one.
void checkPoints(const PoseLines& lines, const std::vector<std::string_view>& words) {
  if (words.size() % 3 != 0)
    lines.fail(
        "not the points of a picture: X Y POINT3D_ID ...; COLMAP has such a line, or an empty one, after "
        "each picture");
  if (!words.empty()) lines.number(words.back());
}

std::vector<Picture> readPictures(const std::string& path) {
  PoseLines lines(path);
  std::vector<Picture> pictures;
  for (std::vector<std::string_view> words; lines.next(words);) {
    if (words.empty() || words[0].starts_with('#')) continue;
    pictures.push_back(readPicture(lines, words));
    if (lines.next(words)) checkPoints(lines, words);
  }
  return pictures;
}

}  // namespace

std::string readColmap(const std::string& path, double rate_hz) {
  std::vector<Picture> pictures = readPictures(path);
  std::sort(pictures.begin(), pictures.end(),
            [](const Picture& a, const Picture& b) { return a.number < b.number; });
  const auto same =
      std::adjacent_find(pictures.begin(), pictures.end(),
                         [](const Picture& a, const Picture& b) { return a.number == b.number; });
  if (same != pictures.end())
    throw std::invalid_argument(path + ": '" + same->name + "' and '" + std::next(same)->name +
                                "' have one number, and so one time");
  std::string csv;
  for (const Picture& picture : pictures) {
    const auto frame = static_cast<double>(picture.number - pictures.front().number);
    if (frame / rate_hz > kMaxSeconds)
      throw std::invalid_argument(path +
                                  ": the numbers in the names span more than 9e9 s; is --pose-rate right?");
    csv += poseText(frame, rate_hz, picture.position, picture.rotation);
  }
  return csv;
}

}  // namespace saccade::client
