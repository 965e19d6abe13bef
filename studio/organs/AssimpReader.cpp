#include "studio/organs/AssimpReader.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <new>
#include <optional>
#include <string>

#include "studio/organs/FileFormatError.hpp"
#include "studio/organs/PlyReordering.hpp"
#include "studio/organs/StlHead.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

/// Names that assimp makes up where the file gives none.
bool is_given_name(const std::string& name) {
  static const std::array<std::string, 4> kMadeUp = {"defaultobject", "DefaultMaterial", "default", "ROOT"};
  return !name.empty() && name.front() != '<' && std::find(kMadeUp.begin(), kMadeUp.end(), name) == kMadeUp.end();
}

/// The reader's reasons quote the file, which may be binary.
std::string printable(std::string text) {
  for (char& character : text) {
    if (character < ' ' || character > '~') character = '?';
  }
  return text;
}

class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::string& file_name, const MeshFileLimits& limits)
      : scene_(scene), file_name_(file_name), limits_(limits) {}

  RawMesh read() {
    visit(*scene_.mRootNode, aiMatrix4x4());
    return std::move(mesh_);
  }

 private:
  void visit(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 placement = parent * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) add(*scene_.mMeshes[node.mMeshes[m]], node, placement);
    for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], placement);
  }

  void add(const aiMesh& part, const aiNode& node, const aiMatrix4x4& placement) {
    const int first_vertex = static_cast<int>(mesh_.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) mesh_.vertices.push_back(placed(part.mVertices[v], placement));
    const int part_index = static_cast<int>(mesh_.part_names.size());
    mesh_.part_names.push_back(names_of(part, node));
    for (unsigned f = 0; f < part.mNumFaces; ++f) add_face(part.mFaces[f], part.mNumVertices, first_vertex, part_index);
  }

  static Eigen::Vector3d placed(const aiVector3D& p, const aiMatrix4x4& m) {
    Eigen::Vector3d x(p.x, p.y, p.z);
    // Where nothing moves nothing is computed, so a coordinate that is no number does not spoil its neighbours.
    if (m == aiMatrix4x4()) return x;
    return {m.a1 * x[0] + m.a2 * x[1] + m.a3 * x[2] + m.a4, m.b1 * x[0] + m.b2 * x[1] + m.b3 * x[2] + m.b4,
            m.c1 * x[0] + m.c2 * x[1] + m.c3 * x[2] + m.c4};
  }

  void add_face(const aiFace& face, unsigned vertex_count, int first_vertex, int part_index) {
    if (face.mNumIndices != 3) return;  // points and lines
    Eigen::Vector3i triangle;
    for (int k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= vertex_count) {
        throw MeshFileError(
            fmt::format("a face has the corner {}, but there are {} vertices", face.mIndices[k], vertex_count));
      }
      triangle[k] = first_vertex + static_cast<int>(face.mIndices[k]);
    }
    if (static_cast<int>(mesh_.triangles.size()) == limits_.triangles) {
      throw MeshFileError(fmt::format("it has more than {} triangles, which is the most that is read; reduce it first",
                                      limits_.triangles));
    }
    mesh_.triangles.push_back(triangle);
    mesh_.parts.push_back(part_index);
  }

  std::vector<std::string> names_of(const aiMesh& part, const aiNode& node) const {
    std::vector<std::string> names;
    const auto add_name = [&](const std::string& name) {
      if (is_given_name(name) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    if (node.mName.C_Str() != file_name_) add_name(node.mName.C_Str());
    add_name(part.mName.C_Str());
    if (part.mMaterialIndex < scene_.mNumMaterials) {
      add_name(scene_.mMaterials[part.mMaterialIndex]->GetName().C_Str());
    }
    return names;
  }

  const aiScene& scene_;
  const std::string file_name_;  // some readers name the whole scene so
  const MeshFileLimits& limits_;
  RawMesh mesh_;
};

bool has_extension(const std::filesystem::path& file, const char* lowercase) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return extension == lowercase;
}

/// A binary STL file that holds another number of triangles than its head announces, which assimp takes for text or for
/// nothing it knows. Throws MeshFileError.
void refuse_cut_off_stl(const std::filesystem::path& file) {
  const std::optional<StlHead> head = binary_stl_head(file);
  if (!head || head->announced == head->present) return;
  throw MeshFileError(fmt::format(
      "its head announces {} triangles, and {} are there: it is cut off, or no binary STL; copy it anew, or "
      "save it anew from a modelling program",
      head->announced, head->present));
}

const aiScene* scene_of(Assimp::Importer& importer, const std::filesystem::path& file, const MeshFileLimits& limits) {
  if (has_extension(file, ".ply")) {
    try {
      const std::optional<std::string> bytes = reordered_ply(file, limits.file_bytes);
      if (bytes) return importer.ReadFileFromMemory(bytes->data(), bytes->size(), aiProcess_Triangulate, "ply");
    } catch (const FileFormatError& error) {
      throw MeshFileError(error.what());
    }
  }
  if (const std::optional<std::string> bytes = shortened_stl(file)) {
    return importer.ReadFileFromMemory(bytes->data(), bytes->size(), aiProcess_Triangulate, "stl");
  }
  return importer.ReadFile(file.string(), aiProcess_Triangulate);
}

}  // namespace

RawMesh read_with_assimp(const std::filesystem::path& file, const MeshFileLimits& limits) {
  Assimp::Importer importer;
  const aiScene* scene = scene_of(importer, file, limits);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string extension = file.extension().string();
    if (!importer.IsExtensionSupported(extension)) {
      throw MeshFileError(
          fmt::format("{} is no mesh format that can be read; OBJ, PLY, STL, OFF and glTF are the common ones",
                      extension.empty() ? "a name without an extension" : in_backticks(extension)));
    }
    const std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    refuse_cut_off_stl(file);
    if (reason.starts_with("No suitable reader")) {
      throw MeshFileError(fmt::format("what it holds is not {}, or is cut off", in_backticks(extension)));
    }
    throw MeshFileError(fmt::format("it is malformed: {}", printable(reason)));
  }
  RawMesh mesh = SceneReader(*scene, file.filename().string(), limits).read();
  if (mesh.triangles.empty()) {
    refuse_cut_off_stl(file);
    throw MeshFileError(mesh.vertices.empty() ? "it holds no triangles"
                                              : "it holds points or lines, but no triangles or polygons");
  }
  return mesh;
}

}  // namespace thinwall
