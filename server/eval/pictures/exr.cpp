#include "eval/pictures/exr.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

namespace saccade::eval {
namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

// Writes beside the target, then renames: no reader sees half a file, nor a mix of two processes.
void writePicture(const std::string& path, const ImageSpec& spec, const float* data) {
  const std::filesystem::path target(path);
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path());
  const std::string partial =
      target.parent_path() / (".partial-" + std::to_string(getpid()) + "-" + target.filename().string());
  auto out = ImageOutput::create(partial);
  if (!out || !out->open(partial, spec) || !out->write_image(TypeDesc::FLOAT, data) || !out->close()) {
    throw std::runtime_error("cannot write " + path + ": " + (out ? out->geterror() : OIIO::geterror()));
  }
  std::filesystem::rename(partial, target);
}

}  // namespace

void writeExr(const std::string& path, const std::vector<ExrChannel>& channels,
              const std::map<std::string, int>& attributes) {
  const int width = channels.at(0).plane->width(), height = channels.at(0).plane->height();
  ImageSpec spec(width, height, static_cast<int>(channels.size()), TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const auto& channel : channels) spec.channelnames.push_back(channel.name);
  for (const auto& [name, value] : attributes) spec.attribute("saccade:" + name, value);
  std::vector<float> pixels;
  pixels.reserve(static_cast<std::size_t>(width) * height * channels.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const auto& channel : channels) pixels.push_back(channel.plane->at(x, y));
    }
  }
  writePicture(path, spec, pixels.data());
}

ExrPicture readExr(const std::string& path) {
  auto in = ImageInput::open(path);
  if (!in) throw std::runtime_error("cannot read " + path + ": " + OIIO::geterror());
  const ImageSpec spec = in->spec();
  std::vector<float> pixels(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
  if (!in->read_image(0, 0, 0, spec.nchannels, TypeDesc::FLOAT, pixels.data())) {
    throw std::runtime_error("cannot read " + path + ": " + in->geterror());
  }
  ExrPicture picture;
  for (int c = 0; c < spec.nchannels; ++c) {
    ImageF plane(spec.width, spec.height);
    for (int y = 0; y < spec.height; ++y) {
      for (int x = 0; x < spec.width; ++x) {
        plane.at(x, y) = pixels[(static_cast<std::size_t>(y) * spec.width + x) * spec.nchannels + c];
      }
    }
    picture.planes.emplace(spec.channelnames[c], std::move(plane));
  }
  for (const auto& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (name.starts_with("saccade:")) picture.attributes[name.substr(8)] = attribute.get_int();
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
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto out = ImageOutput::create("png");
  if (!out || !out->set_ioproxy(&memory) ||
      !out->open("memory.png", ImageSpec(width, height, 3, TypeDesc::UINT8)) ||
      !out->write_image(TypeDesc::UINT8, pixels.data()) || !out->close()) {
    throw std::runtime_error("cannot encode a PNG: " + (out ? out->geterror() : OIIO::geterror()));
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace saccade::eval
