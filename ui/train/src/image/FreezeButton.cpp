#include "FreezeButton.h"

#include "../model/CaseModel.h"
#include "../model/LiveModel.h"

namespace insonate::train {

FreezeButton::FreezeButton(CaseModel& patientCase, LiveModel& live, const QString& toolTip, QWidget* parent)
    : QPushButton(tr("Freeze"), parent), live_(live) {
  setObjectName("freeze");
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setToolTip(toolTip);
  setMinimumHeight(36);
  connect(this, &QPushButton::clicked, &live_, &LiveModel::setFrozen);
  connect(&live_, &LiveModel::frozenChanged, this, [this] { refresh(); });
  connect(&patientCase, &CaseModel::caseChanged, this, [this] { refresh(); });
  connect(&live_, &LiveModel::pictureShown, this, [this] {
    if (!isEnabled()) refresh();
  });
  refresh();
}

void FreezeButton::refresh() {
  setEnabled(live_.shown() != nullptr);
  setChecked(live_.isFrozen());
  setText(live_.isFrozen() ? tr("Unfreeze") : tr("Freeze"));
}

}  // namespace insonate::train
