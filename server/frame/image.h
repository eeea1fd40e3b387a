// A planar picture with a border, so that kernels need no bounds tests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include "base/check.h"

namespace saccade {

// One plane of width x height values. Rows start on 64-byte boundaries. On every side kBorder pixels can be
// read and written: row(y)[x] is valid for x in [-kBorder, width + kBorder). The same holds for y. The border
// is zero at first and keeps what fill() wrote there. Owns its memory. It can be moved; copyFrom() is the
// only way to copy it.
template <class T>
class Image {
 public:
  static constexpr int kBorder = 32;  // the longest tap of five a-trous iterations: 2 * 16

  Image() = default;
  Image(int width, int height) : width_(width), height_(height) {
    SACCADE_CHECK(width > 0 && height > 0);
    constexpr int kPerLine = kAlign / sizeof(T);
    static_assert(kBorder % kPerLine == 0);
    stride_ = (width + 2 * kBorder + kPerLine - 1) / kPerLine * kPerLine;
    const std::size_t count = static_cast<std::size_t>(stride_) * (height + 2 * kBorder);
    data_.reset(static_cast<T*>(::operator new[](count * sizeof(T), std::align_val_t{kAlign})));
    std::fill_n(data_.get(), count, T{});
  }

  int width() const { return width_; }
  int height() const { return height_; }

  T* row(int y) { return data_.get() + static_cast<std::ptrdiff_t>(y + kBorder) * stride_ + kBorder; }
  const T* row(int y) const { return const_cast<Image*>(this)->row(y); }
  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }
  std::ptrdiff_t stride() const { return stride_; }

  // Sets every pixel, border included.
  void fill(T value) { std::fill_n(row(-kBorder) - kBorder, stride_ * (height_ + 2 * kBorder), value); }

  void copyFrom(const Image& other) {
    SACCADE_CHECK(width_ == other.width_ && height_ == other.height_);
    std::copy_n(other.row(-kBorder) - kBorder, stride_ * (height_ + 2 * kBorder), row(-kBorder) - kBorder);
  }

 private:
  static constexpr std::size_t kAlign = 64;
  struct Free {
    void operator()(T* p) const { ::operator delete[](p, std::align_val_t{kAlign}); }
  };
  int width_ = 0, height_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::unique_ptr<T[], Free> data_;
};

using ImageF = Image<float>;

}  // namespace saccade
