#include "ToolPanel.h"

#include "../labels/LabelSession.h"
#include "../model/PrepareModel.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "LabelBox.h"
#include "RangeField.h"
#include "RulesBox.h"
#include "ToolSession.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kSlow_ms = 400;

}  // namespace

ToolPanel::ToolPanel(PrepareModel& shared, ToolSession& tools, const ui::Commands& commands)
    : shared_(shared),
      tools_(tools),
      applies_(tr("%1; Ctrl+Z undoes the change").arg(commands.toolTip(QStringLiteral("prepare.tools.apply")))),
      leaves_(commands.toolTip(QStringLiteral("prepare.tools.leave"))),
      name_(new QLabel),
      advice_(new QLabel),
      told_(ui::paragraph("toolTold", "problem")),
      label_(new LabelBox(shared, tr("Label that the tool writes"), tr("Label that the tool writes (Q, W)"))),
      rules_(new RulesBox(shared)),
      histogram_(std::make_unique<views::HuHistogram>()),
      preview_(ui::pushButton("toolPreview", tr("Preview"),
                              tr("Previews the result on the slices and in 3D; the labels do not change"))),
      apply_(ui::pushButton("toolApply", tr("Apply"), {})),
      leave_(ui::pushButton("toolLeave", tr("Cancel"), {})),
      box_(new QVBoxLayout(this)) {
  name_->setObjectName(QStringLiteral("toolLabel"));
  ui::setRole(name_, "heading");
  label_->setObjectName(QStringLiteral("toolFor"));
  advice_->setObjectName(QStringLiteral("toolAdvice"));
  advice_->setWordWrap(true);
  ui::setRole(advice_, "quiet");
  ui::setRole(apply_, "primary");
  told_->hide();
  arrange();
  slow_.setSingleShot(true);
  slow_.setInterval(kSlow_ms);
  connect(&slow_, &QTimer::timeout, this, [this] { preview_->setText(tr("Computing ...")); });
  connect(&shared_.labeling.preview(), &LabelPreview::computingChanged, this, [this] { showComputing(); });
  connect(preview_, &QPushButton::clicked, this, [this] { tools_.preview(); });
  connect(apply_, &QPushButton::clicked, this, [this] { tools_.apply(); });
  connect(leave_, &QPushButton::clicked, this, [this] { tools_.leave(); });
  connect(label_, &LabelBox::chosen, this, [this](std::uint8_t label) { shared_.structures.select(label); });
  connect(&tools_, &ToolSession::toolChanged, this, [this] { build(); });
  connect(&tools_, &ToolSession::parametersChanged, this, [this] { refresh(); });
  connect(&tools_, &ToolSession::pointsChanged, this, [this] { refresh(); });
  connect(&tools_, &ToolSession::messageReported, this, [this](const QString& sentence) {
    told_->setText(sentence);
    told_->setVisible(!sentence.isEmpty());
  });
  connect(&shared_.structures, &StructureList::selectedChanged, this, [this] { refresh(); });
  connect(&shared_.appearance, &StructureAppearance::lookChanged, this, [this] { refresh(); });
  build();
}

ToolPanel::~ToolPanel() = default;

/// Delay before a slow preview is indicated, so that nothing flickers while a preview follows a slider.
void ToolPanel::showComputing() {
  if (shared_.labeling.preview().isComputing()) return slow_.start();
  slow_.stop();
  preview_->setText(tr("Preview"));
}

void ToolPanel::arrange() {
  auto* head = new QHBoxLayout;
  head->addWidget(name_);
  head->addWidget(label_, 1);
  auto* row = new QHBoxLayout;
  for (QPushButton* one : {preview_, apply_, leave_}) row->addWidget(one, 1);
  box_->setContentsMargins(0, 0, 0, 0);
  box_->setSpacing(ui::kSmallGap);
  box_->addLayout(head);
  box_->addWidget(advice_);
  box_->addWidget(rules_);
  box_->addWidget(told_);
  box_->addLayout(row);
}

void ToolPanel::setHistogram(const views::HuHistogram& histogram) {
  *histogram_ = histogram;
  rules_->setHistogram(histogram);
  if (range_) range_->setHistogram(histogram);
}

void ToolPanel::addNumber(QVBoxLayout& box, const ToolNumber& number) {
  auto* field = new ui::ValueSlider(number.name, number.unit, tools_.rangeOf(number), number.hint);
  field->setObjectName(QStringLiteral("tool-") + number.id);
  box.addWidget(field);
  connect(field, &ui::ValueSlider::valueChanged, this, [this, &number](double value) {
    if (!showing_) tools_.setNumber(number, value);
  });
  shown_.push_back([this, field, &number] { field->setValue(number.get(tools_.parameters())); });
}

void ToolPanel::addChoice(QVBoxLayout& box, const ToolChoice& choice) {
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(choice.name);
  auto* field = new QComboBox;
  field->setObjectName(QStringLiteral("tool-") + choice.id);
  field->setAccessibleName(choice.name);
  field->setToolTip(choice.hint);
  field->addItems(choice.words);
  name->setBuddy(field);
  row->addWidget(name);
  row->addWidget(field, 1);
  box.addLayout(row);
  connect(field, qOverload<int>(&QComboBox::activated), this,
          [this, &choice](int index) { tools_.setChoice(choice, index); });
  shown_.push_back([this, field, &choice] { field->setCurrentIndex(choice.get(tools_.parameters())); });
}

void ToolPanel::addRange(QVBoxLayout& box) {
  range_ = new RangeField(QStringLiteral("tool"));
  range_->setHistogram(*histogram_);
  box.addWidget(range_);
  connect(range_, &RangeField::edited, &tools_, &ToolSession::setRange);
  shown_.push_back([this] {
    range_->setRange(tools_.tool()->range->get(tools_.parameters()));
    range_->setColor(shared_.appearance.look(shared_.structures.selected()).color);
  });
}

void ToolPanel::addOther(QVBoxLayout& box) {
  const ToolLabel& other = *tools_.tool()->other;
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(other.name);
  auto* field = new LabelBox(shared_, other.hint, other.hint);
  field->setObjectName(QStringLiteral("toolOther"));
  name->setBuddy(field);
  row->addWidget(name);
  row->addWidget(field, 1);
  box.addLayout(row);
  connect(field, &LabelBox::chosen, &tools_, &ToolSession::setOther);
  shown_.push_back([this, field, &other] { field->show(other.get(tools_.parameters())); });
}

void ToolPanel::build() {
  delete fields_;
  range_ = nullptr;
  shown_.clear();
  fields_ = new QWidget;
  auto* box = new QVBoxLayout(fields_);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box_->insertWidget(2, fields_);
  if (const Tool* const tool = tools_.tool()) {
    for (const ToolNumber& number : tool->numbers) addNumber(*box, number);
    if (tool->range) addRange(*box);
    for (const ToolChoice& choice : tool->choices) addChoice(*box, choice);
    if (tool->other) addOther(*box);
  }
  refresh();
}

void ToolPanel::refresh() {
  const Tool* const tool = tools_.tool();
  if (!tool) return;
  showing_ = true;
  for (const auto& show : shown_) show();
  showing_ = false;
  name_->setText(tool->name);
  label_->show(shared_.structures.selected());
  const int missing = tool->minPoints - int(tools_.points().size());
  // Points on other slices are not visible.
  const bool clicked = tool->input == ToolInput::Points && !tools_.points().empty();
  advice_->setText(shared_.structures.selected() == kBackground
                       ? tr("Choose a label in the table on the left first, or add one there.")
                   : clicked ? tr("%1 Clicks so far: %2.").arg(tool->advice).arg(tools_.points().size())
                             : tool->advice);
  const bool brush = tool->input == ToolInput::Brush;
  leave_->setText(brush ? tr("Done") : tr("Cancel"));
  leave_->setToolTip(leaves_);
  preview_->setVisible(!brush);
  apply_->setVisible(!brush);
  preview_->setEnabled(tools_.isComplete());
  apply_->setEnabled(tools_.isComplete());
  apply_->setToolTip(missing > 0 ? tr("Click %1 more points on the slices first").arg(missing) : applies_);
}

}  // namespace insonate::prepare
