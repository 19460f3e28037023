#include "PathColumn.h"

#include "LabelPages.h"

#include <insonate/ui/Theme.h>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace insonate::prepare {

PathStep::PathStep(const QString& title)
    : title_(title),
      heading_(new QLabel),
      next_(new QLabel(tr("next"))),
      mark_(new QLabel),
      box_(new QVBoxLayout(this)) {
  ui::setRole(heading_, "heading");
  ui::setRole(mark_, "quiet");
  ui::setRole(next_, "next");
  next_->setToolTip(tr("The next thing to do for this case"));
  next_->hide();
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(heading_, 1);
  row->addWidget(next_);
  row->addWidget(mark_);
  box_->setContentsMargins(0, 0, 0, 0);
  box_->setSpacing(ui::kGap);
  box_->addLayout(row);
}

void PathStep::add(QWidget* controls, int stretch) {
  box_->addWidget(controls, stretch);
}

void PathStep::setMark(const QString& mark, State state) {
  mark_->setText(mark);
  state_ = state;
  Q_EMIT stateChanged();
}

void PathStep::setNext(bool isNext) {
  next_->setVisible(isNext);
}

void PathStep::setNumber(int number) {
  heading_->setText(QStringLiteral("%1  %2").arg(number).arg(title_));
}

bool PathStep::isEmpty() const {
  return box_->count() == 1;
}

PathColumn::PathColumn()
    : import_(new PathStep(tr("Import"))),
      label_(new PathStep(tr("Label"))),
      check_(new PathStep(tr("Check"))),
      publish_(new PathStep(tr("Publish"))),
      labelPages_(new LabelPages),
      box_(new QVBoxLayout(this)) {
  label_->add(labelPages_, 1);
  box_->setContentsMargins(12, ui::kGap, 12, ui::kGap);
  box_->setSpacing(ui::kGap + ui::kSmallGap);
  for (PathStep* step : {import_, label_, check_, publish_}) {
    box_->addWidget(step, step == label_ ? 1 : 0);
    connect(step, &PathStep::stateChanged, this, [this] { showNext(); });
  }
}

/// While a step's state is unknown, no later step is next.
void PathColumn::showNext() {
  using State = PathStep::State;
  bool isReached = true;
  for (PathStep* step : {import_, label_, check_, publish_}) {
    step->setNext(isReached && step->state() == State::Open);
    isReached = isReached && step->state() == State::Done;
  }
}

void PathColumn::addFoot(QWidget* foot) {
  box_->addSpacing(ui::kSmallGap);
  box_->addWidget(foot);
}

void PathColumn::assemble() {
  int number = 0;
  for (PathStep* step : {import_, label_, check_, publish_}) {
    step->setVisible(!step->isEmpty());
    if (!step->isEmpty()) step->setNumber(++number);
  }
}

QToolButton* actionButton(QAction* action, Qt::ToolButtonStyle style) {
  auto* button = new QToolButton;
  button->setDefaultAction(action);
  button->setToolButtonStyle(style);
  button->setIconSize({20, 20});
  button->setFocusPolicy(Qt::TabFocus);
  button->setAccessibleName(action->text());
  return button;
}

}  // namespace insonate::prepare
