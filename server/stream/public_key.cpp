#include "stream/public_key.h"

#include <zmq.hpp>

namespace saccade {

std::string publicKeyOf(const std::string& secret_key) {
  char public_key[41];
  if (zmq_curve_public(public_key, secret_key.c_str()) != 0) throw zmq::error_t();
  return public_key;
}

}  // namespace saccade
