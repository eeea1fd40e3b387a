// A bitmap font of 5x7 pixels: pictures need words on machines without any font.
#pragma once

namespace saccade::client {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;  // pixels; leave one between letters

// Whether the glyph covers the pixel at column x in [0, 5) and row y in [0, 7) from its top left. The font
// has letters, digits and . , : + - % ( ) / =; any other character is a box.
bool isInk(char character, int x, int y);

}  // namespace saccade::client
