#include "scene/mesh/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "scene/files/limits.h"
#include "scene/files/scene_error.h"

namespace saccade {
namespace {

// The number of bytes that zlib is given at once.
uInt piece(std::size_t bytes) {
  return static_cast<uInt>(std::min<std::size_t>(bytes, std::numeric_limits<uInt>::max()));
}

}  // namespace

Inflate::Inflate(std::string_view compressed, const std::string& path)
    : path_(path),
      rest_(compressed),
      left_(compressed.size() * kMaxMeshBytesPerByte),
      stream_(std::make_unique<z_stream>()) {
  if (inflateInit(stream_.get()) != Z_OK) fail("there is no memory to inflate it");
}

Inflate::~Inflate() {
  inflateEnd(stream_.get());
}

void Inflate::read(void* to, std::size_t bytes) {
  if (bytes > left_)
    fail("its data is more than " + std::to_string(kMaxMeshBytesPerByte) + " times as large as in the file");
  left_ -= bytes;
  stream_->next_out = static_cast<Bytef*>(to);
  for (std::size_t done = 0; done < bytes;) {
    const uInt given = piece(rest_.size()), wanted = piece(bytes - done);
    stream_->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));  // zlib only reads it
    stream_->avail_in = given, stream_->avail_out = wanted;
    const int result = inflate(stream_.get(), Z_SYNC_FLUSH);
    rest_.remove_prefix(given - stream_->avail_in);
    const std::size_t got = wanted - stream_->avail_out;
    done += got;
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) fail("its zlib data is faulty");
    if (got == 0) fail("its zlib data ends within the mesh");
  }
}

void Inflate::fail(const std::string& what) const {
  throw SceneError(path_ + ": " + what);
}

}  // namespace saccade
