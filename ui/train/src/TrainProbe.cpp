#include "TrainParts.h"
#include "panel/ControlsPanel.h"
#include "probe/FitDialog.h"
#include "probe/FovHandles.h"
#include "probe/ProbeChooser.h"
#include "probe/ProbeEditor.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QStackedWidget>

namespace insonate::train {

void TrainWorkspace::Parts::connectProbe() {
  // After the workspace's own filter, so that it is asked first.
  fov_ = new FovHandles(model.status, model.history, model.imaging, *image_, *imageWidget_->focusProxy(), imageWidget_);
  connect(fov_, &FovHandles::released, this, [this] {
    shape_ = nullptr;
    if (model.live.shown()) showPicture();
  });
  // The next scene may take seconds: the image there is already at the scale of the handles.
  connect(&model.imaging, &ImagingModel::setupChanged, this, [this] {
    if (!fov_->isActive() || fov_->isHeld()) return;
    const BeamGrid grid(model.imaging.probe(), model.imaging.settings());
    image_->setBounds(
        fov_->roomFor({grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()}));
  });
  connect(&panel->probes(), &ProbeChooser::editWanted, this, [this] { editProbe(true); });
  connect(editor_, &ProbeEditor::done, this, [this] { editProbe(false); });
  connect(editor_, &ProbeEditor::fitWanted, this, [this] { fitToPicture(); });
}

void TrainWorkspace::Parts::editProbe(bool on) {
  if (on) model.live.setFrozen(false);  // The image is the preview.
  left_->setCurrentWidget(on ? static_cast<QWidget*>(editor_) : panel);
  fov_->setActive(on);
  shape_ = nullptr;
  if (model.live.shown()) showPicture();
  model.status.setHint(on ? tr("Drag the handles on the image, or G and Ctrl with arrows.") : QString());
}

void TrainWorkspace::Parts::fitToPicture() {
  auto* dialog = new FitDialog(model.imaging.probe(), &workspace_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { editor_->take(dialog->probe()); });
  dialog->show();
}

}  // namespace insonate::train
