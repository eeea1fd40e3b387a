"""Files of calibrations. The texts are as the programs' own pages show them."""
import importlib.util
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import saccade
from saccade.protocol.request import make_request
from saccade.v1 import control_pb2 as c

# As cv::FileStorage writes it (docs.opencv.org, "Camera calibration With OpenCV").
OPENCV = """%YAML:1.0
---
calibration_time: "Thu Oct  6 10:12:11 2016"
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 6.5746697944293521e+002, 0., 3.1950000000000000e+002, 0.,
       6.5746697944293521e+002, 2.3950000000000000e+002, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -4.1802327176423804e-001, 5.0715244063187526e-001, 0., 0., -5.7843597214487474e-001 ]
"""
# github.com/ethz-asl/kalibr/wiki/yaml-formats, with a fisheye as second camera.
KALIBR = """cam0:
  camera_model: pinhole
  intrinsics: [461.629, 460.152, 362.680, 246.049]
  distortion_model: radtan
  distortion_coeffs: [-0.27695497, 0.06712482, 0.00087538, 1e-5]
  T_cam_imu:
  - [0.01779318, 0.99967549, -0.01822936, 0.07008565]
  - [-0.9998017, 0.01795239, 0.00860714, -0.01771023]
  - [0.00893160, 0.01807260, 0.99979678, 0.00399246]
  - [0.0, 0.0, 0.0, 1.0]
  timeshift_cam_imu: -8.121e-05
  rostopic: /cam0/image_raw
  resolution: [752, 480]
cam1:
  camera_model: pinhole
  intrinsics: [300, 301, 170, 131]
  distortion_model: equidistant
  distortion_coeffs: [0.1, 0.2, 0.3, 0.4]
  T_cn_cnm1: [[1, 0, 0, -0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
  resolution: [346, 260]
"""
# wiki.ros.org/camera_calibration_parsers
ROS = """image_width: 640
image_height: 480
camera_name: camera
camera_matrix:
  rows: 3
  cols: 3
  data: [438.783367, 0.000000, 305.593336, 0.000000, 437.302876, 243.738352, 0.000000, 0.000000, 1.000000]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.361976, 0.110510, 0.001014, 0.000505, 0.000000]
rectification_matrix:
  rows: 3
  cols: 3
  data: [0.999978, 0.002789, -0.006046, -0.002816, 0.999986, -0.004401, 0.006034, 0.004417, 0.999972]
"""


@unittest.skipUnless(importlib.util.find_spec("yaml"), "yaml is not installed")
class Files(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def write(self, text):
        path = self.folder / "cam.yaml"
        path.write_text(text, encoding="utf-8")
        return path

    def read(self, text, **more):
        camera = saccade.read_calibration(self.write(text), **more)
        return camera.size, camera.intrinsics, camera.distortion, camera.T_body_camera

    def test_opencv(self):
        radtan = ("radtan", (-0.41802327176423804, 0.50715244063187526, 0, 0, -0.57843597214487474))
        expected = ((640, 480), (657.46697944293521, 657.46697944293521, 319.5, 239.5), radtan, None)
        self.assertEqual(self.read(OPENCV), expected)
        matrix = saccade.read_calibration(self.folder / "cam.yaml").matrix
        np.testing.assert_array_equal(matrix, [[expected[1][0], 0, 319.5], [0, expected[1][1], 239.5], [0, 0, 1]])
        fisheye = OPENCV.replace("rows: 5", "rows: 4").replace(", -5.7843597214487474e-001", "") + "fisheye_model: 1\n"
        self.assertEqual(self.read(fisheye)[2], ("equidistant", radtan[1][:4]))

    def test_kalibr(self):
        size, intrinsics, distortion, place = self.read(KALIBR)
        self.assertEqual((size, intrinsics), ((752, 480), (461.629, 460.152, 362.680, 246.049)))
        self.assertEqual(distortion, ("radtan", (-0.27695497, 0.06712482, 0.00087538, 1e-5)))
        imu_to_camera = [[0.01779318, 0.99967549, -0.01822936, 0.07008565],
                         [-0.9998017, 0.01795239, 0.00860714, -0.01771023],
                         [0.00893160, 0.01807260, 0.99979678, 0.00399246], [0, 0, 0, 1]]
        np.testing.assert_allclose(place @ imu_to_camera, np.eye(4), atol=1e-5)
        self.assertEqual(self.read(KALIBR, camera=1), ((346, 260), (300, 301, 170, 131),
                                                       ("equidistant", (0.1, 0.2, 0.3, 0.4)), None))
        self.assertIsNone(self.read(KALIBR.replace("radtan", "none"))[2])

    def test_ros(self):
        expected = ((640, 480), (438.783367, 437.302876, 305.593336, 243.738352),
                    ("radtan", (-0.361976, 0.110510, 0.001014, 0.000505)), None)
        self.assertEqual(self.read(ROS), expected)
        fisheye = ROS.replace("plumb_bob", "equidistant").replace(", 0.000505, 0.000000", ", 0.000505")
        self.assertEqual(self.read(fisheye)[2], ("equidistant", expected[2][1]))

    def test_a_stream_takes_it(self):
        needed = {"scene": "room", "rate_hz": 100, "motion": "right", "truth": "imu"}
        path = self.write(KALIBR)
        by_path = make_request({**needed, "calibration": str(path), "metres_per_unit": 0.5})
        camera = saccade.read_calibration(path)
        self.assertEqual(by_path, make_request({**needed, "calibration": camera, "metres_per_unit": 0.5}))
        self.assertEqual(by_path, make_request({
            **needed, "metres_per_unit": 0.5, "size": (752, 480), "intrinsics": camera.intrinsics,
            "distortion": camera.distortion,
            "T_body_camera": [[*row[:3], 2 * row[3]] for row in camera.T_body_camera[:3]] + [[0, 0, 0, 1]]}))
        again = saccade.Camera.of(by_path.view)
        self.assertEqual((again.size, again.intrinsics, again.distortion),
                         (camera.size, camera.intrinsics, camera.distortion))
        np.testing.assert_allclose(again.T_body_camera[:3, 3], 2 * camera.T_body_camera[:3, 3])
        np.testing.assert_allclose(again.T_body_camera[:3, :3], camera.T_body_camera[:3, :3], atol=1e-6)
        own = make_request({**needed, "calibration": path, "size": (752, 480), "T_body_camera": (1, 2, 3)})
        self.assertEqual(own.view.body_camera, c.RigidTransform(position=c.Vector3(x=1, y=2, z=3)))
        with self.assertRaisesRegex(ValueError, r"size: \(6, 4\) is not that of the calibration, \(752, 480\)"):
            make_request({**needed, "calibration": path, "size": (6, 4)})
        with self.assertRaisesRegex(TypeError, "either calibration or intrinsics"):
            make_request({**needed, "calibration": path, "intrinsics": (1, 1, 1, 1)})

    def test_other_files_are_refused(self):
        for text, why in (("", "none of these: OpenCV.*Kalibr.*ROS"), ("- 1\n", "none of these"), ("a: [", "no YAML"),
                          ("[" * 1200, "no YAML"), ("%YAML:1.0\n---\nmat: !!opencv-matrix {rows: 1}", "none of these"),
                          ("a: !!python/object/apply:os.system [ls]", "no YAML"),
                          (ROS.replace("plumb_bob", "rational_polynomial"), "lens 'rational_polynomial' is not one of"),
                          (ROS.replace("0.000505, 0.0", "0.000505, 0.1, 0.2"), "4 or 5 coefficients, not 6"),
                          (ROS.replace("image_width", "width"), "image_width is not a finite number"),
                          (ROS.replace("640", "no"), "image_width is not"),
                          (ROS.replace("640", "[]"), "image_width is not"), (ROS.replace("640", "0.5"), "none of a picture"),
                          (ROS.replace("438.783367", ".nan"), "data is not 9 finite"),
                          (ROS.replace("438.783367, 0.0", "4, 0.1"), "skew"),
                          (ROS.replace("438.783367, 0.0", "4"), "data is not 9 finite"),
                          (ROS.replace("data", "date"), "data is not"),
                          (KALIBR.replace("pinhole", "omni"), "'omni' is not pinhole"),
                          (KALIBR.replace("- [0.0, 0.0, 0.0, 1.0]", "- [0.0, 0.0, 0.0, 2.0]"), "no rotation"),
                          (KALIBR.replace("[752, 480]", "[752]"), "resolution is not 2 finite"),
                          ("cam0: {camera_model: pinhole}", "resolution is not"),
                          ("camera_matrix: 5\ndistortion_coefficients: 6", "camera_matrix is no matrix"),
                          (KALIBR.replace("radtan", "[1]"), "lens"), (KALIBR.replace("radtan", "fov"), "lens 'fov'")):
            with self.subTest(why), self.assertRaisesRegex(saccade.FormatError, f"cam.yaml: .*{why}"):
                self.read(text)
        with self.assertRaisesRegex(saccade.FormatError, "no camera cam2; there are: cam0, cam1"):
            self.read(KALIBR, camera=2)
        (self.folder / "cam.yaml").write_bytes(b"\xff\xfe\x00")
        with self.assertRaisesRegex(saccade.FormatError, "cam.yaml"):
            saccade.read_calibration(self.folder / "cam.yaml")
        with self.assertRaises(FileNotFoundError):
            saccade.read_calibration(self.folder / "none.yaml")


class WithoutYaml(unittest.TestCase):
    def test_the_package_to_install_is_named(self):
        with unittest.mock.patch.dict(sys.modules, {"yaml": None}), self.assertRaisesRegex(ImportError, "python3-yaml"):
            saccade.read_calibration("cam.yaml")


if __name__ == "__main__":
    unittest.main()
