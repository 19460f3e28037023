#include "PathPage.h"

#include "../attempt/AttemptWords.h"
#include "Course.h"
#include "LevelControl.h"
#include "LevelWords.h"
#include "TestAdmissions.h"
#include "TestEntryDialog.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kList_px = 340, kLevel_px = 760;

QString procedureTitle(const std::string& name) {
  const auto procedure = builtInProcedure(name);
  return ui::qt(procedure ? procedure->title : name);
}

QString settingOf(const Level& level) {
  QStringList parts{ui::builtInTitle(ui::qt(level.caseName)), procedureTitle(level.procedure)};
  if (!level.position.empty()) parts << ui::qt(level.position);
  parts << assistanceText(level.assistance);
  return parts.join(QStringLiteral("   ·   "));
}

/// The last attempt of this level that counts; null without one.
const AttemptFacts* lastOf(const std::vector<AttemptFacts>& history, const Curriculum& curriculum, const Level& level) {
  const auto last = std::find_if(history.rbegin(), history.rend(), [&](const AttemptFacts& one) {
    return one.curriculum == curriculum.name && one.level == level.name && one.procedure == level.procedure &&
           isCounted(one, level);
  });
  return last == history.rend() ? nullptr : &*last;
}

/// Each standard, with the sign of the last attempt where there is one.
QString standardsOf(const Level& level, const AttemptFacts* last) {
  QStringList lines;
  const Judgement judgement = last ? judge(level.pass, *last) : Judgement();
  for (std::size_t i = 0; i < level.pass.standards.size(); ++i) {
    const MetricStandard& standard = level.pass.standards[i];
    const QString sign = !last                       ? QStringLiteral("·")
                         : judgement.standardsMet[i] ? QStringLiteral("✓")
                                                     : QStringLiteral("✗");
    lines << sign + QStringLiteral("  ") + (last ? comparedWith(standard, *last) : limitOf(standard));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

PathPage::PathPage(Course& course, LevelControl& levels, TestAdmissions& admissions, QWidget* parent)
    : QWidget(parent),
      course_(course),
      levels_(levels),
      admissions_(admissions),
      head_(ui::paragraph("courseHead", "heading")),
      note_(ui::paragraph("courseNote", "quiet")) {
  auto* columns = new QHBoxLayout;
  columns->setSpacing(ui::kLargeGap);
  columns->addWidget(buildList());
  columns->addWidget(buildLevel(), 1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(head_);
  box->addWidget(note_);
  box->addLayout(columns, 1);
  setFocusProxy(list_);
  connect(&course_, &Course::changed, this, [this] { refresh(); });
  connect(&levels_, &LevelControl::changed, this, [this] { refresh(); });
  connect(&admissions_, &TestAdmissions::changed, this, [this] { refreshLevel(); });
  refresh();
}

QWidget* PathPage::buildList() {
  choice_ = new QComboBox;
  choice_->setObjectName(QStringLiteral("courseChoice"));
  choice_->setAccessibleName(tr("Class"));
  choice_->setToolTip(tr("Class whose curriculum applies"));
  connect(choice_, qOverload<int>(&QComboBox::activated), &course_, &Course::choose);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("levels"));
  list_->setAccessibleName(tr("Levels"));
  list_->setToolTip(tr("Enter starts the selected level"));
  list_->setWordWrap(true);
  connect(list_, &QListWidget::currentRowChanged, this, [this] { refreshLevel(); });
  connect(list_, &QListWidget::itemActivated, this, [this] { practise(); });
  auto* column = new QWidget;
  column->setFixedWidth(kList_px);
  auto* box = new QVBoxLayout(column);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(choice_);
  box->addWidget(list_, 1);
  return column;
}

QWidget* PathPage::buildLevel() {
  title_ = ui::paragraph("levelHead", "title");
  about_ = ui::paragraph("levelAbout");
  why_ = ui::paragraph("levelWhy", "heading");
  test_ = ui::paragraph("levelTest");
  setting_ = ui::paragraph("levelSetting", "quiet");
  pass_ = ui::paragraph("levelPass");
  standards_ = ui::paragraph("levelLimits", "quiet");
  mastery_ = ui::paragraph("levelMastery");
  practise_ = new QPushButton(tr("Practice this level"));
  practise_->setObjectName(QStringLiteral("levelPractise"));
  practise_->setToolTip(tr("Opens the case of the level and sets procedure, position and assistance (Enter)"));
  ui::setRole(practise_, "primary");
  free_ = new QPushButton(tr("Free practice"));
  free_->setObjectName(QStringLiteral("courseFree"));
  free_->setToolTip(tr("Leaves the level; you can then choose any case, procedure and assistance"));
  auto* row = new QHBoxLayout;
  row->addWidget(practise_);
  row->addWidget(free_);
  row->addStretch(1);
  level_ = new QWidget;
  auto* box = new QVBoxLayout(level_);
  box->setContentsMargins(0, 0, ui::kGap, 0);
  box->setSpacing(ui::kGap);
  for (QLabel* one : {title_, setting_, why_, test_, about_}) box->addWidget(one);
  box->addLayout(row);
  for (QLabel* one : {pass_, standards_, mastery_}) box->addWidget(one);
  box->addStretch(1);
  level_->setMaximumWidth(kLevel_px);
  auto* scroll = new QScrollArea;
  scroll->setWidget(level_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  connect(practise_, &QPushButton::clicked, this, [this] { practise(); });
  connect(free_, &QPushButton::clicked, this, [this] {
    levels_.leave();
    Q_EMIT chosen();
  });
  return scroll;
}

void PathPage::refresh() {
  refreshHead();
  refreshList();
  refreshLevel();
}

void PathPage::refreshHead() {
  const Curriculum* curriculum = course_.curriculum();
  head_->setText(curriculum
                     ? tr("%1, version %2, %3")
                           .arg(ui::qt(curriculum->title), QString::number(curriculum->version), course_.origin())
                     : tr("Levels"));
  QString note = course_.error();
  if (note.isEmpty() && !curriculum) note = tr("Looking up your levels ...");
  if (note.isEmpty() && !course_.isSomebodys())
    note = tr("You are a guest: attempts are recorded, but do not count. Sign in (Ctrl+L) to unlock levels.");
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  const auto choices = course_.choices();
  choice_->clear();
  for (const Course::Choice& one : choices) choice_->addItem(ui::qt(one.cohort));
  choice_->setCurrentIndex(course_.chosen());
  choice_->setVisible(choices.size() > 1);
}

void PathPage::refreshList() {
  const Level* was = selected();
  const std::string name = was ? was->name : levels_.level() ? levels_.level()->name : std::string();
  const QSignalBlocker quiet(list_);
  list_->clear();
  const Curriculum* curriculum = course_.curriculum();
  if (!curriculum) return;
  int row = -1, firstDue = -1;
  for (const Level& level : curriculum->levels) {
    const LevelProgress* progress = course_.progressIn(level.name);
    if (!progress) continue;
    const StateWords state = displayText(progress->state);
    QString line = state.word;
    const bool due = progress->state == LevelState::Open || progress->state == LevelState::Lapsed;
    if (due) line += QStringLiteral("   ") + dotsOf(level, *progress);
    if (levels_.level() && levels_.level()->name == level.name) line += tr("   chosen");
    auto* item = new QListWidgetItem(QStringLiteral("%1  %2\n     %3").arg(state.sign, ui::qt(level.title), line));
    item->setForeground(
        ui::toQColor(progress->state == LevelState::Locked ? views::theme::kQuiet : views::theme::kText));
    item->setData(Qt::UserRole, ui::qt(level.name));
    item->setToolTip(ui::plainToolTip(ui::qt(progress->why)));
    list_->addItem(item);
    if (level.name == name) row = list_->count() - 1;
    if (due && firstDue < 0) firstDue = list_->count() - 1;
  }
  list_->setCurrentRow(row >= 0 ? row : std::max(0, firstDue));
}

const Level* PathPage::selected() const {
  const QListWidgetItem* item = list_->currentItem();
  const Curriculum* curriculum = course_.curriculum();
  return item && curriculum ? curriculum->level(item->data(Qt::UserRole).toString().toStdString()) : nullptr;
}

void PathPage::refreshLevel() {
  const Level* level = selected();
  const LevelProgress* progress = level ? course_.progressIn(level->name) : nullptr;
  level_->setVisible(progress);
  if (!progress) return;
  const bool locked = progress->state == LevelState::Locked;
  const auto history = course_.history();
  title_->setText(ui::qt(level->title));
  setting_->setText(settingOf(*level));
  why_->setText(displayText(progress->state).sign + QStringLiteral("  ") + ui::qt(progress->why));
  about_->setText(ui::qt(level->about));
  about_->setVisible(!level->about.empty());
  pass_->setText(tr("To pass: %1").arg(passOf(level->pass)));
  const AttemptFacts* last = lastOf(history, *course_.curriculum(), *level);
  standards_->setText((last ? tr("Your last attempt:\n") : QString()) + standardsOf(*level, last));
  standards_->setVisible(!level->pass.standards.empty());
  mastery_->setText(tr("Mastery: %1.").arg(masteryOf(*level)));
  practise_->setEnabled(!locked);
  test_->setText(admissions_.findingText(*level));
  test_->setVisible(!test_->text().isEmpty());
  const auto admission = admissions_.of(*level);
  const bool isOpen = admission && admission->kind != TestAdmission::Kind::Closed;
  practise_->setText(locked ? tr("Locked") : isOpen ? tr("Take this test") : tr("Practice this level"));
  free_->setVisible(levels_.level());
}

void PathPage::practise() {
  const Level* level = selected();
  if (!level) return;
  const auto admission = admissions_.of(*level);
  const LevelProgress* progress = course_.progressIn(level->name);
  const bool isLocked = !progress || progress->state == LevelState::Locked;
  const bool counts = admissions_.expectedTestConditions(*level) != TestConditions::Practice;
  if (!admission || isLocked || counts) return begin(level->name);
  auto* entry = new TestEntryDialog(admissions_, *level, this);
  connect(entry, &QDialog::accepted, this, [this, name = level->name] { begin(name); });
  entry->open();
}

void PathPage::begin(const std::string& name) {
  levels_.choose(name);
  if (levels_.level() && levels_.level()->name == name) Q_EMIT chosen();
}

}  // namespace insonate::train
