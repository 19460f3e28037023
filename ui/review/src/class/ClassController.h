#pragma once

#include "ClassReading.h"

#include <insonate/teaching/HeatMap.h>

#include <QObject>
#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {
class Account;
}

namespace insonate::review {

/// The classes of the signed-in user, and the selected class. Uses no widgets. The store is queried on the account's
/// thread. The progress of people whose stored progress is outdated arrives for a few people at a time, since it is
/// computed from all attempts of each person.
class ClassController : public QObject {
  Q_OBJECT

 public:
  explicit ClassController(QObject* parent = nullptr);

  void setAccount(ui::Account& account);
  ui::Account* account() const { return account_; }
  /// Tells whether a user who may query classes is signed in.
  bool isSomebody() const;
  /// Tells whether the user is an instructor or administrator, who may see other people.
  bool teaches() const;
  bool administers() const;

  /// Queries the store again; the present data stay until the results arrive.
  void refresh();
  const std::vector<Cohort>& cohorts() const { return cohorts_; }
  int chosen() const { return chosen_; }
  void choose(int cohort);

  /// Facts of the class; null until they are read. Always null for a trainee, who gets only curriculum().
  const ClassFacts* facts() const { return facts_ ? &*facts_ : nullptr; }
  const Curriculum* curriculum() const;
  /// The heat map; empty until the facts are read.
  const HeatMap& heat() const;
  /// Remembers the code of an opening until another user signs in. The store holds only a hash of the code.
  void rememberCode(const std::string& opening, const QString& code) { codes_[opening] = code; }
  /// Returns the remembered code of an opening; empty if there is none.
  QString codeOf(const std::string& opening) const {
    const auto found = codes_.find(opening);
    return found == codes_.end() ? QString() : found->second;
  }
  /// Tells whether a query other than for standings is running.
  bool isReading() const { return asking_ > 0; }
  int pendingStandings() const { return int(queue_.size()); }
  /// Returns a sentence that says why there are no data, and what to do; empty if there is no problem.
  QString error() const { return error_; }

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
  std::optional<Curriculum> own_;         ///< curriculum of a signed-in trainee
  std::vector<std::string> queue_;        ///< ids of people whose standing must be computed; the last id in the list is
                                          ///< computed first
  std::map<std::string, QString> codes_;  ///< codes of tests that the user has opened, by TestOpening::id
  int asking_ = 0;
  int round_ = 0;  ///< number of the last selection; results for earlier classes are dropped
  QString error_;
};

}  // namespace insonate::review
