#include "SpeedClass.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/teaching/DemoClass.h>
#include <insonate/ui/Attempts.h>

#include <support/SmallCase.h>
#include <unit/curriculum/StoreRig.h>

#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>
#include <stdexcept>

namespace insonate::test {
namespace {

constexpr int kMadeUp = 10;  ///< attempts of each; the others are copies, since 100 000 one by one take minutes
constexpr const char* kConnection = "copies";

void copyAttempts(const QString& file) {
  QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", kConnection);
  database.setDatabaseName(file);
  if (!database.open()) throw std::runtime_error(database.lastError().text().toStdString());
  const auto run = [&](const QString& statement) {
    QSqlQuery query(database);
    if (!query.exec(statement)) throw std::runtime_error(query.lastError().text().toStdString());
    return query;
  };
  run("PRAGMA busy_timeout = 20000");
  QSqlQuery names = run("SELECT group_concat(name, ',') FROM pragma_table_info('attempts')");
  names.next();
  QString columns = names.value(0).toString(), values = columns;
  values.replace("arrival", "a.arrival + n.i * 1000000");
  values.replace(",id,", ",printf('%08x-0000-4000-8000-%012x', n.i, a.arrival),");
  run(QString("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1) "
              "INSERT INTO attempts (%2) SELECT %3 FROM n, attempts a")
          .arg(QString::number(kSpeedAttemptsEach / kMadeUp - 1), columns, values));
}

void judgeNewest(const CurriculumStore& store) {
  const Form form = valueOf(loadForm("jugular_checklist"));
  FormAnswers answers;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) answers[item.name] = "done";
  for (const char* rater : {kDemoInstructor, kDemoAdministrator}) {
    const SignedIn by = valueOf(store.signIn(rater, kSpeedPassword));
    for (const Cohort& cohort : valueOf(CohortStore(by).cohorts())) {
      if (cohort.name != kDemoClass) continue;
      for (const Member& member : valueOf(CohortStore(by).members(cohort.id))) {
        if (member.teaches) continue;
        const auto newest = valueOf(AttemptStore(by).page(member.person.id, 1));
        valueOf(FormStore(by).add({.form = form.name,
                                   .formVersion = form.version,
                                   .person = member.person.id,
                                   .attempt = newest.front().facts.id,
                                   .answers = answersText(answers)}));
      }
    }
  }
}

}  // namespace

void fillSpeedClass(const QString& file, const StoreServices& services) {
  const CurriculumStore store = valueOf(CurriculumStore::open(file.toStdString(), services));
  const DemoClassPlan plan{.trainees = kSpeedTrainees, .attempts = kMadeUp};
  succeed(makeDemoClass(store, valueOf(loadCurriculum("central_line")), plan, kSpeedPassword));
  copyAttempts(file);
  QSqlDatabase::removeDatabase(kConnection);
  judgeNewest(store);
}

void fillRecordings(const QString& folder, int count) {
  const PatientCase block = smallAttemptCase();
  const auto script = valueOf(readSessionScript(
      R"({"acts": [{"probe": "auto"}, {"needle": {"from_mm": [0, -5, 0], "to": "vein"}}, {"advance_mm": 17}]})",
      block));
  QDir().mkpath(folder);
  const auto name = [&](int i) { return QDir(folder).filePath(QString::number(i) + ui::kAttemptSuffix); };
  if (const auto run = runSession(script, block, "insonate test", name(0).toStdString()); !run)
    throw std::runtime_error(run.error().message);
  for (int i = 1; i < count; ++i) QFile::copy(name(0), name(i));
}

}  // namespace insonate::test
