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

namespace insonate::train {

ProbeFeature::ProbeFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout, {Command::Move, Command::Home, Command::Recall}),
      library_(new ProbeLibrary({}, this)),
      chooser_(new ProbeChooser(model.imaging, *library_)),
      heldPress_(new HeldPress(model.motion, this)) {
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
  numbers->setRefused([this](const QString& sentence) { model_.status.say(sentence); });
  box->addWidget(ui::heading(tr("Position")));
  box->addWidget(positions_);
  box->addSpacing(4);
  box->addWidget(numbers);
  connect(&model_.motion, &ProbeMotion::handMoved, numbers,
          [this, numbers] { numbers->show(model_.motion.numbers()); });
  connect(&model_.disclosure, &DisclosureModel::changed, positions_,
          [this] { positions_->setVisible(model_.disclosure.current().anatomy); });
  return section;
}

void ProbeFeature::buildEditor() {
  SharedViews& views = layout_.views();
  editor_ = new ProbeEditor(model_.status, model_.imaging, *library_);
  layout_.addControlsPage(editor_);
  handles_ = new FovHandles(model_.status, model_.history, model_.imaging, views.image(),
                            *views.imageWidget().focusProxy(), this);
  views.setBounds([this](const views::PictureBounds& fieldOfView) {
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
  connect(chooser_, &ProbeChooser::editWanted, this, [this] { edit(true); });
  connect(editor_, &ProbeEditor::done, this, [this] { edit(false); });
  connect(editor_, &ProbeEditor::fitWanted, this, [this] { fitToImage(); });
}

void ProbeFeature::act(const KeyRow& row, KeyPress press) {
  if (row.command == Command::Home) return model_.motion.home();
  if (row.command == Command::Recall) return positions_->recall(row.place);
  if (row.axis == HandAxis::Press) return press.repeated ? void() : heldPress_->begin(row.step);
  if (!press.repeated) model_.motion.beginGesture();
  model_.motion.move(row.axis, press.wide ? row.wide : row.step);
}

void ProbeFeature::edit(bool isEdited) {
  if (isEdited) model_.live.setFrozen(false);  // The image is the preview.
  layout_.showControlsPage(isEdited ? editor_ : nullptr);
  handles_->setActive(isEdited);
  Q_EMIT layout_.views().boundsChanged();
  model_.status.setHint(isEdited ? tr("Drag the handles on the image, or G and Ctrl with arrows.") : QString());
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
