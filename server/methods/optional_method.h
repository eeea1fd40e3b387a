// Methods that need a library or a file which a program may lack.
#pragma once

#include <string>

#include "methods/method.h"

namespace saccade {

struct OptionalMethod {
  MethodInfo info;     // only the name where the method is absent
  std::string absent;  // what is missing and what to do; empty: the method is a row of methodTable()

  static OptionalMethod missing(const std::string& name, const std::string& why) {
    OptionalMethod method;
    method.info.name = name, method.absent = why;
    return method;
  }
};

// Open Image Denoise; learned_oidn.cpp, or learned_oidn_absent.cpp of a build without the library.
OptionalMethod oidnMethod();
// The network that SACCADE_LEARNED_MODEL names; learned_onnx.cpp, or learned_onnx_absent.cpp of a build
// without ONNX Runtime. Reads the file.
OptionalMethod learnedMethod();

// Why no row of methodTable() has this name.
std::string noMethod(const std::string& name);

}  // namespace saccade
