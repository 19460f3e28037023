#pragma once

#include <insonate/curriculum/CurriculumStore.h>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThread>
#include <QTimer>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace insonate::ui {

/// Returns the address of the database of people and attempts: the value of the environment variable INSONATE_DATABASE
/// (a file), else the default file on this computer.
QString defaultStoreAddress();

/// The signed-in user, and the connection to the store (database) of people, levels and attempts. Queries run one after
/// the other on a background thread, which owns the connection; their results arrive on the window's thread. May be
/// used only on the window's thread.
class Account : public QObject {
  Q_OBJECT

 public:
  enum class State {
    Opening,
    Unreachable,  ///< the store cannot be reached or opened; error() says why
    NoUsers,      ///< there is no store, or the store has no people: an administrator must be set up first
    Guest,        ///< no user is signed in
    SignedIn,
  };

  /// Opens the store if it exists; `address` as in CurriculumStore. A store file is created only by setUp().
  explicit Account(QString address = defaultStoreAddress(), StoreServices services = {}, QObject* parent = nullptr);
  /// Waits until all queries are done.
  ~Account() override;

  State state() const { return state_; }
  bool isSignedIn() const { return state_ == State::SignedIn; }
  /// Returns the user's data at sign-in; all members are empty for a guest.
  const Person& person() const { return person_; }
  bool mustChangePassword() const { return session_ && session_->mustChangePassword(); }
  /// Returns a sentence that says why the store is Unreachable; empty in other states.
  QString error() const { return error_; }
  /// Tells whether the server did not answer the last query. The program then tries to reach the server every few
  /// seconds.
  bool isServerUnreachable() const { return away_; }
  /// Tells whether the user can only read the store's file. Storing anything then fails with a sentence.
  bool isReadOnly() const { return isReadOnly_; }
  QString place() const;  ///< location of the store, without a password
  const QString& address() const { return address_; }
  const StoreServices& services() const { return services_; }

  using Done = std::function<void(Result<void>)>;
  void setUp(const NewPerson& administrator, const QString& password, Done done);
  /// Sets up the store for one person who trains alone, and keeps this person signed in when the program is started
  /// again. If `password` is empty, a password is generated and stored on this computer. Fails if the store is on a
  /// server and `password` is empty.
  void setUpAlone(const QString& fullName, const QString& password, Done done);
  /// Signs in. On a workstation of a site (SiteExchange), the site's server checks the password, if it can be reached.
  void signIn(const QString& name, const QString& password, Done done);
  /// Signs out. Has no effect while hasGeneratedPassword(): the user does not know the password and could not sign in
  /// again.
  void signOut();
  /// Tells whether the signed-in user has not chosen a password yet.
  bool hasGeneratedPassword() const { return isSignedIn() && !generatedPassword_.empty(); }
  /// Changes the password of the signed-in user; `old` is ignored while hasGeneratedPassword().
  void changePassword(const QString& old, const QString& password, Done done);
  void changeDetails(const QString& fullName, const QString& email, Done done);
  /// Tries again to open a store that could not be reached.
  void reopen();

  /// Queues `question` for the store's thread. When `question` has run, `done` is called once on the window's thread
  /// with the result. If `receiver` was deleted meanwhile, `done` is not called. If another user has signed in
  /// meanwhile, `done` receives an error, so that no user sees another user's data. `question` runs in all these cases.
  template <class T>
  void query(const QObject* receiver, std::function<Result<T>(const SignedIn&)> question,
             std::function<void(Result<T>)> done) {
    post([this, session = session_, number = number_, receiver = QPointer<const QObject>(receiver),
          question = std::move(question), done = std::move(done)]() mutable {
      auto answer = std::make_shared<Result<T>>(session ? guarded<T>(question, *session) : fail(notOpenMessage()));
      deliver([this, number, receiver, answer, done = std::move(done)] {
        if (!*answer) checkConnection();
        if (!receiver || !done) return;
        done(number == number_ ? std::move(*answer) : fail(otherUserMessage()));
      });
    });
  }

 Q_SIGNALS:
  void changed();          ///< emitted when state() or person() has changed
  void peopleChanged();    ///< emitted when people, classes or their curricula were changed in a window of this program
  void casesDownloaded();  ///< emitted when a case of the site's server has arrived (SiteExchange)
  void reconnected();      ///< emitted when the server answers again; receivers should repeat queries that have failed

 private:
  template <class T>
  static Result<T> guarded(const std::function<Result<T>(const SignedIn&)>& question, const SignedIn& session) {
    try {
      return question(session);
    } catch (const std::exception& e) {
      return fail(e.what());
    }
  }
  struct Entered {
    SignedIn session;
    std::string generatedPassword{};  ///< generated password; empty if the user has chosen a password
  };
  static Entered asEntered(const SignedIn& session) { return {session}; }
  using Entering = std::function<Result<Entered>(const CurriculumStore&)>;
  std::filesystem::path keptFile() const;
  static std::string notOpenMessage();
  static std::string otherUserMessage();
  Result<void> reachStore();
  void checkConnection();
  void look();
  void post(std::function<void()> work);
  void deliver(std::function<void()> news);
  void open(Entering enter, Done done);
  void changePasswordAtSite(const std::string& old, const std::string& password, Done done);
  void take(State state, std::optional<Entered> entered, const QString& error);

  std::string generatedPassword_;  ///< generated password of the signed-in user; empty if the user has chosen one
  const QString address_;
  const StoreServices services_;
  State state_ = State::Opening;
  std::optional<SignedIn> session_;
  Person person_;
  QString error_;
  /// increased at each change of state or user; answers to queries of an earlier user are discarded
  int number_ = 0;
  bool away_ = false, looking_ = false, isReadOnly_ = false;
  QTimer again_;
  std::optional<CurriculumStore> store_;  ///< used on the store's thread only
  QThread thread_;
  QObject worker_;  ///< object on the store's thread
};

}  // namespace insonate::ui
