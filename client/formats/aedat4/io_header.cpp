#include "client/formats/aedat4/io_header.h"

#include <stdexcept>

#include "io_header_generated.h"

namespace saccade::client::aedat4 {

std::string encodeHeader(const IoHeader& header) {
  flatbuffers::FlatBufferBuilder builder;
  builder.ForceDefaults(true);
  const auto info_node = builder.CreateString(header.info_node);
  fb::FinishSizePrefixedIoHeaderBuffer(
      builder, fb::CreateIoHeader(builder, static_cast<fb::Compression>(header.compression),
                                  header.table_position, info_node));
  return {reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()};
}

IoHeader decodeHeader(std::string_view bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(data, bytes.size());
  if (!fb::VerifySizePrefixedIoHeaderBuffer(verifier)) throw std::runtime_error("is not of the format IOHE");
  const fb::IoHeader& read = *fb::GetSizePrefixedIoHeader(data);
  IoHeader header{static_cast<Compression>(read.compression()), read.table_position(),
                  read.info_node() ? read.info_node()->str() : ""};
  if (nameOf(header.compression).empty())
    throw std::runtime_error("has the unknown compression " + std::to_string(read.compression()));
  return header;
}

}  // namespace saccade::client::aedat4
