#include "eval/figures/false_event_rows.h"

#include <cstdio>
#include <sstream>

namespace saccade::eval {

std::string csvOf(const std::vector<FalseEventRow>& rows) {
  std::ostringstream csv;
  csv << "scene,method,spp,threshold";
  for (const char* part : {"quiet", "all", "small"})
    csv << ',' << part << "_share," << part << "_mean_noise," << part << "_sigma," << part
        << "_sigma_trimmed";
  csv << ",quiet_fresh_phase,quiet_accumulating,all_false_and_missed,small_false_and_missed\n";
  const auto add = [&](double share, const NoiseSize& noise) {
    csv << ',' << share << ',' << noise.mean_abs << ',' << noise.sigma << ',' << noise.sigma_trimmed;
  };
  for (const auto& [scene, method, spp, C, e] : rows) {
    csv << scene << ',' << method << ',' << spp << ',' << C;
    add(e.quiet.share, e.quiet.noise), add(e.all.share, e.all.noise), add(e.small.share, e.small.noise);
    csv << ',' << e.quiet.fresh_phase << ',' << e.quiet.accumulating << ',' << e.all.false_and_missed << ','
        << e.small.false_and_missed << '\n';
  }
  return csv.str();
}

void printRows(const std::vector<FalseEventRow>& rows) {
  std::printf("%-37s | %-44s | %-17s | %-24s\n", "", "truth at rest", "all pixels", "changes below C");
  std::printf("%-14s %-16s %-3s %-4s", "scene", "method", "spp", "C");
  std::printf("| %5s %8s %8s %8s %8s %8s | %8s %8s | %5s %8s %8s\n", "share", "|noise|", "sigma", "trimmed",
              "fresh", "accum.", "|noise|", "f+m", "share", "|noise|", "f+m");
  for (const auto& [scene, method, spp, C, e] : rows) {
    std::printf("%-14s %-16s %3d %4g", scene.c_str(), method.c_str(), spp, C);
    std::printf("| %5.3f %8.5f %8.5f %8.5f %8.5f %8.5f | %8.5f %8.5f | %5.3f %8.5f %8.5f\n", e.quiet.share,
                e.quiet.noise.mean_abs / C, e.quiet.noise.sigma / C, e.quiet.noise.sigma_trimmed / C,
                e.quiet.fresh_phase, e.quiet.accumulating, e.all.noise.mean_abs / C, e.all.false_and_missed,
                e.small.share, e.small.noise.mean_abs / C, e.small.false_and_missed);
  }
}

}  // namespace saccade::eval
