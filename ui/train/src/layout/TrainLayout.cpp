#include "TrainLayout.h"

#include "Columns.h"
#include "ControlsColumn.h"
#include "LeftColumn.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

namespace insonate::train {

TrainLayout::TrainLayout(ui::Workspace& workspace)
    : workspace_(workspace),
      controls_(new ControlsColumn),
      leftPages_(new QStackedWidget),
      left_(new LeftColumn(leftPages_)),
      image_(new ImageColumn),
      columns_(new Columns(&workspace)),
      patient_(new QWidget) {
  leftPages_->addWidget(controls_);
  views_ = new SharedViews(workspace.commands(), *image_);
  auto* box = new QVBoxLayout(&workspace);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(columns_);
  ui::setMaximizeArea(columns_);
  auto* column = new QVBoxLayout(patient_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
}

TrainLayout::~TrainLayout() {
  delete columns_;
}

void TrainLayout::setPatient(QWidget* views) {
  static_cast<QVBoxLayout*>(patient_->layout())->addWidget(views, 1);
}

void TrainLayout::addAbovePatient(QWidget* widget) {
  static_cast<QVBoxLayout*>(patient_->layout())->insertWidget(0, widget);
}

void TrainLayout::assemble() {
  columns_->set(left_, image_, patient_);
}

void TrainLayout::addControlsPage(QWidget* page) {
  leftPages_->addWidget(page);
}

void TrainLayout::showControlsPage(QWidget* page) {
  leftPages_->setCurrentWidget(page ? page : controls_);
}

void TrainLayout::showPage(QWidget* page) {
  if (page_) page_->hide();
  page_ = page;
  columns_->setVisible(!page_);
  if (!page_) return;
  workspace_.layout()->addWidget(page_);
  page_->show();
}

bool TrainLayout::isPageShown() const {
  return page_ && page_->isVisibleTo(&workspace_);
}

void TrainLayout::addToViewMenu(QAction& action) {
  const QList<QAction*> others = workspace_.actions();
  workspace_.insertAction(others.isEmpty() ? nullptr : others.front(), &action);
}

}  // namespace insonate::train
