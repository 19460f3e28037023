#include "PatientBox.h"
#include "SceneDrawing.h"

#include <vtkRenderWindow.h>

namespace insonate::views {

void SceneView::setStereo(Stereo stereo) {
  drawing_->state.stereo = stereo;
  changed();
}

Stereo SceneView::stereo() const {
  return drawing_->state.stereo;
}

bool SceneView::supports(Stereo stereo) {
  return stereo != Stereo::QuadBuffer || (window() && window()->GetStereoCapableWindow());
}

void SceneView::setHeadCoupling(std::optional<HeadCoupling> coupling) {
  // An eye in or behind the screen has no view through it.
  if (coupling && !(coupling->eye_mm.z >= 1 && coupling->width_mm > 0 && coupling->height_mm >= 0)) coupling.reset();
  drawing_->state.coupling = coupling;
  changed();
}

const std::optional<HeadCoupling>& SceneView::headCoupling() const {
  return drawing_->state.coupling;
}

Vec3 SceneView::viewerDirection() const {
  const double* into = drawing_->usual->GetDirectionOfProjection();
  return -Vec3{into[0], into[1], into[2]};
}

/// The camera of the next image, or the one between its eyes; the near and far planes enclose the patient.
vtkCamera& SceneView::aimed() {
  frame();
  double box[6];
  const bool known = patientBox(drawing_->state, nullptr, box);
  if (drawing_->patient) ctBox(*drawing_->patient, box);
  const auto encloseAll = [&](vtkCamera& camera) {
    if (known || drawing_->patient) enclose(camera, box);
  };
  if (!drawing_->state.coupling) {
    encloseAll(*drawing_->usual);
    return *drawing_->usual;
  }
  const HeadCoupling coupling = placed(*drawing_->state.coupling, *drawing_->usual, width_px(), height_px());
  standBeforeScreen(*drawing_->coupled, coupling, 0);
  encloseAll(*drawing_->coupled);
  lookThroughScreen(*drawing_->coupled, coupling, 0);
  return *drawing_->coupled;
}

}  // namespace insonate::views
