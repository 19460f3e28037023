#pragma once

#include <QMenu>

class QAction;
class QShortcut;

namespace insonate::ui {

class Account;
class Commands;
class SiteExchange;

/// Menu with the account actions that are possible now: sign in, sign out, set up the first administrator, change one's
/// own password and details.
class AccountMenu : public QMenu {
  Q_OBJECT

 public:
  /// Adds the keys for signing in and out to the window's commands.
  AccountMenu(Account& account, SiteExchange& site, Commands& commands, QWidget* window);

  /// Returns the text for the header: the user's name, for example "A. User", or "Sign in".
  QString shortText() const;

  /// Tells whether a class was set up with askSetUp() since the program was started.
  bool hasSetUpClass() const { return hasSetUpClass_; }
  void showPeople();
  void showCurricula();
  /// If the store has no people, asks the user at the first start who trains on this computer.
  void askAtFirstStart();
  void askAlone();
  void askSetUp();
  void askSignIn();
  void askPassword();
  void askDetails();
  void askServer();

 Q_SIGNALS:
  void textChanged();
  void firstAsked();                            ///< emitted when the question of the first start is shown
  void databaseRequested();                     ///< emitted when an administrator asks for the window of the database
  void authoringChosen();                       ///< emitted when the user wants to prepare cases
  void statusMessage(const QString& sentence);  ///< emitted with a sentence for the status bar
  void helpRequested(const QString& page);      ///< emitted when the user asks for a page of the help

 private:
  void refresh();
  void welcome(const QString& hint = {});
  void announceComments();

  Account& account_;
  SiteExchange& site_;
  QWidget* window_;
  QShortcut* already_;  ///< key of signing in while a user is signed in
  bool hasSetUpClass_ = false;
  QAction *who_, *alone_, *setUp_, *signIn_, *password_, *details_, *people_, *levels_, *database_, *server_, *again_,
      *signOut_;
};

}  // namespace insonate::ui
