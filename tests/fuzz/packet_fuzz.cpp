// Input of a client: packets of a server that may be anyone's.
#include "fuzz/fuzz_target.h"
#include "fuzz/inputs.pb.h"
#include "fuzz/message_mutator.h"
#include "saccade/sequence_check.h"
#include "saccade/stream_fault.h"
#include "saccade/wire/packet.h"

namespace saccade {
namespace {

void checkContent(const v1::PacketHeader& header, const PacketContent& content) {
  const Events& events = content.events;
  const std::size_t pixels = std::size_t{header.width()} * header.height();
  const bool snapshot = header.kind() == v1::KIND_SNAPSHOT;
  SACCADE_CHECK(content.pixels.brightness.size() == (snapshot ? pixels : 0));
  SACCADE_CHECK(content.pixels.reference.size() == (snapshot ? pixels : 0));
  SACCADE_CHECK(events.size() == header.count() || header.kind() != v1::KIND_EVENTS);
  std::int64_t prev = header.t0_ns();
  for (const Event& e : events) {
    SACCADE_CHECK(e.x < header.width() && e.y < header.height() && e.p <= 1);
    SACCADE_CHECK(e.t_ns >= prev && e.t_ns <= header.t1_ns());
    prev = e.t_ns;
  }
}

// The second of two sensors goes on at an event.
v1::OpenStream resolved() {
  v1::OpenStream request;
  request.add_sensors();
  request.add_sensors()->set_from_event(1);
  return request;
}

bool follows(client::SequenceCheck& sequence, const v1::PacketHeader& header, const Events& events) {
  return accepts<client::StreamFault>([&] {
    const auto fresh = sequence.add(header);
    SACCADE_CHECK(!fresh || fresh->known_items <= events.size());
  });
}

bool read(std::string_view bytes) {
  fuzz::PacketTrain train;
  if (!train.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  client::SequenceCheck sequence(resolved());
  for (fuzz::Packet& packet : *train.mutable_packets()) {
    v1::PacketHeader& header = *packet.mutable_header();
    if (header.crc32() == 0) header.set_crc32(crc32Of(packet.payload()));
    PacketContent content;
    if (!decodePacket(header, packet.payload(), content).empty()) return false;
    checkContent(header, content);
    if (!follows(sequence, header, content.events)) return false;
  }
  return true;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const std::vector<std::string> words{"",
                                              std::string(9, '\0'),
                                              std::string(18, '\0'),
                                              std::string("\1\0\0\0\2\0\0\0\1\0\2\0\3\0\4\0\1\0", 18),
                                              std::string(8, '\xff'),
                                              "why"};
  static const FuzzTarget target{
      {bytesOf<fuzz::PacketTrain>(
           "packets { header { kind: KIND_EVENTS layout: LAYOUT_COLUMNS codec: CODEC_NONE dt_unit_ns: 1000 "
           "count: 2 "
           "t1_ns: 4000 width: 8 height: 8 } payload: "
           "'\\001\\000\\000\\000\\002\\000\\000\\000\\001\\000\\002\\000\\003\\000\\004\\000\\001\\000' } "
           "packets { header { kind: KIND_HEARTBEAT } } "
           "packets { header { kind: KIND_END seq: 1 first_event_index: 2 t0_ns: 4000 t1_ns: 4000 } }"),
       bytesOf<fuzz::PacketTrain>("packets { header { kind: KIND_ERROR } payload: 'why' }")},
      words,
      read,
      [](const std::string& bytes, Draws& draw) {
        return mutateBytesOf<fuzz::PacketTrain>(bytes, words, draw);
      }};
  return target;
}

}  // namespace saccade
