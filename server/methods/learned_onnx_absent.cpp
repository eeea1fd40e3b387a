#include "methods/optional_method.h"

namespace saccade {

OptionalMethod learnedMethod() {
  return OptionalMethod::missing("learned",
                                 "this program was built without ONNX Runtime: install its C library and "
                                 "headers, then configure and build again");
}

}  // namespace saccade
