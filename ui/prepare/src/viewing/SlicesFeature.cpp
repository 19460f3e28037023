#include "SlicesFeature.h"

#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"
#include "SliceControls.h"

namespace insonate::prepare {
namespace {

constexpr double kOpacityStep = 0.05;

}  // namespace

SlicesFeature::SlicesFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  SliceSettings& slices = model_.slices;
  const auto fade = [&slices](double step) { slices.setLabelOpacity(slices.labelOpacity() + step); };
  commands().beginSection(tr("Slices and 3D"));
  add("prepare.slices.opacity", QStringLiteral("A, D"),
      tr("decreases or increases the opacity of labels on the slices"),
      {{Qt::Key_A, [fade] { fade(-kOpacityStep); }}, {Qt::Key_D, [fade] { fade(kOpacityStep); }}});
  add("prepare.slices.labels", QStringLiteral("G"), tr("hides or shows all labels on the slices"),
      {{Qt::Key_G, [&slices] { slices.setLabelsShown(!slices.labelsShown()); }}});
  layout_.right().addSection(RightColumn::Place::Case, QStringLiteral("slices"), tr("Slices"),
                             new SliceControls(model_, commands()));
}

void SlicesFeature::save(QSettings& settings) const {
  model_.slices.save(settings);
}

void SlicesFeature::restore(QSettings& settings) {
  model_.slices.restore(settings);
}

}  // namespace insonate::prepare
