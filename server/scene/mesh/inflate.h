// Reads data that zlib has compressed.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct z_stream_s;

namespace saccade {

// Each byte that read() returns is inflated as it is asked for, so that a huge count ends with the data.
// Throws SceneError, which names the file: faulty or short data, or more of it than limits.h allows for its
// compressed size.
class Inflate {
 public:
  // Keeps references to both.
  Inflate(std::string_view compressed, const std::string& path);
  ~Inflate();
  Inflate(const Inflate&) = delete;
  Inflate& operator=(const Inflate&) = delete;

  void read(void* to, std::size_t bytes);

 private:
  [[noreturn]] void fail(const std::string& what) const;

  const std::string& path_;
  std::string_view rest_;  // that zlib has not been given
  std::size_t left_;       // that may be read
  std::unique_ptr<z_stream_s> stream_;
};

}  // namespace saccade
