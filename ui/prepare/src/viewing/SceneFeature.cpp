#include "SceneFeature.h"

#include "../layout/CaseViews.h"
#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../layout/Section.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"

#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/ScenePanel.h>

#include <QLayout>
#include <QSettings>

namespace insonate::prepare {

SceneFeature::SceneFeature(PrepareModel& model, PrepareLayout& layout)
    : Feature(model, layout),
      panel_(new ui::ScenePanel(layout.views().sharedScene(), nullptr, ui::ScenePanel::Structures::Elsewhere)) {
  // Its margins are those of a separate column.
  panel_->layout()->setContentsMargins(0, 0, 0, 0);
  layout_.right().addSection(RightColumn::Place::Case, QStringLiteral("scene"), tr("3D"), panel_).setOpen(false);
  connect(&model_.openCase, &OpenCase::caseChanged, panel_, [this] { panel_->setCase(model_.openCase.patient()); });
  connect(&model_.slices, &SliceSettings::changed, panel_,
          [this] { histogram().setWindowLevel(model_.slices.windowLevel()); });
}

ui::HistogramEditor& SceneFeature::histogram() {
  return panel_->histogram();
}

void SceneFeature::save(QSettings& settings) const {
  settings.beginGroup(QStringLiteral("scene"));
  panel_->save(settings);
  settings.endGroup();
}

void SceneFeature::restore(QSettings& settings) {
  settings.beginGroup(QStringLiteral("scene"));
  panel_->restore(settings);
  settings.endGroup();
}

}  // namespace insonate::prepare
