#include "MeshProbe.h"
#include "support/TestData.h"

#include <insonate/surface/MeshFile.h>

#include <gmock/gmock.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using test::bytesOf;
using testing::ElementsAre;
using testing::HasSubstr;

template <class T>
T numberAt(const std::string& bytes, std::size_t offset) {
  T value{};
  EXPECT_LE(offset + sizeof value, bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// Two voxels side by side, oblique in nothing, far from the origin.
Mesh sample() {
  LabelMap labels = emptyMap(6, 6, 6);
  labels.geometry.origin_mm = {-120.25, 80.5, 900};
  addBox(labels, 3, {2, 2, 2}, {3, 2, 2});
  return surfaceOf(labels, 3, {.smoothing_mm = 0, .detail_mm = 0});
}

class MeshFile : public testing::Test {
 protected:
  fs::path file(const std::string& name) const { return folder_ / name; }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) names.push_back(entry.path().filename());
    return names;
  }
  const Mesh mesh_ = sample();
  TemporaryFolder folder_;
};

TEST_F(MeshFile, StlReadsBackAsItsTriangles) {
  const auto written = writeMesh(file("a.stl"), mesh_);
  ASSERT_TRUE(written) << written.error().message;
  const std::string bytes = bytesOf(file("a.stl"));
  EXPECT_THAT(bytes.substr(0, 80), HasSubstr("SPACE=LPS"));
  EXPECT_NE(bytes.substr(0, 5), "solid") << "which would make it a text file";
  const auto count = numberAt<std::uint32_t>(bytes, 80);
  ASSERT_EQ(count, mesh_.triangleCount());
  ASSERT_EQ(bytes.size(), 84 + 50 * std::size_t(count));
  for (std::size_t t = 0; t < count; ++t) {
    Vec3 facet[4];  // normal, three corners
    for (int n = 0; n < 12; ++n) facet[n / 3][n % 3] = numberAt<float>(bytes, 84 + 50 * t + 4 * n);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(facet[1 + c], point(mesh_.points_mm, mesh_.triangles[3 * t + c]));
    const Vec3 across = normalized(cross(facet[2] - facet[1], facet[3] - facet[1]));
    EXPECT_GT(dot(across, facet[0]), 0.999) << "the normal follows the corners";
    EXPECT_GT(dot(facet[0], facet[1] - centroid(mesh_)), 0) << "and points outward";
  }
}

TEST_F(MeshFile, PlyReadsBackAsItsPointsNormalsAndTriangles) {
  ASSERT_TRUE(writeMesh(file("a.ply"), mesh_));
  const std::string bytes = bytesOf(file("a.ply"));
  const std::size_t body = bytes.find("end_header\n") + std::strlen("end_header\n");
  EXPECT_THAT(bytes.substr(0, body),
              AllOf(HasSubstr("SPACE=LPS"), HasSubstr("element vertex " + std::to_string(mesh_.pointCount()) + "\n"),
                    HasSubstr("element face " + std::to_string(mesh_.triangleCount()) + "\n")));
  ASSERT_EQ(bytes.size(), body + 24 * mesh_.pointCount() + 13 * mesh_.triangleCount());
  for (std::size_t c = 0; c < mesh_.points_mm.size(); ++c) {
    const std::size_t at = body + 24 * (c / 3) + 4 * (c % 3);
    EXPECT_EQ(numberAt<float>(bytes, at), mesh_.points_mm[c]);
    EXPECT_EQ(numberAt<float>(bytes, at + 12), mesh_.normals[c]);
  }
  for (std::size_t c = 0; c < mesh_.triangles.size(); ++c) {
    const std::size_t at = body + 24 * mesh_.pointCount() + 13 * (c / 3);
    EXPECT_EQ(bytes[at], 3);
    EXPECT_EQ(numberAt<std::uint32_t>(bytes, at + 1 + 4 * (c % 3)), mesh_.triangles[c]);
  }
}

TEST_F(MeshFile, ObjReadsBackAsItsPointsNormalsAndTriangles) {
  ASSERT_TRUE(writeMesh(file("a.obj"), mesh_));
  std::ifstream in(file("a.obj"));
  Mesh read;
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    words >> word;
    for (float value; word[0] == 'v' && words >> value;) (word == "v" ? read.points_mm : read.normals).push_back(value);
    char slash = 0;
    for (std::uint32_t at = 0, normal = 0; word == "f" && words >> at >> slash >> slash >> normal;) {
      EXPECT_EQ(at, normal);
      read.triangles.push_back(at - 1);
    }
  }
  EXPECT_EQ(read.points_mm, mesh_.points_mm);
  EXPECT_EQ(read.normals, mesh_.normals);
  EXPECT_EQ(read.triangles, mesh_.triangles);
}

TEST_F(MeshFile, VtpReadsBackAsItsPointsNormalsAndTriangles) {
  ASSERT_TRUE(writeMesh(file("a.vtp"), mesh_));
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file("a.vtp").c_str());
  reader->Update();
  vtkPolyData& read = *reader->GetOutput();
  ASSERT_EQ(read.GetNumberOfPoints(), static_cast<vtkIdType>(mesh_.pointCount()));
  ASSERT_EQ(read.GetNumberOfCells(), static_cast<vtkIdType>(mesh_.triangleCount()));
  for (std::size_t c = 0; c < mesh_.points_mm.size(); ++c) {
    const auto at = static_cast<vtkIdType>(c / 3);
    EXPECT_EQ(static_cast<float>(read.GetPoint(at)[c % 3]), mesh_.points_mm[c]);
    EXPECT_EQ(static_cast<float>(read.GetPointData()->GetNormals()->GetTuple(at)[c % 3]), mesh_.normals[c]);
  }
  for (std::size_t c = 0; c < mesh_.triangles.size(); ++c)
    EXPECT_EQ(read.GetCell(static_cast<vtkIdType>(c / 3))->GetPointId(static_cast<int>(c % 3)), mesh_.triangles[c]);
  auto* space = vtkStringArray::SafeDownCast(read.GetFieldData()->GetAbstractArray("SPACE"));
  ASSERT_TRUE(space);
  EXPECT_EQ(space->GetValue(0), "LPS");
}

TEST_F(MeshFile, RefusalsLeaveWhatWasThere) {
  std::ofstream(file("old.stl")) << "old";
  Mesh broken = mesh_;
  broken.triangles[4] = static_cast<std::uint32_t>(mesh_.pointCount());
  const auto refusal = [&](const std::string& name, const Mesh& mesh) {
    const auto written = writeMesh(file(name), mesh);
    EXPECT_FALSE(written) << name;
    return written ? "" : written.error().message;
  };
  EXPECT_THAT(refusal("old.stl", broken), HasSubstr("inconsistent"));
  EXPECT_THAT(refusal("old.stl", Mesh{}), HasSubstr("no triangles"));
  EXPECT_THAT(refusal("a.vtk", mesh_), HasSubstr(".stl, .ply, .obj or .vtp"));
  EXPECT_THAT(refusal("none/a.stl", mesh_), HasSubstr("does not exist"));
  EXPECT_EQ(bytesOf(file("old.stl")), "old");
  EXPECT_THAT(files(), ElementsAre("old.stl"));
}

}  // namespace
}  // namespace insonate::test
