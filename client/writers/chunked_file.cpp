#include "client/writers/chunked_file.h"

#include <system_error>

namespace saccade::client {

void ChunkedFile::appendChunk(std::string_view bytes, std::uint64_t events) {
  try {
    append(bytes);
  } catch (const std::system_error& error) {
    throw std::system_error(error.code(), path_ + ": holds the first " + std::to_string(events_) + " events");
  }
  events_ += events;
}

}  // namespace saccade::client
