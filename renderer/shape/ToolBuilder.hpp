#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/shape/ToolShape.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

constexpr float kPolished = 0.10f;  // roughness of a ball or a tip
constexpr float kBrushed = 0.24f;   // of a shaft

/// A point of an outline: `back` metres from the tip against the direction, `out` metres from the middle.
struct OutlinePoint {
  double back = 0;
  double out = 0;
  double normal_back = 0;  // outward normal in the same plane, not of length one
  double normal_out = 1;
  float roughness = kBrushed;  // below 0 that of a flat face
  float grip = 0;              // as of ToolVertex
};

/// A section of a flat tool across its direction: a rectangle, its corners ground off.
struct FlatSection {
  double back = 0;            // metres from the tip
  double middle = 0;          // metres along x' from the middle line
  double half_thickness = 0;  // metres, along x'
  double half_width = 0;      // metres, along y'
  float roughness = kBrushed;
  float grip = 0;      // of its broad faces, from the section before on
  double chamfer = 0;  // metres, along both faces at an edge; zero: parts of them as handles have
};

/// Puts the shape of a tool together where the tool is.
class ToolBuilder {
 public:
  /// `scene_size`: metres, of which grooves of handles are parts.
  ToolBuilder(const SnapshotTool& tool, double scene_size);

  /// The surface that `outline` sweeps around the line through the tip along the direction.
  void turn(const std::vector<OutlinePoint>& outline);

  /// The closed `outline` drawn out along the axis, centred on the tip, with flat ends.
  void draw_out(const std::vector<OutlinePoint>& outline, double span);

  /// The flat faces between sections, from the tip backwards, and those that close both ends.
  void join(const std::vector<FlatSection>& sections);

  /// A face with the given corners, one after the other, and outward normals, not of length one; both along x', along
  /// y' and backwards, from the tip. It counts as flat. `shade`: part of the light that parts close to a corner take.
  void add_quad(const std::array<Vector3, 4>& corners, const std::array<Vector3, 4>& normals, float roughness,
                const std::array<float, 4>& shade = {});

  /// Likewise a narrow side between two broad ones: from the first corner to the second it is as wide as these are
  /// apart, and these lean there by `hollow`.
  void add_narrow_quad(const std::array<Vector3, 4>& corners, const std::array<Vector3, 4>& normals, float roughness,
                       double hollow, float broad_roughness);

  /// Rods stand for the tool in shade and reflections: one along the direction, and one along the axis.
  void add_rod(double back_from, double back_to, double radius);
  void add_rod_along_axis(double back, double span, double radius);

  void add(const ToolShape& other);

  ToolShape take();

 private:
  Vector3 turned(Vector3 local) const;
  Vector3 place(const OutlinePoint& point, double along_axis) const;
  void append_face(const std::array<Vector3, 4>& corners, Vector3 front, Vector3 rear, const FlatSection& section,
                   bool is_broad);
  void shown_as_beside(const std::array<Vector3, 4>& corners, Vector3 own, Vector3 next, float roughness);
  void append(Vector3 position, Vector3 normal, const OutlinePoint& point);
  void append_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void stitch(std::uint32_t first, std::uint32_t rows, std::uint32_t columns);
  void add_rod(Vector3 start, Vector3 end, double radius);

  Vector3 tip_;
  Vector3 direction_;
  Vector3 axis_;
  Vector3 side_;
  double scene_size_;
  ToolShape shape_;
};

}  // namespace thinwall
