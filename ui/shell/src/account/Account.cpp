#include "KeptSignIn.h"

#include <insonate/curriculum/FirstPassword.h>
#include <insonate/curriculum/OwnTraining.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Attempts.h>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUrl>

namespace insonate::ui {

QString usualStore() {
  const QString named = qEnvironmentVariable("INSONATE_DATABASE");
  if (!named.isEmpty()) return named;
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/curriculum.sqlite");
}

namespace {

constexpr int kAgain_ms = 5000;

bool isServer(const QString& address) {
  return address.startsWith(QLatin1String("postgresql://"));
}

/// A server keeps no recordings; this workstation keeps them.
StoreServices withRecordings(StoreServices services, const QString& address) {
  if (isServer(address) && services.recordings.empty()) services.recordings = serverRecordingsFolder().toStdString();
  return services;
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
  return isServer(address_) ? QUrl(address_).toString(QUrl::RemovePassword) : QDir::toNativeSeparators(address_);
}

std::string Account::notOpen() {
  return tr("The store of people and attempts is not open.").toStdString();
}

std::string Account::notYours() {
  return tr("Another user has signed in meanwhile.").toStdString();
}

void Account::post(std::function<void()> work) {
  QMetaObject::invokeMethod(&worker_, std::move(work), Qt::QueuedConnection);
}

void Account::deliver(std::function<void()> news) {
  QMetaObject::invokeMethod(this, std::move(news), Qt::QueuedConnection);
}

void Account::reopen() {
  if (!isServer(address_) && !QFileInfo::exists(address_)) return take(State::NobodyYet, std::nullopt, {});
  take(State::Opening, std::nullopt, {});
  const KeptSignIn kept = readKeptSignIn(keptFile());
  generatedPassword_ = kept.password;
  open(
      [file = keptFile(), token = kept.token](const CurriculumStore& store) -> Result<SignedIn> {
        if (token.empty()) return store.guest();
        if (auto session = store.signInByToken(token)) return session;
        removeKeptSignIn(file);
        return store.guest();
      },
      {});
}

/// Empty if nobody is kept signed in at this store: on a server, the token would open it from any computer.
std::filesystem::path Account::keptFile() const {
  return isServer(address_) ? std::filesystem::path() : std::filesystem::path((address_ + ".signed-in").toStdString());
}

void Account::setUp(const NewPerson& administrator, const QString& password, Done done) {
  if (!isServer(address_)) QDir().mkpath(QFileInfo(address_).absolutePath());
  open([administrator, password = password.toStdString()](
           const CurriculumStore& store) { return store.createFirstAdministrator(administrator, password); },
       std::move(done));
}

void Account::setUpAlone(const QString& fullName, const QString& password, Done done) {
  if (!isServer(address_)) QDir().mkpath(QFileInfo(address_).absolutePath());
  const bool isGenerated = password.isEmpty();
  const std::string chosen = isGenerated ? firstPassword() : password.toStdString();
  open(
      [file = keptFile(), chosen, isGenerated,
       name = fullName.trimmed().toStdString()](const CurriculumStore& store) -> Result<SignedIn> {
        auto me = setUpOwnTraining(store, name, chosen);
        if (!me) return me;
        if (auto kept = keepSignedIn(file, *me, isGenerated ? chosen : std::string()); !kept)
          return tl::unexpected(kept.error());
        return me;
      },
      [this, chosen, isGenerated, done = std::move(done)](const Result<void>& result) {
        if (result && isGenerated) generatedPassword_ = chosen;
        done(result);
        if (result) Q_EMIT changed();
      });
}

void Account::signIn(const QString& name, const QString& password, Done done) {
  open([name = name.toStdString(),
        password = password.toStdString()](const CurriculumStore& store) { return store.signIn(name, password); },
       std::move(done));
}

void Account::signOut() {
  if (!isSignedIn() || hasGeneratedPassword()) return;
  if (!keptFile().empty() && removeKeptSignIn(keptFile()))
    ask<void>(this, [](const SignedIn& by) { return PeopleStore(by).revokeTokens(); }, {});
  reopen();
}

void Account::changePassword(const QString& old, const QString& password, Done done) {
  const std::string known = hasGeneratedPassword() ? generatedPassword_ : old.toStdString();
  ask<void>(
      this,
      [known, password = password.toStdString(), file = keptFile()](const SignedIn& by) -> Result<void> {
        if (auto changed = PeopleStore(by).changeOwnPassword(known, password); !changed) return changed;
        // The former token ended with the former password.
        return removeKeptSignIn(file) ? keepSignedIn(file, by, {}) : Result<void>();
      },
      [this, done = std::move(done)](const Result<void>& result) {
        if (result) generatedPassword_.clear();
        done(result);
        if (result) Q_EMIT changed();
      });
}

void Account::changeDetails(const QString& fullName, const QString& email, Done done) {
  ask<Person>(
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
  auto opened = CurriculumStore::open(address_.toStdString(), services_);
  if (!opened) return tl::unexpected(opened.error());
  store_ = std::move(*opened);
  return {};
}

/// A query failed: the store refused it or did not answer.
void Account::checkConnection() {
  if (isServer(address_) && session_ && !away_) look();
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
      if (wasAway) Q_EMIT cameBack();
    });
  });
}

void Account::open(Entering enter, Done done) {
  post([this, enter = std::move(enter), done = std::move(done)] {
    struct Outcome {
      std::optional<SignedIn> session;
      bool anybody = true;
      std::string trouble, refusal;
    };
    auto outcome = std::make_shared<Outcome>();
    if (const auto reached = reachStore(); !reached) {
      outcome->trouble = reached.error().message;
    } else {
      auto entered = enter(*store_);
      const auto anybody = store_->hasPeople();
      if (!anybody) outcome->trouble = anybody.error().message;
      outcome->anybody = anybody.value_or(true);
      entered ? void(outcome->session = std::move(*entered)) : void(outcome->refusal = entered.error().message);
    }
    deliver([this, outcome, done] {
      const QString trouble = QString::fromStdString(outcome->trouble);
      away_ = isServer(address_) && !trouble.isEmpty();
      if (away_) again_.start();
      if (!done && isSignedIn()) return;  // only while the store was being opened for a guest
      if (!trouble.isEmpty())
        take(State::Unreachable, std::nullopt, trouble);
      else if (!outcome->anybody)
        take(State::NobodyYet, std::nullopt, {});
      else if (outcome->session)
        take(outcome->session->isGuest() ? State::Guest : State::SignedIn, outcome->session, {});
      if (!done) return;
      const std::string& why = trouble.isEmpty() ? outcome->refusal : outcome->trouble;
      done(why.empty() ? Result<void>() : fail(why));
    });
  });
}

void Account::take(State state, std::optional<SignedIn> session, const QString& trouble) {
  state_ = state, session_ = std::move(session), trouble_ = trouble;
  person_ = session_ ? session_->person() : Person();
  ++number_;
  Q_EMIT changed();
}

}  // namespace insonate::ui
