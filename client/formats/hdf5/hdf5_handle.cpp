#include "client/formats/hdf5/hdf5_handle.h"

#include <stdexcept>

namespace saccade::client {
namespace {

herr_t takeFirst(unsigned, const H5E_error2_t* error, void* text) {
  *static_cast<std::string*>(text) = error->desc ? error->desc : "";
  return 1;
}

}  // namespace

void startHdf5() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

// The first entry is that of the function that found the fault; the others are its callers.
std::string hdf5Reason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, takeFirst, &text);
  return text.empty() ? "no reason given" : text;
}

void checkHdf5(bool done, const std::string& object) {
  if (!done) throw std::runtime_error("HDF5 refuses " + object + ": " + hdf5Reason());
}

}  // namespace saccade::client
