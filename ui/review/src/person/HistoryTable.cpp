#include "HistoryTable.h"

#include "../attempt/Words.h"
#include "../class/ClassWords.h"
#include "PersonController.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QDir>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::review {
namespace {

constexpr int kHistoryRow_px = 26, kHistoryDate_px = 172, kHistoryLevel_px = 200, kHistoryLength_px = 80,
              kHistoryPoints_px = 64, kHistoryRecording_px = 150, kHistoryComments_px = 150, kHistoryForms_px = 60;
enum HistoryColumn {
  kHistoryDate,
  kHistoryLevel,
  kHistoryOutcome,
  kHistoryPoints,
  kHistoryLength,
  kHistoryRecording,
  kHistoryForms,
  kHistoryComments,
  kHistoryColumns
};

QString placeOf(const StoredAttempt& attempt, const QString& recording) {
  if (!attempt.recordingFile.empty()) return HistoryTable::tr("in the database");
  if (!recording.isEmpty()) return HistoryTable::tr("on this computer");
  if (attempt.facts.recording.empty()) return HistoryTable::tr("none");
  return HistoryTable::tr("on %1").arg(QString::fromStdString(attempt.facts.workstation));
}

/// States that the recording of this attempt is not available, and what to do.
QString whyNoReplay(const StoredAttempt& attempt) {
  if (attempt.facts.recording.empty()) return HistoryTable::tr("This attempt has no recording.");
  return HistoryTable::tr(
             "The recording '%1' is not on this computer but on %2. Copy the recording from there into %3.")
      .arg(QString::fromStdString(attempt.facts.recording), QString::fromStdString(attempt.facts.workstation),
           QDir::toNativeSeparators(ui::attemptsFolder()));
}

}  // namespace

HistoryTable::HistoryTable(PersonController& controller, ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      table_(new QTableWidget),
      replay_(new QPushButton(ui::icon(QStringLiteral("play")), tr("Replay"))),
      void_(new QPushButton(tr("Void ..."))),
      accept_(new QPushButton(tr("Accept ..."))),
      earlier_(new QPushButton(tr("Earlier attempts"))),
      changeNow_(new QPushButton),
      words_(new QLabel),
      question_(new QLabel),
      asking_(nullptr),
      reason_(new QLineEdit) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  asking_ = buildReason();
  box->addWidget(buildTable(), 1);
  setFocusProxy(table_);
  box->addWidget(asking_);
  box->addWidget(buildButtons(commands));
  connect(&controller_, &PersonController::attemptsChanged, this, [this] { show(); });
  show();
}

QWidget* HistoryTable::buildTable() {
  table_->setObjectName(QStringLiteral("history"));
  table_->setAccessibleName(tr("Attempts of this person, the latest first"));
  table_->setColumnCount(kHistoryColumns);
  table_->setHorizontalHeaderLabels({tr("Attempt"), tr("Level"), tr("Outcome"), tr("Points"), tr("Duration"),
                                     tr("Recording"), tr("Forms"), tr("Comments")});
  ui::makeRowTable(*table_, kHistoryRow_px);
  table_->setMinimumHeight(4 * kHistoryRow_px);
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(kHistoryOutcome, QHeaderView::Stretch);
  header->resizeSection(kHistoryDate, kHistoryDate_px);
  header->resizeSection(kHistoryLevel, kHistoryLevel_px);
  header->resizeSection(kHistoryPoints, kHistoryPoints_px);
  header->resizeSection(kHistoryLength, kHistoryLength_px);
  header->resizeSection(kHistoryRecording, kHistoryRecording_px);
  header->resizeSection(kHistoryComments, kHistoryComments_px);
  header->resizeSection(kHistoryForms, kHistoryForms_px);
  // Outcomes with reasons are long: they wrap.
  table_->verticalHeader()->setMinimumSectionSize(kHistoryRow_px);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeaderItem(kHistoryForms)->setToolTip(tr("Number of checklists and ratings that were handed in"));
  table_->horizontalHeaderItem(kHistoryComments)
      ->setToolTip(tr("Comments on the replay; unread comments are those that the trainee has not opened yet"));
  connect(table_, &QTableWidget::itemActivated, this, [this] { replay(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { showChosen(); });
  return table_;
}

QWidget* HistoryTable::buildButtons(ui::Commands& commands) {
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  replay_->setObjectName(QStringLiteral("replayAttempt"));
  ui::setRole(replay_, "primary");
  void_->setObjectName(QStringLiteral("voidAttempt"));
  commands.beginSection(tr("Person"));
  commands.add(QStringLiteral("review.person.void"),
               tr("voids the attempt with a reason: the attempt stays in the list but does not count"), *void_,
               QKeySequence(Qt::Key_Delete));
  earlier_->setObjectName(QStringLiteral("earlierAttempts"));
  earlier_->setToolTip(tr("Lists %1 earlier attempts").arg(kPage));
  words_->setObjectName(QStringLiteral("historyWords"));
  words_->setTextFormat(Qt::PlainText);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  ui::setRole(words_, "quiet");
  connect(replay_, &QPushButton::clicked, this, [this] { replay(); });
  accept_->setObjectName(QStringLiteral("acceptAttempt"));
  accept_->setToolTip(tr("Counts this passed attempt although it is not proven; you enter a reason"));
  connect(void_, &QPushButton::clicked, this, [this] { askReason(Change::Void); });
  connect(accept_, &QPushButton::clicked, this, [this] { askReason(Change::Accept); });
  connect(earlier_, &QPushButton::clicked, this, [this] { controller_.readEarlier(); });
  row->addWidget(replay_);
  row->addWidget(void_);
  row->addWidget(accept_);
  row->addWidget(words_, 1);
  row->addWidget(earlier_);
  return buttons;
}

QWidget* HistoryTable::buildReason() {
  auto* part = new QFrame;
  ui::setRole(part, "panel");
  auto* row = new QHBoxLayout(part);
  row->setSpacing(ui::kGap);
  reason_->setObjectName(QStringLiteral("voidReason"));
  changeNow_->setObjectName(QStringLiteral("voidNow"));
  changeNow_->setToolTip(tr("Voids the attempt; this cannot be undone (Enter)"));
  auto* leave = new QPushButton(tr("Cancel"));
  leave->setToolTip(tr("Leaves the attempt unchanged (Esc)"));
  auto* escape = new QAction(part);
  escape->setShortcut(QKeySequence(Qt::Key_Escape));
  escape->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  part->addAction(escape);
  connect(escape, &QAction::triggered, this, [this] { askReason(Change::None); });
  connect(leave, &QPushButton::clicked, this, [this] { askReason(Change::None); });
  connect(changeNow_, &QPushButton::clicked, this, [this] { changeChosen(); });
  connect(reason_, &QLineEdit::returnPressed, this, [this] { changeChosen(); });
  connect(reason_, &QLineEdit::textChanged, this,
          [this](const QString& text) { changeNow_->setEnabled(!text.trimmed().isEmpty()); });
  changeNow_->setEnabled(false);
  question_->setBuddy(reason_);
  question_->setObjectName(QStringLiteral("changeQuestion"));
  question_->setTextFormat(Qt::PlainText);
  wordReason(true);
  row->addWidget(question_);
  row->addWidget(reason_, 1);
  row->addWidget(changeNow_);
  row->addWidget(leave);
  part->hide();
  return part;
}

void HistoryTable::show() {
  const auto& attempts = controller_.attempts();
  // A new attempt comes first and moves the others down.
  const auto same = std::ranges::find(attempts, chosen_, [](const StoredAttempt& one) { return one.facts.id; });
  const int row = same == attempts.end() ? table_->currentRow() : int(same - attempts.begin());
  {
    const QSignalBlocker quiet(table_);
    table_->setRowCount(int(attempts.size()));
    for (int i = 0; i < int(attempts.size()); ++i) fill(i, attempts[std::size_t(i)]);
    if (!attempts.empty()) table_->selectRow(std::clamp(row, 0, int(attempts.size()) - 1));
    hideOtherLevels();
  }
  earlier_->setVisible(controller_.hasEarlierAttempts());
  showChosen();
}

void HistoryTable::showLevel(const std::string& level) {
  if (std::exchange(level_, level) == level) return;
  hideOtherLevels();
  showChosen();
}

/// Selects the first attempt at the level if the selected one is hidden.
void HistoryTable::hideOtherLevels() {
  const auto& attempts = controller_.attempts();
  int first = -1;
  // The page of the person may show another level before the table has the new attempts.
  for (int row = 0; row < std::min(table_->rowCount(), int(attempts.size())); ++row) {
    const bool hides = !level_.empty() && attempts[std::size_t(row)].facts.level != level_;
    table_->setRowHidden(row, hides);
    if (!hides && first < 0) first = row;
  }
  if (first < 0)
    table_->clearSelection();
  else if (table_->isRowHidden(table_->currentRow()))
    table_->selectRow(first);
}

void HistoryTable::fill(int row, const StoredAttempt& attempt) {
  const Curriculum* curriculum =
      controller_.facts() && controller_.facts()->curriculum ? &*controller_.facts()->curriculum : nullptr;
  const AttemptFacts& facts = attempt.facts;
  const auto set = [&](int column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setToolTip(plainToolTip(text));
    if (facts.state == AttemptState::Voided) item->setForeground(ui::toQColor(views::theme::kQuiet));
    table_->setItem(row, column, item);
  };
  QString outcome = QString::fromStdString(outcomeText(attempt, curriculum));
  if (const QString why = controller_.attentionReason(facts); !why.isEmpty()) outcome += tr("   ▲ %1").arg(why);
  set(kHistoryDate, ui::dayAndTimeOf(facts.begun_us));
  set(kHistoryLevel, levelTitle(curriculum, facts.level));
  set(kHistoryOutcome, outcome);
  set(kHistoryPoints, pointsOf(facts) ? QString::number(std::lround(*pointsOf(facts))) : tr("n/a"));
  set(kHistoryLength, clockOf(facts.length_us));
  set(kHistoryRecording, placeOf(attempt, recordingPath(attempt)));
  set(kHistoryComments, commentsOf(facts.id));
  const PersonFacts* person = controller_.facts();
  const auto forms = person ? person->notes.forms.find(facts.id) : std::map<std::string, int>::const_iterator();
  set(kHistoryForms, person && forms != person->notes.forms.end() ? QString::number(forms->second) : QString());
}

QString HistoryTable::recordingPath(const StoredAttempt& attempt) const {
  return ui::findRecordingFile(attempt, controller_.storeAddress());
}

QString HistoryTable::commentsOf(const std::string& attempt) const {
  if (!controller_.facts()) return {};
  const auto& comments = controller_.facts()->notes.comments;
  const auto found = comments.find(attempt);
  return found == comments.end() ? QString()
                                 : QString::fromStdString(commentText(found->second, controller_.mayVoid()));
}

const StoredAttempt* HistoryTable::chosen() const {
  const int row = table_->currentRow();
  return row < 0 || row >= int(controller_.attempts().size()) ? nullptr : &controller_.attempts()[std::size_t(row)];
}

void HistoryTable::showChosen() {
  const StoredAttempt* attempt = chosen();
  // A reason that is being typed stays while its attempt is selected.
  if (const std::string id = attempt ? attempt->facts.id : ""; std::exchange(chosen_, id) != id)
    askReason(Change::None);
  const bool here = attempt && !recordingPath(*attempt).isEmpty();
  replay_->setEnabled(here);
  replay_->setToolTip(here ? tr("Replays the attempt (Enter)") : tr("The recording is not on this computer"));
  const bool ended =
      attempt && (attempt->facts.state == AttemptState::Completed || attempt->facts.state == AttemptState::Abandoned);
  void_->setVisible(controller_.mayVoid());
  void_->setEnabled(ended);
  accept_->setVisible(controller_.mayVoid() && ended && isUnproven(*attempt));
  words_->setText(
      !controller_.facts() ? QString()
      : !attempt
          ? tr("No attempts yet. Attempts that the person makes in Train (Ctrl+2) while signed in are listed here.")
      : here ? hiddenWords()
             : whyNoReplay(*attempt));
  words_->setToolTip(plainToolTip(words_->text()));
}

QString HistoryTable::hiddenWords() const {
  int hidden = 0;
  for (int row = 0; row < table_->rowCount(); ++row) hidden += table_->isRowHidden(row);
  return hidden == 0 ? QString()
                     : tr("%1 at other levels are not listed; choose All attempts above.")
                           .arg(countOf(hidden, tr("attempt"), tr("attempts")));
}

void HistoryTable::replay() {
  const StoredAttempt* attempt = chosen();
  if (!attempt) return;
  const QString file = recordingPath(*attempt);
  if (file.isEmpty()) return Q_EMIT failed(whyNoReplay(*attempt), {});
  Q_EMIT replayRequested(file, QString::fromStdString(attempt->facts.id));
}

void HistoryTable::askReason(Change change) {
  change_ = change;
  asking_->setVisible(change != Change::None);
  if (change == Change::None) return;
  wordReason(change == Change::Void);
  reason_->clear();
  reason_->setFocus();
}

void HistoryTable::wordReason(bool voids) {
  const int row = table_->currentRow();
  const auto cell = [&](int column) { return row < 0 ? QString() : table_->item(row, column)->text(); };
  const QString which = tr("%1, %2").arg(cell(kHistoryDate), cell(kHistoryLevel));
  question_->setText(voids ? tr("Void the attempt of %1 (cannot be undone). Reason:").arg(which)
                           : tr("Accept the attempt of %1. Reason:").arg(which));
  changeNow_->setText(voids ? tr("Void") : tr("Accept"));
  reason_->setAccessibleName(voids ? tr("Reason why the attempt does not count") : tr("Reason why the attempt counts"));
  reason_->setPlaceholderText(voids ? tr("Reason, for example: the device lost its calibration")
                                    : tr("Reason, for example: I watched the attempt"));
  reason_->setToolTip(
      voids ? tr("The trainee can read the reason. Enter voids the attempt, Esc cancels")
            : tr("The audit log records the reason with your name. Enter accepts the attempt, Esc cancels"));
}

void HistoryTable::changeChosen() {
  const StoredAttempt* attempt = chosen();
  const QString reason = reason_->text().trimmed();
  if (!attempt || reason.isEmpty()) return;
  if (change_ == Change::Void)
    controller_.voidAttempt(attempt->facts.id, reason);
  else
    controller_.acceptAttempt(attempt->facts.id, reason);
  askReason(Change::None);
}

}  // namespace insonate::review
