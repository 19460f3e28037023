#include "AttemptList.h"

#include "../attempt/Words.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrent>
#include <algorithm>
#include <iterator>

namespace insonate::review {
namespace {

constexpr int kWidest_px = 1100, kAttemptRow_px = 30;
constexpr int kDate_px = 170, kLength_px = 90, kStatus_px = 280;
enum Column { kDate, kCase, kProcedure, kLength, kStatus, kColumns };

}  // namespace

std::vector<ListedAttempt> attemptsIn(const QString& folder) {
  std::vector<ListedAttempt> attempts;
  const QDir place(folder);
  for (const QString& name : place.entryList(QDir::Files)) {
    const QString file = place.filePath(name);
    if (!ui::isAttemptFile(file)) continue;
    const auto recording = AttemptRecording::open(file.toStdString());
    if (recording) attempts.push_back({file, recording->header(), recording->status(), recording->end_us()});
  }
  // ISO 8601 in one time zone, so that alphabetical order is that of time.
  std::ranges::stable_sort(attempts, std::greater{}, [](const ListedAttempt& one) { return one.header.begun; });
  return attempts;
}

AttemptList::AttemptList(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget), words_(new QLabel), open_(new QPushButton(tr("Open"))) {
  auto* title = new QLabel(tr("Recordings of this computer"));
  ui::setRole(title, "title");
  words_->setWordWrap(true);
  words_->setObjectName(QStringLiteral("attemptsWords"));
  ui::setRole(open_, "primary");
  open_->setObjectName(QStringLiteral("openAttempt"));
  open_->setToolTip(tr("Replay the selected attempt (Enter)"));
  auto* row = new QHBoxLayout;
  buttons_ = row;
  row->addWidget(open_);
  row->addStretch(1);
  auto* column = new QWidget;
  column->setMaximumWidth(kWidest_px);
  auto* box = new QVBoxLayout(column);
  box->setSpacing(ui::kLargeGap);
  box->addWidget(title);
  box->addWidget(words_);
  box->addWidget(buildTable(), 100);
  box->addLayout(row);
  box->addStretch(1);  // if there is no table
  auto* middle = new QHBoxLayout(this);
  middle->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  middle->addStretch(1);
  middle->addWidget(column, 100);
  middle->addStretch(1);
  connect(open_, &QPushButton::clicked, this, [this] { choose(); });
  connect(&reading_, &QFutureWatcherBase::finished, this, [this] {
    all_ = reading_.result();
    show();
    Q_EMIT listed();
  });
  show();
}

AttemptList::~AttemptList() = default;

QWidget* AttemptList::buildTable() {
  table_->setObjectName(QStringLiteral("attempts"));
  table_->setAccessibleName(tr("Attempts, the latest first"));
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels({tr("Date"), tr("Case"), tr("Procedure"), tr("Duration"), tr("Status")});
  ui::makeRowTable(*table_, kAttemptRow_px);
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(kCase, QHeaderView::Stretch);
  header->setSectionResizeMode(kProcedure, QHeaderView::Stretch);
  header->resizeSection(kDate, kDate_px);
  header->resizeSection(kLength, kLength_px);
  header->resizeSection(kStatus, kStatus_px);
  connect(table_, &QTableWidget::itemActivated, this, [this] { choose(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { open_->setEnabled(!table_->selectedItems().isEmpty()); });
  return table_;
}

void AttemptList::addOpenAction(QAction* action) {
  auto* button = new QPushButton(action->icon(), action->text());
  button->setToolTip(action->toolTip());
  connect(button, &QPushButton::clicked, action, &QAction::trigger);
  buttons_->insertWidget(1, button);
}

void AttemptList::refresh() {
  if (!reading_.isRunning()) reading_.setFuture(QtConcurrent::run([] { return attemptsIn(ui::attemptsFolder()); }));
}

void AttemptList::setUser(const std::string& person, bool seesAll) {
  person_ = person, seesAll_ = seesAll;
  show();
}

void AttemptList::show() {
  std::vector<ListedAttempt> attempts;
  std::ranges::copy_if(all_, std::back_inserter(attempts), [this](const ListedAttempt& one) {
    const std::string& whose = one.header.recordedFor.person;
    return seesAll_ || whose.empty() || whose == person_;
  });
  table_->setRowCount(int(attempts.size()));
  for (int row = 0; row < int(attempts.size()); ++row) {
    const ListedAttempt& one = attempts[std::size_t(row)];
    const auto set = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setData(Qt::UserRole, one.file);
      item->setToolTip(ui::plainToolTip(one.file));
      table_->setItem(row, column, item);
    };
    set(kDate, dateOf(one.header.begun));
    set(kCase, QString::fromStdString(one.header.caseName));
    set(kProcedure, titleOf(one.header));
    set(kLength, clockOf(one.end_us));
    set(kStatus, displayText(one.status));
  }
  const bool any = !attempts.empty();
  table_->setVisible(any);
  open_->setVisible(any);
  open_->setEnabled(false);
  if (any) table_->selectRow(0);
  const auto others = int(all_.size() - attempts.size());
  words_->setText(
      !any && others > 0 ? tr("The recordings in the folder of this computer (%1) are of people who have signed in: "
                              "%2. Sign in (Ctrl+L) "
                              "to see your own recordings or, as an instructor, all of them.")
                               .arg(QDir::toNativeSeparators(ui::attemptsFolder()))
                               .arg(others)
      : any ? tr("Open an attempt to replay it with its ultrasound images and to see its result. A recording "
                 "from another computer can be dropped here.")
            : tr("There are no recordings in the folder of this computer (%1). Make an attempt in Train "
                 "(Ctrl+2), or drop a recording here. Attempts that are stored with people are on the page of "
                 "each person.")
                  .arg(QDir::toNativeSeparators(ui::attemptsFolder())));
}

void AttemptList::choose() {
  if (const auto chosenItems = table_->selectedItems(); !chosenItems.isEmpty())
    Q_EMIT chosen(chosenItems.first()->data(Qt::UserRole).toString());
}

}  // namespace insonate::review
