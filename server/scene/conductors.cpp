#include "scene/conductors.h"

#include <vector>

#include "base/names.h"

namespace saccade {
namespace {

// The measured spectra that come with Mitsuba 0.6 (from luxpop.com), folded with the CIE 1931 observer and
// taken to Rec. 709, as Mitsuba does where it renders in RGB.
const std::vector<ComplexIndex>& conductorTable() {
  static const std::vector<ComplexIndex> table = {
      {"none", {0, 0, 0}, {1, 1, 1}},
      {"Ag", {0.15526f, 0.11672f, 0.13838f}, {4.82834f, 3.12225f, 2.14696f}},
      {"Al", {1.65746f, 0.88037f, 0.52123f}, {9.22387f, 6.26952f, 4.83701f}},
      {"Au", {0.14312f, 0.37494f, 1.44251f}, {3.98317f, 2.38573f, 1.60321f}},
      {"Be", {4.18506f, 3.18506f, 2.78410f}, {3.83544f, 3.01012f, 2.86902f}},
      {"Cr", {4.36968f, 2.91671f, 1.65470f}, {5.20643f, 4.23137f, 3.75497f}},
      {"Cu", {0.20041f, 0.92405f, 1.10222f}, {3.91294f, 2.45284f, 2.14220f}},
      {"Hg", {2.39893f, 1.44003f, 0.90955f}, {6.32763f, 4.37194f, 3.42180f}},
      {"Ir", {3.08642f, 2.08219f, 1.61789f}, {5.59215f, 4.06718f, 3.26727f}},
      {"Li", {0.26579f, 0.19561f, 0.22092f}, {3.54018f, 2.31113f, 1.66860f}},
      {"Mo", {4.48369f, 3.52548f, 2.77608f}, {4.11112f, 3.42087f, 3.15061f}},
      {"Nb", {3.42014f, 2.79020f, 2.39559f}, {3.44138f, 2.73764f, 2.57993f}},
      {"Ni_palik", {2.36728f, 1.66336f, 1.46706f}, {4.49884f, 3.05016f, 2.34543f}},
      {"Rh", {2.58580f, 1.86018f, 1.55444f}, {6.78229f, 4.70295f, 3.97610f}},
      {"Ta", {2.06258f, 2.39310f, 2.62808f}, {2.40804f, 1.74137f, 1.94704f}},
      {"TiN", {1.64847f, 1.15044f, 1.37978f}, {3.36847f, 1.94349f, 1.10201f}},
      {"V_palik", {4.27751f, 3.51316f, 2.76114f}, {3.49118f, 2.88935f, 3.11171f}},
      {"VN", {2.86560f, 2.11918f, 1.94008f}, {3.03233f, 2.05611f, 1.61630f}},
      {"W", {4.37070f, 3.30030f, 2.99827f}, {3.50068f, 2.60486f, 2.27320f}},
  };
  return table;
}

}  // namespace

const ComplexIndex* findConductor(const std::string& name) {
  return findRow(conductorTable(), name);
}

std::string conductorNames() {
  return joinRowNames(conductorTable());
}

}  // namespace saccade
