// The interface between the module and its loader.
#pragma once

#include "pictures/library.h"

namespace saccade::pictures {

using Entry = const Library*();

// The number changes with library.h: after an upgrade, a program that still runs finds no module rather than
// another.
extern "C" const Library* saccadePictures2();
inline constexpr const char* kEntryName = "saccadePictures2";

}  // namespace saccade::pictures
