#include "saccade/wire/packet_source.h"

#include "saccade/wire/event.h"

namespace saccade {

v1::PacketHeader headerOf(const PacketSource& source) {
  v1::PacketHeader header;
  header.set_stream_id(source.stream_id);
  header.set_epoch(source.epoch);
  header.set_sensor(source.sensor);
  header.set_width(source.width);
  header.set_height(source.height);
  header.set_dt_unit_ns(kTimeUnitNs);
  header.set_codec(source.codec->id);
  return header;
}

}  // namespace saccade
