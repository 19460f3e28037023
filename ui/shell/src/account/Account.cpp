#include "KeptSignIn.h"
#include "SiteSettings.h"

#include <insonate/curriculum/FirstPassword.h>
#include <insonate/curriculum/OwnTraining.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/StoreAddress.h>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUrl>
#include <tuple>

namespace insonate::ui {

QString defaultStoreAddress() {
  QString named = qEnvironmentVariable("INSONATE_DATABASE");
  if (!named.isEmpty()) return named;
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/curriculum.sqlite");
}

namespace {

constexpr int kAgain_ms = 5000;

/// A server keeps no recordings; this workstation keeps them.
StoreServices withRecordings(StoreServices services, const QString& address) {
  if (isPostgresAddress(address) && services.recordings.empty())
    services.recordings = serverRecordingsFolder().toStdString();
  return services;
}

/// Signs in with what is kept on this computer, else as a guest. What is kept stays even so: the store may only be
/// busy, and a generated password is written nowhere else.
Result<SignedIn> signInAsKept(const CurriculumStore& store, const KeptSignIn& kept) {
  if (!kept.token.empty())
    if (auto session = store.signInByToken(kept.token)) return session;
  if (!kept.generatedPassword.empty())
    if (auto session = store.signIn(kept.name, kept.generatedPassword)) return session;
  return store.guest();
}

/// The generated password is written first, since nobody knows it.
Result<SignedIn> setUpKept(const CurriculumStore& store, const std::filesystem::path& file, const std::string& fullName,
                           const std::string& password) {
  if (file.empty())
    return fail(Account::tr("The database is on a server, so you need a password; enter one.").toStdString());
  const auto anybody = store.hasPeople();
  if (!anybody) return tl::unexpected(anybody.error());
  if (!*anybody) {
    const KeptSignIn kept{.name = signInNameOf(fullName), .generatedPassword = password};
    if (auto written = writeKeptSignIn(file, kept); !written) return tl::unexpected(written.error());
  }
  auto me = setUpOwnTraining(store, fullName, password);
  if (!me && !store.hasPeople().value_or(true)) removeKeptSignIn(file);
  return me;
}

}  // namespace

Account::Account(QString address, StoreServices services, QObject* parent)
    : QObject(parent), address_(std::move(address)), services_(withRecordings(std::move(services), address_)) {
  again_.setInterval(kAgain_ms);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, &Account::look);
  thread_.setObjectName(QStringLiteral("account"));
  worker_.moveToThread(&thread_);
  thread_.start(QThread::LowPriority);
  reopen();
}

Account::~Account() {
  session_.reset();
  post([this] {
    store_.reset();
    thread_.quit();
  });
  thread_.wait();
}

QString Account::place() const {
  return isPostgresAddress(address_) ? QUrl(address_).toString(QUrl::RemovePassword)
                                     : QDir::toNativeSeparators(address_);
}

std::string Account::notOpenMessage() {
  return tr("The database of people and attempts is not open.").toStdString();
}

std::string Account::otherUserMessage() {
  return tr("Another user has signed in meanwhile.").toStdString();
}

void Account::post(std::function<void()> work) {
  QMetaObject::invokeMethod(&worker_, std::move(work), Qt::QueuedConnection);
}

void Account::deliver(std::function<void()> news) {
  QMetaObject::invokeMethod(this, std::move(news), Qt::QueuedConnection);
}

void Account::reopen() {
  if (!isPostgresAddress(address_) && !QFileInfo::exists(address_)) return take(State::NoUsers, std::nullopt, {});
  take(State::Opening, std::nullopt, {});
  open(
      [file = keptFile()](const CurriculumStore& store) -> Result<Entered> {
        const KeptSignIn kept = readKeptSignIn(file);
        auto session = signInAsKept(store, kept);
        if (!session) return tl::unexpected(session.error());
        return Entered{*session, session->isGuest() ? std::string() : kept.generatedPassword};
      },
      {});
}

/// Empty on a server, where no sign-in is kept: its token would open the server from any computer.
std::filesystem::path Account::keptFile() const {
  return isPostgresAddress(address_) ? std::filesystem::path()
                                     : std::filesystem::path((address_ + ".signed-in").toStdString());
}

void Account::setUp(const NewPerson& administrator, const QString& password, Done done) {
  if (!isPostgresAddress(address_)) QDir().mkpath(QFileInfo(address_).absolutePath());
  open(
      [administrator, password = password.toStdString()](const CurriculumStore& store) {
        return store.createFirstAdministrator(administrator, password).map(asEntered);
      },
      std::move(done));
}

void Account::setUpAlone(const QString& fullName, const QString& password, Done done) {
  if (!isPostgresAddress(address_)) QDir().mkpath(QFileInfo(address_).absolutePath());
  open(
      [file = keptFile(), name = fullName.trimmed().toStdString(),
       chosen = password.toStdString()](const CurriculumStore& store) -> Result<Entered> {
        const std::string generated = chosen.empty() ? generateFirstPassword() : std::string();
        auto me = chosen.empty() ? setUpKept(store, file, name, generated) : setUpOwnTraining(store, name, chosen);
        if (!me) return tl::unexpected(me.error());
        // If the token cannot be kept, the next start asks for the password.
        if (!chosen.empty() && !file.empty()) std::ignore = keepSignedIn(file, *me);
        return Entered{*me, generated};
      },
      std::move(done));
}

void Account::signIn(const QString& name, const QString& password, Done done) {
  if (!isPostgresAddress(address_)) QDir().mkpath(QFileInfo(address_).absolutePath());
  open(
      [database = address_, name = name.toStdString(),
       password = password.toStdString()](const CurriculumStore& store) -> Result<Entered> {
        const SiteSettings settings = readSiteSettings(database);
        if (!settings.isHttp()) return store.signIn(name, password).map(asEntered);
        const auto site = siteUploadOf(store, settings, {});
        if (!site) return tl::unexpected(site.error());
        const auto reached = site->signIn(name, password);
        if (!reached) return tl::unexpected(reached.error());
        auto session = store.signIn(name, password);
        if (!session && *reached == SiteUpload::Reached::No)
          return fail(tr("The server cannot be reached. Without it, only people who have signed in on this computer "
                         "before can sign in, with the password that they had then.")
                          .toStdString());
        return session.map(asEntered);
      },
      std::move(done));
}

void Account::signOut() {
  if (!isSignedIn() || hasGeneratedPassword()) return;
  query<void>(this,
              [file = keptFile()](const SignedIn& by) -> Result<void> {
                if (readKeptSignIn(file).name != by.person().name) return {};
                removeKeptSignIn(file);
                return PeopleStore(by).revokeTokens();
              },
              {});
  reopen();
}

void Account::changePasswordAtSite(const std::string& old, const std::string& password, Done done) {
  open(
      [database = address_, file = keptFile(), name = person_.name, old,
       password](const CurriculumStore& store) -> Result<Entered> {
        const auto site = siteUploadOf(store, readSiteSettings(database), {});
        if (!site) return tl::unexpected(site.error());
        if (auto changed = site->changePassword(name, old, password); !changed) return tl::unexpected(changed.error());
        auto session = store.signIn(name, password);
        if (session && readKeptSignIn(file).name == name && !keepSignedIn(file, *session)) removeKeptSignIn(file);
        return session.map(asEntered);
      },
      std::move(done));
}

void Account::changePassword(const QString& old, const QString& password, Done done) {
  const std::string known = hasGeneratedPassword() ? generatedPassword_ : old.toStdString();
  if (readSiteSettings(address_).isHttp()) return changePasswordAtSite(known, password.toStdString(), std::move(done));
  query<void>(
      this,
      [known, password = password.toStdString(), file = keptFile()](const SignedIn& by) -> Result<void> {
        const bool isKept = readKeptSignIn(file).name == by.person().name;
        if (auto changed = PeopleStore(by).changeOwnPassword(known, password); !changed) return changed;
        // A token and a generated password end with the former password.
        if (isKept && !keepSignedIn(file, by)) removeKeptSignIn(file);
        return {};
      },
      [this, done = std::move(done)](const Result<void>& result) {
        if (result) generatedPassword_.clear();
        done(result);
        if (result) Q_EMIT changed();
      });
}

void Account::changeDetails(const QString& fullName, const QString& email, Done done) {
  query<Person>(
      this,
      [name = fullName.toStdString(), email = email.toStdString()](const SignedIn& by) -> Result<Person> {
        const PeopleStore people(by);
        if (const auto kept = people.changeOwnDetails(name, email); !kept) return tl::unexpected(kept.error());
        return people.person(by.person().id);
      },
      [this, done = std::move(done)](const Result<Person>& person) {
        done(person ? Result<void>() : fail(person.error().message));
        if (!person) return;
        person_ = *person;
        Q_EMIT changed();
      });
}

/// Runs on the account's thread.
Result<void> Account::reachStore() {
  if (store_) return {};
  StoreServices services = services_;
  services.opensReadOnly = true;
  auto opened = CurriculumStore::open(address_.toStdString(), services);
  if (!opened) return tl::unexpected(opened.error());
  store_ = std::move(*opened);
  return {};
}

/// A query failed: the store refused it or did not answer.
void Account::checkConnection() {
  if (isPostgresAddress(address_) && session_ && !away_) look();
}

void Account::look() {
  if (std::exchange(looking_, true)) return;
  post([this] {
    const bool isThere = reachStore() && store_->hasPeople();
    deliver([this, isThere] {
      looking_ = false;
      const bool wasAway = std::exchange(away_, !isThere);
      if (!isThere) return again_.start();
      if (state_ == State::Unreachable) return reopen();
      if (wasAway) Q_EMIT reconnected();
    });
  });
}

void Account::open(Entering enter, Done done) {
  post([this, enter = std::move(enter), done = std::move(done)] {
    struct Outcome {
      std::optional<Entered> entered;
      bool anybody = true, isReadOnly = false;
      std::string error, refusal;
    };
    auto outcome = std::make_shared<Outcome>();
    if (const auto reached = reachStore(); !reached) {
      outcome->error = reached.error().message;
    } else {
      auto entered = enter(*store_);
      const auto anybody = store_->hasPeople();
      if (!anybody) outcome->error = anybody.error().message;
      outcome->anybody = anybody.value_or(true);
      outcome->isReadOnly = store_->isReadOnly();
      entered ? void(outcome->entered = std::move(*entered)) : void(outcome->refusal = entered.error().message);
    }
    deliver([this, outcome, done] {
      const QString error = QString::fromStdString(outcome->error);
      away_ = isPostgresAddress(address_) && !error.isEmpty();
      isReadOnly_ = outcome->isReadOnly;
      if (away_) again_.start();
      if (!done && isSignedIn()) return;  // only while the store was being opened for a guest
      if (!error.isEmpty())
        take(State::Unreachable, std::nullopt, error);
      else if (!outcome->anybody)
        take(State::NoUsers, std::nullopt, {});
      else if (outcome->entered)
        take(outcome->entered->session.isGuest() ? State::Guest : State::SignedIn, outcome->entered, {});
      else if (state_ == State::NoUsers)
        reopen();  // somebody was set up after all
      if (!done) return;
      const std::string& why = error.isEmpty() ? outcome->refusal : outcome->error;
      done(why.empty() ? Result<void>() : fail(why));
    });
  });
}

void Account::take(State state, std::optional<Entered> entered, const QString& error) {
  state_ = state, error_ = error;
  session_ = entered ? std::optional(entered->session) : std::nullopt;
  generatedPassword_ = entered ? entered->generatedPassword : std::string();
  person_ = session_ ? session_->person() : Person();
  ++number_;
  Q_EMIT changed();
}

}  // namespace insonate::ui
