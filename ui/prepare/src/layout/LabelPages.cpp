#include "LabelPages.h"

#include <insonate/ui/Theme.h>

#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <utility>

namespace insonate::prepare {

LabelPages::LabelPages() : tabs_(new QTabBar), stack_(new QStackedWidget) {
  tabs_->setObjectName(QStringLiteral("labelling"));
  tabs_->setAccessibleName(tr("Labeling"));
  tabs_->setDrawBase(false);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(tabs_);
  box->addWidget(stack_, 1);
  connect(tabs_, &QTabBar::currentChanged, stack_, &QStackedWidget::setCurrentIndex);
  connect(tabs_, &QTabBar::tabBarClicked, this, &LabelPages::chosen);
}

void LabelPages::add(QWidget* page, const QString& title, const QString& tip, Make make) {
  stack_->addWidget(page);
  makes_.push_back(std::move(make));
  tabs_->setTabToolTip(tabs_->addTab(title), tip);
}

void LabelPages::showPage(QWidget* page) {
  tabs_->setCurrentIndex(stack_->indexOf(page));
}

void LabelPages::leavePage(QWidget* page) {
  if (stack_->currentWidget() != page) return;
  tabs_->setCurrentIndex((stack_->indexOf(page) + 1) % stack_->count());
}

void LabelPages::makeStructure(std::uint8_t label) {
  for (std::size_t page = 0; page < makes_.size(); ++page)
    if (makes_[page](label)) return tabs_->setCurrentIndex(int(page));
}

}  // namespace insonate::prepare
