// Calibrations as texts.
#include "client/calibration/calibration.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

v1::View view() {
  v1::View v;
  v.set_width(640), v.set_height(480);
  return v;
}

v1::OpenStream streamOf(const v1::View& view) {
  v1::OpenStream stream;
  *stream.mutable_view() = view;
  return stream;
}

std::string textOf(const std::string& ending, const v1::View& v) {
  for (const CalibrationFile& file : calibrationFiles("a.h5", streamOf(v)))
    if (file.name == "a.h5." + ending) return file.text;
  return {};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

TEST(Calibration, AFieldOfViewGivesTheIntrinsics) {
  v1::View v = view();
  v.set_fov_x_deg(90);
  const std::string text = textOf("kalibr.yaml", v);
  EXPECT_TRUE(holds(text, ", 319.5, 239.5]")) << text;
  EXPECT_TRUE(holds(text, "intrinsics: [320.0") || holds(text, "intrinsics: [319.99999")) << text;
  EXPECT_TRUE(holds(text, "distortion_coeffs: [0.0, 0.0, 0.0, 0.0]")) << text;
}

TEST(Calibration, HoldsTheNumbersOfTheRequest) {
  v1::View v = view();
  v1::Intrinsics& k = *v.mutable_intrinsics();
  k.set_fx(500), k.set_fy(501.25), k.set_cx(310.5), k.set_cy(1e-5);
  v.mutable_distortion()->set_model(v1::DISTORTION_MODEL_EQUIDISTANT);
  for (const double c : {-0.1, 2e-7, 0.0, 1e-3}) v.mutable_distortion()->add_coefficients(c);
  EXPECT_EQ(textOf("camera_info.yaml", v),
            "image_width: 640\nimage_height: 480\ncamera_name: cam0\n"
            "camera_matrix:\n  rows: 3\n  cols: 3\n"
            "  data: [500.0, 0.0, 310.5, 0.0, 501.25, 1.0e-05, 0.0, 0.0, 1.0]\n"
            "distortion_model: equidistant\n"
            "distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: [-0.1, 2.0e-07, 0.0, 0.001]\n"
            "rectification_matrix:\n  rows: 3\n  cols: 3\n"
            "  data: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\n"
            "projection_matrix:\n  rows: 3\n  cols: 4\n"
            "  data: [500.0, 0.0, 310.5, 0.0, 0.0, 501.25, 1.0e-05, 0.0, 0.0, 0.0, 1.0, 0.0]\n");
  EXPECT_TRUE(holds(textOf("cam_to_cam.yaml", v), "camera_matrix: [500.0, 501.25, 310.5, 1.0e-05]"));
  EXPECT_EQ(calibrationFiles("a.csv", streamOf(v)).size(), 2u);  // DSEC's belongs to its own format
}

TEST(Calibration, K3HasNoPlaceInKalibr) {
  v1::View v = view();
  v.mutable_distortion()->set_model(v1::DISTORTION_MODEL_RADTAN);
  for (const double c : {-0.1, 0.0, 0.0, 0.0, 0.0}) v.mutable_distortion()->add_coefficients(c);
  v1::OpenStream stream = streamOf(view());
  *stream.add_further_views() = v;
  EXPECT_EQ(calibrationFault(stream), "");
  stream.mutable_further_views(0)->mutable_distortion()->set_coefficients(4, 0.02);
  EXPECT_NE(calibrationFault(stream), "");
}

}  // namespace
}  // namespace saccade::client
