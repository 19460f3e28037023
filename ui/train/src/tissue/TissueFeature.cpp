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

TissueFeature::TissueFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout, {Command::ShowTissue}),
      shown_(new TissueShown(model.status, model.disclosure, model.patientCase, model.live, layout.views().image(),
                             &layout.image())) {
  layout.image().add(ImageColumn::Curve, &shown_->curve());
  layout.image().add(ImageColumn::Line, &shown_->strip());
  auto* controls = new TissueControls(model.status, model.imaging);
  layout.controls().addSection(controls);
  connect(&model.disclosure, &DisclosureModel::changed, controls,
          [this, controls] { controls->setVisible(model_.disclosure.current().anatomy); });
}

void TissueFeature::act(const KeyRow& row, KeyPress) {
  if (model_.disclosure.mayShowAnatomy()) shown_->toggle(row.place);
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
