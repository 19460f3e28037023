#include "RightColumn.h"

#include "../case/CaseFacts.h"
#include "../check/DifficultyBox.h"
#include "../check/FindingsList.h"
#include "../live/UltrasoundPane.h"
#include "../places/PlacesBox.h"
#include "../recipe/RecipeBox.h"
#include "../tools/ToolPanel.h"
#include "../tools/ToolSession.h"
#include "../viewing/SliceControls.h"
#include "Section.h"

#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/Theme.h>

#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kWidth_px = 362, kUltrasound_px = 310;
enum Page { kLook, kCheck };

}  // namespace

RightColumn::RightColumn(PrepareModel& shared, ToolSession& tools, std::shared_ptr<views::SceneView> scene,
                         QWidget* parent)
    : QSplitter(Qt::Vertical, parent),
      tabs_(new QTabBar),
      scroll_(new QScrollArea),
      scene_(new ui::ScenePanel(std::move(scene), nullptr, ui::ScenePanel::Structures::Elsewhere)),
      ultrasound_(new UltrasoundPane(shared)) {
  auto* toolPanel = new ToolPanel(shared, tools);
  tool_ = new Section(QStringLiteral("tool"), tr("Tool"), toolPanel);
  connect(&scene_->histogram(), &ui::HistogramEditor::counted, toolPanel,
          [this, toolPanel] { toolPanel->setHistogram(scene_->histogram().histogram()); });
  setObjectName(QStringLiteral("prepareRight"));
  setChildrenCollapsible(false);
  // Its margins are those of a separate column.
  scene_->layout()->setContentsMargins(0, 0, 0, 0);
  tabs_->setObjectName(QStringLiteral("rightPages"));
  tabs_->setAccessibleName(tr("Beside the slices"));
  tabs_->setDrawBase(false);
  tabs_->setTabToolTip(tabs_->addTab(tr("Case")), tr("Facts, slices and 3D (C)"));
  tabs_->setTabToolTip(tabs_->addTab(tr("Check")), tr("Errors, warnings, difficulty and places (C)"));
  look_ = buildPage({new Section(QStringLiteral("case"), tr("Case"), new CaseFacts(shared)),
                     new Section(QStringLiteral("slices"), tr("Slices"), new SliceControls(shared)),
                     new Section(QStringLiteral("recipe"), tr("Steps"), new RecipeBox(shared)),
                     new Section(QStringLiteral("scene"), tr("3D"), scene_)});
  all_.back()->setOpen(false);
  checkPage_ = buildPage(buildCheck(shared));
  auto* inner = new QWidget;
  auto* box = new QVBoxLayout(inner);
  box->setContentsMargins(12, ui::kGap, 12, ui::kGap);
  box->setSpacing(ui::kGap);
  for (QWidget* each : {static_cast<QWidget*>(tool_), look_, checkPage_}) box->addWidget(each);
  box->addStretch(1);
  tool_->hide();
  scroll_->setWidget(inner);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* head = new QWidget;
  auto* headBox = new QVBoxLayout(head);
  headBox->setContentsMargins(0, ui::kGap, 0, 0);
  headBox->setSpacing(0);
  headBox->addWidget(tabs_);
  headBox->addWidget(scroll_, 1);
  auto* foot = new QWidget;
  auto* footBox = new QVBoxLayout(foot);
  footBox->setContentsMargins(12, ui::kGap, 12, ui::kGap);
  footBox->addWidget(ultrasound_);
  addWidget(head);
  addWidget(foot);
  setStretchFactor(0, 1);
  setStretchFactor(1, 0);
  setSizes({1000, kUltrasound_px});
  setMinimumWidth(kWidth_px);
  connect(tabs_, &QTabBar::currentChanged, this, [this] { showPage(); });
  showPage();
}

std::vector<Section*> RightColumn::buildCheck(PrepareModel& shared) {
  auto* findings = new FindingsList(shared);
  auto* places = new PlacesBox(shared);
  check_ = new Section(QStringLiteral("check"), tr("Findings"), findings);
  auto* placesSection = new Section(QStringLiteral("places"), tr("Targets and landmarks"), places);
  connect(findings, &FindingsList::labelWanted, this, &RightColumn::labelWanted);
  connect(places, &PlacesBox::markingBegun, this, &RightColumn::markingBegun);
  connect(findings, &FindingsList::placeWanted, this, [this, places, placesSection](const QString& kind) {
    placesSection->setOpen(true);
    places->offer(kind);
    // Its position is known only after the next layout.
    QMetaObject::invokeMethod(
        this, [this, places] { scroll_->ensureWidgetVisible(places); }, Qt::QueuedConnection);
  });
  return {check_, new Section(QStringLiteral("difficulty"), tr("Difficulty"), new DifficultyBox(shared)),
          placesSection};
}

QWidget* RightColumn::buildPage(const std::vector<Section*>& sections) {
  auto* page = new QWidget;
  auto* box = new QVBoxLayout(page);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  for (Section* section : sections) box->addWidget(section), all_.push_back(section);
  return page;
}

void RightColumn::showPage() {
  look_->setVisible(!showsCheck());
  checkPage_->setVisible(showsCheck());
  scroll_->verticalScrollBar()->setValue(0);
}

bool RightColumn::showsCheck() const {
  return tabs_->currentIndex() == kCheck;
}

void RightColumn::setCheckShown(bool shown) {
  tabs_->setCurrentIndex(shown ? kCheck : kLook);
  if (shown) check_->setOpen(true);
}

void RightColumn::setToolShown(bool shown) {
  tool_->setVisible(shown);
  tool_->setOpen(true);
  scroll_->verticalScrollBar()->setValue(0);
}

void RightColumn::setToolRemark(const QString& remark) {
  tool_->setRemark(remark);
}

void RightColumn::setCheckRemark(const QString& remark) {
  check_->setRemark(remark);
}

void RightColumn::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("right"), saveState());
  for (const Section* section : all_) settings.setValue(QStringLiteral("open-") + section->key(), section->isOpen());
}

void RightColumn::restore(QSettings& settings) {
  restoreState(settings.value(QStringLiteral("right")).toByteArray());
  for (Section* section : all_)
    section->setOpen(settings.value(QStringLiteral("open-") + section->key(), section->isOpen()).toBool());
}

}  // namespace insonate::prepare
