#pragma once

#include "PersonReading.h"

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {
class Account;
}

namespace insonate::review {

/// The data of the selected person. Uses no widgets.
class PersonController : public QObject {
  Q_OBJECT

 public:
  explicit PersonController(QObject* parent = nullptr);
  void setAccount(ui::Account& account);

  /// Queries everything about a person; "" shows no person.
  void show(const std::string& person, const std::optional<Curriculum>& curriculum);
  void refresh();
  /// Queries only the numbers of comments and forms, for example after comments were read.
  void refreshComments();
  /// Facts of the person; null until they are read.
  const PersonFacts* facts() const { return facts_ ? &*facts_ : nullptr; }
  /// The attempts that were read so far, newest first.
  const std::vector<StoredAttempt>& attempts() const { return attempts_; }
  bool hasEarlierAttempts() const { return earlier_; }
  void readEarlier();

  /// Tells whether the user may void this person's attempts.
  bool mayVoid() const;
  /// Returns a sentence that says why an attempt is implausible; empty if the attempt is plausible, or if the user does
  /// not teach the person.
  QString attentionReason(const AttemptFacts& attempt) const;
  void voidAttempt(const std::string& attempt, const QString& reason);
  /// Accepts an attempt without proof, so that it counts. Call it only if mayVoid().
  void acceptAttempt(const std::string& attempt, const QString& reason);

  /// Returns Account::address().
  QString storeAddress() const;
  bool isReading() const { return asking_ > 0; }
  QString error() const { return error_; }

 Q_SIGNALS:
  void personChanged();
  void attemptsChanged();
  void readingChanged();
  void countChanged();  ///< emitted when an attempt was voided or accepted
  void failed(const QString& what);

 private:
  void changeCount(std::function<Result<void>(const SignedIn&)> change);
  template <class T, class Question, class Take>
  void ask(Question question, Take take);

  ui::Account* account_ = nullptr;
  std::string person_;
  std::optional<Curriculum> curriculum_;
  std::optional<PersonFacts> facts_;
  std::vector<StoredAttempt> attempts_;
  bool earlier_ = false;
  int asking_ = 0, round_ = 0;
  QString error_;
};

}  // namespace insonate::review
