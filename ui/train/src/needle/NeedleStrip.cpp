#include "NeedleStrip.h"

#include "../model/NeedleMotion.h"
#include "../model/NeedleTray.h"
#include "NeedlePlaneButtons.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QPushButton>

namespace insonate::train {

NeedleStrip::NeedleStrip(HapticControl& hands, NeedleMotion& needle, NeedleTray& tray, const ui::Commands& commands,
                         QWidget* parent)
    : QWidget(parent), hands_(hands), needle_(needle), tray_(tray) {
  setObjectName("needleStrip");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 0);
  row->setSpacing(4);
  row->addWidget(new NeedlePlaneButtons("strip", hands_, needle_, commands, this));
  row->addStretch(1);
  const QString advance =
      commands.toolTip(tr("Advances the needle by 1 mm; hold down the button to continue"), "train.needle.advance");
  const QString withdraw =
      commands.toolTip(tr("Withdraws the needle by 1 mm; hold down the button to continue"), "train.needle.advance");
  const QString angle =
      commands.toolTip(tr("Changes the angle between needle and skin by 1 degree; hold down the button to continue"),
                       "train.needle.angle");
  // The guide marks both buttons together.
  auto* angles = new QWidget;
  angles->setObjectName("needleAngleButtons");
  auto* both = new QHBoxLayout(angles);
  both->setContentsMargins(0, 0, 0, 0);
  both->setSpacing(row->spacing());
  addMove(*both, "needleFlatter", tr("flatter"), NeedleAxis::Angle, -1, angle);
  addMove(*both, "needleSteeper", tr("steeper"), NeedleAxis::Angle, 1, angle);
  row->addWidget(angles);
  addMove(*row, "needleWithdraw", tr("withdraw"), NeedleAxis::Advance, -1, withdraw);
  addMove(*row, "needleAdvance", tr("advance"), NeedleAxis::Advance, 1, advance);
  // The buttons must not keep the column wide.
  setMinimumWidth(200);
  connect(&hands_, &HapticControl::needleChanged, this, [this] { refresh(); });
  connect(&hands_, &HapticControl::handsChanged, this, [this] { refresh(); });
  connect(&tray_, &NeedleTray::changed, this, [this] { refresh(); });
  refresh();
}

void NeedleStrip::addMove(QHBoxLayout& row, const char* object, const QString& text, NeedleAxis axis, double step,
                          const QString& says) {
  auto* button = ui::pushButton(object, text, says, Qt::TabFocus);
  button->setAutoRepeat(true);
  connect(button, &QPushButton::clicked, this, [this, axis, step] { needle_.move(axis, step); });
  row.addWidget(button);
  moves_.push_back(button);
}

void NeedleStrip::refresh() {
  const bool isHeld = hands_.needleHand() != nullptr;
  setVisible(tray_.isOut() && (isHeld || !hands_.needle()));
  for (QPushButton* button : moves_) button->setEnabled(isHeld);
}

}  // namespace insonate::train
