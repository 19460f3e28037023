#pragma once

#include "ClassReading.h"
#include "HeatMap.h"

#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {
class Account;
}

namespace insonate::review {

/// The classes of the signed-in user, and the selected one, without a widget. The store is queried on the account's
/// thread. Outdated standings arrive for some people after the other, since each is computed from all attempts of the
/// person.
class ClassDesk : public QObject {
  Q_OBJECT

 public:
  explicit ClassDesk(QObject* parent = nullptr);

  void setAccount(ui::Account& account);
  ui::Account* account() const { return account_; }
  /// Tells whether a user who may query classes is signed in.
  bool isSomebody() const;
  /// Tells whether the user may see others: an instructor or administrator.
  bool teaches() const;
  bool administers() const;

  /// Queries again; the shown data stays until the answer arrives.
  void refresh();
  const std::vector<Cohort>& cohorts() const { return cohorts_; }
  int chosen() const { return chosen_; }
  void choose(int cohort);

  /// Facts of the class; null until they are read, and always for a trainee, whose curriculum is curriculum().
  const ClassFacts* facts() const { return facts_ ? &*facts_ : nullptr; }
  const Curriculum* curriculum() const;
  /// Heat map; empty until the facts are read.
  const HeatMap& heat() const;
  /// Something that was asked is not answered yet; standings do not count.
  bool isReading() const { return asking_ > 0; }
  int pendingStandings() const { return int(queue_.size()); }
  /// Why nothing is there, and what to do; empty where all is well.
  QString trouble() const { return trouble_; }

 Q_SIGNALS:
  void cohortsChanged();
  void classChanged();
  void standingChanged(const QString& person);
  void readingChanged();

 private:
  template <class T, class Question, class Take>
  void ask(Question question, Take take);
  void forget();
  void readCohorts();
  void readClass();
  void take(ClassFacts facts);
  void take(const std::string& person, Standing standing);
  void nextStandings();

  ui::Account* account_ = nullptr;
  std::vector<Cohort> cohorts_;
  int chosen_ = 0;
  std::optional<ClassFacts> facts_;
  std::optional<Curriculum> own_;   ///< a trainee's
  std::vector<std::string> queue_;  ///< whose standing is to be worked out, the last one first
  int asking_ = 0;
  int round_ = 0;  ///< answers to questions of an earlier class are not taken
  QString trouble_;
};

}  // namespace insonate::review
