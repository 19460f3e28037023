#pragma once

#include <QWidget>
#include <set>
#include <string>

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QStackedWidget;

namespace insonate::ui {
class Account;
class Commands;
class TaskBar;
}  // namespace insonate::ui

namespace insonate::review {

class AttemptList;
class ClassController;
class ClassPage;
class ComparePage;
class PersonController;
class PersonPage;
class RatersPage;
class SaveMenu;

/// The pages that are shown while no attempt is open. A signed-in user gets the pages class, person and recordings, as
/// far as permitted. A guest gets only the recordings on this computer.
class ReviewHome final : public QWidget {
  Q_OBJECT

 public:
  /// `list` is shown on the page of recordings.
  ReviewHome(AttemptList& list, ui::Commands& commands, ui::TaskBar& tasks, QWidget* parent = nullptr);

  void setAccount(ui::Account& account);
  /// Queries the numbers of comments on the person's page again.
  void refreshComments();
  /// Tells whether all queries are answered.
  bool isSettled() const;
  /// Sentence about the next thing to do.
  QString statusText() const;
  /// Opens the menu that saves the present page.
  void showSaving();
  /// Gives the keyboard focus to the page that is shown.
  void focusPage();
  /// Returns a sentence about a portfolio that waits until another task has ended; empty if there is none.
  QString unwrittenPortfolio() const;

 Q_SIGNALS:
  void readinessChanged();
  void statusChanged();  ///< emitted when statusText() has changed
  /// Emitted when the user wants to replay the recording of an attempt of the store.
  void replayRequested(const QString& file, const QString& attempt);
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 private:
  enum Tab { kClass, kPerson, kCompare, kRecordings, kRaters };

  QWidget* buildTabs();
  void addTabs(ui::Commands& commands);
  void addPortfolio(ui::Commands& commands);
  void connectParts();
  void showSignedInPages();
  /// Queries the store again for pages that show data of these people.
  void showChanges(const std::set<std::string>& people);
  void showSelf();
  void showTab(int tab);
  void choosePerson(const QString& person);

  ui::Account* account_ = nullptr;
  AttemptList& list_;
  ClassController* room_;
  PersonController* person_;
  QHBoxLayout* row_;  ///< row of the tabs
  QWidget* bar_;
  QLabel* notice_;
  QButtonGroup* tabs_;
  QStackedWidget* pages_;
  ClassPage* classPage_;
  PersonPage* personPage_;
  ComparePage* comparePage_;
  RatersPage* ratersPage_;
  SaveMenu *saveClass_, *savePerson_;
};

}  // namespace insonate::review
