#pragma once

#include <QMenu>

class QAction;

namespace insonate::ui {

class Account;
class SiteExchange;

/// Sign in, sign out, the set-up of the first administrator, one's own password and details: what can be done now.
class AccountMenu : public QMenu {
  Q_OBJECT

 public:
  AccountMenu(Account& account, SiteExchange& site, QWidget* window);

  /// Name of the user for the header: "Sign in", "A. User".
  QString shortText() const;

  void showPeople();
  void showCurricula();
  void askSetUp();
  void askSignIn();
  void askPassword();
  void askDetails();
  void askServer();

 Q_SIGNALS:
  void textChanged();
  void said(const QString& sentence);  ///< for the status line

 private:
  void refresh();
  void welcome();

  Account& account_;
  SiteExchange& site_;
  QWidget* window_;
  QAction *who_, *setUp_, *signIn_, *password_, *details_, *people_, *levels_, *server_, *again_, *signOut_;
};

}  // namespace insonate::ui
