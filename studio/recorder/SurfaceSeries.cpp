#include "studio/recorder/SurfaceSeries.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>

#include "renderer/image/Folder.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

/// XML's own signs in a text of the user.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

/// The arrays behind the XML: each as its size in bytes (uint64) and its data.
class Appended {
 public:
  /// The XML element of an array whose data are appended.
  template <typename Number>
  std::string array(const std::string& type, const std::string& name, int components, std::span<const Number> values) {
    const std::size_t offset = data_.size();
    const std::uint64_t bytes = values.size_bytes();
    data_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    data_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    return fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
                       type, escaped(name), components, offset);
  }
  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

std::string name_with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

}  // namespace

std::string vtk_poly_data(const SnapshotSurface& surface) {
  const SnapshotTopology& topology = *surface.topology;
  Appended appended;
  std::string of_points;
  std::string of_cells = appended.array("Float32", name_with_unit("thickness_at_rest", "m"), 1,
                                        std::span<const float>(topology.thickness));
  for (const SnapshotField& field : surface.fields) {
    std::string& elements = field.location == FieldLocation::kVertex ? of_points : of_cells;
    elements +=
        appended.array("Float32", name_with_unit(field.name, field.unit), 1, std::span<const float>(field.values));
  }
  const std::string points = appended.array(
      "Float32", "Points", 3, std::span<const float>(surface.positions.front().data(), 3 * surface.positions.size()));
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  for (const Triangle& triangle : topology.triangles) {
    connectivity.insert(connectivity.end(), triangle.begin(), triangle.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  const std::string polys = appended.array("Int64", "connectivity", 1, std::span<const std::int64_t>(connectivity)) +
                            appended.array("Int64", "offsets", 1, std::span<const std::int64_t>(offsets));
  return fmt::format(
             R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="{}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{}">
<PointData>{}</PointData><CellData>{}</CellData><Points>{}</Points><Polys>{}</Polys>
</Piece></PolyData><AppendedData encoding="raw">_)",
             surface.positions.size(), topology.triangles.size(), of_points, of_cells, points, polys) +
         appended.data() + "</AppendedData></VTKFile>\n";
}

SurfaceSeries::SurfaceSeries(const std::filesystem::path& folder) : target_(folder / "surfaces") {
  make_folder(unfinished_name(target_));
}

void SurfaceSeries::write(const Snapshot& snapshot) {
  for (std::size_t part = 0; part < snapshot.surfaces.size(); ++part) {
    const std::string file = fmt::format("body_{}_{:06}.vtp", part, frames_);
    write_whole_file(unfinished_name(target_) / file, vtk_poly_data(snapshot.surfaces[part]));
    entries_.push_back({.time = snapshot.time, .part = part, .file = file});
  }
  ++frames_;
}

void SurfaceSeries::finish() {
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\"><Collection>\n";
  for (const Entry& entry : entries_) {
    collection +=
        fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", entry.time, entry.part, entry.file);
  }
  write_whole_file(unfinished_name(target_) / "surfaces.pvd", collection + "</Collection></VTKFile>\n");
  rename_folder(unfinished_name(target_), target_);
}

}  // namespace thinwall
