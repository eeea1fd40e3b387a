#include "saccade/wire/planes.h"

#include <bit>
#include <cstring>

namespace saccade {
namespace {

static_assert(std::endian::native == std::endian::little, "planes are copied as they lie in memory");

std::string_view bytesOf(const std::vector<float>& plane) {
  return {reinterpret_cast<const char*>(plane.data()), plane.size() * sizeof(float)};
}

}  // namespace

std::string encodePlanes(const PixelState& pixels) {
  std::string payload(bytesOf(pixels.brightness));
  payload += bytesOf(pixels.reference);
  return payload;
}

PixelState decodePlanes(std::string_view payload) {
  const std::size_t pixels = payload.size() / kPlanesBytesPerPixel, plane = pixels * sizeof(float);
  PixelState state{std::vector<float>(pixels), std::vector<float>(pixels)};
  std::memcpy(state.brightness.data(), payload.data(), plane);
  std::memcpy(state.reference.data(), payload.data() + plane, plane);
  return state;
}

}  // namespace saccade
