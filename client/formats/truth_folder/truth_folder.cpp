#include "client/formats/truth_folder/truth_folder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "client/formats/common/truth_layout.h"
#include "client/formats/common/units.h"
#include "client/formats/truth_folder/picture_file.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTimesHead = "index,t_us,exposure_begin_us,exposure_end_us\n";

template <class T>
std::string numberText(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string elementText(v1::Element element, const char* at) {
  switch (element) {
    case v1::ELEMENT_U8:
      return numberText<std::uint8_t>(at);
    case v1::ELEMENT_U16:
      return numberText<std::uint16_t>(at);
    case v1::ELEMENT_U32:
      return numberText<std::uint32_t>(at);
    case v1::ELEMENT_F64:
      return numberText<double>(at);
    default:
      return numberText<float>(at);
  }
}

std::string rowsHead(const v1::RecordedTruth& channel) {
  std::string head = "t_us";
  for (const std::string& plane : channel.info().planes()) head += "," + plane;
  return head + "\n";
}

std::string rowText(const v1::RecordedTruth& channel, const TruthSample& sample) {
  std::string line = std::to_string(sample.t_ns / kNsPerUs);
  const std::size_t size = bytesOf(channel.info().element());
  for (std::size_t i = 0; i < planesOf(channel); ++i)
    line += "," + elementText(channel.info().element(), sample.elements.data() + i * size);
  return line + "\n";
}

std::string sixDigits(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  return std::string(6 - std::min<std::size_t>(6, digits.size()), '0') + digits;
}

std::string timesText(std::uint64_t index, const TruthSample& sample) {
  std::string line = std::to_string(index);
  for (const std::int64_t t_ns : {sample.t_ns, sample.exposure_begin_ns, sample.exposure_end_ns})
    line += "," + std::to_string(t_ns / kNsPerUs);
  return line + "\n";
}

}  // namespace

TruthFolder::TruthFolder(const std::string& folder) : folder_(folder) {
  fs::remove_all(folder);
  fs::create_directory(folder);
}

void TruthFolder::add(int index, const v1::RecordedTruth& channel) {
  const std::string path = folder_ + "/" + channel.name();
  const bool picture = isPicture(channel);
  if (picture) fs::create_directory(path);
  auto table = std::make_unique<OutputFile>(picture ? path + "/times.csv" : path + ".csv");
  table->append(picture ? kTimesHead : rowsHead(channel));
  channels_[index] = {channel, path, std::move(table)};
}

void TruthFolder::write(int index, const TruthSamples& samples) {
  Channel& c = channels_.at(index);
  for (const TruthSample& sample : samples) {
    if (isPicture(c.about)) {
      writePicture(c.folder + "/" + sixDigits(c.pictures) + pictureExtension(c.about), c.about,
                   sample.elements);
      c.table->append(timesText(c.pictures++, sample));
    } else {
      c.table->append(rowText(c.about, sample));
    }
  }
}

void TruthFolder::close() {
  for (auto& [index, channel] : channels_) channel.table->close();
}

}  // namespace saccade::client
