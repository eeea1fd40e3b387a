#include "saccade/wire/columns.h"

#include <bit>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace saccade {
namespace {

static_assert(std::endian::native == std::endian::little, "columns are copied as they lie in memory");

// Where each column of n events starts in a payload.
struct Offsets {
  Offsets(std::size_t n, v1::Layout layout)
      : x(4 * n),
        y(6 * n),
        p(8 * n),
        source(9 * n),
        artefact(10 * n),
        object((hasLabels(layout) ? 11 : 9) * n) {}
  std::size_t x, y, p, source, artefact, object;
};

// Payloads received from a socket need not be aligned, so values are copied, never cast.
template <class T>
T load(const char* column, std::size_t i) {
  T value;
  std::memcpy(&value, column + i * sizeof(T), sizeof(T));
  return value;
}

template <class T>
void store(char* column, std::size_t i, T value) {
  std::memcpy(column + i * sizeof(T), &value, sizeof(T));
}

// The interval as unsigned lengths, so that no header can overflow the sums.
struct Span {
  explicit Span(const v1::PacketHeader& h)
      : length(static_cast<std::uint64_t>(h.t1_ns()) - static_cast<std::uint64_t>(h.t0_ns())) {}
  bool holds(std::uint64_t after_t0) const { return length == 0 ? after_t0 == 0 : after_t0 < length; }
  std::uint64_t length;
};

// The numbers of one event as a payload has them.
struct Numbers {
  std::uint16_t x, y;
  std::uint8_t p, source = 0, artefact = 0;
  std::uint32_t object = 0;
};

std::string check(const Numbers& e, const v1::PacketHeader& h) {
  if (e.x >= h.width() || e.y >= h.height()) return "a pixel outside the view";
  if (e.p > 1) return "a polarity that is neither 0 nor 1";
  if (!v1::EventSource_IsValid(e.source)) return "a source that is unknown";
  if (e.object > kMaxObject) return "an object beyond " + std::to_string(kMaxObject);
  return {};
}

}  // namespace

std::string encodeColumns(std::span<const Event> events, std::int64_t t0_ns, v1::Layout layout) {
  const std::size_t n = events.size();
  const auto units = [&](const Event& e) { return static_cast<std::uint64_t>(e.t_ns - t0_ns) / kTimeUnitNs; };
  if (n > 0 &&
      (events.front().t_ns < t0_ns || units(events.back()) > std::numeric_limits<std::uint32_t>::max()))
    throw std::out_of_range("an event lies outside the times its packet can express");
  const Offsets at(n, layout);
  std::string payload(n * bytesPerEvent(layout), '\0');
  char* bytes = payload.data();
  for (std::size_t i = 0; i < n; ++i) store(bytes, i, static_cast<std::uint32_t>(units(events[i])));
  for (std::size_t i = 0; i < n; ++i) store(bytes + at.x, i, events[i].x);
  for (std::size_t i = 0; i < n; ++i) store(bytes + at.y, i, events[i].y);
  for (std::size_t i = 0; i < n; ++i) store(bytes + at.p, i, std::uint8_t{events[i].p});
  if (hasLabels(layout)) {
    for (std::size_t i = 0; i < n; ++i) store(bytes + at.source, i, std::uint8_t{events[i].source});
    for (std::size_t i = 0; i < n; ++i) store(bytes + at.artefact, i, events[i].artefact);
  }
  if (hasObjects(layout))
    for (std::size_t i = 0; i < n; ++i) store(bytes + at.object, i, std::uint32_t{events[i].object});
  return payload;
}

std::string decodeColumns(const v1::PacketHeader& header, std::string_view payload, Events& out) {
  out.clear();
  const std::size_t n = header.count();
  const std::size_t size = bytesPerEvent(header.layout());
  if (payload.size() != n * size)
    return "a payload whose size is not " + std::to_string(size) + " bytes an event";
  if (header.t0_ns() < 0 || header.t1_ns() < header.t0_ns()) return "an interval that runs backwards";
  const bool labelled = hasLabels(header.layout()), with_objects = hasObjects(header.layout());
  const Offsets at(n, header.layout());
  const Span span(header);
  const char* bytes = payload.data();
  out.reserve(n);
  std::uint64_t prev = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t after_t0 = std::uint64_t{load<std::uint32_t>(bytes, i)} * header.dt_unit_ns();
    if (after_t0 < prev) return "times that run backwards";
    if (!span.holds(after_t0)) return "a time outside the packet's interval";
    prev = after_t0;
    Numbers event{load<std::uint16_t>(bytes + at.x, i), load<std::uint16_t>(bytes + at.y, i),
                  load<std::uint8_t>(bytes + at.p, i)};
    if (labelled) {
      event.source = load<std::uint8_t>(bytes + at.source, i);
      event.artefact = load<std::uint8_t>(bytes + at.artefact, i);
    }
    if (with_objects) event.object = load<std::uint32_t>(bytes + at.object, i);
    if (std::string fault = check(event, header); !fault.empty()) return fault;
    out.push_back({header.t0_ns() + static_cast<std::int64_t>(after_t0), event.x, event.y, event.p,
                   event.source, event.object, event.artefact});
  }
  return {};
}

}  // namespace saccade
