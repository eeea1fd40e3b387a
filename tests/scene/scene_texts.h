// Texts of small scene files.
#pragma once

namespace saccade::test {

// The beginning of a scene; "</scene>" ends it.
inline constexpr const char* kSensor =
    "<scene><sensor type='perspective'><float name='fov' value='40'/></sensor>";
// A mesh file.
inline constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace saccade::test
