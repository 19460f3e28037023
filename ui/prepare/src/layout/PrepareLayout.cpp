#include "PrepareLayout.h"

#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "CaseViews.h"
#include "PathColumn.h"
#include "RightColumn.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/ViewWidget.h>

#include <QHBoxLayout>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kPath_px = 284, kRight_px = 362;

ui::EmptyWorkspace* makeEmpty() {
  auto* empty = new ui::EmptyWorkspace(
      {QStringLiteral("prepare"),
       QObject::tr("Prepare a case"),
       {QObject::tr("Drop a case folder, a folder of DICOM files, or an NRRD, NIfTI or MetaImage file here."),
        QObject::tr("A step-by-step guide leads from an imported CT to a labeled neck. Insonate then checks the case. "
                    "Once the check finds no errors, publish the case for trainees.")},
       {},
       {}});
  empty->setObjectName(QStringLiteral("prepareEmpty"));
  return empty;
}

}  // namespace

PrepareLayout::PrepareLayout(ui::Workspace& workspace, PrepareModel& model)
    : workspace_(workspace),
      model_(model),
      pages_(new QStackedLayout(&workspace)),
      empty_(makeEmpty()),
      columns_(new QSplitter(Qt::Horizontal, &workspace)),
      path_(new PathColumn),
      middle_(new QWidget),
      views_(new CaseViews(model)),
      right_(new RightColumn) {
  pages_->setContentsMargins(0, 0, 0, 0);
  columns_->setObjectName(QStringLiteral("prepareColumns"));
  columns_->setChildrenCollapsible(false);
  path_->setMinimumWidth(kPath_px);
  right_->setMinimumWidth(kRight_px);
  auto* box = new QVBoxLayout(middle_);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  bars_ = new QHBoxLayout;
  bars_->setSpacing(0);
  box->addLayout(bars_);
  box->addWidget(views_, 1);
  for (ui::ViewWidget* view : views_->widgets()) offerKeys(*view);
}

PrepareLayout::~PrepareLayout() {
  delete columns_;
  delete empty_;
}

void PrepareLayout::addBar(QWidget* bar) {
  bars_->addWidget(bar, bars_->count() == 0 ? 1 : 0);
}

void PrepareLayout::addBanner(QWidget* banner) {
  static_cast<QVBoxLayout*>(middle_->layout())->insertWidget(0, banner);
}

void PrepareLayout::offerKeys(ui::ViewWidget& view) {
  ui::CanvasInput::of(*view.focusProxy()).add(ui::InputRank::Commands, workspace_);
}

void PrepareLayout::assemble() {
  path_->assemble();
  columns_->addWidget(path_);
  columns_->addWidget(middle_);
  columns_->addWidget(right_);
  columns_->setStretchFactor(0, 0);
  columns_->setStretchFactor(1, 1);
  columns_->setStretchFactor(2, 0);
  columns_->setSizes({kPath_px, 1000, kRight_px});
  pages_->addWidget(empty_);
  pages_->addWidget(columns_);
  QObject::connect(&model_.openCase, &OpenCase::caseChanged, columns_, [this] {
    pages_->setCurrentWidget(model_.openCase.patient() ? static_cast<QWidget*>(columns_) : empty_);
  });
}

}  // namespace insonate::prepare
