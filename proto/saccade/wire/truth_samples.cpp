#include "saccade/wire/truth_samples.h"

#include <bit>
#include <cstring>
#include <utility>

#include "saccade/wire/event.h"
#include "saccade/wire/packet.h"

namespace saccade {
namespace {

static_assert(std::endian::native == std::endian::little, "elements are copied as they lie in memory");

constexpr std::uint64_t kTimeBytes = sizeof(std::uint32_t);  // of a row

std::string checkPicture(const v1::PacketHeader& header) {
  const std::uint64_t pixels = std::uint64_t{header.width()} * header.height();
  if (header.count() > 1) return "a packet carries one picture";
  if (pixels == 0 || pixels > kMaxSnapshotPixels) return std::to_string(pixels) + " pixels of a picture";
  return {};
}

std::string checkRows(const v1::PacketHeader& header) {
  if (header.count() > kMaxPacketRows) return "count is above " + std::to_string(kMaxPacketRows);
  return header.dt_unit_ns() > 0 ? "" : "dt_unit_ns is 0";
}

}  // namespace

std::size_t bytesOf(v1::Element element) {
  switch (element) {
    case v1::ELEMENT_F32:
    case v1::ELEMENT_U32:
      return 4;
    case v1::ELEMENT_F64:
      return 8;
    case v1::ELEMENT_U8:
      return 1;
    case v1::ELEMENT_U16:
      return 2;
    default:
      return 0;
  }
}

std::uint64_t sampleBytes(const v1::PacketHeader& header) {
  const std::uint64_t plane = bytesOf(header.element()) * std::uint64_t{header.planes()};
  const bool picture = header.layout() == v1::LAYOUT_PICTURE;
  return picture ? plane * header.width() * header.height() : plane;
}

std::uint64_t truthBytes(const v1::PacketHeader& header) {
  const std::uint64_t time = header.layout() == v1::LAYOUT_ROWS ? kTimeBytes : 0;
  return header.count() * (time + sampleBytes(header));
}

std::string encodeTruth(std::span<const TruthSample> samples, v1::Layout layout, std::int64_t t0_ns) {
  std::string payload;
  if (layout == v1::LAYOUT_ROWS) {
    for (const TruthSample& sample : samples) {
      const auto dt = static_cast<std::uint32_t>((sample.t_ns - t0_ns) / kTimeUnitNs);
      payload.append(reinterpret_cast<const char*>(&dt), sizeof dt);
    }
  }
  for (const TruthSample& sample : samples) payload += sample.elements;
  return payload;
}

std::string checkTruth(const v1::PacketHeader& header) {
  if (bytesOf(header.element()) == 0) return "element " + std::to_string(header.element()) + " is unknown";
  const std::uint32_t most = header.layout() == v1::LAYOUT_ROWS ? kMaxRowElements : kMaxPicturePlanes;
  if (header.planes() == 0 || header.planes() > most) {
    return std::to_string(header.planes()) + " planes: 1 to " + std::to_string(most) + " are valid";
  }
  if (header.t0_ns() < 0 || header.t1_ns() < header.t0_ns()) return "an interval that runs backwards";
  if (header.layout() == v1::LAYOUT_PICTURE) return checkPicture(header);
  if (header.layout() == v1::LAYOUT_ROWS) return checkRows(header);
  return "layout " + std::to_string(header.layout()) + " of a truth channel";
}

std::string decodeTruth(const v1::PacketHeader& header, std::string payload, TruthSamples& out) {
  out.clear();
  if (header.count() == 0) return {};
  if (header.layout() == v1::LAYOUT_PICTURE) {
    out.push_back({header.t1_ns(), std::move(payload), header.exposure_begin_ns(), header.exposure_end_ns()});
    return {};
  }
  const char* times = payload.data();
  const std::size_t size = sampleBytes(header);
  const auto length = static_cast<std::uint64_t>(header.t1_ns() - header.t0_ns());
  std::uint64_t prev = 0;
  for (std::size_t i = 0; i < header.count(); ++i) {
    std::uint32_t dt;
    std::memcpy(&dt, times + i * kTimeBytes, sizeof dt);
    const std::uint64_t after_t0 = std::uint64_t{dt} * header.dt_unit_ns();
    if (after_t0 < prev) return "times that run backwards";
    if (after_t0 > length) return "a time outside the packet's interval";
    prev = after_t0;
    out.push_back({header.t0_ns() + static_cast<std::int64_t>(after_t0),
                   payload.substr(header.count() * kTimeBytes + i * size, size)});
  }
  return {};
}

}  // namespace saccade
