// Files of pictures, which OpenImageIO reads and writes. It brings 250 shared libraries along, and so it
// stands in a module that is loaded on first use.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace saccade::pictures {

// Type of the numbers in a file.
enum class Number { kU8, kU16, kU32, kOtherWhole, kF16, kF32, kF64 };

constexpr bool isWhole(Number number) {
  return number < Number::kF16;
}

struct Shape {
  int width = 0, height = 0;
  std::vector<std::string> channels = {};  // their names
  Number number = Number::kF32;
  int alpha = -1;                         // the index of that channel; -1: none
  bool multiplied = false;                // of a file: its colours have been multiplied by alpha
  bool several = false;                   // of a file: it holds further pictures, as a video does
  std::map<std::string, int> notes = {};  // of Saccade, by name

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// An open file, of which the header has been read.
class Input {
 public:
  virtual ~Input() = default;

  const Shape& shape() const { return shape_; }
  // Gives `count` channels of each pixel from the channel `first` on, row by row from the top, and
  // `pixel_bytes` from one pixel to the next. Whole numbers become fractions of their largest value. Throws
  // std::runtime_error with the file's name.
  virtual void read(int first, int count, float* to, std::size_t pixel_bytes) = 0;

 protected:
  Shape shape_;
};

class Library {
 public:
  // Whether it knows such files, by the extension or the first bytes. A video is no picture.
  virtual bool canRead(const std::string& path) const = 0;

  // Opens a flat picture. Colours are not multiplied by the alpha of a file that keeps both apart. Throws
  // std::runtime_error with the file's name.
  virtual std::unique_ptr<Input> open(const std::string& path) const = 0;
  // The same of a PNG, JPEG or WebP picture in memory, which must outlive the input. `name` is for messages.
  virtual std::unique_ptr<Input> openBytes(std::string_view bytes, const std::string& name) const = 0;

  // Writes the format of the extension. `numbers`: channels of a pixel side by side, of the type
  // `shape.number`; f64 becomes f32. Equal pictures have equal bytes. Throws std::runtime_error with the
  // file's name.
  virtual void write(const std::string& path, const Shape& shape, const void* numbers) const = 0;
  // Returns the bytes of a PNG file. Throws std::runtime_error.
  virtual std::string encodePng(const Shape& shape, const void* numbers) const = 0;

 protected:
  ~Library() = default;
};

// Loads the module at the first call. Throws std::runtime_error with the name of the file that cannot be
// loaded.
const Library& library();

}  // namespace saccade::pictures
