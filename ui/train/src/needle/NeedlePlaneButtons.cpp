#include "NeedlePlaneButtons.h"

#include "../model/NeedleMotion.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QPushButton>

namespace insonate::train {

NeedlePlaneButtons::NeedlePlaneButtons(const QString& object, HapticControl& hands, NeedleMotion& needle,
                                       const ui::Commands& commands, QWidget* parent)
    : QWidget(parent), hands_(hands), needle_(needle) {
  along_ = planeButton(
      object + "Along", tr("in-plane"),
      commands.toolTip(
          tr("Takes an 18 G needle (70 mm long) in-plane, beside the end of the probe, or puts the needle away"),
          "train.needle.take"),
      NeedlePlane::InPlane);
  across_ = planeButton(
      object + "Across", tr("out-of-plane"),
      commands.toolTip(
          tr("Takes an 18 G needle (70 mm long) out-of-plane, in front of the probe, or puts the needle away"),
          "train.needle.take"),
      NeedlePlane::OutOfPlane);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  // In proportion to their texts: there is little room.
  for (QPushButton* button : {along_, across_}) row->addWidget(button, button->sizeHint().width());
  connect(&hands_, &HapticControl::needleChanged, this, [this] { refresh(); });
  refresh();
}

QPushButton* NeedlePlaneButtons::planeButton(const QString& object, const QString& text, const QString& says,
                                             NeedlePlane plane) {
  auto* button = ui::pushButton(object.toLatin1(), text, says, Qt::TabFocus);
  button->setCheckable(true);
  connect(button, &QPushButton::clicked, this, [this, plane](bool on) {
    if (on)
      needle_.take(plane);
    else
      needle_.putAway();
    refresh();
  });
  return button;
}

void NeedlePlaneButtons::refresh() {
  const bool isHeld = hands_.needleHand() != nullptr;
  const bool isAlong = hands_.needlePlane() == NeedlePlane::InPlane;
  along_->setChecked(isHeld && isAlong);
  across_->setChecked(isHeld && !isAlong);
}

}  // namespace insonate::train
