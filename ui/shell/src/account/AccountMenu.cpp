#include "AccountMenu.h"

#include "CurriculumWindow.h"
#include "EntryDialog.h"
#include "PeopleWindow.h"
#include "RoleWords.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/SiteExchange.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QSettings>
#include <QShortcut>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace insonate::ui {
namespace {

const QString kLastName = QStringLiteral("account/name"), kAsked = QStringLiteral("account/asked");

Result<void> bothEqual(const QString& password, const QString& again) {
  if (password == again) return {};
  return fail(AccountMenu::tr("The two passwords differ; type the new password twice.").toStdString());
}

}  // namespace

AccountMenu::AccountMenu(Account& account, SiteExchange& site, Commands& commands, QWidget* window)
    : QMenu(window), account_(account), site_(site), window_(window) {
  setToolTipsVisible(true);
  const auto add = [this](const char* name, const QString& words, const QString& tip, auto act) {
    QAction* action = addAction(words);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  who_ = addAction(QString());
  who_->setEnabled(false);
  addSeparator();
  alone_ = add("accountAlone", tr("Just me ..."), tr("Sets up levels, results and learning curves for one person"),
               [this] { askAlone(); });
  setUp_ = add("accountSetUp", tr("Set up accounts and levels ..."),
               tr("Sets up the database of people and attempts, with you as administrator"), [this] { askSetUp(); });
  signIn_ = add("accountSignIn", tr("Sign in ..."), {}, [this] { askSignIn(); });
  signIn_->setShortcut(QKeySequence(QStringLiteral("Ctrl+L")));
  commands.add(QStringLiteral("window.account.signIn"), tr("signs in, so that attempts count toward levels"), *signIn_);
  already_ = new QShortcut(signIn_->shortcut(), window_, this, [this] {
    Q_EMIT statusMessage(tr("%1 is signed in. Sign out first (Ctrl+Shift+L).").arg(shortText()));
  });
  details_ = add("accountDetails", tr("My name and e-mail ..."), tr("Changes your name and e-mail address"),
                 [this] { askDetails(); });
  password_ =
      add("accountPassword", tr("Change password ..."), tr("Changes your own password"), [this] { askPassword(); });
  people_ = add("accountPeople", tr("People and classes ..."),
                tr("Opens the window that shows people, their classes and their roles"), [this] { showPeople(); });
  levels_ = add("accountLevels", tr("Curricula and levels ..."),
                tr("Opens curricula with their levels, rules and versions"), [this] { showCurricula(); });
  database_ = add("accountDatabase", tr("Database ..."),
                  tr("Backs up, exports and verifies the database of people and attempts; shows the audit log"),
                  [this] { Q_EMIT databaseRequested(); });
  server_ =
      add("accountServer", tr("Hospital server ..."),
          tr("Connects this computer to your hospital's server, to which attempts are sent"), [this] { askServer(); });
  again_ = add("accountAgain", tr("Try again"), tr("Tries again to open the database of people and attempts"),
               [this] { account_.reopen(); });
  signOut_ = add("accountSignOut", tr("Sign out"), {}, [this] { account_.signOut(); });
  signOut_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+L")));
  commands.add(QStringLiteral("window.account.signOut"), tr("signs out, so that the next user can sign in"), *signOut_);
  // Shortcuts work while the menu is closed.
  window_->addActions({signIn_, signOut_});
  connect(&account_, &Account::changed, this, &AccountMenu::refresh);
  connect(&site_, &SiteExchange::exchanged, this, [this] { Q_EMIT statusMessage(site_.outcome()); });
  refresh();
}

QString AccountMenu::shortText() const {
  switch (account_.state()) {
    case Account::State::SignedIn: {
      const QString name = QString::fromStdString(account_.person().fullName);
      return account_.isReadOnly() ? tr("%1 (read-only)").arg(name) : name;
    }
    case Account::State::Opening:
    case Account::State::NoUsers:
    case Account::State::Guest:
      break;
    case Account::State::Unreachable:
      return tr("Guest, no database");
  }
  return tr("Guest");
}

void AccountMenu::refresh() {
  using State = Account::State;
  const State state = account_.state();
  for (QAction* first : {alone_, setUp_}) first->setVisible(state == State::NoUsers);
  // A new workstation has no people yet: the first one who signs in comes from the server.
  const bool isOfSite = !site_.server().isEmpty();
  signIn_->setVisible(state == State::Guest || (state == State::NoUsers && isOfSite));
  already_->setEnabled(state == State::SignedIn);
  again_->setVisible(state == State::Unreachable);
  server_->setVisible(state == State::NoUsers ||
                      (state == State::SignedIn && account_.person().role == Role::Administrator));
  people_->setVisible(state == State::SignedIn && account_.person().role != Role::Trainee);
  levels_->setVisible(people_->isVisible());
  database_->setVisible(people_->isVisible() && account_.person().role == Role::Administrator);
  for (QAction* own : {details_, password_, signOut_}) own->setVisible(state == State::SignedIn);
  password_->setText(account_.hasGeneratedPassword() ? tr("Choose a password ...") : tr("Change password ..."));
  signOut_->setEnabled(!account_.hasGeneratedPassword());
  signOut_->setToolTip(account_.hasGeneratedPassword() ? tr("To sign out, choose a password first")
                                                       : tr("Signs out, so that the next user can sign in"));
  QString words = tr("Guest: attempts are recorded, but do not count toward levels");
  if (state == State::SignedIn)
    words = tr("%1, %2").arg(QString::fromStdString(account_.person().fullName), nameOf(account_.person().role));
  if (state == State::Opening) words = tr("Opening the database of people and attempts ...");
  if (state == State::Unreachable) words = tr("The database of people and attempts cannot be reached");
  who_->setText(plainCaption(words));
  who_->setToolTip(plainToolTip(state == State::Unreachable ? account_.error() : account_.place()));
  Q_EMIT textChanged();
  if (state == State::Unreachable) Q_EMIT statusMessage(account_.error());
}

void AccountMenu::welcome(const QString& hint) {
  QSettings().setValue(kLastName, QString::fromStdString(account_.person().name));
  QString words = tr("Signed in as %1.").arg(QString::fromStdString(account_.person().fullName));
  if (account_.isReadOnly())
    words += QLatin1Char(' ') + tr("The database can only be read; attempts and judgments cannot be stored.");
  Q_EMIT statusMessage(hint.isEmpty() ? words : words + QLatin1Char(' ') + hint);
  if (account_.mustChangePassword()) return askPassword();
  if (account_.person().role == Role::Trainee) announceComments();
}

void AccountMenu::announceComments() {
  using Counts = std::map<std::string, CommentStore::Count>;
  account_.query<Counts>(
      this, [](const SignedIn& by) { return CommentStore(by).countsOf(by.person().id); },
      [this](const Result<Counts>& counts) {
        int unread = 0;
        if (counts)
          for (const auto& [attempt, count] : *counts) unread += count.unread;
        if (unread == 0) return;
        Q_EMIT statusMessage(
            (unread == 1 ? tr("Signed in as %1. You have %2 unread comment: open My attempts in Review (Ctrl+3).")
                         : tr("Signed in as %1. You have %2 unread comments: open My attempts in Review (Ctrl+3)."))
                .arg(shortText(), QString::number(unread)));
      });
}

void AccountMenu::showPeople() {
  auto* people = new PeopleWindow(account_, window_);
  connect(people, &PeopleWindow::changed, &account_, &Account::peopleChanged);
  new QShortcut(QKeySequence(Qt::Key_F1), people, this, [this] { Q_EMIT helpRequested(QStringLiteral("people")); });
  people->show();
}

void AccountMenu::showCurricula() {
  auto* curricula = new CurriculumWindow(account_, window_);
  connect(curricula, &QDialog::finished, &account_, &Account::peopleChanged);
  curricula->show();
}

void AccountMenu::askAtFirstStart() {
  if (account_.state() == Account::State::Opening) {
    const auto once = std::make_shared<QMetaObject::Connection>();
    *once = connect(&account_, &Account::changed, this, [this, once] {
      disconnect(*once);
      askAtFirstStart();
    });
    return;
  }
  if (account_.state() != Account::State::NoUsers || QSettings().value(kAsked).toBool()) return;
  QSettings().setValue(kAsked, true);
  askAlone();
  Q_EMIT firstAsked();
}

void AccountMenu::askAlone() {
  const auto act = [this](const QStringList& texts, const Account::Done& done) {
    if (const auto equal = bothEqual(texts[1], texts[2]); !equal) return done(equal);
    account_.setUpAlone(texts[0], texts[1], [this, done](const Result<void>& result) {
      done(result);
      if (result) welcome(tr("Shift+F1 shows the first steps."));
    });
  };
  auto* dialog = new EntryDialog(
      tr("Who trains on this computer?"),
      tr("Just me: you get the levels of the built-in curriculum, and see your results and learning curves. You stay "
         "signed in on this computer. A class can be added later; your attempts are kept.\n\nA class: an administrator "
         "adds instructors and trainees, who sign in with a password.\n\nA site: your hospital has a server, where you "
         "have a name and a password.\n\nPrepare cases: an author makes cases from CTs, and needs no "
         "account.\n\nCancel to try the program first. The button at the top right offers the "
         "first three choices later."),
      {{"aloneName", tr("Your name"), tr("Name that is shown with your results")},
       {"alonePassword", tr("Password (optional)"), tr("At least 8 characters"), {}, true},
       {"aloneAgain", tr("Repeat password"), tr("The same password again, if you chose one"), {}, true}},
      tr("Just me"), act, window_);
  dialog->offer("entrySite", tr("A site ..."), tr("Connects this computer to your hospital's server"),
                [this] { askServer(); });
  dialog->offer("entryOther", tr("A class ..."), tr("Sets up accounts, classes and levels"), [this] { askSetUp(); });
  dialog->offer("entryAuthor", tr("Prepare cases"), tr("Opens the workspace Prepare and an author's first steps"),
                [this] { Q_EMIT authoringChosen(); });
  dialog->open();
}

void AccountMenu::askSetUp() {
  const auto act = [this](const QStringList& texts, const Account::Done& done) {
    if (const auto equal = bothEqual(texts[3], texts[4]); !equal) return done(equal);
    const NewPerson administrator{.name = texts[0].toStdString(),
                                  .fullName = texts[1].toStdString(),
                                  .email = texts[2].toStdString(),
                                  .role = Role::Administrator};
    account_.setUp(administrator, texts[3], [this, done](const Result<void>& result) {
      done(result);
      hasSetUpClass_ = result.has_value();
      if (result) welcome(tr("Shift+F1 shows the first steps."));
    });
  };
  (new EntryDialog(tr("Set up accounts and levels"),
                   tr("You become the administrator, who adds instructors, classes and trainees. All data are stored "
                      "in %1. Keep your password safe: it cannot be read or reset.")
                       .arg(account_.place()),
                   {{"setUpName", tr("Sign-in name"), tr("Name that consists of letters, digits and . _ - + @")},
                    {"setUpFullName", tr("Full name"), tr("Name that other users see")},
                    {"setUpEmail", tr("E-mail"), tr("Optional")},
                    {"setUpPassword", tr("Password"), tr("At least 8 characters"), {}, true},
                    {"setUpAgain", tr("Repeat password"), tr("The same password again"), {}, true}},
                   tr("Set up"), act, window_))
      ->open();
}

void AccountMenu::askSignIn() {
  const auto act = [this](const QStringList& texts, const Account::Done& done) {
    account_.signIn(texts[0], texts[1], [this, done](const Result<void>& result) {
      done(result);
      if (result) welcome();
    });
  };
  (new EntryDialog(tr("Sign in"),
                   tr("After you sign in, your attempts count toward levels. A level unlocks when you have mastered "
                      "the levels before it."),
                   {{"signInName", tr("Sign-in name"), tr("The name that your account has, not your full name"),
                     QSettings().value(kLastName).toString()},
                    {"signInPassword",
                     tr("Password"),
                     tr("If you forgot the password, your instructor can set a new password"),
                     {},
                     true}},
                   tr("Sign in"), act, window_))
      ->open();
}

void AccountMenu::askPassword() {
  const auto act = [this](const QStringList& texts, const Account::Done& done) {
    const int last = int(texts.size()) - 1;
    if (const auto equal = bothEqual(texts[last - 1], texts[last]); !equal) return done(equal);
    account_.changePassword(texts[0], texts[last], [this, done](const Result<void>& result) {
      done(result);
      if (result) Q_EMIT statusMessage(tr("Your password is changed."));
    });
  };
  const bool isFirst = account_.hasGeneratedPassword();
  std::vector<EntryDialog::Entry> entries{
      {"passwordNew", tr("New password"), tr("At least 8 characters"), {}, true},
      {"passwordAgain", tr("Repeat new password"), tr("The same password again"), {}, true}};
  if (!isFirst)
    entries.insert(entries.begin(),
                   {"passwordOld", tr("Current password"), tr("The password that you signed in with"), {}, true});
  (new EntryDialog(isFirst ? tr("Choose a password") : tr("Change password"),
                   account_.mustChangePassword()
                       ? tr("Another user has set your password. Choose a password of your own before you continue.")
                       : tr("At least 8 characters; a sentence is easy to remember."),
                   entries, isFirst ? tr("Choose") : tr("Change"), act, window_))
      ->open();
}

void AccountMenu::askDetails() {
  const auto act = [this](const QStringList& texts, const Account::Done& done) {
    account_.changeDetails(texts[0], texts[1], done);
  };
  const Person& me = account_.person();
  (new EntryDialog(
       tr("My name and e-mail"), tr("Your sign-in name is %1.").arg(QString::fromStdString(me.name)),
       {{"detailsFullName", tr("Full name"), tr("Name that other users see"), QString::fromStdString(me.fullName)},
        {"detailsEmail", tr("E-mail"), tr("Optional"), QString::fromStdString(me.email)}},
       tr("Save"), act, window_))
      ->open();
}

void AccountMenu::askServer() {
  const auto act = [this](const QStringList& texts, const Account::Done& done) {
    const auto joined = site_.setServer(texts[0], texts[1], texts[2]);
    done(joined);
    refresh();
    if (joined && signIn_->isVisible() && account_.state() == Account::State::NoUsers) askSignIn();
  };
  const QString last = site_.outcome().isEmpty() ? tr("No attempts have been sent yet.") : site_.outcome();
  (new EntryDialog(
       tr("Hospital server"),
       tr("Enter the address of your hospital's server and the token of this computer, which the server's "
          "administrator gives you.\n\nAttempts and completed forms are sent to the server. People, classes and "
          "curricula are read from the server, and everyone signs in with the name and password of their account on "
          "the server. Without a server, all data stay on this computer.\n\n%1")
           .arg(last),
       {{"serverAddress", tr("Address"), tr("Address of the server, https://HOST; leave empty to use no server"),
         site_.server()},
        {"serverToken",
         tr("Token"),
         tr("Token of this computer, which the server's administrator gives you if the address begins with https; "
            "leave empty to keep the present token"),
         {},
         true},
        {"serverAuthority", tr("Certificate file"),
         tr("Certificate (PEM) of the authority that signed the server's certificate; leave empty if this computer "
            "already trusts the authority"),
         site_.authorityFile()}},
       tr("Connect"), act, window_))
      ->open();
}

}  // namespace insonate::ui
