#include "DatabaseWindow.h"

#include "AuditTable.h"

#include <insonate/curriculum/AuditAnchors.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/simulator/EventCheck.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QClipboard>
#include <QDate>
#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <filesystem>
#include <memory>
#include <vector>

namespace insonate::ui {
namespace {

constexpr int kResultRow_px = 26;
enum ResultColumn { kResultWhat, kResultPerson, kResultAttempt, kResultDetails, kResultColumns };

QString factsText(const StoreFacts& facts) {
  return DatabaseWindow::tr("%1: %2 people, %3 classes, %4 attempts, %5 forms, %6 entries in the audit log")
      .arg(qt(facts.place), QString::number(facts.people), QString::number(facts.cohorts),
           QString::number(facts.attempts), QString::number(facts.forms), QString::number(facts.auditEntries));
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : "; ") + word;
  return all;
}

std::vector<std::filesystem::path> caseLibraries() {
  std::vector<std::filesystem::path> folders{downloadFolder().toStdString()};
  for (const QString& folder : libraryFolders()) folders.emplace_back(folder.toStdString());
  return folders;
}

CompareEvents eventsIn(const std::vector<std::filesystem::path>& libraries) {
  const auto check = std::make_shared<EventCheck>(libraries);
  return [check](const AttemptRecording& recording, const Progress& progress) {
    return check->compare(recording, progress);
  };
}

QString askedFile(QWidget* parent, const QString& title, const QString& name, const QString& filter) {
  return QFileDialog::getSaveFileName(parent, title, QDir::home().filePath(name), filter);
}

}  // namespace

DatabaseWindow::DatabaseWindow(Account& account, TaskBar& tasks, QWidget* parent)
    : QDialog(parent),
      account_(account),
      tasks_(tasks),
      facts_(paragraph("databaseFacts")),
      message_(paragraph("databaseMessage")),
      earlierAnchor_(named(new QLineEdit, "databaseEarlierAnchor", tr("Earlier anchor"),
                           tr("Anchor from an earlier verification; shows whether the log was rewritten since"))),
      anchor_(named(new QLineEdit, "databaseAnchor", tr("Anchor"),
                    tr("Short code for the present state of the log; keep the code outside of this computer"))),
      differences_(named(new QTableWidget(0, kResultColumns), "databaseDifferences", tr("Findings of the verification"),
                         tr("Values that differ, attempts that cannot be recomputed, and implausible attempts"))),
      audit_(new AuditTable(account)) {
  setWindowTitle(tr("Database"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* tabs = new QTabWidget;
  tabs->addTab(audit_, tr("Audit log"));
  tabs->addTab(results(), tr("Verification"));
  tabs->setObjectName(QStringLiteral("databaseTabs"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kGap);
  column->addWidget(facts_);
  column->addWidget(actions());
  column->addWidget(message_);
  column->addWidget(tabs, 1);
  message_->hide();
  resize(1040, 620);
  connect(audit_, &AuditTable::failed, this, [this](const QString& why) { tell(why, true); });
  // The next user must not see anything that was read for the former one.
  connect(&account_, &Account::changed, this, [this, whose = account_.person().id] {
    if (account_.person().id != whose) close();
  });
  connect(&tasks_, &TaskBar::runningChanged, this, [this](bool running) {
    for (QPushButton* one : {backUp_, export_, verify_}) one->setEnabled(!running);
  });
  readFacts();
  audit_->read();
}

QWidget* DatabaseWindow::actions() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  backUp_ = pushButton("databaseBackUp", tr("Back up ..."),
                       tr("Copies the database and its recordings, also while others use them"));
  export_ = pushButton("databaseExport", tr("Export (JSON) ..."), tr("Writes all data except passwords to one file"));
  verify_ = pushButton("databaseVerify", tr("Verify"),
                       tr("Checks the log, and computes the results of all attempts again from their recordings"));
  earlierAnchor_->setPlaceholderText(tr("Earlier anchor (optional)"));
  connect(backUp_, &QPushButton::clicked, this, &DatabaseWindow::backUp);
  connect(export_, &QPushButton::clicked, this, &DatabaseWindow::exportJson);
  connect(verify_, &QPushButton::clicked, this, &DatabaseWindow::verify);
  for (QPushButton* one : {backUp_, export_, verify_}) line->addWidget(one);
  line->addWidget(earlierAnchor_, 1);
  return row;
}

QWidget* DatabaseWindow::results() {
  auto* page = new QWidget;
  makeRowTable(*differences_, kResultRow_px);
  differences_->setHorizontalHeaderLabels({tr("Finding"), tr("Person"), tr("Attempt"), tr("Details")});
  differences_->horizontalHeader()->setSectionResizeMode(kResultDetails, QHeaderView::Stretch);
  anchor_->setReadOnly(true);
  anchor_->setPlaceholderText(tr("Anchor, after a verification without a difference"));
  auto* copy = pushButton("databaseCopyAnchor", tr("Copy anchor"), tr("Copies the anchor to the clipboard"));
  connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(anchor_->text()); });
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(kGap);
  grid->addWidget(differences_, 0, 0, 1, 2);
  grid->addWidget(anchor_, 1, 0);
  grid->addWidget(copy, 1, 1);
  return page;
}

void DatabaseWindow::readFacts() {
  account_.query<StoreFacts>(
      this, [](const SignedIn& by) { return StoreUpkeep(by).facts(); },
      [this](const Result<StoreFacts>& facts) {
        facts ? facts_->setText(factsText(*facts)) : tell(qt(facts.error().message), true);
      });
}

template <class T>
void DatabaseWindow::run(const QString& title, std::function<Result<T>(const SignedIn&, const Progress&)> work,
                         std::function<void(const T&)> done) {
  account_.query<SignedIn>(
      this, [](const SignedIn& by) -> Result<SignedIn> { return by; },
      [this, title, work = std::move(work), done = std::move(done)](const Result<SignedIn>& by) {
        if (!by) return tell(qt(by.error().message), true);
        tell({}, false);
        tasks_.run<T>(
            title, [work, by = *by](const Progress& progress) { return work(by, progress); },
            [self = QPointer(this), done](const Result<T>& result) {
              if (!self) return;
              if (!result) return self->tell(qt(result.error().message), true);
              done(*result);
              self->readFacts();
              self->audit_->read();
            });
      });
}

void DatabaseWindow::backUp() {
  const QString name = QStringLiteral("insonate-%1.sqlite").arg(QDate::currentDate().toString(Qt::ISODate));
  const QString file = askedFile(this, tr("Back up"), name, tr("Database (*.sqlite)"));
  if (file.isEmpty()) return;
  run<QString>(
      tr("Backing up the database"),
      [file](const SignedIn& by, const Progress& progress) -> Result<QString> {
        if (auto done = StoreUpkeep(by).backup(file.toStdString(), progress); !done)
          return tl::unexpected(done.error());
        return file;
      },
      [this](const QString& written) {
        tell(tr("Backed up to %1 and %1.recordings. insonate-cli curriculum restore restores the backup.").arg(written),
             false);
      });
}

void DatabaseWindow::exportJson() {
  const QString name = QStringLiteral("insonate-%1.json").arg(QDate::currentDate().toString(Qt::ISODate));
  const QString file = askedFile(this, tr("Export"), name, tr("JSON (*.json)"));
  if (file.isEmpty()) return;
  run<QString>(
      tr("Exporting the database"),
      [file](const SignedIn& by, const Progress&) -> Result<QString> {
        if (auto done = StoreUpkeep(by).exportJson(file.toStdString()); !done) return tl::unexpected(done.error());
        return file;
      },
      [this](const QString& written) { tell(tr("Exported to %1, without passwords.").arg(written), false); });
}

void DatabaseWindow::verify() {
  std::vector<AuditAnchor> anchors;
  if (const QString typed = earlierAnchor_->text().trimmed(); !typed.isEmpty()) {
    const auto anchor = parseAuditAnchor(typed.toStdString());
    if (!anchor) return tell(qt(anchor.error().message), true);
    anchors.push_back(*anchor);
  }
  run<Verification>(
      tr("Verifying the database"),
      [anchors, libraries = caseLibraries()](const SignedIn& by, const Progress& progress) -> Result<Verification> {
        if (auto whole = StoreUpkeep(by).verify(); !whole) return tl::unexpected(whole.error());
        // verify() has read the log; it is read again only to compare it with an anchor.
        if (!anchors.empty())
          if (auto log = AuditLog(by).verify(anchors); !log) return tl::unexpected(log.error());
        auto found = compareDatabase(by, eventsIn(libraries), progress);
        if (!found) return tl::unexpected(found.error());
        const auto people = PeopleStore(by).all();
        if (!people) return tl::unexpected(people.error());
        const auto anchor = AuditLog(by).anchor();
        if (!anchor) return tl::unexpected(anchor.error());
        Verification verification{.found = std::move(*found), .names = {}, .anchor = *anchor};
        for (const Person& person : *people) verification.names[person.id] = person.fullName;
        return verification;
      },
      [this](const Verification& verification) { showVerification(verification); });
}

void DatabaseWindow::showVerification(const Verification& verification) {
  const RecomputedAttempts& found = verification.found;
  differences_->setRowCount(0);
  for (const StoreDifference& one : found.differences)
    addResult(tr("%1 differs").arg(qt(one.field)), verification, one.person, one.attempt,
              tr("stored: %1; expected: %2").arg(qt(one.stored), qt(one.expected)));
  for (const RecomputedAttempts::Flagged& one : found.implausible)
    addResult(tr("implausible"), verification, one.person, one.attempt, qt(joined(one.words)));
  for (const RecomputedAttempts::Left& one : found.left)
    addResult(tr("not recomputed"), verification, one.person, one.attempt, qt(one.why));
  for (const auto& [why, attempts] : found.eventsNotCompared)
    addResult(tr("needle events not computed"), verification, {}, {},
              tr("%1 (%2 attempts)").arg(qt(why)).arg(attempts));
  for (const auto& [what, attempts] : found.notCompared)
    addResult(tr("not compared"), verification, {}, {}, tr("%1 (%2 attempts)").arg(qt(what)).arg(attempts));
  for (int column = 0; column < kResultColumns; ++column)
    if (column != kResultDetails) differences_->resizeColumnToContents(column);
  const bool isIntact = found.differences.empty();
  anchor_->setText(isIntact
                       ? QString::number(verification.anchor.number) + QLatin1Char(':') + qt(verification.anchor.hash)
                       : QString());
  findChild<QTabWidget*>()->setCurrentIndex(1);
  if (isIntact)
    return tell(tr("No difference was found. %1 attempts were recomputed from their recordings; %2 could not be "
                   "recomputed. Keep the anchor below outside of this computer; later it shows whether the log was "
                   "rewritten.")
                    .arg(QString::number(found.compared), QString::number(found.left.size())),
                false);
  tell(tr("%1 values differ from recordings, log or attempts: another program has written to the database. Compare the "
          "database with a backup.")
           .arg(found.differences.size()),
       true);
}

void DatabaseWindow::addResult(const QString& what, const Verification& verification, const std::string& person,
                               const std::string& attempt, const QString& details) {
  const auto name = verification.names.find(person);
  const QString texts[] = {what, qt(name == verification.names.end() ? person : name->second), qt(attempt), details};
  const int row = differences_->rowCount();
  differences_->insertRow(row);
  for (int column = 0; column < kResultColumns; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setToolTip(plainToolTip(texts[column]));
    differences_->setItem(row, column, item);
  }
}

void DatabaseWindow::tell(const QString& words, bool isError) {
  message_->setText(isError ? QStringLiteral("▲  ") + words : words);
  message_->setVisible(!words.isEmpty());
}

}  // namespace insonate::ui
