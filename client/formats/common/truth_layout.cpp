#include "client/formats/common/truth_layout.h"

#include <cstring>

#include "saccade/wire/truth_samples.h"

namespace saccade::client {

std::uint32_t planesOf(const v1::RecordedTruth& channel) {
  return static_cast<std::uint32_t>(channel.info().planes_size());
}

std::uint64_t sampleBytes(const v1::RecordedTruth& channel) {
  const std::uint64_t pixels = isPicture(channel) ? std::uint64_t{channel.width()} * channel.height() : 1;
  return pixels * planesOf(channel) * bytesOf(channel.info().element());
}

std::string interleaved(const v1::RecordedTruth& channel, const std::string& elements) {
  const std::size_t planes = planesOf(channel), size = bytesOf(channel.info().element());
  if (!isPicture(channel) || planes == 1) return elements;
  const std::size_t pixels = elements.size() / (planes * size);
  std::string bytes(elements.size(), '\0');
  for (std::size_t plane = 0; plane < planes; ++plane) {
    const char* from = elements.data() + plane * pixels * size;
    char* to = bytes.data() + plane * size;
    for (std::size_t i = 0; i < pixels; ++i) std::memcpy(to + i * planes * size, from + i * size, size);
  }
  return bytes;
}

}  // namespace saccade::client
