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

/// Holds whether the tests of the course are open for the signed-in user. The store is queried on the account's thread,
/// again every few seconds. What is known here only informs the user: the store decides whether an attempt counts.
class TestAdmissions final : public QObject {
  Q_OBJECT

 public:
  explicit TestAdmissions(Course& course, QObject* parent = nullptr);
  void setAccount(ui::Account& account);

  /// The admission to a test; empty if it is not known, for other levels and for guests.
  std::optional<TestAdmission> of(const Level& level) const;
  /// Returns a sentence about an attempt at a test that would begin now; empty for other levels and for guests.
  QString sentenceOf(const Level& level) const;
  /// The sitting that the store will probably decide for an attempt that begins now.
  AttemptSitting expectedSitting(const Level& level) const;

  void refresh();
  /// Enters the code of a test; `done` is called with an error if it was not accepted.
  void enterCode(const std::string& level, const QString& code, std::function<void(Result<void>)> done);

 Q_SIGNALS:
  void changed();

 private:
  using Known = std::map<std::string, TestAdmission>;
  void take(Result<Known> known);

  Course& course_;
  ui::Account* account_ = nullptr;
  Known known_;  ///< by Level::name
  QTimer again_;
};

}  // namespace insonate::train
