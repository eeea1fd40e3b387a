#include "methods/optional_method.h"

namespace saccade {

OptionalMethod oidnMethod() {
  return OptionalMethod::missing("oidn",
                                 "this program was built without Open Image Denoise: install its "
                                 "version 2, then configure and build again");
}

}  // namespace saccade
