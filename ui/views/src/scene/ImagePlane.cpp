#include "ImagePlane.h"

#include "../ultrasound/FanOutline.h"

#include <insonate/views/Theme.h>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>

namespace insonate::views {

ImagePlane::ImagePlane(vtkRenderer& renderer) : renderer_(renderer) {
  bytes_->SetNumberOfComponents(1);
  bytes_->SetNumberOfTuples(1);
  bytes_->SetValue(0, 0);
  image_->SetDimensions(1, 1, 1);
  image_->GetPointData()->SetScalars(bytes_);
  texture_->SetInputData(image_);
  texture_->SetColorModeToDirectScalars();
  texture_->InterpolateOn();
  texture_->RepeatOff();
  texture_->EdgeClampOn();

  vtkNew<vtkPolyDataMapper> sheetMapper, rimMapper;
  sheetMapper->SetInputData(sheetData_);
  rimMapper->SetInputData(rimData_);
  sheet_->SetMapper(sheetMapper);
  sheet_->SetTexture(texture_);
  // The image keeps its gray values: shading would change their meaning.
  sheet_->GetProperty()->LightingOff();
  rim_->SetMapper(rimMapper);
  rim_->GetProperty()->LightingOff();
  rim_->GetProperty()->SetColor(theme::kAccent.red / 255.0, theme::kAccent.green / 255.0, theme::kAccent.blue / 255.0);
  rim_->GetProperty()->SetLineWidth(1.5F);
  renderer_.AddActor(sheet_);
  renderer_.AddActor(rim_);
}

ImagePlane::~ImagePlane() {
  renderer_.RemoveActor(sheet_);
  renderer_.RemoveActor(rim_);
}

void ImagePlane::setFieldOfView(const Probe& probe, const ImagingSettings& settings) {
  const std::vector<PlanePoint> strip = fieldOfViewStrip(probe, settings),
                                outline = fieldOfViewOutline(probe, settings);
  vtkNew<vtkPoints> points, rim;
  vtkNew<vtkCellArray> cells, lines;
  for (const PlanePoint& point : strip) points->InsertNextPoint(point.lateral_mm, 0, point.axial_mm);
  for (vtkIdType k = 0; k + 3 < points->GetNumberOfPoints(); k += 2) {
    const vtkIdType quad[4] = {k, k + 1, k + 3, k + 2};
    cells->InsertNextCell(4, quad);
  }
  lines->InsertNextCell(static_cast<int>(outline.size()) + 1);
  for (const PlanePoint& point : outline)
    lines->InsertCellPoint(rim->InsertNextPoint(point.lateral_mm, 0, point.axial_mm));
  lines->InsertCellPoint(0);
  sheetData_->SetPoints(points);
  sheetData_->SetPolys(cells);
  rimData_->SetPoints(rim);
  rimData_->SetLines(lines);
  // The present image has another field of view.
  shape_ = {};
  setVisible(visible_);
}

void ImagePlane::placeTexture() {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType k = 0; k < sheetData_->GetNumberOfPoints(); ++k) {
    const double* point = sheetData_->GetPoint(k);
    coordinates->InsertNextTuple2(((point[0] - shape_.left_mm) / shape_.pixel_mm + 0.5) / shape_.width,
                                  ((point[2] - shape_.top_mm) / shape_.pixel_mm + 0.5) / shape_.height);
  }
  sheetData_->GetPointData()->SetTCoords(coordinates);
}

void ImagePlane::setImage(const BModeImage& image) {
  const std::size_t count = std::size_t(image.width) * image.height;
  if (count == 0 || image.gray.size() != count || !(image.pixel_mm > 0)) return;
  const bool moved = image.width != shape_.width || image.height != shape_.height ||
                     image.pixel_mm != shape_.pixel_mm || image.left_mm != shape_.left_mm ||
                     image.top_mm != shape_.top_mm;
  if (moved) {
    image_->SetDimensions(image.width, image.height, 1);
    bytes_->SetNumberOfTuples(static_cast<vtkIdType>(count));
    shape_.width = image.width, shape_.height = image.height, shape_.pixel_mm = image.pixel_mm;
    shape_.left_mm = image.left_mm, shape_.top_mm = image.top_mm;
    placeTexture();
  }
  std::memcpy(bytes_->GetPointer(0), image.gray.data(), count);
  bytes_->Modified();
  image_->Modified();
  setVisible(visible_);
}

void ImagePlane::setPose(vtkMatrix4x4* patientFromProbe) {
  sheet_->SetUserMatrix(patientFromProbe);
  rim_->SetUserMatrix(patientFromProbe);
}

void ImagePlane::setVisible(bool visible) {
  visible_ = visible;
  sheet_->SetVisibility(visible && shape_.width > 0);
  rim_->SetVisibility(visible);
}

}  // namespace insonate::views
