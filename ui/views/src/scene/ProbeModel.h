#pragma once

#include <insonate/ultrasound/Probe.h>

#include <vtkActor.h>
#include <vtkNew.h>

class vtkMatrix4x4;
class vtkRenderer;

namespace insonate::views {

/// Model of the transducer in a scene.
class ProbeModel {
 public:
  explicit ProbeModel(vtkRenderer& renderer);
  ~ProbeModel();

  void setProbe(const Probe& probe);
  void setPose(vtkMatrix4x4* patientFromProbe);
  void setVisible(bool visible);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkActor> body_, lens_, marker_;
};

}  // namespace insonate::views
