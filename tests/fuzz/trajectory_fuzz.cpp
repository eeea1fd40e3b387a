#include "fuzz/fuzz_target.h"
#include "fuzz/path_check.h"
#include "scene/files/scene_error.h"

namespace saccade {

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"# t x y z qx qy qz qw\n0 0 0 0 0 0 0 1\n0.5 1 0 -2e-3 0 0.6 0 0.8\n1e1 1 1 1 0 0 0 -2\n",
       "#timestamp [ns],p_RS_R_x [m],p_y,tz,q_w [],qx,qy,qz,v_x [m "
       "s^-1]\n0.0,1,2,3,1,0,0,0,5\n4e7,1,2,3,1,0,0,0,5\n",
       "t,x,y,z,qx,qy,qz,qw\r\n100,0,0,0,0,0,0,1\r\n2000,1,0,0,0,0,1,0\r\n\r\n"},
      {" ",
       ",",
       "t",
       "_us",
       "x",
       "qw",
       "[ns]",
       "[",
       "]",
       ":",
       "# t x y z qx qy qz qw",
       "b_w_x",
       ".0",
       "\n",
       "\r\n",
       "#",
       "-1",
       "0",
       "0.6 0.8",
       "nan",
       "inf",
       "1e9",
       "1e300",
       "1e-320",
       "9223372036854775807",
       "-9223372036854775808",
       "0x10",
       "+",
       "."},
      [](std::string_view bytes) {
        return accepts<SceneError>([&] { checkPath(parseTrajectory(bytes, "fuzz.csv"), TimeNs{0}); });
      }};
  return target;
}

}  // namespace saccade
