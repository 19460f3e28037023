#include "PathPanel.h"

#include "../check/FindingsList.h"
#include "../guide/GuidePage.h"
#include "../guide/GuideSession.h"
#include "../model/CaseMeasuring.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../publish/PublishStep.h"
#include "../structures/StructureTable.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::prepare {

PathPanel::PathPanel(PrepareModel& shared, GuideSession& guide, ui::TaskBar& tasks, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      guide_(guide),
      caseRow_(new QHBoxLayout),
      editRow_(new QHBoxLayout),
      table_(new StructureTable(shared)),
      tabs_(new QTabBar),
      labelling_(new QStackedWidget),
      check_(new QPushButton(tr("Findings"))) {
  for (QHBoxLayout* row : {caseRow_, editRow_}) {
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(ui::kSmallGap);
  }
  check_->setToolTip(tr("Errors, warnings, difficulty and places (C)"));
  check_->setObjectName(QStringLiteral("toFindings"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(12, ui::kGap, 12, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addWidget(step(tr("1  Import"), importMark_));
  box->addLayout(caseRow_);
  box->addSpacing(ui::kSmallGap);
  box->addWidget(step(tr("2  Label"), labelMark_));
  box->addWidget(buildLabelling());
  box->addWidget(labelling_, 1);
  box->addSpacing(ui::kSmallGap);
  box->addWidget(step(tr("3  Check"), checkMark_));
  box->addWidget(check_);
  box->addSpacing(ui::kSmallGap);
  box->addWidget(step(tr("4  Publish"), publishMark_));
  box->addWidget(new PublishStep(shared, tasks, *publishMark_));
  box->addSpacing(ui::kGap);
  box->addLayout(editRow_);
  connect(check_, &QPushButton::clicked, this, &PathPanel::checkChosen);
  connect(&shared_.openCase, &OpenCase::originChanged, this, [this] { refresh(); });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] {
    chosen_ = false;
    refresh();
  });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { refresh(); });
  refresh();
}

/// Guide and table show the labels, one at a time, since both need the column's height.
QWidget* PathPanel::buildLabelling() {
  labelling_->addWidget(new GuidePage(guide_));
  labelling_->addWidget(table_);
  tabs_->setObjectName(QStringLiteral("labelling"));
  tabs_->setAccessibleName(tr("Labeling"));
  tabs_->setDrawBase(false);
  tabs_->setTabToolTip(tabs_->addTab(tr("Guide")), tr("Step by step through the structures of a neck"));
  tabs_->setTabToolTip(tabs_->addTab(tr("Structures")), tr("All structures of the case, with color and visibility"));
  connect(tabs_, &QTabBar::currentChanged, labelling_, &QStackedWidget::setCurrentIndex);
  connect(tabs_, &QTabBar::tabBarClicked, this, [this] { chosen_ = true; });
  tabs_->setCurrentIndex(1);
  return tabs_;
}

/// A neck without a vein must be labeled first; an author who has started with the guide continues with it.
void PathPanel::chooseLabelling() {
  if (std::exchange(chosen_, true)) return;
  const bool vein = std::ranges::find(shared_.structures.labels(), kVein) != shared_.structures.labels().end();
  showGuide(!vein || guide_.goesOn());
}

void PathPanel::showGuide(bool guide) {
  tabs_->setCurrentIndex(guide ? 0 : 1);
}

QWidget* PathPanel::step(const QString& title, QLabel*& mark) {
  auto* row = new QWidget;
  auto* heading = new QLabel(title);
  ui::setRole(heading, "heading");
  mark = new QLabel;
  ui::setRole(mark, "quiet");
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(heading, 1);
  box->addWidget(mark);
  return row;
}

QToolButton* PathPanel::button(QAction* action, bool withText) {
  auto* button = new QToolButton;
  button->setDefaultAction(action);
  button->setToolButtonStyle(withText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
  button->setIconSize({20, 20});
  button->setFocusPolicy(Qt::TabFocus);
  button->setAccessibleName(action->text());
  return button;
}

void PathPanel::setCaseActions(QAction* open, QAction* import, QAction* reload) {
  // Texts of the menu are long; the tooltips have the details.
  const std::pair<QAction*, QString> all[] = {{open, tr("Open")}, {import, tr("Import")}, {reload, tr("Reload")}};
  for (const auto& [action, word] : all) {
    QToolButton* made = button(action, true);
    made->setText(word);
    made->setToolButtonStyle(Qt::ToolButtonTextOnly);
    connect(action, &QAction::changed, made, [made, text = word] { made->setText(text); });
    caseRow_->addWidget(made);
  }
  caseRow_->addStretch(1);
}

void PathPanel::setEditActions(QAction* undo, QAction* redo, QAction* save) {
  editRow_->addWidget(button(undo, false));
  editRow_->addWidget(button(redo, false));
  editRow_->addStretch(1);
  editRow_->addWidget(button(save, true));
}

void PathPanel::refresh() {
  const ui::CaseOrigin& origin = shared_.openCase.origin();
  importMark_->setText(origin.builtIn                ? tr("built in")
                       : !origin.versionOf.isEmpty() ? tr("earlier version")
                       : origin.folder.isEmpty()     ? tr("not saved")
                                                     : tr("done"));
  const auto& measures = shared_.measuring.measures();
  if (!measures) {
    const bool stopped = shared_.measuring.state() == CaseMeasuring::State::Stopped;
    labelMark_->setText(stopped ? tr("not measured") : tr("measuring ..."));
    checkMark_->setText(stopped ? tr("not checked") : tr("checking ..."));
    return;
  }
  chooseLabelling();
  const int count = int(shared_.structures.labels().size());
  labelMark_->setText(count == 0 ? tr("nothing yet") : count == 1 ? tr("1 structure") : tr("%1 structures").arg(count));
  checkMark_->setText(findingCount(measures->findings));
}

}  // namespace insonate::prepare
