#include "MeshVtp.h"

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

namespace insonate {

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

}  // namespace insonate
