#include "VesselFeature.h"

#include "../layout/CaseViews.h"
#include "../layout/PrepareLayout.h"
#include "../model/PrepareModel.h"
#include "VesselPanel.h"
#include "VesselSession.h"

#include <insonate/ui/Theme.h>

#include <QToolButton>

namespace insonate::prepare {

VesselFeature::VesselFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  auto* panel = new VesselPanel(model_, *new VesselSession(model_, this));
  CaseViews& views = layout_.views();
  views.setLowerPanel(panel);
  const auto show = [&views, panel](bool isShown) {
    views.showLowerPanel(isShown);
    if (isShown) panel->setFocus();
  };
  auto* button = new QToolButton;
  ui::setRole(button, "palette");
  button->setObjectName(QStringLiteral("showVessel"));
  button->setText(tr("Along vessel"));
  button->setIcon(ui::icon(QStringLiteral("along-vessel")));
  button->setIconSize({20, 20});
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  commands().beginSection(tr("Vessel"));
  add("prepare.vessel.show", QStringLiteral("V"),
      tr("shows the selected vessel straightened and in cross-sections, in place of the sagittal slice and 3D"),
      {{Qt::Key_V, [button] { button->toggle(); }}});
  commands().addListed(tr("Wheel, arrow keys on the vessel"), tr("moves along the vessel; the crosshair follows"));
  commands().addListed(tr("Shift + wheel, Shift + arrow keys on the vessel"), tr("rotates the straightened vessel"));
  commands().addListed(tr("Left drag on the outline of the large cross-section"),
                       tr("changes the outline of the vessel"));
  button->setToolTip(commands().toolTip(QStringLiteral("prepare.vessel.show")));
  connect(button, &QToolButton::toggled, panel, show);
  layout_.addBar(button);
}

}  // namespace insonate::prepare
