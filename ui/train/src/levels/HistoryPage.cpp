#include "HistoryPage.h"

#include "../attempt/AttemptWords.h"
#include "Course.h"
#include "CurveChoice.h"
#include "LevelWords.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/LearningChart.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kPage = 200, kRow_px = 28;
enum Column { kDate, kLevel, kOutcome, kPoints, kDuration, kComments, kColumns };

QString levelOf(const Curriculum* curriculum, const AttemptFacts& facts) {
  const Level* level = curriculum && facts.curriculum == curriculum->name ? curriculum->level(facts.level) : nullptr;
  return level ? ui::qt(level->title) : ui::qt(facts.level.empty() ? facts.caseName : facts.level);
}

QString tipOf(const StoredAttempt& one) {
  QStringList parts{HistoryPage::tr("Case: %1").arg(ui::qt(one.facts.caseName))};
  if (!one.facts.workstation.empty()) parts << HistoryPage::tr("Workstation: %1").arg(ui::qt(one.facts.workstation));
  if (!one.voidReason.empty()) parts << HistoryPage::tr("Does not count: %1").arg(ui::qt(one.voidReason));
  if (hasBrokenOff(one.facts)) parts << HistoryPage::tr("Abandoned: the recording stopped early");
  return ui::plainToolTip(parts.join(QLatin1Char('\n')));
}

QComboBox* choice(const char* object, const QString& name, const QString& says) {
  auto* made = ui::choiceBox(object, name, says);
  made->setMinimumContentsLength(14);
  return made;
}

}  // namespace

HistoryPage::HistoryPage(Course& course, ui::Account* account, QWidget* parent)
    : QWidget(parent), course_(course), account_(account) {
  auto* columns = new QSplitter(Qt::Horizontal);
  columns->setChildrenCollapsible(false);
  columns->addWidget(buildList());
  columns->addWidget(buildCurve());
  columns->setSizes({560, 640});
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(columns);
  setFocusProxy(table_);
  connect(&course_, &Course::changed, this, [this] { refresh(); });
  refresh();
}

QWidget* HistoryPage::buildList() {
  words_ = new QLabel;
  words_->setObjectName(QStringLiteral("historyWords"));
  words_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  table_ = new QTableWidget;
  table_->setObjectName(QStringLiteral("history"));
  table_->setAccessibleName(tr("Your attempts, the newest first"));
  table_->setToolTip(tr("Enter opens the attempt in Review"));
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels(
      {tr("Begun"), tr("Level"), tr("Result"), tr("Points"), tr("Duration"), tr("Comments")});
  ui::makeRowTable(*table_, kRow_px);
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(kLevel, QHeaderView::Stretch);
  for (const auto& [column, px] :
       {std::pair{kDate, 158}, {kOutcome, 96}, {kPoints, 58}, {kDuration, 72}, {kComments, 108}})
    header->resizeSection(column, px);
  open_ = ui::pushButton("historyOpen", tr("Open attempt in Review"), tr("Replay the selected attempt (Enter)"));
  older_ = ui::pushButton("historyOlder", tr("Older attempts"), tr("Lists older attempts"));
  auto* row = new QHBoxLayout;
  row->addWidget(open_);
  row->addWidget(older_);
  row->addStretch(1);
  auto* column = new QWidget;
  auto* box = new QVBoxLayout(column);
  box->setContentsMargins(0, 0, ui::kGap, 0);
  box->addWidget(words_);
  box->addWidget(table_, 1);
  box->addLayout(row);
  connect(table_, &QTableWidget::itemActivated, this, [this] { open(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { open_->setEnabled(!table_->selectedItems().isEmpty()); });
  connect(open_, &QPushButton::clicked, this, [this] { open(); });
  connect(older_, &QPushButton::clicked, this, [this] { ask(attempts_.back().arrival); });
  return column;
}

QWidget* HistoryPage::buildCurve() {
  of_ =
      choice("curveOf", tr("Attempts"), tr("Attempts shown in the curve: one level, or all attempts at one procedure"));
  metric_ = choice("curveMetric", tr("Metric"), tr("Metric that the curve shows"));
  chart_ = new ui::Chart;
  chart_->setObjectName(QStringLiteral("curve"));
  auto* row = new QHBoxLayout;
  row->addWidget(of_, 1);
  row->addWidget(metric_, 1);
  auto* column = new QWidget;
  auto* box = new QVBoxLayout(column);
  box->setContentsMargins(ui::kGap, 0, 0, 0);
  box->addLayout(row);
  box->addWidget(chart_, 1);
  for (const MetricMeaning& one : curveMetrics({})) metric_->addItem(ui::qt(one.title), ui::qt(one.id));
  for (QComboBox* one : {of_, metric_})
    connect(one, qOverload<int>(&QComboBox::activated), this, [this] { refreshCurve(); });
  connect(chart_, &ui::Chart::written, this, &HistoryPage::written);
  connect(chart_, &ui::Chart::failed, this, &HistoryPage::failed);
  return column;
}

void HistoryPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!std::exchange(asked_, true)) ask(0);
  askComments();
}

/// The list is asked anew when somebody looks.
void HistoryPage::refresh() {
  refreshChoices();
  refreshCurve();
  asked_ = isVisible();
  if (asked_) ask(0);
  if (!course_.isSomebodys()) append({});
  if (!course_.isSomebodys()) comments_.clear();
  if (isVisible()) askComments();
}

/// Comments are read in Review, and written there by others: each time the page is shown.
void HistoryPage::askComments() {
  if (!course_.isSomebodys()) return;
  account_->query<std::map<std::string, CommentStore::Count>>(
      this, [](const SignedIn& by) { return CommentStore(by).countsOf(by.person().id); },
      [this](Result<std::map<std::string, CommentStore::Count>> counts) {
        if (!counts) return;  // the list of attempts states why the store does not answer
        comments_ = std::move(*counts);
        showComments();
        refreshWords();
      });
}

void HistoryPage::showComments() {
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto found = comments_.find(attempts_[std::size_t(row)].facts.id);
    table_->item(row, kComments)
        ->setText(found == comments_.end() ? QString() : ui::qt(commentCountText(found->second)));
  }
}

void HistoryPage::ask(std::int64_t before) {
  const int asking = ++asking_;
  if (before == 0) more_ = false;
  if (!course_.isSomebodys()) return refreshWords();
  account_->query<std::vector<StoredAttempt>>(
      this, [before](const SignedIn& by) { return AttemptStore(by).page(by.person().id, kPage, before); },
      [this, asking, before](const Result<std::vector<StoredAttempt>>& page) {
        if (asking != asking_) return;
        error_ = page ? QString() : ui::qt(page.error().message);
        if (page && before == 0) attempts_.clear();
        if (page) append(*page);
        refreshWords();
      });
}

void HistoryPage::append(const std::vector<StoredAttempt>& page) {
  if (!course_.isSomebodys()) attempts_.clear();
  const bool fresh = attempts_.empty();
  attempts_.insert(attempts_.end(), page.begin(), page.end());
  more_ = int(page.size()) == kPage;
  table_->setRowCount(int(attempts_.size()));
  for (int row = int(attempts_.size() - page.size()); row < int(attempts_.size()); ++row) {
    const StoredAttempt& one = attempts_[std::size_t(row)];
    const AttemptFacts& facts = one.facts;
    const QString texts[kColumns] = {ui::dayAndTimeOf(facts.begun_us),
                                     levelOf(course_.curriculum(), facts),
                                     outcomeOf(course_.curriculum(), facts),
                                     pointsOf(facts) ? QString::number(std::lround(*pointsOf(facts))) : tr("n/a"),
                                     clockOf(double(facts.length_us) * 1e-6),
                                     {}};
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(tipOf(one));
      table_->setItem(row, column, item);
    }
  }
  showComments();
  open_->setEnabled(!table_->selectedItems().isEmpty());
  if (fresh && !attempts_.empty()) table_->selectRow(0);
}

void HistoryPage::refreshWords() {
  const bool any = !attempts_.empty();
  for (QWidget* one : {static_cast<QWidget*>(table_), static_cast<QWidget*>(open_)}) one->setVisible(any);
  older_->setVisible(any && more_);
  QString words = error_;
  if (words.isEmpty() && !course_.isSomebodys())
    words = tr("Sign in (Ctrl+L) to see your attempts. Recordings of guests are listed in Review (Ctrl+3).");
  else if (words.isEmpty() && !any)
    words = tr("You have no attempts yet. Choose a level and practice; each attempt is then listed here.");
  int unread = 0;
  for (const auto& [attempt, count] : comments_) unread += count.unread;
  if (words.isEmpty() && unread > 0)
    words = unread == 1
                ? tr("You have 1 unread comment. Open the attempt in Review to read the comment.")
                : tr("You have %1 unread comments. Open the attempts in Review to read the comments.").arg(unread);
  words_->setText(words);
  words_->setVisible(!words.isEmpty());
}

void HistoryPage::refreshChoices() {
  const QVariant was = of_->currentData();
  of_->clear();
  for (const CurveChoice& one : curveChoices(course_.curriculum(), course_.history()))
    of_->addItem(one.title, QStringList{ui::qt(one.procedure), ui::qt(one.level)});
  of_->setCurrentIndex(std::max(0, of_->findData(was)));
}

void HistoryPage::refreshCurve() {
  const QStringList of = of_->currentData().toStringList();
  if (of.size() != 2) return chart_->show({});
  const CurveChoice which{{}, of[0].toStdString(), of[1].toStdString()};
  const std::string metric = metric_->currentData().toString().toStdString();
  for (const MetricMeaning& meaning : curveMetrics(which.procedure))
    if (meaning.id == metric) {
      auto picture = ui::learningChart(meaning, curveValues(course_.curriculum(), course_.history(), which, meaning));
      picture.xTitle = which.level.empty()
                           ? tr("attempt number for this procedure, counting all levels and free practice")
                           : tr("attempt number at this level");
      chart_->show(picture);
    }
}

void HistoryPage::open() {
  const int row = table_->currentRow();
  if (row < 0 || row >= int(attempts_.size())) return;
  const AttemptFacts& facts = attempts_[std::size_t(row)].facts;
  const QString file = ui::findRecordingFile(attempts_[std::size_t(row)], account_->address());
  if (!file.isEmpty()) return Q_EMIT attemptRequested(file);
  Q_EMIT messageReported(
      facts.recording.empty()
          ? tr("This attempt has no recording: the file could not be written, or the program ended too early.")
          : tr("The recording of this attempt is not on this computer. The attempt was made on the workstation '%1'.")
                .arg(ui::qt(facts.workstation)));
}

}  // namespace insonate::train
