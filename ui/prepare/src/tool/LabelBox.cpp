#include "LabelBox.h"

#include "../PrepareSession.h"
#include "../table/Swatch.h"

#include <insonate/ui/QuietWheel.h>

namespace insonate::prepare {

LabelBox::LabelBox(PrepareSession& session, const QString& name, const QString& hint) : session_(session) {
  new ui::QuietWheel(this);
  setAccessibleName(name);
  setToolTip(hint);
  setPlaceholderText(tr("choose a label"));
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
  connect(&session_, &PrepareSession::structuresChanged, this, [this] { fill(); });
  connect(&session_, &PrepareSession::termsChanged, this, [this] { fill(); });
  connect(&session_, &PrepareSession::lookChanged, this, [this](int label) {
    const int row = findData(label);
    if (row >= 0) setItemIcon(row, swatch(session_.look(std::uint8_t(label)).colour));
  });
  connect(this, qOverload<int>(&QComboBox::activated), this, [this](int row) {
    label_ = std::uint8_t(itemData(row).toInt());
    Q_EMIT chosen(label_);
  });
  fill();
}

void LabelBox::fill() {
  clear();
  for (const std::uint8_t label : session_.structures())
    addItem(swatch(session_.look(label).colour), session_.nameOf(label), int(label));
  show(label_);
}

void LabelBox::show(std::uint8_t label) {
  label_ = label;
  setCurrentIndex(findData(int(label)));
}

}  // namespace insonate::prepare
