#include "ClassListDialog.h"

#include "EntryDialog.h"
#include "PasswordPaper.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QDir>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

using Step = ClassImportRow::Step;
enum Column { kLine, kFullName, kName, kEmail, kOutcome, kColumns };
constexpr int kRow_px = 28, kLook_ms = 50;
constexpr int kWidths_px[kOutcome] = {52, 170, 140, 180};

QString countOf(const std::vector<ClassImportRow>& plan, Step step, const char* words) {
  return QStringLiteral("%1 %2")
      .arg(std::ranges::count(plan, step, &ClassImportRow::step))
      .arg(ClassListDialog::tr(words));
}

/// Planned outcome of a line, with a sign in addition to its color.
QString outcomeOf(const ClassImportRow& row) {
  switch (row.step) {
    case Step::Add:
      return ClassListDialog::tr("+  new");
    case Step::Join:
      return ClassListDialog::tr("+  has an account, joins the class");
    case Step::AlreadyThere:
      return ClassListDialog::tr("✓  already in the class");
    case Step::Refuse:
      break;
  }
  const QString line = QStringLiteral("Line %1: ").arg(row.line);  // the line number is in another column
  return QStringLiteral("▲  ") + (qt(row.why).startsWith(line) ? qt(row.why).mid(line.size()) : qt(row.why));
}

/// Runs on the account's thread.
Result<std::vector<ClassImportRow>> planOf(const SignedIn& by, const std::string& cohort, const QString& file) {
  constexpr qint64 kMost = 8 << 20;
  QFile list(file);
  if (!list.open(QFile::ReadOnly) || list.size() > kMost)
    return fail(ClassListDialog::tr("%1 cannot be read, or is too large for a class list; choose another file.")
                    .arg(QDir::toNativeSeparators(file))
                    .toStdString());
  const auto parsed = parseClassList(list.readAll().toStdString());
  if (!parsed) return tl::unexpected(parsed.error());
  return ClassImport(by).plan(cohort, *parsed);
}

QString droppedFile(const QMimeData& data) {
  return data.urls().size() == 1 ? data.urls().front().toLocalFile() : QString();
}

}  // namespace

ClassListDialog::ClassListDialog(Account& account, Cohort cohort, QWidget* parent)
    : QDialog(parent),
      account_(account),
      cohort_(std::move(cohort)),
      file_(new QLabel(tr("No file is chosen yet. Choose a file, or drop a file here."))),
      words_(new QLabel),
      table_(new QTableWidget(0, kColumns)),
      bar_(new QProgressBar) {
  setWindowTitle(tr("Class list"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAcceptDrops(true);
  auto* title = new QLabel(tr("Import a class list into %1").arg(qt(cohort_.name)));
  setRole(title, "title");
  auto* about =
      new QLabel(tr("The class list is a table that Moodle or a spreadsheet has saved (CSV). Its first line names the "
                    "columns: Full name, or First name and Last name; and Username, ID number or Email address, or the "
                    "German, French or Spanish titles. Nothing changes until you confirm."));
  setRole(about, "quiet");
  for (QLabel* label : {title, about, file_, words_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
  }
  words_->setObjectName(QStringLiteral("listWords"));
  choose_ = button("listChoose", tr("Choose a file ..."), tr("Chooses the file of the class list (CSV)"),
                   &ClassListDialog::choose);
  go_ = button("listGo", tr("Add"), tr("Adds all listed people, or none if adding one fails"), &ClassListDialog::apply);
  save_ =
      button("listSave", tr("Save passwords ..."),
             tr("Saves the first passwords as a table (CSV) that only you can read"), &ClassListDialog::savePasswords);
  print_ = button("listPrint", tr("Print passwords ..."),
                  tr("Prints the first passwords on a page that you cut into slips and hand out"),
                  &ClassListDialog::printPasswords);
  close_ = button("listClose", tr("Close"), tr("Back to the list of people (Esc)"), &ClassListDialog::reject);
  setRole(go_, "primary");
  setRole(save_, "primary");
  table_->setObjectName(QStringLiteral("listTable"));
  table_->setAccessibleName(tr("Result for each line of the class list"));
  table_->setToolTip(tr("Lines of the file with their outcome"));
  table_->setHorizontalHeaderLabels({tr("Line"), tr("Full name"), tr("Sign-in name"), tr("E-mail"), tr("Result")});
  makeRowTable(*table_, kRow_px);
  for (int column = 0; column < kOutcome; ++column) table_->setColumnWidth(column, kWidths_px[column]);
  table_->horizontalHeader()->setSectionResizeMode(kOutcome, QHeaderView::Stretch);
  bar_->setAccessibleName(tr("Progress"));
  bar_->setTextVisible(false);  // the bar is too low for a text
  bar_->hide();
  auto* top = new QHBoxLayout;
  top->setSpacing(kGap);
  top->addWidget(choose_);
  top->addWidget(file_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGap);
  buttons->addWidget(bar_, 1);
  buttons->addStretch();
  for (QPushButton* one : {close_, print_, save_, go_}) buttons->addWidget(one);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kGap);
  column->addWidget(title);
  column->addWidget(about);
  column->addLayout(top);
  column->addWidget(table_, 1);
  column->addWidget(words_);
  column->addLayout(buttons);
  resize(1000, 560);
  connect(&account_, &Account::reconnected, this, [this] {
    if (!path_.isEmpty() && !isWorking() && passwords_.empty()) open(path_);
  });
  looking_.setInterval(kLook_ms);
  connect(&looking_, &QTimer::timeout, this, [this] {
    bar_->setValue(int(100 * work_->done));
    if (!work_->stopped) say(tr("Adding people ... %1 %").arg(bar_->value()), false);
  });
  showRows();
}

ClassListDialog::~ClassListDialog() {
  if (work_) work_->stopped = true;
}

QPushButton* ClassListDialog::button(const char* name, const QString& words, const QString& tip,
                                     void (ClassListDialog::*act)()) {
  auto* made = pushButton(name, words, tip);
  connect(made, &QPushButton::clicked, this, act);
  return made;
}

void ClassListDialog::say(const QString& words, bool isError) {
  words_->setText(isError ? QStringLiteral("▲  ") + words : words);
}

void ClassListDialog::choose() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Class list"), QDir::homePath(),
                                                    tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
  if (!file.isEmpty()) open(file);
}

void ClassListDialog::dragEnterEvent(QDragEnterEvent* event) {
  if (choose_->isEnabled() && !droppedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ClassListDialog::dropEvent(QDropEvent* event) {
  open(droppedFile(*event->mimeData()));
}

void ClassListDialog::open(const QString& file) {
  path_ = file;
  file_->setText(QFileInfo(file).fileName());
  plan_.clear();
  showRows();
  say(tr("Reading the class list ..."), false);
  account_.query<std::vector<ClassImportRow>>(
      this, [cohort = cohort_.id, file](const SignedIn& by) { return planOf(by, cohort, file); },
      [this, round = ++round_](Result<std::vector<ClassImportRow>> plan) {
        if (round == round_) takePlan(std::move(plan));
      });
}

void ClassListDialog::takePlan(Result<std::vector<ClassImportRow>> plan) {
  plan_ = plan ? std::move(*plan) : std::vector<ClassImportRow>();
  showRows();
  if (!plan) return say(qt(plan.error().message), true);
  if (plan_.empty()) return say(tr("The class list has a header line but no people."), true);
  const bool someStayOut = std::ranges::count(plan_, Step::Refuse, &ClassImportRow::step) > 0;
  QStringList parts{countOf(plan_, Step::Add, "new"), countOf(plan_, Step::Join, "join"),
                    countOf(plan_, Step::AlreadyThere, "there already"), countOf(plan_, Step::Refuse, "refused")};
  say(parts.join(QStringLiteral("   ·   ")) + (someStayOut ? tr(". Refused people are not added. To add them, correct "
                                                                "the file and choose the file again, now or later.")
                                                           : QString()),
      false);
}

void ClassListDialog::showRows() {
  const auto comes = [](const ClassImportRow& row) { return row.step == Step::Add || row.step == Step::Join; };
  const auto count = std::ranges::count_if(plan_, comes);
  const bool done = !passwords_.empty();
  table_->setRowCount(int(plan_.size()));
  auto password = passwords_.begin();
  for (int at = 0; at < int(plan_.size()); ++at) {
    const ClassImportRow& row = plan_[std::size_t(at)];
    const bool isNew = row.step == Step::Add && done;
    const QString outcome = isNew ? tr("✓  first password: %1").arg(qt((password++)->password)) : outcomeOf(row);
    const QString texts[kColumns] = {QString::number(row.line), qt(row.person.fullName), qt(row.person.name),
                                     qt(row.person.email), outcome};
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(plainToolTip(texts[column]));
      if (row.step == Step::Refuse) item->setForeground(toQColor(views::theme::kCaution));
      if (row.step == Step::AlreadyThere) item->setForeground(toQColor(views::theme::kQuiet));
      table_->setItem(at, column, item);
    }
  }
  table_->resizeRowsToContents();
  choose_->setEnabled(!isWorking() && !done);
  go_->setVisible(!done);
  go_->setEnabled(count > 0 && !isWorking());
  go_->setText(count == 1 ? tr("Add one person") : count > 1 ? tr("Add %1 people").arg(count) : tr("Add"));
  save_->setVisible(done);
  print_->setVisible(done);
  close_->setText(isWorking() ? tr("Cancel") : tr("Close"));
  // Enter presses the button that has the focus, or else the next step.
  for (QPushButton* one : {choose_, close_, print_, save_, go_}) one->setAutoDefault(true);
  (done ? save_ : go_->isEnabled() ? go_ : choose_)->setDefault(true);
}

void ClassListDialog::apply() {
  auto passwords = std::make_shared<std::vector<FirstPassword>>(ClassImport::passwordsFor(plan_));
  work_ = std::make_shared<Work>();
  say(tr("Adding people ..."), false);
  bar_->setValue(0);
  bar_->show();
  looking_.start();
  showRows();
  account_.query<void>(
      this,
      [cohort = cohort_.id, plan = plan_, passwords, work = work_](const SignedIn& by) {
        return ClassImport(by).apply(cohort, plan, *passwords, [work](std::string_view, double done) {
          work->done = done;
          return !work->stopped;
        });
      },
      [this, passwords](const Result<void>& outcome) {
        if (outcome) passwords_ = std::move(*passwords);
        takeOutcome(outcome);
      });
}

void ClassListDialog::takeOutcome(const Result<void>& outcome) {
  looking_.stop();
  work_.reset();
  bar_->hide();
  showRows();
  if (!outcome)
    return say(
        outcome.error().message == kCancelled ? tr("Canceled. No person was added.") : qt(outcome.error().message),
        true);
  Q_EMIT imported();
  if (passwords_.empty()) {
    go_->setEnabled(false);
    return say(tr("Done. The listed people have joined the class; all of them already had an account."), false);
  }
  say(tr("Done. The first passwords are shown only now: save or print them, hand them out, and then delete them. Each "
         "person chooses a new password at the first sign-in."),
      false);
  save_->setFocus();
}

void ClassListDialog::savePasswords() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save passwords"), QDir::home().filePath(QStringLiteral("first-passwords.csv")),
      QStringLiteral("CSV (*.csv)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (file.isEmpty()) return;
  const auto written = writeFirstPasswords(file.toStdString(), passwords_);
  if (!written) return say(qt(written.error().message), true);
  handedOut_ = true;
  say(tr("Saved as %1, which only you can read. Delete the file after you have handed out the passwords.")
          .arg(QDir::toNativeSeparators(file)),
      false);
}

void ClassListDialog::printPasswords() {
  const Result<QString> printed = printPasswordPaper(qt(cohort_.name), passwords_, this);
  if (!printed) return say(qt(printed.error().message), true);
  if (printed->isEmpty()) return;
  handedOut_ = true;
  say(*printed, false);
}

/// Stops a running import and waits for it; asks before passwords that were not saved are discarded.
void ClassListDialog::reject() {
  if (isWorking()) {
    work_->stopped = true;
    return say(tr("Stopping ..."), false);
  }
  if (passwords_.empty() || handedOut_) return QDialog::reject();
  auto* question = new EntryDialog(
      tr("Close without saving the passwords?"),
      tr("The first passwords were neither saved nor printed, and they cannot be shown again. Without a first "
         "password, the new people on this list cannot sign in; each of them needs a new password."),
      {}, tr("Close without saving passwords"),
      [this](const QStringList&, const std::function<void(Result<void>)>& done) {
        handedOut_ = true;
        done({});
        reject();
      },
      this);
  question->offerAsDefault("listSaveFirst", tr("Save passwords ..."),
                           tr("Saves the first passwords as a table (CSV) that only you can read (Enter)"),
                           [this] { savePasswords(); });
  question->open();
}

}  // namespace insonate::ui
