#include "MeshParts.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/surface/MeshFile.h>

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace insonate {
namespace fs = std::filesystem;
namespace {

/// Writes VTK's own format (VTP, compressed) with normals; a field SPACE holds "LPS", which 3D Slicer reads. False
/// where the file cannot be written.
bool writeVtp(const Mesh& mesh, const std::filesystem::path& file) {
  vtkNew<vtkFloatArray> coordinates, normals;
  const auto fill = [](vtkFloatArray& array, const std::vector<float>& values) {
    array.SetNumberOfComponents(3);
    array.SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
    std::ranges::copy(values, array.GetPointer(0));
  };
  fill(*coordinates, mesh.points_mm);
  fill(*normals, mesh.normals);
  normals->SetName("Normals");
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    triangles->InsertNextCell({mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]});
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("LPS");
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->GetPointData()->SetNormals(normals);
  surface->GetFieldData()->AddArray(space);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->GlobalWarningDisplayOff();
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  return writer->Write() == 1 && writer->GetErrorCode() == 0;
}

static_assert(std::endian::native == std::endian::little, "STL and PLY are written as the numbers lie in memory");

constexpr std::string_view kSaysSpace = "SPACE=LPS";

/// Collects bytes and writes them in large pieces.
class Output {
 public:
  explicit Output(const fs::path& file) : stream_(file, std::ios::binary) {}

  void text(std::string_view text) {
    bytes_ += text;
    if (bytes_.size() > kPiece) flush();
  }
  template <class T>
  void binary(const T* values, std::size_t count) {
    text({reinterpret_cast<const char*>(values), count * sizeof(T)});
  }
  /// The shortest digits that read back as the same number.
  template <class T>
  void number(T value) {
    char digits[32];
    text({digits, std::to_chars(digits, digits + sizeof digits, value).ptr});
  }
  bool close() {
    flush();
    stream_.close();
    return !stream_.fail();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 20;
  void flush() {
    stream_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    bytes_.clear();
  }
  std::ofstream stream_;
  std::string bytes_;
};

void writeStl(const Mesh& mesh, Output& out) {
  std::string header = "Insonate ";
  header.append(kSaysSpace).append(" UNIT=mm").resize(80, ' ');
  out.text(header);
  const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
  out.binary(&count, 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t* corner = &mesh.triangles[t];
    const Vec3 a = pointOf(mesh.points_mm, corner[0]);
    const Vec3 twiceArea = cross(pointOf(mesh.points_mm, corner[1]) - a, pointOf(mesh.points_mm, corner[2]) - a);
    const double length = norm(twiceArea);
    const Vec3 normal = length > 0 ? twiceArea / length : Vec3{};
    const float facet[3] = {float(normal.x), float(normal.y), float(normal.z)};
    out.binary(facet, 3);
    for (int c = 0; c < 3; ++c) out.binary(&mesh.points_mm[3 * corner[c]], 3);
    constexpr std::uint16_t kNoAttributes = 0;
    out.binary(&kNoAttributes, 1);
  }
}

void writePly(const Mesh& mesh, Output& out) {
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment Insonate, millimeters\ncomment ";
  header.append(kSaysSpace).append("\nelement vertex ").append(std::to_string(mesh.pointCount()));
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"}) header.append("\nproperty float ").append(property);
  header.append("\nelement face ").append(std::to_string(mesh.triangleCount()));
  out.text(header + "\nproperty list uchar uint vertex_indices\nend_header\n");
  for (std::size_t p = 0; p < mesh.points_mm.size(); p += 3) {
    out.binary(&mesh.points_mm[p], 3);
    out.binary(&mesh.normals[p], 3);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    out.text("\x03");
    out.binary(&mesh.triangles[t], 3);
  }
}

void writeObj(const Mesh& mesh, Output& out) {
  out.text(std::string("# Insonate, millimeters\n# ").append(kSaysSpace).append("\n"));
  for (const auto& [word, values] : {std::pair{"v", &mesh.points_mm}, {"vn", &mesh.normals}})
    for (std::size_t p = 0; p < values->size(); p += 3) {
      out.text(word);
      for (std::size_t a = p; a < p + 3; ++a) out.text(" "), out.number((*values)[a]);
      out.text("\n");
    }
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    out.text("f");
    for (std::size_t c = t; c < t + 3; ++c) {
      const std::uint64_t number = std::uint64_t(mesh.triangles[c]) + 1;  // OBJ counts from one
      out.text(" "), out.number(number), out.text("//"), out.number(number);
    }
    out.text("\n");
  }
}

Result<void> checkMesh(const fs::path& file, const Mesh& mesh) {
  if (mesh.triangles.empty())
    return fail("The mesh has no triangles, so nothing was written to " + file.string() + ": no triangles.");
  const bool whole = mesh.points_mm.size() % 3 == 0 && mesh.triangles.size() % 3 == 0;
  if (!whole || mesh.normals.size() != mesh.points_mm.size() || std::ranges::max(mesh.triangles) >= mesh.pointCount())
    return fail("The mesh for " + file.string() + " is inconsistent: its points, normals and triangles do not agree.");
  return {};
}

}  // namespace

Result<void> writeMesh(const fs::path& file, const Mesh& mesh) {
  const std::string extension = file.extension().string();
  void (*write)(const Mesh&, Output&) = extension == ".stl"   ? writeStl
                                        : extension == ".ply" ? writePly
                                        : extension == ".obj" ? writeObj
                                                              : nullptr;
  if (!write && extension != ".vtp")
    return fail(file.string() +
                " is not a mesh format that Insonate can write. Use a name that ends in .stl, .ply, .obj or .vtp.");
  if (auto ok = checkMesh(file, mesh); !ok) return ok;
  return writeAtomically(file, [&](const fs::path& beside) -> Result<void> {
    bool written = false;
    if (write) {
      Output out(beside);
      write(mesh, out);
      written = out.close();
    } else {
      written = writeVtp(mesh, beside);
    }
    if (!written)
      return fail("Could not write " + file.string() +
                  ": the disk is full or the folder cannot be written. Free space or choose another folder.");
    return {};
  });
}

}  // namespace insonate
