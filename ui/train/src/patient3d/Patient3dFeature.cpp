#include "Patient3dFeature.h"

#include "../layout/Columns.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "FourSlices.h"
#include "PatientViews.h"
#include "SceneNeedle.h"

#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/ViewWidget.h>

#include <QKeyEvent>
#include <QSettings>
#include <QSplitter>
#include <algorithm>
#include <utility>
#include <vector>

namespace insonate::train {
namespace {

/// Keys that a CT slice uses itself: structures, fit, other slices.
SharedViews::OwnKeys keysOfSlice(const views::MprView& slice) {
  return [&slice](const QKeyEvent& event) {
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
    switch (event.key()) {
      case Qt::Key_A:
      case Qt::Key_D:
      case Qt::Key_G:
      case Qt::Key_R:
        return true;
      // The probe's plane has no neighbors: there the arrows move the probe.
      case Qt::Key_Up:
      case Qt::Key_Down:
      case Qt::Key_Left:
      case Qt::Key_Right:
      case Qt::Key_PageUp:
      case Qt::Key_PageDown:
        return slice.kind() != views::SliceKind::Oblique;
      default:
        return false;
    }
  };
}

}  // namespace

Patient3dFeature::Patient3dFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout) {
  addCommands();
  patient_ = new PatientViews(model, commands());
  layout.setPatient(patient_);
  SharedViews& views = layout.views();
  views.add(patient_->sceneWidget());
  views.addSlice({&patient_->mpr(), &patient_->mprWidget()}, keysOfSlice(patient_->mpr()));
  FourSlices& four = patient_->allSlices();
  for (std::size_t n = 0; n < FourSlices::kCount; ++n)
    views.addSlice({&four.slice(n), &four.widget(n)}, keysOfSlice(four.slice(n)));
  patient_->setWindowChanged([&views](views::WindowLevel value) { Q_EMIT views.windowLevelChanged(value); });
  patient_->setRoomRequested([this](bool more) { layout_.columns().expandPatient(more); });
  connectNeedle();
}

void Patient3dFeature::connectNeedle() {
  connect(&model_.tray, &NeedleTray::changed, this, [this] {
    patient_->needle().setColor(ui::colorOf(model_.tray.needle()));
    patient_->setTrayVisible(model_.tray.isOut());
  });
  // A new needle is taken by touching the tray, with the pointer or with the needle itself.
  patient_->setTrayTaken([this] { model_.tray.touch(); });
  connect(&model_.hands, &HapticControl::needleChanged, this, [this] {
    const auto& held = model_.hands.needle();
    const bool used = model_.tray.isOut() && model_.tray.needle() == NeedlePlace::Used;
    const bool touches = used && held && patient_->needle().isOnTray(held->patientFromNeedle.offset);
    // Once a touch: the tray hears of the new needle a little later.
    if (!std::exchange(touchesTray_, touches) && touches) model_.tray.touch();
  });
  connect(&model_.hands, &HapticControl::anatomyTurned, this,
          [this](double across_deg, double up_deg) { patient_->turn(across_deg, up_deg); });
}

void Patient3dFeature::addCommands() {
  beginSection(KeySection::Patient);
  addCommand({.id = "train.patient3d.cut",
              .text = {},
              .does = tr("cuts the 3D anatomy open along the needle, or closes the cut"),
              .listed = tr("H"),
              .keys = keys({Qt::Key_H}),
              .perform = once([this] {
                if (model_.disclosure.mayShowAnatomy()) patient_->needle().toggleCut();
              })});
  addCommand(
      {.id = "train.patient3d.allSlices",
       .text = {},
       .does = tr("shows four CT slices with one crosshair (image plane, axial, coronal, sagittal), or one CT slice"),
       .listed = tr("X"),
       .keys = keys({Qt::Key_X}),
       .perform = [this](ui::KeyPress) {
         if (model_.disclosure.mayShowAnatomy()) patient_->setAllSlices(!patient_->showsAllSlices());
       }});
  addWindows();
  const std::pair<QString, QString> gestures[] = {
      {tr("Left drag on the skin"),
       tr("moves the probe to the pointer; with Ctrl, moves the entry point of the needle")},
      {tr("Wheel on a CT slice"), tr("shows the next or previous slice; with Ctrl, or in the image plane, zooms")},
      {tr("Right drag on a CT slice"), tr("changes window and level")},
      {tr("Left drag on a CT slice"), tr("moves the crosshair")},
      {tr("Middle drag on a CT slice"), tr("pans the slice")},
      {tr("In a CT slice: arrow keys, Page Up, Page Down"),
       tr("moves by one slice; Page Up and Page Down move by 10 slices")},
      {tr("In a CT slice: G, A, D"), tr("G shows or hides the structures; A makes them fainter, D stronger")},
      {tr("In a CT slice: R"), tr("fits the slice into its view")},
  };
  for (const auto& [gesture, does] : gestures) commands().addListed(gesture, does);
}

void Patient3dFeature::addWindows() {
  std::vector<ui::CommandKey> numbers;
  QStringList names;
  for (const views::WindowLevelPreset& preset : views::windowLevelPresets()) {
    const int index = int(numbers.size());
    numbers.push_back(
        {Qt::Key_1 + index, Qt::AltModifier, [this, index](ui::KeyPress) { patient_->setSliceWindow(index); }});
    names << ui::qt(preset.name);
  }
  addCommand({.id = "train.patient3d.window",
              .text = {},
              .does = tr("sets window and level of the CT: %1").arg(names.join(QStringLiteral(", "))),
              .listed = tr("Alt+1 to Alt+%1").arg(names.size()),
              .keys = std::move(numbers),
              .perform = {}});
}

void Patient3dFeature::setCompact(bool isCompact) {
  patient_->setCompact(isCompact);
}

void Patient3dFeature::save(QSettings& settings) const {
  settings.setValue("labelOpacity", patient_->mpr().labelOpacity());
  const bool allSlices = patient_->showsAllSlices();
  // Four slices take their height again when they are restored.
  patient_->setAllSlices(false);
  settings.setValue("patientViews", patient_->splitter().saveState());
  patient_->setAllSlices(allSlices);
  settings.setValue("slice", int(patient_->mpr().kind()));
  settings.setValue("allSlices", allSlices);
  settings.beginGroup("scene");
  patient_->scenePanel().save(settings);
  settings.endGroup();
}

void Patient3dFeature::restore(QSettings& settings) {
  patient_->mpr().setLabelOpacity(settings.value("labelOpacity", 0).toDouble());
  patient_->splitter().restoreState(settings.value("patientViews").toByteArray());
  const int slice = settings.value("slice", int(views::SliceKind::Oblique)).toInt();
  patient_->setSliceKind(views::SliceKind(std::clamp(slice, 0, int(views::SliceKind::Oblique))));
  if (settings.value("allSlices", false).toBool()) patient_->setAllSlices(true);
  settings.beginGroup("scene");
  patient_->scenePanel().restore(settings);
  settings.endGroup();
}

}  // namespace insonate::train
