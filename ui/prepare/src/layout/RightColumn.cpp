#include "RightColumn.h"

#include "Section.h"

#include <insonate/ui/Theme.h>

#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kFoot_px = 310;
enum Page { kCasePage, kCheckPage };

QVBoxLayout* sectionBox(QWidget* page) {
  auto* box = new QVBoxLayout(page);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  return box;
}

}  // namespace

RightColumn::RightColumn()
    : QSplitter(Qt::Vertical),
      tabs_(new QTabBar),
      scroll_(new QScrollArea),
      casePage_(new QWidget),
      checkPage_(new QWidget) {
  setObjectName(QStringLiteral("prepareRight"));
  setChildrenCollapsible(false);
  tabs_->setObjectName(QStringLiteral("rightPages"));
  tabs_->setAccessibleName(tr("Panel beside the slices"));
  tabs_->setDrawBase(false);
  tabs_->addTab(tr("Case"));
  tabs_->addTab(tr("Check"));
  case_ = sectionBox(casePage_);
  check_ = sectionBox(checkPage_);
  auto* inner = new QWidget;
  auto* box = new QVBoxLayout(inner);
  box->setContentsMargins(12, ui::kGap, 12, ui::kGap);
  box->setSpacing(ui::kGap);
  top_ = new QVBoxLayout;
  top_->setSpacing(ui::kGap);
  box->addLayout(top_);
  for (QWidget* page : {casePage_, checkPage_}) box->addWidget(page);
  box->addStretch(1);
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
  addWidget(head);
  setStretchFactor(0, 1);
  connect(tabs_, &QTabBar::currentChanged, this, [this] { showPage(); });
  showPage();
}

Section& RightColumn::addSection(Place place, const QString& key, const QString& title, QWidget* content) {
  auto* section = new Section(key, title, content);
  (place == Place::Top ? top_ : place == Place::Case ? case_ : check_)->addWidget(section);
  if (place == Place::Top)
    section->hide();
  else
    all_.push_back(section);
  return *section;
}

void RightColumn::setFoot(QWidget* foot) {
  auto* frame = new QWidget;
  auto* box = new QVBoxLayout(frame);
  box->setContentsMargins(12, ui::kGap, 12, ui::kGap);
  box->addWidget(foot);
  addWidget(frame);
  setStretchFactor(1, 0);
  setSizes({1000, kFoot_px});
}

void RightColumn::setTips(const QString& casePage, const QString& checkPage) {
  tabs_->setTabToolTip(kCasePage, casePage);
  tabs_->setTabToolTip(kCheckPage, checkPage);
}

void RightColumn::showPage() {
  casePage_->setVisible(!showsCheck());
  checkPage_->setVisible(showsCheck());
  scroll_->verticalScrollBar()->setValue(0);
}

bool RightColumn::showsCheck() const {
  return tabs_->currentIndex() == kCheckPage;
}

void RightColumn::showCheck(bool isShown) {
  tabs_->setCurrentIndex(isShown ? kCheckPage : kCasePage);
}

void RightColumn::setShown(Section& section, bool isShown) {
  section.setVisible(isShown);
  section.setOpen(true);
  scroll_->verticalScrollBar()->setValue(0);
}

void RightColumn::scrollTo(QWidget& widget) {
  // Its position is known only after the next layout.
  QMetaObject::invokeMethod(
      &widget, [this, &widget] { scroll_->ensureWidgetVisible(&widget); }, Qt::QueuedConnection);
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
