#include "SaveMenu.h"

#include "../person/PersonController.h"
#include "../result/PaperPage.h"
#include "CsvTables.h"
#include "Portfolio.h"
#include "ReportPages.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/XapiStatements.h>
#include <insonate/teaching/ClassExports.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/TaskBar.h>

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLocale>
#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <iterator>

namespace insonate::review {
namespace {

const QString kHomePage = QStringLiteral("review/xapiHomePage");

/// Writes all statements about these people to a file, on the account's thread. Returns leftOutSentence().
Result<std::string> writeStatements(const SignedIn& by, const std::vector<Person>& people, const Curriculum& curriculum,
                                    const XapiSite& site, const std::string& file) {
  XapiExport all;
  for (const Person& person : people) {
    const auto history = AttemptStore(by).history(person.id);
    if (!history) return tl::unexpected(history.error());
    auto statements = xapiStatements(site, curriculum, person, *history);
    if (!statements) return tl::unexpected(statements.error());
    std::ranges::move(statements->statements, std::back_inserter(all.statements));
    std::ranges::move(statements->leftOut, std::back_inserter(all.leftOut));
  }
  if (const auto written = writeXapi(file, all.statements); !written) return tl::unexpected(written.error());
  return leftOutSentence(all.leftOut);
}

/// Writes grades to a file, on the account's thread. Returns a sentence about people who were left out.
Result<std::string> writeGrades(const SignedIn& by, const Cohort& cohort, const Curriculum& curriculum, GradeKey key,
                                const std::string& file) {
  const auto made = exportGrades(by, cohort, curriculum, "Insonate", key);
  if (!made) return tl::unexpected(made.error());
  if (const auto written = writeAtomically(file, made->book.csv); !written) return tl::unexpected(written.error());
  const std::vector<UngradedPerson>& leftOut = made->book.leftOut;
  if (leftOut.empty()) return std::string();
  std::string sentence = "Left out: " + leftOut.front().fullName + " (" + leftOut.front().why + ")";
  if (leftOut.size() > 1) sentence += " and " + std::to_string(leftOut.size() - 1) + " more";
  return sentence + ".";
}

}  // namespace

SaveMenu::SaveMenu(Subject subject, ClassController& room, PersonController& person, ui::TaskBar& tasks,
                   QWidget* parent)
    : QMenu(parent), subject_(subject), room_(room), person_(person), tasks_(tasks) {
  setToolTipsVisible(true);
  add("savePage", tr("Page (PDF or PNG) ..."), tr("Saves one A4 page to print or to send"),
      QStringLiteral("PDF (*.pdf);;PNG (*.png)"), &SaveMenu::savePage);
  add("saveTable", tr("Table (CSV) ..."),
      subject_ == Subject::Class ? tr("Saves a table with a row for each person, for a spreadsheet")
                                 : tr("Saves a table with a row for each attempt and all metrics, for a spreadsheet"),
      QStringLiteral("CSV (*.csv)"), &SaveMenu::saveTable);
  if (subject_ == Subject::Class)
    add("saveGrades", tr("Grades for Moodle (CSV) ..."),
        tr("Saves the share of levels that each trainee has mastered, for the grade book of Moodle"),
        QStringLiteral("CSV (*.csv)"), &SaveMenu::saveGrades, tr("-grades"));
  add("saveXapi", tr("Learning records (xAPI) ..."),
      tr("Saves all attempts as xAPI 1.0.3 statements, for a learning record store"), QStringLiteral("JSON (*.json)"),
      &SaveMenu::askXapi);
}

QAction& SaveMenu::addPortfolio() {
  QAction* action = add("savePortfolio", tr("Portfolio (PDF) ..."),
                        tr("Saves levels, tests, learning curves, checklists, ratings and all attempts"),
                        QStringLiteral("PDF (*.pdf)"), &SaveMenu::savePortfolio, tr("-portfolio"));
  return *action;
}

QAction* SaveMenu::add(const char* name, const QString& text, const QString& tip, const QString& ending,
                       void (SaveMenu::*save)(const QString&), const QString& part) {
  QAction* action = addAction(text);
  action->setObjectName(QLatin1String(name));
  action->setToolTip(tip);
  connect(action, &QAction::triggered, this, [this, ending, save, part] {
    const QString suffix = ending.section(QStringLiteral("*."), 1, 1).section(QLatin1Char(')'), 0, 0);
    const QString offered = fileName() + part + QLatin1Char('.') + suffix;
    const QString file =
        QFileDialog::getSaveFileName(parentWidget(), tr("Save"), QDir::home().filePath(offered), ending);
    if (!file.isEmpty()) (this->*save)(file);
  });
  return action;
}

QString SaveMenu::fileName() const {
  const ClassFacts* room = room_.facts();
  const PersonFacts* person = person_.facts();
  QString words = subject_ == Subject::Class ? (room ? QString::fromStdString(room->cohort.name) : QString())
                                             : (person ? QString::fromStdString(person->person.fullName) : QString());
  for (QChar& letter : words)
    if (!letter.isLetterOrNumber()) letter = QLatin1Char('-');
  return words;
}

void SaveMenu::savePage(const QString& file) {
  const ClassFacts* room = room_.facts();
  const auto paint = [&](QPainter& painter) {
    if (subject_ == Subject::Class)
      paintClassReport(painter, room_);
    else
      paintPersonReport(painter, *person_.facts(), room_.heat());
  };
  if (subject_ == Subject::Class ? !room : !person_.facts()) return;
  const QString error = writePage(file, fileName(), paint);
  error.isEmpty() ? tell(file) : Q_EMIT failed(error, {});
}

void SaveMenu::saveTable(const QString& file) {
  if (subject_ == Subject::Class ? !room_.facts() : !person_.facts()) return;
  const std::string text = subject_ == Subject::Class ? classCsv(room_) : attemptsCsv(*person_.facts());
  const auto written = writeAtomically(file.toStdString(), text);
  written ? tell(file) : Q_EMIT failed(QString::fromStdString(written.error().message), {});
}

void SaveMenu::saveGrades(const QString& file) {
  const ClassFacts* facts = room_.facts();
  if (!facts) return;
  const Curriculum* curriculum = room_.curriculum();
  if (!curriculum)
    return Q_EMIT failed(tr("There are no grades: the class has no curriculum yet."),
                         tr("Choose a curriculum for the class first."));
  const bool hasMail =
      std::ranges::any_of(facts->learners, [](const Member& one) { return !one.person.email.empty(); });
  room_.account()->query<std::string>(
      this,
      [cohort = facts->cohort, curriculum = *curriculum, key = hasMail ? GradeKey::Email : GradeKey::Name,
       name = file.toStdString()](const SignedIn& by) { return writeGrades(by, cohort, curriculum, key, name); },
      [this, file](const Result<std::string>& done) {
        done ? tell(file, QString::fromStdString(*done))
             : Q_EMIT failed(QString::fromStdString(done.error().message), {});
      });
}

void SaveMenu::savePortfolio(const QString& file) {
  const PersonFacts* facts = person_.facts();
  if (!facts || !room_.account()) return;
  const std::int64_t now_us = QDateTime::currentMSecsSinceEpoch() * 1000;
  room_.account()->query<Portfolio>(
      this,
      [person = facts->person.id, curriculum = facts->curriculum, now_us](const SignedIn& by) {
        return readPortfolio(by, person, curriculum, now_us);
      },
      [this, file](Result<Portfolio> portfolio) {
        portfolio ? writePages(file, std::move(*portfolio))
                  : Q_EMIT failed(QString::fromStdString(portfolio.error().message), {});
      });
}

void SaveMenu::writePages(const QString& file, Portfolio portfolio) {
  // The task bar runs one job; another one would cancel the opening of a case.
  if (tasks_.isRunning()) return writeLater(file, std::move(portfolio));
  const bool usesLetter = QLocale::system().measurementSystem() == QLocale::ImperialUSSystem;
  const auto paper = usesLetter ? QPageSize::Letter : QPageSize::A4;
  const QString title = tr("Writing the portfolio of %1").arg(QString::fromStdString(portfolio.person.person.fullName));
  auto curves = curvesOf(portfolio);
  tasks_.run<bool>(
      title,
      [file, paper, curves = std::move(curves),
       portfolio = std::move(portfolio)](const Progress& progress) -> Result<bool> {
        if (const auto done = writePortfolio(file, portfolio, curves, paper, progress); !done)
          return tl::unexpected(done.error());
        return true;
      },
      [menu = QPointer<SaveMenu>(this), file](const Result<bool>& done) {
        if (!menu || (!done && done.error().message == kCancelled)) return;
        done ? menu->tell(file) : Q_EMIT menu->failed(QString::fromStdString(done.error().message), {});
      },
      ui::TaskBar::WhenClosed::Ask);
}

void SaveMenu::writeLater(const QString& file, Portfolio portfolio) {
  const QString name = QString::fromStdString(portfolio.person.person.fullName);
  Q_EMIT written(tr("The portfolio of %1 will be written when this task is done: %2.").arg(name, tasks_.title()), {});
  waiting_ << name;
  auto* end = new QObject(this);
  connect(
      &tasks_, &ui::TaskBar::runningChanged, end,
      [this, end, file, name, portfolio = std::move(portfolio)](bool isRunning) mutable {
        if (isRunning) return;
        end->deleteLater();
        waiting_.removeOne(name);
        writePages(file, std::move(portfolio));
      },
      // After the reaction to the end of that task, which may begin another one.
      Qt::QueuedConnection);
}

void SaveMenu::askXapi(const QString& file) {
  bool sure = false;
  const QString page = QInputDialog::getText(
      parentWidget(), tr("Learning records (xAPI)"),
      tr("Web address of your site; together with a person's ID, it identifies the person in the records:"),
      QLineEdit::Normal, QSettings().value(kHomePage, QStringLiteral("https://")).toString(), &sure);
  if (!sure) return;
  QSettings().setValue(kHomePage, page);
  saveXapi(file, page);
}

void SaveMenu::saveXapi(const QString& file, const QString& homePage) {
  const Curriculum* curriculum = room_.curriculum();
  if (!curriculum)
    return Q_EMIT failed(tr("There are no xAPI statements: the class has no curriculum yet."),
                         tr("Choose a curriculum for the class first."));
  std::vector<Person> people;
  if (subject_ == Subject::Person && person_.facts()) people.push_back(person_.facts()->person);
  if (subject_ == Subject::Class && room_.facts())
    for (const Member& member : room_.facts()->learners) people.push_back(member.person);
  room_.account()->query<std::string>(
      this,
      [people, curriculum = *curriculum, site = XapiSite{homePage.toStdString(), false},
       name = file.toStdString()](const SignedIn& by) { return writeStatements(by, people, curriculum, site, name); },
      [this, file](const Result<std::string>& done) {
        done ? tell(file, QString::fromStdString(*done))
             : Q_EMIT failed(QString::fromStdString(done.error().message), {});
      });
}

void SaveMenu::tell(const QString& file, const QString& besides) {
  const QString saved = tr("Saved as %1.").arg(QFileInfo(file).fileName());
  Q_EMIT written(besides.isEmpty() ? saved : saved + QLatin1Char(' ') + besides, QFileInfo(file).absolutePath());
}

}  // namespace insonate::review
