#include "eval/pictures/exr.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "pictures/library.h"

namespace saccade::eval {
namespace {

// Writes beside the target, then renames: no reader sees half a file, nor a mix of two processes.
void writePicture(const std::string& path, const pictures::Shape& shape, const float* data) {
  const std::filesystem::path target(path);
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path());
  const std::string partial =
      target.parent_path() / (".partial-" + std::to_string(getpid()) + "-" + target.filename().string());
  pictures::library().write(partial, shape, data);
  std::filesystem::rename(partial, target);
}

}  // namespace

void writeExr(const std::string& path, const std::vector<ExrChannel>& channels,
              const std::map<std::string, int>& attributes) {
  const int width = channels.at(0).plane->width(), height = channels.at(0).plane->height();
  pictures::Shape shape{.width = width, .height = height, .notes = attributes};
  for (const auto& channel : channels) shape.channels.push_back(channel.name);
  std::vector<float> pixels;
  pixels.reserve(static_cast<std::size_t>(width) * height * channels.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const auto& channel : channels) pixels.push_back(channel.plane->at(x, y));
    }
  }
  writePicture(path, shape, pixels.data());
}

ExrPicture readExr(const std::string& path) {
  const auto file = pictures::library().open(path);
  const pictures::Shape& shape = file->shape();
  const std::size_t channels = shape.channels.size();
  std::vector<float> pixels(shape.pixels() * channels);
  file->read(0, static_cast<int>(channels), pixels.data(), channels * sizeof(float));
  ExrPicture picture{.planes = {}, .attributes = shape.notes};
  for (std::size_t c = 0; c < channels; ++c) {
    ImageF plane(shape.width, shape.height);
    for (int y = 0; y < shape.height; ++y) {
      for (int x = 0; x < shape.width; ++x) {
        plane.at(x, y) = pixels[(static_cast<std::size_t>(y) * shape.width + x) * channels + c];
      }
    }
    picture.planes.emplace(shape.channels[c], std::move(plane));
  }
  return picture;
}

RgbPlanes readRgb(const std::string& path) {
  ExrPicture picture = readExr(path);
  RgbPlanes planes;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto plane = picture.planes.find(std::string(1, "RGB"[c]));
    if (plane == picture.planes.end()) throw std::runtime_error(path + " has no channels R, G and B");
    planes[c] = std::move(plane->second);
  }
  return planes;
}

std::string encodePng(int width, int height, const std::vector<Rgb8>& pixels) {
  return pictures::library().encodePng({width, height, {"R", "G", "B"}, pictures::Number::kU8},
                                       pixels.data());
}

}  // namespace saccade::eval
