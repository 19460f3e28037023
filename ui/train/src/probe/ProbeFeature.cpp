#include "ProbeFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "FitDialog.h"
#include "FovHandles.h"
#include "HeldPress.h"
#include "PlaceOffer.h"
#include "Positions.h"
#include "ProbeChooser.h"
#include "ProbeEditor.h"
#include "ProbeLibrary.h"
#include "ProbeNumbers.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ui/Workspace.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QSettings>
#include <QVBoxLayout>
#include <optional>
#include <utility>
#include <vector>

namespace insonate::train {

ProbeFeature::ProbeFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout),
      library_(new ProbeLibrary({}, this)),
      chooser_(new ProbeChooser(model.imaging, *library_)),
      heldPress_(new HeldPress(model.motion, this)) {
  addCommands();
  layout.controls().addSection(buildPositionSection());
  layout.image().add(ImageColumn::Image, new PlaceOffer(model.patientCase, model.motion));
  buildEditor();
}

QWidget& ProbeFeature::chooser() {
  return *chooser_;
}

QWidget* ProbeFeature::buildPositionSection() {
  auto* section = new QWidget;
  auto* box = new QVBoxLayout(section);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  positions_ = new Positions(model_.status, model_.history, model_.patientCase, model_.motion, section);
  auto* numbers = new ProbeNumbers(section);
  numbers->setTyped([this](HandAxis axis, double value) { model_.motion.typed(axis, value); });
  numbers->setPlaced([this](Vec3 patient_mm) { model_.motion.placed(patient_mm); });
  numbers->setRefused([this](const QString& sentence) { model_.status.showMessage(sentence); });
  box->addWidget(ui::heading(tr("Position")));
  box->addWidget(positions_);
  box->addSpacing(4);
  box->addWidget(numbers);
  connect(&model_.motion, &ProbeMotion::handMoved, numbers,
          [this, numbers] { numbers->show(model_.motion.numbers()); });
  const auto offer = [this] {
    positions_->setVisible(model_.disclosure.current().anatomy && !model_.motion.isStartHeld());
  };
  connect(&model_.disclosure, &DisclosureModel::changed, positions_, offer);
  connect(&model_.motion, &ProbeMotion::startHeldChanged, positions_, offer);
  return section;
}

void ProbeFeature::buildEditor() {
  SharedViews& views = layout_.views();
  editor_ = new ProbeEditor(model_.status, model_.imaging, *library_);
  layout_.addControlsPage(editor_);
  handles_ = new FovHandles(model_.status, model_.history, model_.imaging, views.image(),
                            *views.imageWidget().focusProxy(), this);
  views.setBounds([this](const views::ImageBounds& fieldOfView) {
    return handles_->isHeld() ? std::nullopt : std::optional(handles_->roomFor(fieldOfView));
  });
  connect(handles_, &FovHandles::released, &views, &SharedViews::boundsChanged);
  // The next scene may take seconds: the image there is already at the scale of the handles.
  connect(&model_.imaging, &ImagingModel::setupChanged, this, [this] {
    if (!handles_->isActive() || handles_->isHeld()) return;
    const BeamGrid grid(model_.imaging.probe(), model_.imaging.settings());
    layout_.views().image().setBounds(
        handles_->roomFor({grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()}));
  });
  connect(chooser_, &ProbeChooser::editRequested, this, [this] { edit(true); });
  connect(editor_, &ProbeEditor::done, this, [this] { edit(false); });
  connect(editor_, &ProbeEditor::fitRequested, this, [this] { fitToImage(); });
}

void ProbeFeature::addCommands() {
  beginSection(KeySection::Probe);
  addMoves();
  const auto press = [this](int key, double step_mm) -> ui::CommandKey {
    return {key, {}, once([this, step_mm] { heldPress_->begin(step_mm); })};
  };
  // On many keyboards plus needs Shift: there are no wide steps here.
  addCommand({.id = "train.probe.press",
              .text = {},
              .does = tr("compresses or releases the tissue by 0.5 mm; smoothly while the key is held"),
              .listed = tr("+, -"),
              .keys = {press(Qt::Key_Plus, 0.5), press(Qt::Key_Equal, 0.5), press(Qt::Key_Minus, -0.5)},
              .perform = {}});
  addCommand({.id = "train.probe.home",
              .text = {},
              .does = tr("returns the probe to its start position"),
              .listed = tr("Home"),
              .keys = keys({Qt::Key_Home}),
              .perform = [this](ui::KeyPress) { model_.motion.home(); }});
  constexpr int kNumberKeys = 9;
  std::vector<ui::CommandKey> numbers;
  for (int place = 0; place < kNumberKeys; ++place)
    numbers.push_back({Qt::Key_1 + place, {}, [this, place](ui::KeyPress) { positions_->recall(place); }});
  addCommand({.id = "train.probe.recall",
              .text = {},
              .does = tr("moves the probe to the position with this number in the list"),
              .listed = tr("1 to 9"),
              .keys = std::move(numbers),
              .perform = {}});
  commands().addListed(tr("G, Ctrl+arrows"), tr("while you edit a probe: G selects the next handle of the field of "
                                                "view, Ctrl+arrows move it by 1 mm or 1 degree (with Shift: 5)"));
}

void ProbeFeature::addMoves() {
  using enum HandAxis;
  addCommand({.id = "train.probe.slide",
              .text = {},
              .does = tr("slides the probe by 1 mm (with Shift: 5 mm)"),
              .listed = tr("Arrows"),
              .keys = {moveKey(Qt::Key_Left, Lateral, -1, -5), moveKey(Qt::Key_Right, Lateral, 1, 5),
                       moveKey(Qt::Key_Up, Elevation, -1, -5), moveKey(Qt::Key_Down, Elevation, 1, 5)},
              .perform = {}});
  addCommand({.id = "train.probe.rotate",
              .text = {},
              .does = tr("rotates the probe by 2 degrees (with Shift: 10 degrees)"),
              .listed = tr("Q, E"),
              .keys = {moveKey(Qt::Key_Q, Rotation, -2, -10), moveKey(Qt::Key_E, Rotation, 2, 10)},
              .perform = {}});
  addCommand({.id = "train.probe.tilt",
              .text = {},
              .does = tr("tilts the probe by 1 degree (with Shift: 5 degrees)"),
              .listed = tr("W, S"),
              .keys = {moveKey(Qt::Key_W, Tilt, 1, 5), moveKey(Qt::Key_S, Tilt, -1, -5)},
              .perform = {}});
  addCommand({.id = "train.probe.rock",
              .text = {},
              .does = tr("rocks the probe by 1 degree (with Shift: 5 degrees)"),
              .listed = tr("A, D"),
              .keys = {moveKey(Qt::Key_A, Rock, -1, -5), moveKey(Qt::Key_D, Rock, 1, 5)},
              .perform = {}});
}

/// Key that moves the probe in mm or degrees. While it is held down, its moves are one gesture.
ui::CommandKey ProbeFeature::moveKey(int key, HandAxis axis, double step, double wide) const {
  return {key, {}, [this, axis, step, wide](ui::KeyPress press) {
            if (!press.repeated) model_.motion.beginGesture();
            model_.motion.move(axis, press.wide ? wide : step);
          }};
}

void ProbeFeature::edit(bool isEdited) {
  if (isEdited) model_.live.setFrozen(false);  // The image is the preview.
  layout_.showControlsPage(isEdited ? editor_ : nullptr);
  handles_->setActive(isEdited);
  Q_EMIT layout_.views().boundsChanged();
  model_.status.setHint(
      isEdited ? tr("Drag the handles on the image, or select a handle with G and move it with Ctrl+arrows.")
               : QString());
}

void ProbeFeature::fitToImage() {
  auto* dialog = new FitDialog(model_.imaging.probe(), &layout_.workspace());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { editor_->take(dialog->probe()); });
  dialog->show();
}

void ProbeFeature::save(QSettings& settings) const {
  settings.setValue("probe",
                    chooser_->key().isEmpty() ? QString::fromStdString(model_.imaging.probe().name) : chooser_->key());
  positions_->save(settings);
}

void ProbeFeature::restore(QSettings& settings) {
  const QString present = QString::fromStdString(model_.imaging.probe().name);
  model_.imaging.setProbe(settings.value("probe", present).toString().toStdString());
  positions_->restore(settings);
}

}  // namespace insonate::train
