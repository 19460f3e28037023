#pragma once

#include <insonate/curriculum/CurriculumStore.h>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThread>
#include <QTimer>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace insonate::ui {

/// Address of this computer's store of people, unless INSONATE_DATABASE names a file or a server.
QString usualStore();

/// The user who is signed in, and the store of people, levels and attempts. Queries run one after the other on a
/// thread of their own, which has the store's connection, and are answered on the window's. For the window's thread.
class Account : public QObject {
  Q_OBJECT

 public:
  enum class State {
    Opening,
    Unreachable,  ///< trouble() says why
    NobodyYet,    ///< no store, or an empty one: the administrator is to be set up
    Guest,        ///< whoever sits there has not signed in
    SignedIn,
  };

  /// Opens the store where there is one; `address` as in CurriculumStore. A file is not made before the set-up.
  explicit Account(QString address = usualStore(), StoreServices services = {}, QObject* parent = nullptr);
  /// Waits until all that was asked is done.
  ~Account() override;

  State state() const { return state_; }
  bool isSignedIn() const { return state_ == State::SignedIn; }
  /// The user's data at sign-in; all empty for a guest.
  const Person& person() const { return person_; }
  bool mustChangePassword() const { return session_ && session_->mustChangePassword(); }
  QString trouble() const { return trouble_; }
  /// A server that did not answer when it was last asked. It is looked for each few seconds.
  bool isAway() const { return away_; }
  QString place() const;  ///< of the store, without a password
  const QString& address() const { return address_; }
  const StoreServices& services() const { return services_; }

  using Done = std::function<void(Result<void>)>;
  void setUp(const NewPerson& administrator, const QString& password, Done done);
  void signIn(const QString& name, const QString& password, Done done);
  void signOut();
  /// Changes the password of the signed-in user.
  void changePassword(const QString& old, const QString& password, Done done);
  void changeDetails(const QString& fullName, const QString& email, Done done);
  /// Tries again to open a store that could not be reached.
  void reopen();

  /// Calls `done` once, later, unless `asker` is gone by then; with an error if another user has signed in meanwhile,
  /// so that nobody sees another's answers. The effects of `question` take place in any case.
  template <class T>
  void ask(const QObject* asker, std::function<Result<T>(const SignedIn&)> question,
           std::function<void(Result<T>)> done) {
    post([this, session = session_, number = number_, asker = QPointer<const QObject>(asker),
          question = std::move(question), done = std::move(done)]() mutable {
      auto answer = std::make_shared<Result<T>>(session ? guarded<T>(question, *session) : fail(notOpen()));
      deliver([this, number, asker, answer, done = std::move(done)] {
        if (!*answer) checkConnection();
        if (!asker || !done) return;
        done(number == number_ ? std::move(*answer) : fail(notYours()));
      });
    });
  }

 Q_SIGNALS:
  void changed();        ///< state() or person()
  void peopleChanged();  ///< people, classes or what they are taught, in a window of this program
  void cameBack();       ///< a server answers again: what it was asked in vain is asked again

 private:
  template <class T>
  static Result<T> guarded(const std::function<Result<T>(const SignedIn&)>& question, const SignedIn& session) {
    try {
      return question(session);
    } catch (const std::exception& e) {
      return fail(e.what());
    }
  }
  using Entering = std::function<Result<SignedIn>(const CurriculumStore&)>;
  static std::string notOpen();
  static std::string notYours();
  Result<void> reachStore();
  void checkConnection();
  void look();
  void post(std::function<void()> work);
  void deliver(std::function<void()> news);
  void open(Entering enter, Done done);
  void take(State state, std::optional<SignedIn> session, const QString& trouble);

  const QString address_;
  const StoreServices services_;
  State state_ = State::Opening;
  std::optional<SignedIn> session_;
  Person person_;
  QString trouble_;
  int number_ = 0;  ///< of the session
  bool away_ = false, looking_ = false;
  QTimer again_;
  std::optional<CurriculumStore> store_;  ///< touched by the thread only
  QThread thread_;
  QObject worker_;  ///< lives on the thread
};

}  // namespace insonate::ui
