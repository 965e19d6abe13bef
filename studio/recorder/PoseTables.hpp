#pragma once

#include <string>

#include "renderer/camera/Camera.hpp"
#include "renderer/ground_truth/Projection.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Where cameras and tools were, as CSV, and the first camera's matrix and lens as OpenCV reads them.
class PoseTables {
 public:
  PoseTables();
  void add(std::size_t frame, double time, const Camera& camera, const PicturePart& part,
           const std::vector<SnapshotTool>& tools);

  /// `frame,time_s,fx_px,fy_px,cx_px,cy_px,r11,...,r33,t1_m,t2_m,t3_m,k1,k2,p1,p2,k3`: x' = R x + t takes the world to
  /// the camera's axes (x to the right, y down, z along the line of sight), in OpenCV's way; its lens bends x'/z',
  /// y'/z' (LensDistortion). A frame's row tells all of its camera, which cuts and keyframes change.
  const std::string& cameras() const { return cameras_; }

  /// `frame,time_s,tool,kind,phase,x_m,...,fz_N,opening_m,in_picture`: tip, direction and y' of the tool's frame, the
  /// force on it, how far the jaws of forceps are apart (0 for others), and 0 where it is set aside, else 1.
  const std::string& tools() const { return tools_; }

  /// Of the first frame alone, for cv::FileStorage: image_width, image_height, camera_matrix, distortion_coefficients.
  const std::string& intrinsics() const { return intrinsics_; }

 private:
  std::string cameras_;
  std::string tools_;
  std::string intrinsics_;
};

}  // namespace thinwall
