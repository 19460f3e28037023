#include "ToolPanel.h"

#include "../PrepareSession.h"
#include "ToolSession.h"

#include <insonate/ui/QuietWheel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

QPushButton* button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QLatin1String(name));
  made->setToolTip(tip);
  return made;
}

}  // namespace

ToolPanel::ToolPanel(PrepareSession& session, ToolSession& tools, QWidget* parent)
    : QWidget(parent),
      session_(session),
      tools_(tools),
      label_(new QLabel),
      advice_(new QLabel),
      preview_(button("toolPreview", tr("Preview"), tr("Show on the slices what would be written"))),
      apply_(button("toolApply", tr("Apply"), tr("Write it to the labels (Enter); Ctrl+Z takes it back"))),
      leave_(button("toolLeave", tr("Cancel"), tr("Stop, forget what was clicked, or lay the tool away (Esc)"))),
      box_(new QVBoxLayout(this)) {
  label_->setObjectName(QStringLiteral("toolLabel"));
  advice_->setWordWrap(true);
  ui::setRole(advice_, "quiet");
  ui::setRole(apply_, "primary");
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  for (QPushButton* one : {preview_, apply_, leave_}) row->addWidget(one, 1);
  box_->setContentsMargins(0, 0, 0, 0);
  box_->setSpacing(ui::kSmallGap);
  box_->addWidget(label_);
  box_->addWidget(advice_);
  box_->addLayout(row);
  connect(preview_, &QPushButton::clicked, this, [this] { tools_.preview(); });
  connect(apply_, &QPushButton::clicked, this, [this] { tools_.apply(); });
  connect(leave_, &QPushButton::clicked, this, [this] { tools_.leave(); });
  connect(&tools_, &ToolSession::toolChanged, this, [this] { build(); });
  connect(&tools_, &ToolSession::parametersChanged, this, [this] { refresh(); });
  connect(&tools_, &ToolSession::pointsChanged, this, [this] { refresh(); });
  connect(&session_, &PrepareSession::selectedChanged, this, [this] { refresh(); });
  build();
}

void ToolPanel::build() {
  delete fields_;
  shown_.clear();
  fields_ = new QWidget;
  auto* box = new QVBoxLayout(fields_);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box_->insertWidget(2, fields_);
  if (const Tool* const tool = tools_.tool()) {
    for (const ToolNumber& number : tool->numbers) {
      auto* field = new ui::ValueSlider(number.name, number.unit, number.range, number.hint);
      field->setObjectName(QStringLiteral("tool-") + number.name);
      box->addWidget(field);
      connect(field, &ui::ValueSlider::valueChanged, this, [this, &number](double value) {
        if (!showing_) tools_.setNumber(number, value);
      });
      shown_.push_back([this, field, &number] { field->setValue(number.get(tools_.parameters())); });
    }
    for (const ToolChoice& choice : tool->choices) {
      auto* row = new QHBoxLayout;
      auto* name = new QLabel(choice.name);
      auto* field = new QComboBox;
      new ui::QuietWheel(field);
      field->setObjectName(QStringLiteral("tool-") + choice.name);
      field->setAccessibleName(choice.name);
      field->setToolTip(choice.hint);
      field->addItems(choice.words);
      name->setBuddy(field);
      row->addWidget(name);
      row->addWidget(field, 1);
      box->addLayout(row);
      connect(field, qOverload<int>(&QComboBox::activated), this,
              [this, &choice](int index) { tools_.setChoice(choice, index); });
      shown_.push_back([this, field, &choice] { field->setCurrentIndex(choice.get(tools_.parameters())); });
    }
  }
  refresh();
}

void ToolPanel::refresh() {
  const Tool* const tool = tools_.tool();
  if (!tool) return;
  showing_ = true;
  for (const auto& show : shown_) show();
  showing_ = false;
  label_->setText(session_.selected() == 0 ? tr("<b>%1</b>: choose a label on the left").arg(tool->name)
                                           : tr("<b>%1</b>: %2").arg(tool->name, structureName(session_.selected())));
  const int missing = tool->leastPoints - int(tools_.points().size());
  advice_->setText(tool->advice);
  const bool brush = tool->input == ToolInput::Brush;
  preview_->setVisible(!brush);
  apply_->setVisible(!brush);
  preview_->setEnabled(tools_.isComplete());
  apply_->setEnabled(tools_.isComplete());
  apply_->setToolTip(missing > 0 ? tr("Click %1 more on the slices first").arg(missing)
                                 : tr("Write it to the labels (Enter); Ctrl+Z takes it back"));
}

}  // namespace insonate::prepare
