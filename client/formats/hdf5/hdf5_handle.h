// Handles of HDF5's C library that close themselves, and its faults as text.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

namespace saccade::client {

class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  // `id` may be negative, as the library returns it after a fault.
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { close(); }

  explicit operator bool() const { return id_ >= 0; }
  hid_t id() const { return id_; }
  // Whether the library did so without a fault.
  bool close() { return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

// To be called before any other call of the library. It then neither prints its faults nor closes files at
// the end of the program, when their owners are gone.
void startHdf5();

std::string hdf5Reason();  // what the library says of the fault of the last call
// Unless `done`, throws std::runtime_error with `object` and the reason.
void checkHdf5(bool done, const std::string& object);

}  // namespace saccade::client
