#include "ImageQuad.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>
#include <vtkUnsignedCharArray.h>

namespace insonate::views {

ImageQuad::ImageQuad(vtkRenderer& renderer, int components, bool interpolate)
    : renderer_(renderer), components_(components) {
  bytes_->SetNumberOfComponents(components);
  image_->SetDimensions(1, 1, 1);
  bytes_->SetNumberOfTuples(1);
  bytes_->Fill(0);
  image_->GetPointData()->SetScalars(bytes_);
  texture_->SetInputData(image_);
  texture_->SetInterpolate(interpolate);
  texture_->SetColorModeToDirectScalars();
  texture_->SetRepeat(false);
  texture_->SetEdgeClamp(true);

  corners_->SetNumberOfPoints(4);
  for (int k = 0; k < 4; ++k) corners_->SetPoint(k, 0, 0, 0);
  coordinates_->SetNumberOfComponents(2);
  coordinates_->SetNumberOfTuples(4);
  coordinates_->Fill(0);
  vtkNew<vtkCellArray> quad;
  const vtkIdType ids[4] = {0, 1, 2, 3};
  quad->InsertNextCell(4, ids);
  vtkNew<vtkPolyData> data;
  data->SetPoints(corners_);
  data->SetPolys(quad);
  data->GetPointData()->SetTCoords(coordinates_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  actor_->SetMapper(mapper);
  actor_->SetTexture(texture_);
  actor_->SetLayerNumber(0);
  actor_->SetVisibility(false);
  renderer_.AddActor2D(actor_);
}

ImageQuad::~ImageQuad() {
  renderer_.RemoveActor2D(actor_);
}

std::span<std::uint8_t> ImageQuad::picture(int width, int height) {
  int size[3];
  image_->GetDimensions(size);
  if (size[0] != width || size[1] != height) {
    image_->SetDimensions(width, height, 1);
    bytes_->SetNumberOfTuples(vtkIdType(width) * height);
  }
  return {bytes_->GetPointer(0), std::size_t(width) * height * components_};
}

void ImageQuad::pictureChanged() {
  bytes_->Modified();
  image_->Modified();
}

void ImageQuad::place(DisplayPoint topLeft, DisplayPoint bottomRight, int height_px, const Part& part) {
  const double top = height_px - topLeft.y, bottom = height_px - bottomRight.y;
  corners_->SetPoint(0, topLeft.x, bottom, 0);
  corners_->SetPoint(1, bottomRight.x, bottom, 0);
  corners_->SetPoint(2, bottomRight.x, top, 0);
  corners_->SetPoint(3, topLeft.x, top, 0);
  corners_->Modified();
  // Texture rows are counted from the top row of the image.
  coordinates_->SetTuple2(0, part.left, part.bottom);
  coordinates_->SetTuple2(1, part.right, part.bottom);
  coordinates_->SetTuple2(2, part.right, part.top);
  coordinates_->SetTuple2(3, part.left, part.top);
  coordinates_->Modified();
}

void ImageQuad::show(bool visible) {
  actor_->SetVisibility(visible);
}

void ImageQuad::setBrightness(double factor) {
  actor_->GetProperty()->SetColor(factor, factor, factor);
}

}  // namespace insonate::views
