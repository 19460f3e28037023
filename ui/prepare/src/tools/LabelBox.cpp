#include "LabelBox.h"

#include "../model/PrepareModel.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "../model/Structures.h"
#include "../model/TermsEditor.h"

namespace insonate::prepare {

LabelBox::LabelBox(PrepareModel& shared, const QString& name, const QString& hint) : shared_(shared) {
  setAccessibleName(name);
  setToolTip(hint);
  setPlaceholderText(tr("choose a label"));
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
  connect(&shared_.structures, &StructureList::changed, this, [this] { listLabels(); });
  connect(&shared_.terms, &TermsEditor::changed, this, [this] { listLabels(); });
  connect(&shared_.appearance, &StructureAppearance::lookChanged, this, [this](int label) {
    const int row = findData(label);
    if (row >= 0) setItemIcon(row, swatch(shared_.appearance.look(std::uint8_t(label)).color));
  });
  connect(this, qOverload<int>(&QComboBox::activated), this, [this](int row) {
    label_ = std::uint8_t(itemData(row).toInt());
    Q_EMIT chosen(label_);
  });
  listLabels();
}

void LabelBox::listLabels() {
  clear();
  for (const std::uint8_t label : shared_.structures.labels())
    addItem(swatch(shared_.appearance.look(label).color), shared_.terms.nameOf(label), int(label));
  show(label_);
}

void LabelBox::show(std::uint8_t label) {
  label_ = label;
  setCurrentIndex(findData(int(label)));
}

}  // namespace insonate::prepare
