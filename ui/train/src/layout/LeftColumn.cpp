#include "LeftColumn.h"

#include <insonate/ui/Theme.h>

#include <QFrame>
#include <QVBoxLayout>
#include <utility>

namespace insonate::train {
namespace {

/// Share of the column's height for the head; the controls keep the rest.
constexpr double kHeadShare = 0.72;

}  // namespace

LeftColumn::LeftColumn(QWidget* controls) : box_(new QVBoxLayout(this)) {
  setObjectName("trainPanel");
  box_->setContentsMargins(0, 0, 0, 0);
  box_->setSpacing(0);
  box_->addWidget(controls, 1);
}

void LeftColumn::setHead(QWidget* head, std::function<void(int maximum_px)> setMaximumHeight) {
  auto* rule = new QFrame;
  ui::setRole(rule, "rule");
  box_->insertWidget(0, head);
  box_->insertWidget(1, rule);
  setHeadHeight_ = std::move(setMaximumHeight);
}

void LeftColumn::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (setHeadHeight_) setHeadHeight_(int(kHeadShare * height()));
}

}  // namespace insonate::train
