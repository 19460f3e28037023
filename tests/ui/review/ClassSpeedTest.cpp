#include "Classroom.h"
#include "class/ClassTable.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
#include <cstdio>

namespace insonate::review {
namespace {

constexpr int kTrainees = 200, kAttemptsEach = 500;

/// Fills the store by SQL, since 100 000 attempts one by one take minutes: copies of one attempt.
void copyAttempts(const QString& file, const std::string& attempt) {
  QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", "copies");
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
  values.replace("arrival", "a.arrival + n.i * 1000 + p.k");
  values.replace(",id,", ",printf('%08x-0000-4000-8000-%012x', n.i, p.k),");
  values.replace(",person,", ",p.id,");
  run("BEGIN IMMEDIATE");
  run(QString("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1), "
              "p(id, k) AS (SELECT id, row_number() OVER () FROM people WHERE name LIKE 'mass%') "
              "INSERT INTO attempts (%2) SELECT %3 FROM n, p, attempts a WHERE a.id = '%4'")
          .arg(QString::number(kAttemptsEach), columns, values, QString::fromStdString(attempt)));
  run("COMMIT");
}

class ClassSpeed : public Classroom {
 protected:
  /// As the end of each attempt does, which these did not have.
  void keepStandings() {
    const CohortStore cohorts(school_->admin);
    std::vector<std::string> people;
    for (const Member& one : test::valueOf(cohorts.members(school_->spring.id))) people.push_back(one.person.id);
    QElapsedTimer clock;
    clock.start();
    test::valueOf(cohorts.standings(school_->spring.id, people));
    std::printf("all levels worked out from all attempts: %lld ms\n", clock.elapsed());
  }
};

TEST_F(ClassSpeed, ManyPeopleWithManyAttempts) {
  for (int i = 0; i < kTrainees; ++i)
    test::valueOf(PeopleStore(school_->admin)
                      .add({"mass" + std::to_string(i), "Trainee " + std::to_string(i), "", Role::Trainee},
                           "first password", school_->spring.id));
  practise(school_->as(school_->anna), true);
  copyAttempts(file(), last_.id);
  QSqlDatabase::removeDatabase("copies");
  keepStandings();

  enter("");
  // Of the window's thread, how long it does not answer.
  QTimer beat;
  QElapsedTimer since, clock;
  qint64 longest_ms = 0;
  QObject::connect(&beat, &QTimer::timeout, [&] { longest_ms = std::max(longest_ms, since.restart()); });
  signIn("ina");
  beat.start(1);
  since.start();
  clock.start();
  auto& table = *child<QTableView>("classTable");
  const auto rows = [&] { return table.model()->rowCount() > kTrainees && table.isVisible(); };
  ASSERT_TRUE(QTest::qWaitFor(rows, kPatience_ms));
  const qint64 class_ms = clock.elapsed();
  settle();
  std::printf("%d trainees x %d attempts: class %lld ms, all levels %lld ms", kTrainees, kAttemptsEach, class_ms,
              clock.elapsed());
  EXPECT_EQ(table.model()->index(5, ClassTable::kAttempts).data().toString(), QString::number(kAttemptsEach));

  table.setCurrentIndex(table.model()->index(5, 0));
  table.setFocus();
  clock.restart();
  QTest::keyClick(&table, Qt::Key_Return);
  auto& history = *child<QTableWidget>("history");
  ASSERT_TRUE(QTest::qWaitFor([&] { return history.rowCount() > 0; }, kPatience_ms));
  std::printf(", person %lld ms, longest pause of the window %lld ms\n", clock.elapsed(), longest_ms);
}

}  // namespace
}  // namespace insonate::review
