#include "TissueFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "TissueControls.h"
#include "TissueShown.h"
#include "TissueStrip.h"

#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kTissueGroup = "tissue";

}  // namespace

TissueFeature::TissueFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout) {
  addCommands();
  shown_ = new TissueShown(model.status, model.disclosure, model.patientCase, model.live, layout.views().image(),
                           commands(), &layout.image());
  layout.image().add(ImageColumn::Curve, &shown_->curve());
  layout.image().add(ImageColumn::Line, &shown_->strip());
  auto* controls = new TissueControls(model.status, model.imaging);
  layout.controls().addSection(controls);
  connect(&model.disclosure, &DisclosureModel::changed, controls,
          [this, controls] { controls->setVisible(model_.disclosure.current().anatomy); });
}

void TissueFeature::addCommands() {
  const auto toggle = [this](int what) -> Perform {
    return [this, what](ui::KeyPress) {
      if (model_.disclosure.mayShowAnatomy()) shown_->toggle(what);
    };
  };
  beginSection(KeySection::Tissue);
  addCommand({.id = "train.tissue.grid",
              .text = tr("Grid in the tissue"),
              .does = tr("shows or hides a grid that moves with the tissue, over the image"),
              .listed = tr("T"),
              .keys = keys({Qt::Key_T}),
              .perform = toggle(TissueStrip::kGrid)});
  addCommand({.id = "train.tissue.pressure",
              .text = tr("Pressure in the tissue"),
              .does = tr("shows or hides the pressure in the tissue (in kPa) as colors over the image"),
              .listed = tr("P"),
              .keys = keys({Qt::Key_P}),
              .perform = toggle(TissueStrip::kPressure)});
  addCommand({.id = "train.tissue.areas",
              .text = tr("Vessel areas against force"),
              .does = tr("shows or hides the curve of the areas of vein and artery against the force of the probe"),
              .listed = tr("K"),
              .keys = keys({Qt::Key_K}),
              .perform = toggle(TissueStrip::kPlot)});
}

void TissueFeature::save(QSettings& settings) const {
  settings.beginGroup(kTissueGroup);
  saveTissue(model_.imaging.tissue(), settings);
  settings.endGroup();
  shown_->save(settings);
}

void TissueFeature::restore(QSettings& settings) {
  settings.beginGroup(kTissueGroup);
  model_.imaging.setTissue(restoredTissue(settings));
  settings.endGroup();
  shown_->restore(settings);
}

}  // namespace insonate::train
