#include "CurriculumWindow.h"

#include "../account/EntryDialog.h"
#include "CurriculumController.h"
#include "LevelForm.h"
#include "LevelList.h"
#include "LevelSituationsView.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

using Kind = OfferedCurriculum::Kind;

constexpr int kSide_px = 320, kShelf_px = 150;

QString displayText(const OfferedCurriculum& offer) {
  if (offer.kind == Kind::Draft) return CurriculumWindow::tr("%1: draft").arg(qt(offer.name));
  const QString version = CurriculumWindow::tr("%1, version %2").arg(qt(offer.name), QString::number(offer.version));
  return offer.kind == Kind::Published ? version : CurriculumWindow::tr("%1 (comes with Insonate)").arg(version);
}

}  // namespace

CurriculumWindow::CurriculumWindow(Account& account, QWidget* parent)
    : QDialog(parent),
      controller_(new CurriculumController(account, this)),
      shelf_(new QListWidget),
      levels_(new LevelList),
      form_(new LevelForm(controller_->known())),
      story_(new LevelSituationsView),
      cohort_(new QComboBox),
      state_(paragraph("curriculumState")),
      words_(paragraph("curriculumWords")) {
  setWindowTitle(tr("Curricula and levels"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* scroll = new QScrollArea;
  scroll->setWidget(form_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* side = new QWidget;
  side->setFixedWidth(kSide_px);
  auto* left = new QVBoxLayout(side);
  left->setContentsMargins(0, 0, 0, 0);
  left->setSpacing(kLargeGap);
  left->addWidget(buildShelf());
  left->addWidget(levels_, 1);
  auto* right = new QVBoxLayout;
  right->setSpacing(kGap);
  right->addWidget(buildBar());
  right->addWidget(contest_ = buildContest());
  right->addWidget(teaching_ = buildTeaching());
  right->addWidget(words_);
  right->addWidget(scroll, 1);
  right->addWidget(story_);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  columns->setSpacing(kLargeGap);
  columns->addWidget(side);
  columns->addLayout(right, 1);
  const QSize screen = QGuiApplication::primaryScreen() ? QGuiApplication::primaryScreen()->availableSize() : QSize();
  resize((screen * 0.9).expandedTo(minimumSizeHint()).boundedTo(screen));
  connectParts();
  // The next user must not see anything that was read for the former one.
  connect(&account, &Account::changed, this, [this, &account, whose = account.person().id] {
    if (account.person().id != whose) QDialog::reject();
  });
  words_->hide();
  showCurriculum();
  showSaving();
}

QPushButton* CurriculumWindow::button(const char* name, const QString& words, const QString& tip,
                                      void (CurriculumWindow::*act)()) {
  auto* made = pushButton(name, words, tip);
  connect(made, &QPushButton::clicked, this, act);
  return made;
}

QWidget* CurriculumWindow::buildShelf() {
  named(shelf_, "curricula", tr("Curricula"),
        tr("List of curricula: drafts, published versions and built-in curricula"));
  shelf_->setFixedHeight(kShelf_px);
  new_ =
      button("curriculumNew", tr("New ..."), tr("Begins a new curriculum as an empty draft"), &CurriculumWindow::begin);
  version_ = button("curriculumVersion", tr("New version"), tr("Begins a draft as a copy of the version shown"),
                    &CurriculumWindow::beginVersion);
  discard_ = button("curriculumDiscard", tr("Discard ..."),
                    tr("Discards the selected draft; published versions are unchanged"), &CurriculumWindow::discard);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSmallGap);
  for (QPushButton* one : {new_, version_, discard_}) row->addWidget(one);
  auto* heading = new QLabel(tr("Curricula"));
  setRole(heading, "heading");
  auto* part = new QWidget;
  auto* box = new QVBoxLayout(part);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kGap);
  box->addWidget(heading);
  box->addWidget(shelf_);
  box->addLayout(row);
  return part;
}

QWidget* CurriculumWindow::buildBar() {
  undo_ = named(new QPushButton(tr("Undo")), "curriculumUndo", tr("Undo"), tr("Undoes the last change (Ctrl+Z)"));
  redo_ =
      named(new QPushButton(tr("Redo")), "curriculumRedo", tr("Redo"), tr("Redoes the last undone change (Ctrl+Y)"));
  undo_->setShortcut(QKeySequence::Undo);
  redo_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Y")));
  for (QPushButton* one : {undo_, redo_}) one->setAutoDefault(false);
  connect(undo_, &QPushButton::clicked, controller_, &CurriculumController::undo);
  connect(redo_, &QPushButton::clicked, controller_, &CurriculumController::redo);
  publish_ = button("curriculumPublish", tr("Publish ..."),
                    tr("Publishes the draft as a version that can no longer change"), &CurriculumWindow::publish);
  setRole(publish_, "primary");
  setRole(state_, "quiet");
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap);
  row->addWidget(state_, 1);
  for (QPushButton* one : {undo_, redo_, publish_}) row->addWidget(one);
  return bar;
}

QWidget* CurriculumWindow::buildContest() {
  auto* theirs = named(new QPushButton(tr("Reload")), "curriculumTheirs", tr("Reload"),
                       tr("Shows the saved draft and discards your changes"));
  auto* mine = named(new QPushButton(tr("Overwrite")), "curriculumMine", tr("Overwrite"),
                     tr("Saves your draft and discards the other user's changes"));
  for (QPushButton* one : {theirs, mine}) one->setAutoDefault(false);
  connect(theirs, &QPushButton::clicked, controller_, &CurriculumController::reloadDraft);
  connect(mine, &QPushButton::clicked, controller_, &CurriculumController::overwriteTheirs);
  auto* label = paragraph("curriculumContest");
  label->setText(
      tr("Another user has saved this draft in the meantime. Choose which draft to keep; until then, your changes are "
         "not saved."));
  setRole(label, "problem");
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label, 1);
  row->addWidget(theirs);
  row->addWidget(mine);
  return part;
}

QWidget* CurriculumWindow::buildTeaching() {
  named(cohort_, "curriculumCohort", tr("Class"), tr("Class to which you can assign this version"));
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap);
  cohort_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row->addWidget(new QLabel(tr("Class")));
  row->addWidget(cohort_, 1);
  row->addWidget(button("curriculumTeach", tr("Assign version to class"),
                        tr("Assigns this version to the class; the attempts of the class do not change"),
                        &CurriculumWindow::teach));
  return part;
}

void CurriculumWindow::connectParts() {
  connect(controller_, &CurriculumController::offersChanged, this, &CurriculumWindow::showShelf);
  connect(controller_, &CurriculumController::curriculumChanged, this, &CurriculumWindow::showCurriculum);
  connect(controller_, &CurriculumController::savingChanged, this, &CurriculumWindow::showSaving);
  connect(controller_, &CurriculumController::statusMessage, this, &CurriculumWindow::say);
  connect(shelf_, &QListWidget::currentRowChanged, this, &CurriculumWindow::choose);
  connect(levels_, &LevelList::chosenChanged, this, &CurriculumWindow::showLevel);
  connect(levels_, &LevelList::edited, controller_, &CurriculumController::edit);
  connect(form_, &LevelForm::edited, this, [this](const QString& field, const LevelEdit& change) {
    const std::string name = levels_->chosen();
    controller_->edit(field.isEmpty() ? field : qt(name) + QLatin1Char(' ') + field, [&](Curriculum& all) {
      for (Level& level : all.levels)
        if (level.name == name) change(level);
    });
  });
}

void CurriculumWindow::say(const QString& words, bool isError) {
  words_->setText(isError && !words.isEmpty() ? QStringLiteral("▲  ") + words : words);
  words_->setVisible(!words.isEmpty());
}

void CurriculumWindow::showShelf() {
  const QSignalBlocker quiet(shelf_);
  shelf_->clear();
  for (const OfferedCurriculum& offer : controller_->offers()) {
    shelf_->addItem(displayText(offer));
    if (controller_->chosen() && offer == *controller_->chosen()) shelf_->setCurrentRow(shelf_->count() - 1);
  }
  const QString before = cohort_->currentText();
  cohort_->clear();
  for (const Cohort& one : controller_->cohorts()) {
    const QString now = one.curriculum.empty() ? tr("no curriculum yet")
                                               : displayText({one.curriculum, one.curriculumVersion, Kind::Published});
    cohort_->addItem(QStringLiteral("%1  (%2)").arg(qt(one.name), now), qt(one.id));
  }
  cohort_->setEnabled(cohort_->count() > 0);
}

void CurriculumWindow::choose() {
  const int row = shelf_->currentRow();
  if (row < 0 || row >= int(controller_->offers().size())) return;
  say({}, false);
  controller_->choose(controller_->offers()[std::size_t(row)]);
}

void CurriculumWindow::showCurriculum() {
  const Curriculum* now = controller_->curriculum();
  const bool draft = controller_->isDraft();
  levels_->show(now ? *now : Curriculum(), controller_->errors(), draft);
  teaching_->setVisible(now && !draft);
  version_->setEnabled(now && !draft);
  discard_->setEnabled(draft);
  undo_->setVisible(draft);
  redo_->setVisible(draft);
  publish_->setVisible(draft);
  undo_->setEnabled(controller_->canUndo());
  redo_->setEnabled(controller_->canRedo());
  publish_->setEnabled(controller_->errors().empty());
  if (const OfferedCurriculum* chosen = controller_->chosen())
    for (int row = 0; row < shelf_->count(); ++row)
      if (controller_->offers()[std::size_t(row)] == *chosen) {
        const QSignalBlocker quiet(shelf_);
        shelf_->setCurrentRow(row);
      }
  showLevel();
}

void CurriculumWindow::showLevel() {
  const Curriculum* now = controller_->curriculum();
  const std::string name = levels_->chosen();
  const Level* level = now ? now->level(name) : nullptr;
  form_->setVisible(level);
  story_->setVisible(now);
  if (level) form_->show(*now, *level, controller_->isDraft());
  if (now) story_->show(*now, name, controller_->errors());
}

void CurriculumWindow::showSaving() {
  contest_->setVisible(controller_->isContested());
  const Curriculum* now = controller_->curriculum();
  if (!now) return state_->setText(tr("Choose a curriculum, or begin a new curriculum."));
  const QString version = tr("%1, version %2").arg(qt(now->name), QString::number(now->version));
  if (!controller_->isDraft())
    return state_->setText(
        tr("%1 is published and cannot be changed. To make changes, begin a new version.").arg(version));
  state_->setText(controller_->isSaved() ? tr("Draft of the curriculum %1, saved").arg(version)
                                         : tr("Draft of the curriculum %1, not saved yet").arg(version));
}

void CurriculumWindow::begin() {
  (new EntryDialog(
       tr("New curriculum"),
       tr("A new curriculum begins as a draft. Trainees do not see it until it is published and assigned to a class."),
       {{"curriculumName", tr("Short name"), tr("At most 64 letters (a to z), digits, '_', '-' and '.'")}}, tr("Begin"),
       [this](const QStringList& texts, const std::function<void(Result<void>)>& done) {
         controller_->begin(texts[0], done);
       },
       this))
      ->open();
}

void CurriculumWindow::beginVersion() {
  controller_->beginVersion();
}

void CurriculumWindow::discard() {
  (new EntryDialog(
       tr("Discard the draft?"), tr("All changes since the last published version will be lost, for all users."), {},
       tr("Discard"),
       [this](const QStringList&, const std::function<void(Result<void>)>& done) {
         controller_->discard();
         done({});
       },
       this))
      ->open();
}

void CurriculumWindow::publish() {
  if (!controller_->isDraft()) return;
  const Curriculum& draft = *controller_->curriculum();
  (new EntryDialog(
       tr("Publish %1, version %2?").arg(qt(draft.name), QString::number(draft.version)),
       tr("A published version cannot change, so that attempts stay comparable; changes need a new version. Classes "
          "keep their present version until you assign the new version."),
       {}, tr("Publish"),
       [this](const QStringList&, const std::function<void(Result<void>)>& done) { controller_->publish(done); }, this))
      ->open();
}

bool CurriculumWindow::event(QEvent* event) {
  if (event->type() == QEvent::WindowActivate) controller_->refreshCases();
  return QDialog::event(event);
}

void CurriculumWindow::reject() {
  controller_->afterSaving([this] { QDialog::reject(); }, [this] { askToClose(); });
}

void CurriculumWindow::askToClose() {
  (new EntryDialog(
       tr("Close without saving your changes?"),
       tr("The draft cannot be saved now. Keep this window open; the draft will be saved as soon as possible."), {},
       tr("Close without saving"),
       [this](const QStringList&, const std::function<void(Result<void>)>& done) {
         done({});
         QDialog::reject();
       },
       this))
      ->open();
}

void CurriculumWindow::teach() {
  if (cohort_->currentIndex() >= 0) controller_->teach(cohort_->currentData().toString().toStdString());
}

}  // namespace insonate::ui
