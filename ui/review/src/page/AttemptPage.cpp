#include "AttemptPage.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "../feature/Feature.h"

#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ui/Workspace.h>

#include <QButtonGroup>
#include <QLabel>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

namespace insonate::review {
namespace {

constexpr int kMoments_px = 270, kCenter_px = 700, kScene_px = 460;

QHBoxLayout* rowOf(int spacing_px) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing_px);
  return row;
}

/// Gives the upper widget `upper` parts of the height, and each widget below it 400.
void shareHeight(QSplitter& column, int upper) {
  QList<int> sizes;
  for (int i = 0; i < column.count(); ++i) sizes << (i == 0 ? upper : 400);
  column.setSizes(sizes);
}

}  // namespace

AttemptPage::AttemptPage(const ReviewModel& model)
    : model_(model),
      title_(new QLabel),
      date_(new QLabel),
      facts_(new QLabel),
      notice_(new QLabel),
      tabRow_(rowOf(0)),
      toggleRow_(rowOf(0)),
      buttonRow_(rowOf(ui::kGap)),
      tabs_(new QButtonGroup(this)),
      body_(new QSplitter(Qt::Horizontal)),
      columns_(new QSplitter(Qt::Horizontal)),
      leftColumn_(new QSplitter(Qt::Vertical)),
      rightColumn_(new QSplitter(Qt::Vertical)),
      center_(new QStackedWidget) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  notice_->setObjectName(QStringLiteral("attemptNotice"));
  notice_->setWordWrap(true);
  notice_->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  ui::setRole(notice_, "problem");
  setNotice({});
  box->addWidget(buildBar());
  box->addWidget(notice_);
  box->addWidget(body_, 1);
  auto* main = new QWidget;
  main_ = new QVBoxLayout(main);
  main_->setContentsMargins(0, 0, 0, 0);
  main_->setSpacing(0);
  main_->addWidget(buildColumns(), 1);
  body_->setChildrenCollapsible(false);
  body_->addWidget(main);
  connect(tabs_, &QButtonGroup::idClicked, this, [this](int tab) { showCenter(center_->widget(tab)); });
  connect(&model_.session, &ReviewSession::attemptChanged, this, [this] { showFacts(); });
}

QWidget* AttemptPage::buildBar() {
  ui::Commands& commands = model_.workspace.commands();
  commands.beginSection(tr("Attempt"));
  commands.add({.id = QStringLiteral("review.attempt.close"),
                .text = tr("Attempts"),
                .does = tr("closes the attempt and returns to the list of attempts"),
                .listed = tr("Backspace"),
                .keys = {{Qt::Key_Backspace}},
                .perform = [&session = model_.session](ui::KeyPress) { session.close(); },
                .isAvailable = [&session = model_.session] { return session.attempt() != nullptr; }});
  auto* bar = new QFrame;
  ui::setRole(bar, "bar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  row->setSpacing(ui::kGap);
  auto* back = ui::pushButton("backToList", tr("Attempts"), commands.toolTip(QStringLiteral("review.attempt.close")),
                              Qt::TabFocus);
  back->setIcon(ui::icon(QStringLiteral("left")));
  connect(back, &QPushButton::clicked, this, [this] { model_.session.close(); });
  row->addWidget(back);
  title_->setObjectName(QStringLiteral("attemptTitle"));
  ui::setRole(title_, "heading");
  date_->setObjectName(QStringLiteral("attemptDate"));
  ui::setRole(date_, "quiet");
  facts_->setObjectName(QStringLiteral("attemptFacts"));
  facts_->setTextFormat(Qt::PlainText);  // names and cases are texts of users
  ui::setRole(facts_, "quiet");
  facts_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(title_);
  row->addWidget(date_);
  row->addWidget(facts_, 1);
  row->addLayout(tabRow_);
  row->addLayout(toggleRow_);
  row->addLayout(buttonRow_);
  return bar;
}

QWidget* AttemptPage::buildColumns() {
  columns_->setObjectName(QStringLiteral("reviewColumns"));
  columns_->setChildrenCollapsible(false);
  leftColumn_->setChildrenCollapsible(false);
  leftColumn_->setMinimumWidth(kMoments_px * 3 / 4);
  rightColumn_->setChildrenCollapsible(false);
  columns_->addWidget(leftColumn_);
  columns_->addWidget(center_);
  columns_->addWidget(rightColumn_);
  columns_->setStretchFactor(0, 0);
  columns_->setStretchFactor(1, 3);
  columns_->setStretchFactor(2, 2);
  columns_->setSizes({kMoments_px, kCenter_px, kScene_px});
  ui::setMaximizeArea(columns_);
  return columns_;
}

void AttemptPage::addCenter(const QString& command, const char* object, const QString& text, QWidget* widget) {
  auto* button = ui::tabButton(object, text, model_.workspace.commands().toolTip(command));
  tabs_->addButton(button, center_->addWidget(widget));
  tabRow_->addWidget(button);
}

void AttemptPage::showCenter(QWidget* widget) {
  center_->setCurrentWidget(widget);
  tabs_->button(center_->currentIndex())->setChecked(true);
  Q_EMIT centerChanged();
}

bool AttemptPage::showsCenter(const QWidget* widget) const {
  return center_->currentWidget() == widget;
}

QToolButton* AttemptPage::addToggle(const QString& command, const char* object, const QString& text) {
  auto* button = ui::tabButton(object, text, model_.workspace.commands().toolTip(command));
  toggleRow_->addWidget(button);
  return button;
}

void AttemptPage::addButton(QWidget* button) {
  buttonRow_->addWidget(button);
}

void AttemptPage::addLeft(QWidget* widget) {
  leftColumn_->addWidget(widget);
  shareHeight(*leftColumn_, 500);
}

void AttemptPage::addBelow(QWidget* widget) {
  rightColumn_->addWidget(widget);
  shareHeight(*rightColumn_, 600);
}

void AttemptPage::setForms(QWidget* forms) {
  forms_ = forms;
  forms_->setMinimumWidth(kScene_px * 3 / 4);
  forms_->hide();
  body_->addWidget(forms_);
  body_->setStretchFactor(0, 1);
  body_->setStretchFactor(1, 0);
}

void AttemptPage::showForms(bool shown) {
  const int width_px = rightColumn_->width();
  rightColumn_->setVisible(!shown);
  forms_->setVisible(shown);
  if (shown) body_->setSizes({body_->width() - width_px, width_px});
}

void AttemptPage::addFoot(QWidget* widget) {
  main_->addWidget(widget);
}

void AttemptPage::setNotice(const QString& text) {
  notice_->setText(text);
  notice_->setVisible(!text.isEmpty());
}

void AttemptPage::setTrainee(const QString& name) {
  if (std::exchange(trainee_, name) != name) showFacts();
}

void AttemptPage::showFacts() {
  if (!model_.session.attempt()) return;
  const AttemptRecording& recording = *model_.session.attempt()->recording;
  title_->setText(titleOf(recording.header()));
  date_->setText(dateOf(recording.header().begun));
  // In a narrow window the facts are cut off. The length is last, since it is also beside Play.
  QStringList facts{QString::fromStdString(recording.header().caseName), displayText(recording.status())};
  if (!trainee_.isEmpty()) facts.prepend(trainee_);
  if (const QString hands = displayText(recording.header().hands); !hands.isEmpty()) facts << hands;
  facts << clockOf(recording.end_us());
  facts_->setText(facts.join(QStringLiteral("   ·   ")));
  facts_->setToolTip(ui::plainToolTip(facts_->text()));
}

void AttemptPage::save(QSettings& settings) const {
  settings.setValue(QStringLiteral("columns"), columns_->saveState());
}

void AttemptPage::restore(QSettings& settings) {
  columns_->restoreState(settings.value(QStringLiteral("columns")).toByteArray());
}

}  // namespace insonate::review
