// The files of the viewer's page, which the build puts into the program.
#pragma once

#include "ops/http_site.h"

namespace saccade {

// Pages by path: "/" and the files that it names.
HttpPages viewerPages();

}  // namespace saccade
