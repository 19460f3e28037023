#include "LiveFeature.h"

#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../model/Crosshair.h"
#include "../model/LivePatient.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "UltrasoundPane.h"

namespace insonate::prepare {

LiveFeature::LiveFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  commands().beginSection(tr("Slices and 3D"));
  add("prepare.live.start", tr("Home"), tr("moves crosshair and probe to the case's start pose"),
      {{Qt::Key_Home, [this] { model_.crosshair.goToStart(); }}});
  auto* pane = new UltrasoundPane(model_, commands());
  layout_.right().setFoot(pane);
  layout_.offerKeys(pane->widget());
}

QString LiveFeature::engineText() const {
  const auto& shown = model_.live.shown();
  if (!model_.openCase.patient() || !shown) return {};
  const bool onCard = shown->engine == "glsl";
  return (onCard ? tr("graphics card   %1 ms per image") : tr("processor   %1 ms per image"))
      .arg(shown->frame_ms, 4, 'f', 1);
}

}  // namespace insonate::prepare
