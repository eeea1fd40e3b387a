#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "client/frames/frame_source.h"
#include "client/frames/natural_order.h"
#include "client/frames/picture.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

void addFolder(const std::string& folder, std::vector<std::string>& files) {
  const auto first = static_cast<std::ptrdiff_t>(files.size());
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (isPicture(entry.path().string())) files.push_back(entry.path().string());
  }
  std::sort(files.begin() + first, files.end(), naturalLess);
}

void addFile(const std::string& file, std::vector<std::string>& files) {
  if (file == kStandardInput)
    throw std::invalid_argument("the standard input has raw frames: give --size WIDTHxHEIGHT");
  if (!fs::exists(file)) throw std::invalid_argument("there is no file '" + file + "'");
  if (!isPicture(file)) throw std::invalid_argument(videoAdvice(file) + "; raw frames need --size");
  files.push_back(file);
}

std::vector<std::string> filesOf(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (fs::is_directory(path)) {
      addFolder(path, files);
    } else {
      addFile(path, files);
    }
  }
  return files;
}

class Pictures final : public FrameSource {
 public:
  Pictures(std::vector<std::string> files, std::optional<Transfer> transfer)
      : files_(std::move(files)), transfer_(transfer) {
    if (!files_.empty()) first_ = readPicture(files_.front(), transfer_);
    if (files_.size() < 2) throw std::invalid_argument("events need at least two frames");
    width_ = first_.width;
    height_ = first_.height;
  }

  std::optional<std::size_t> frames() const override { return files_.size(); }

  std::optional<IntensityFrame> next() override {
    if (at_ == files_.size()) return std::nullopt;
    const std::string& file = files_[at_++];
    return at_ == 1 ? std::move(first_.light) : read(file);
  }

 private:
  IntensityFrame read(const std::string& file) {
    Picture picture = readPicture(file, transfer_);
    if (picture.width != width_ || picture.height != height_)
      throw std::runtime_error(file + ": has " + sizeText(picture.width, picture.height) +
                               " pixels, but the first frame has " + sizeText(width_, height_));
    return std::move(picture.light);
  }

  const std::vector<std::string> files_;
  const std::optional<Transfer> transfer_;
  Picture first_{};
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> openPictures(const std::vector<std::string>& paths,
                                          std::optional<Transfer> transfer) {
  return std::make_unique<Pictures>(filesOf(paths), transfer);
}

}  // namespace saccade::client
