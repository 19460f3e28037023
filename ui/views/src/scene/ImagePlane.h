#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkImageData;
class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;
class vtkTexture;
class vtkUnsignedCharArray;

namespace insonate::views {

/// The ultrasound image at its position in the patient: a surface with the exact outline of the field of view, so that
/// the black around the image is not drawn.
class ImagePlane {
 public:
  explicit ImagePlane(vtkRenderer& renderer);
  ~ImagePlane();

  /// Sets the field of view; only its outline is shown until the next setImage().
  void setFieldOfView(const Probe& probe, const ImagingSettings& settings);
  /// Sets the image. Allocates memory only when the image's size changes.
  void setImage(const BModeImage& image);
  void setPose(vtkMatrix4x4* patientFromProbe);
  void setVisible(bool visible);

 private:
  void placeTexture();

  vtkRenderer& renderer_;
  vtkNew<vtkActor> sheet_, rim_;
  vtkNew<vtkPolyData> sheetData_, rimData_;
  vtkNew<vtkImageData> image_;
  vtkNew<vtkUnsignedCharArray> bytes_;
  vtkNew<vtkTexture> texture_;
  BModeImage shape_;  ///< size and position of the image, without pixels; empty before the first image
  bool visible_ = true;
};

}  // namespace insonate::views
