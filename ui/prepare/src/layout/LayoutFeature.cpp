#include "LayoutFeature.h"

#include "CaseViews.h"
#include "PrepareLayout.h"
#include "RightColumn.h"

#include <QSettings>
#include <QSplitter>

namespace insonate::prepare {

LayoutFeature::LayoutFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  commands().beginSection(tr("Slices and 3D"));
  commands().addListed(tr("Arrow keys, wheel, Page Up, Page Down"), tr("scrolls through the slices"));
  commands().addListed(QStringLiteral("R"), tr("fits the slice to its view; turns the 3D view to the front"));
  commands().addListed(tr("Left drag on a slice"), tr("moves the crosshair (or hold Shift and move the mouse)"));
  commands().addListed(tr("Right drag on a slice"), tr("sets window (horizontal) and level (vertical)"));
  commands().addListed(tr("Ctrl + wheel, middle drag"), tr("zooms, pans"));
  commands().addListed(tr("Click on a structure in 3D"), tr("moves the crosshair to the structure"));
}

void LayoutFeature::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("columns"), layout_.columns().saveState());
  settings.setValue(QStringLiteral("views"), layout_.views().saveState());
  layout_.right().save(settings);
}

void LayoutFeature::restore(QSettings& settings) {
  layout_.columns().restoreState(settings.value(QStringLiteral("columns")).toByteArray());
  layout_.views().restoreState(settings.value(QStringLiteral("views")).toByteArray());
  layout_.right().restore(settings);
}

}  // namespace insonate::prepare
