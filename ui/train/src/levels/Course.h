#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/Unlocking.h>

#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::ui {
class Account;
}

namespace insonate::train {

/// The user's curriculum, progress and attempts. The curriculum is that of one of the user's classes, else the built-in
/// curriculum. Guests have no progress. May be used only on the window's thread; no call blocks.
class Course final : public QObject {
  Q_OBJECT

 public:
  explicit Course(QString unsentFolder, QObject* parent = nullptr);

  void setAccount(ui::Account& account);
  /// Tells whether a user is signed in, whose attempts therefore count.
  bool isSomebodys() const;

  /// The curriculum; null until it is known.
  const Curriculum* curriculum() const { return known_ ? &known_->curriculum : nullptr; }
  /// Returns the origin of the curriculum in words, such as "built-in curriculum".
  QString origin() const;
  /// The user's state in each level, in the curriculum's order.
  const std::vector<LevelProgress>& progress() const { return progress_; }
  /// The user's progress in a level; null if the curriculum lacks the level.
  const LevelProgress* progressIn(std::string_view level) const;
  /// Attempts in the order in which the store received them.
  std::vector<AttemptFacts> history() const { return known_ ? known_->history : std::vector<AttemptFacts>{}; }
  /// Returns a sentence that says why the course, or a part of it, is not known, and what to do; empty if everything is
  /// known.
  QString error() const { return error_; }

  /// A curriculum that the user can choose: the curriculum of each class, else the built-in curriculum.
  struct Choice {
    std::string cohort{};  ///< name of the class; "": the built-in curriculum
    std::string curriculum{};
    int version = 0;

    bool operator==(const Choice&) const = default;
  };
  std::vector<Choice> choices() const { return known_ ? known_->choices : std::vector<Choice>{}; }
  int chosen() const { return known_ ? known_->chosen : 0; }
  void choose(int choice);

  /// Queries the store again; changed() is emitted with the result.
  void refresh();
  /// Adds an attempt that has just ended, so that it counts before the store has it.
  void add(const AttemptFacts& ended);

 Q_SIGNALS:
  void changed();
  void casesDownloaded();  ///< emitted when a case of the site's server has arrived

 private:
  struct Known {
    std::vector<Choice> choices{};
    int chosen = 0;
    Curriculum curriculum{};
    std::vector<AttemptFacts> history{};
  };
  static Result<std::vector<Choice>> choicesOf(const SignedIn& by);
  static Result<Known> ask(const SignedIn& by, const QString& unsent, const std::optional<Choice>& wanted);
  void take(Result<Known> known);
  void workOut();

  const QString unsent_;
  ui::Account* account_ = nullptr;
  std::string person_;  ///< id of the user to whom known_ belongs
  std::optional<Choice> wanted_;
  std::optional<Known> known_;
  std::vector<LevelProgress> progress_;
  QString error_;
};

}  // namespace insonate::train
