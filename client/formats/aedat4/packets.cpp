#include "client/formats/aedat4/packets.h"

#include <cstring>
#include <stdexcept>

#include "client/formats/aedat4/info_node.h"
#include "client/formats/common/units.h"
#include "events_generated.h"

namespace saccade::client::aedat4 {
namespace {}  // namespace

PacketHeader PacketEncoder::append(std::string& to, std::span<const Event> events, std::int64_t offset_us) {
  builder_.Clear();
  fb::Event* elements = nullptr;
  const auto vector = builder_.CreateUninitializedVectorOfStructs(events.size(), &elements);
  for (const Event& event : events) {
    *elements++ = fb::Event(event.t_ns / kNsPerUs + offset_us, static_cast<std::int16_t>(event.x),
                            static_cast<std::int16_t>(event.y), event.p != 0);
  }
  fb::FinishSizePrefixedEventPacketBuffer(builder_, fb::CreateEventPacket(builder_, vector));

  const std::size_t start = to.size();
  to.resize(start + sizeof(PacketHeader));
  compressor_.append(to, {reinterpret_cast<const char*>(builder_.GetBufferPointer()), builder_.GetSize()});
  const PacketHeader header{kStreamId, static_cast<std::int32_t>(to.size() - start - sizeof(PacketHeader))};
  std::memcpy(to.data() + start, &header, sizeof header);
  return header;
}

void appendEvents(Events& to, std::string_view packet) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(packet.data());
  flatbuffers::Verifier verifier(data, packet.size());
  if (!fb::VerifySizePrefixedEventPacketBuffer(verifier))
    throw std::runtime_error("is not of the format EVTS");
  const auto* elements = fb::GetSizePrefixedEventPacket(data)->elements();
  if (!elements) return;
  to.reserve(to.size() + elements->size());
  for (const fb::Event* event : *elements) {
    std::int64_t t_ns;
    if (__builtin_mul_overflow(event->t(), kNsPerUs, &t_ns))
      throw std::runtime_error("has the time " + std::to_string(event->t()) + " us, which is out of range");
    to.push_back(
        {t_ns, static_cast<std::uint16_t>(event->x()), static_cast<std::uint16_t>(event->y()), event->on()});
  }
}

}  // namespace saccade::client::aedat4
