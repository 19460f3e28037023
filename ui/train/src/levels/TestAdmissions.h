#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/OpeningStore.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace insonate {
struct Level;
}

namespace insonate::ui {
class Account;
}

namespace insonate::train {

class Course;

/// Stores whether the tests of the course are open for the signed-in user. The store of attempts is queried on the
/// account's thread, every few seconds. The results only inform the user: the store decides whether an attempt counts.
class TestAdmissions final : public QObject {
  Q_OBJECT

 public:
  explicit TestAdmissions(Course& course, QObject* parent = nullptr);
  void setAccount(ui::Account& account);

  /// Returns whether a test is open for the user; empty if this is not known, for levels that are no test, and for
  /// guests.
  std::optional<TestAdmission> of(const Level& level) const;
  /// Returns a sentence about an attempt at a test that would begin now; empty for levels that are no test, and for
  /// guests.
  QString findingText(const Level& level) const;
  /// Returns the sitting that the store will probably decide for an attempt that begins now.
  TestConditions expectedTestConditions(const Level& level) const;

  void refresh();
  /// Enters the code of a test; `done` is called with an error if the code was not accepted.
  void enterCode(const std::string& level, const QString& code, std::function<void(Result<void>)> done);

 Q_SIGNALS:
  void changed();

 private:
  using Known = std::map<std::string, TestAdmission>;
  void take(Result<Known> known);

  Course& course_;
  ui::Account* account_ = nullptr;
  Known known_;  ///< admissions by Level::name
  QTimer again_;
};

}  // namespace insonate::train
