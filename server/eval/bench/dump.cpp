#include "eval/bench/dump.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "eval/pictures/exr.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

namespace fs = std::filesystem;

std::string fileOf(const std::string& folder, const char* what, int frame) {
  return (fs::path(folder) / format("%s_%05d.exr", what, frame)).string();
}

// The number of "dI_00001.exr", or none.
std::optional<int> frameOf(const std::string& name) {
  int frame = 0;
  if (!name.starts_with("dI_")) return std::nullopt;
  std::from_chars(name.data() + 3, name.data() + name.size(), frame);
  return name == format("dI_%05d.exr", frame) ? std::optional(frame) : std::nullopt;
}

ImageF take(ExrPicture& picture, const std::string& channel, const std::string& file) {
  const auto plane = picture.planes.find(channel);
  if (plane == picture.planes.end()) throw std::runtime_error(file + " has no channel " + channel);
  return std::move(plane->second);
}

ImageF readLuminance(const std::string& file) {
  ExrPicture picture = readExr(file);
  return take(picture, "Y", file);
}

IntensityChange changeOf(ImageF dI, ImageF I_prev) {
  IntensityChange change(dI.width(), dI.height());
  change.dI = std::move(dI), change.I_prev = std::move(I_prev);
  return change;
}

void writePlanes(const std::string& folder, int frame, const IntensityChange& change) {
  writeExr(fileOf(folder, "dI", frame), {{"Y", &change.dI}});
  writeExr(fileOf(folder, "Iprev", frame), {{"Y", &change.I_prev}});
  writeExr(fileOf(folder, "variance", frame), {{"I", &change.var_I_prev}, {"dI", &change.var_dI}});
}

}  // namespace

void writeChange(const std::string& folder, int frame, const IntensityChange& change) {
  fs::remove(fileOf(folder, "halves", frame));
  writePlanes(folder, frame, change);
}

void writeFeatures(const std::string& folder, int frame, const GBuffer& g) {
  writeExr(fileOf(folder, "features", frame), {{"albedo", &g.albedo},
                                               {"emission", &g.emission},
                                               {"normal.x", &g.nx},
                                               {"normal.y", &g.ny},
                                               {"normal.z", &g.nz},
                                               {"Z", &g.z}});
}

void writeReference(const std::string& folder, int frame, const ReferenceChange& truth) {
  writePlanes(folder, frame, truth.change);
  writeExr(fileOf(folder, "halves", frame), {{"dI_a", &truth.half_a},
                                             {"dI_b", &truth.half_b},
                                             {"Iprev_a", &truth.prev_a},
                                             {"Iprev_b", &truth.prev_b}});
}

std::vector<int> commonFrames(const std::string& folder, const std::string& other) {
  std::vector<int> frames;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::optional<int> frame = frameOf(entry.path().filename().string());
    if (frame && fs::exists(fileOf(other, "dI", *frame))) frames.push_back(*frame);
  }
  std::sort(frames.begin(), frames.end());
  if (frames.empty()) throw std::runtime_error("no dI_*.exr is in both " + folder + " and " + other);
  return frames;
}

IntensityChange readChange(const std::string& folder, int frame) {
  const std::string dI_file = fileOf(folder, "dI", frame), prev_file = fileOf(folder, "Iprev", frame);
  ImageF dI = readLuminance(dI_file), I_prev = readLuminance(prev_file);
  if (dI.width() != I_prev.width() || dI.height() != I_prev.height())
    throw std::runtime_error(dI_file + " and " + prev_file + " differ in size");
  return changeOf(std::move(dI), std::move(I_prev));
}

std::optional<ChangeHalves> readHalves(const std::string& folder, int frame) {
  const std::string file = fileOf(folder, "halves", frame);
  if (!fs::exists(file)) return std::nullopt;
  ExrPicture picture = readExr(file);
  const auto half = [&](const std::string& name) {
    return changeOf(take(picture, "dI_" + name, file), take(picture, "Iprev_" + name, file));
  };
  return ChangeHalves{half("a"), half("b")};
}

}  // namespace saccade::eval
