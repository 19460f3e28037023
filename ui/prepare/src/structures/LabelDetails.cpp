#include "LabelDetails.h"

#include "../model/CaseMeasuring.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../model/Structures.h"
#include "../model/TermsEditor.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <algorithm>

namespace insonate::prepare {
namespace {

QComboBox* choice(const char* object, const QString& name, int letters, const QString& tip) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(object));
  box->setAccessibleName(name);
  box->setToolTip(tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(letters);
  return box;
}

}  // namespace

LabelDetails::LabelDetails(PrepareModel& shared, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      // "in progress" must be fully readable; the tissue gets the remaining width.
      state_(choice("labelState", tr("Labeling state of the selected structure"), 11,
                    tr("Labeling progress of the selected structure (S sets the next state); saved with the case"))),
      tissue_(choice("labelTissue", tr("Tissue of the selected structure"), 3, {})),
      term_(ui::paragraph("labelTerm", "quiet")) {
  for (const LabelState state : kLabelStates) state_->addItem(stateIcon(state), stateWord(state));
  for (const LabelInfo& info : labelTable())
    if (info.label != kBackground)
      tissue_->addItem(swatch(viewColor(info.color)), structureName(info.label), int(info.label));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(ui::kSmallGap);
  grid->addWidget(state_, 0, 0);
  grid->addWidget(tissue_, 0, 1);
  grid->addWidget(term_, 1, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  connect(state_, qOverload<int>(&QComboBox::activated), this,
          [this](int row) { shared_.terms.setState(shared_.structures.selected(), kLabelStates[row]); });
  connect(tissue_, qOverload<int>(&QComboBox::activated), this, [this](int row) {
    shared_.terms.setTissue(shared_.structures.selected(), std::uint8_t(tissue_->itemData(row).toInt()));
  });
  connect(&shared_.structures, &StructureList::changed, this, [this] { refresh(); });
  connect(&shared_.structures, &StructureList::selectedChanged, this, [this] { refresh(); });
  connect(&shared_.terms, &TermsEditor::changed, this, [this] { refresh(); });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { refresh(); });
  refresh();
}

void LabelDetails::refresh() {
  const std::uint8_t label = shared_.structures.selected();
  const auto& there = shared_.structures.labels();
  const bool any = std::ranges::find(there, label) != there.end();
  state_->setEnabled(any);
  tissue_->setEnabled(any && isOwnLabel(label));
  tissue_->setToolTip(
      tissue_->isEnabled()
          ? tr("Tissue of the structure: determines its ultrasound image, its stiffness and its resistance to the "
               "needle")
          : tr("The tissue of predefined structures is fixed; use Add for a structure with another tissue"));
  if (!any) return term_->setText(tr("Choose a structure, or add one."));
  const std::uint8_t tissue = tissueOf(shared_.terms.value().own, label);
  state_->setCurrentIndex(int(shared_.terms.stateOf(label)));
  tissue_->setCurrentIndex(tissue_->findData(int(knownLabel(tissue))));
  const auto& measures = shared_.measuring.measures();
  const qulonglong voxels = measures ? measures->statistics.voxels[label] : 0;
  const QString count = QLocale().toString(voxels);
  term_->setText(shared_.measuring.isOutdated(label)
                     ? tr("%1; %2 voxels before the last change").arg(termOf(tissue), count)
                     : tr("%1; %2 voxels").arg(termOf(tissue), count));
}

}  // namespace insonate::prepare
