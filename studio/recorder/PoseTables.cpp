#include "studio/recorder/PoseTables.hpp"

#include <fmt/format.h>

#include <array>

namespace thinwall {
namespace {

/// Focal lengths and principal point, pixels from the middle of the first one.
struct CameraMatrix {
  double fx = 0, fy = 0, cx = 0, cy = 0;
};

CameraMatrix camera_matrix(const Camera& camera, const PictureBox& box) {
  return {.fx = 0.5 * box.size.width / camera.tangent_x,
          .fy = 0.5 * box.size.height / camera.tangent_y,
          .cx = box.left + 0.5 * (box.size.width - 1),
          .cy = box.top + 0.5 * (box.size.height - 1)};
}

/// Radial and tangential coefficients in OpenCV's order k1, k2, p1, p2, k3.
std::array<double, 5> distortion(const Camera& camera) {
  const LensDistortion& lens = camera.lens.distortion();
  return {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
}

std::string intrinsics_text(const Camera& camera, const PicturePart& part) {
  const CameraMatrix k = camera_matrix(camera, part.own);
  const auto [k1, k2, p1, p2, k3] = distortion(camera);
  return fmt::format(
      "%YAML:1.0\n---\nimage_width: {}\nimage_height: {}\n"
      "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
      "   data: [ {:.17g}, 0., {:.17g}, 0., {:.17g}, {:.17g}, 0., 0., 1. ]\n"
      "distortion_coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n"
      "   data: [ {:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g} ]\n",
      part.picture.width, part.picture.height, k.fx, k.cx, k.fy, k.cy, k1, k2, p1, p2, k3);
}

std::string numbers(const Double3& values) {
  return fmt::format(",{:.17g},{:.17g},{:.17g}", values[0], values[1], values[2]);
}

/// A name as a cell: in quotation marks where commas or quotation marks are in it.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

}  // namespace

PoseTables::PoseTables()
    : cameras_(
          "frame,time_s,fx_px,fy_px,cx_px,cy_px,r11,r12,r13,r21,r22,r23,r31,r32,r33,t1_m,t2_m,t3_m,"
          "k1,k2,p1,p2,k3\n"),
      tools_(
          "frame,time_s,tool,kind,phase,x_m,y_m,z_m,direction_x,direction_y,direction_z,axis_x,axis_y,axis_z,fx_N,fy_N,"
          "fz_N,opening_m,in_picture\n") {}

void PoseTables::add(std::size_t frame, double time, const Camera& camera, const PicturePart& part,
                     const std::vector<SnapshotTool>& tools) {
  if (intrinsics_.empty()) intrinsics_ = intrinsics_text(camera, part);
  const CameraMatrix k = camera_matrix(camera, part.own);
  const std::array<Vector3, 3> rows = {camera.right, -camera.up, camera.forward};
  cameras_ += fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", frame, time, k.fx, k.fy, k.cx, k.cy);
  for (const Vector3& row : rows) cameras_ += numbers({row.x, row.y, row.z});
  cameras_ += numbers({-dot(rows[0], camera.position), -dot(rows[1], camera.position), -dot(rows[2], camera.position)});
  for (const double coefficient : distortion(camera)) cameras_ += fmt::format(",{:.17g}", coefficient);
  cameras_ += '\n';
  for (const SnapshotTool& tool : tools) {
    tools_ += fmt::format("{},{:.17g},{},{},{}", frame, time, cell(tool.name),
                          kSnapshotToolKindNames.at(static_cast<std::size_t>(tool.kind)), tool.phase);
    for (const Double3& values : {tool.tip, tool.direction, tool.axis, tool.force}) tools_ += numbers(values);
    tools_ += fmt::format(",{:.17g},{}\n", tool.opening, tool.is_set_aside ? 0 : 1);
  }
}

}  // namespace thinwall
