#include "RulesBox.h"

#include "../labels/LabelSession.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "LabelBox.h"
#include "RangeField.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

/// From fat to soft tissue with contrast agent, which authors label most.
constexpr HuRange kUsual_HU{-20, 300};

}  // namespace

RulesBox::RulesBox(PrepareModel& shared, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      over_(ui::choiceBox("ruleOver", tr("Labels that may be overwritten"),
                          tr("Labels that tools may overwrite; locked and hidden labels always stay unchanged"))),
      inside_(new LabelBox(shared, tr("Label to overwrite"), tr("Only this label is overwritten"))),
      limited_(new QCheckBox(tr("only voxels in this CT range"))),
      range_(new RangeField(QStringLiteral("editable"))) {
  // In the order of LabelRules::Over.
  over_->addItems({tr("unlocked, visible voxels"), tr("fat, muscle, soft tissue"), tr("unlabeled voxels"),
                   tr("only the label below")});
  inside_->setObjectName(QStringLiteral("ruleInside"));
  limited_->setObjectName(QStringLiteral("ruleLimited"));
  limited_->setToolTip(tr("Tools do not change voxels whose CT value is outside this range"));
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(tr("tools may overwrite"));
  name->setBuddy(over_);
  row->addWidget(name);
  row->addWidget(over_, 1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addLayout(row);
  for (QWidget* one : {static_cast<QWidget*>(inside_), static_cast<QWidget*>(limited_), static_cast<QWidget*>(range_)})
    box->addWidget(one);
  connectParts();
  refresh();
}

void RulesBox::connectParts() {
  LabelSession& labels = shared_.labeling;
  connect(over_, qOverload<int>(&QComboBox::activated), this, [this, &labels](int index) {
    LabelRules rules = labels.rules();
    rules.over = LabelRules::Over(index);
    if (rules.inside == kBackground) rules.inside = shared_.structures.selected();
    labels.setRules(rules);
  });
  connect(inside_, &LabelBox::chosen, this, [&labels](std::uint8_t label) {
    LabelRules rules = labels.rules();
    rules.inside = label;
    labels.setRules(rules);
  });
  connect(limited_, &QCheckBox::clicked, this, [this, &labels](bool on) {
    LabelRules rules = labels.rules();
    rules.editable.reset();
    if (on) rules.editable = range_->range();
    labels.setRules(rules);
  });
  connect(range_, &RangeField::edited, this, [&labels](HuRange range) {
    LabelRules rules = labels.rules();
    rules.editable = range;
    labels.setRules(rules);
  });
  range_->setRange(kUsual_HU);
  connect(&labels, &LabelSession::rulesChanged, this, [this] { refresh(); });
}

void RulesBox::setHistogram(const views::HuHistogram& histogram) {
  range_->setHistogram(histogram);
}

void RulesBox::refresh() {
  const LabelRules& rules = shared_.labeling.rules();
  over_->setCurrentIndex(int(rules.over));
  inside_->setVisible(rules.over == LabelRules::Over::Inside);
  inside_->show(rules.inside);
  limited_->setChecked(rules.editable.has_value());
  range_->setVisible(rules.editable.has_value());
  if (rules.editable) range_->setRange(*rules.editable);
}

}  // namespace insonate::prepare
