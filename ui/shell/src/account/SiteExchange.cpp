#include "../live/JobThreads.h"
#include "SiteSettings.h"

#include <insonate/cases/Phantom.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/site/HttpLink.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/SiteExchange.h>
#include <insonate/ui/StoreAddress.h>
#include <insonate/ui/Text.h>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QStringList>
#include <QUrl>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <chrono>
#include <exception>
#include <string_view>
#include <utility>

namespace insonate::ui {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kSoon = 3s, kOften = 5min;

QString sentencesOf(const UploadReport& report) {
  QStringList sentences{
      SiteExchange::tr("Sent to the server: %1 attempts, %2 completed forms.").arg(report.attempts).arg(report.forms)};
  for (const std::string& trouble : report.errors) sentences << QString::fromStdString(trouble);
  return sentences.join(QLatin1Char(' '));
}

/// Outcome of a download of cases.
struct Downloaded {
  QString outcome{};   ///< sentences; empty if everything was there already
  bool isNew = false;  ///< true: a case has arrived
};

Downloaded downloadFrom(const SiteSettings& settings, const std::vector<std::string>& cases,
                        const std::shared_ptr<std::atomic<bool>>& isStopped) {
  const auto failed = [](const std::string& why) {
    return Downloaded{SiteExchange::tr("Cases could not be downloaded from the server. %1").arg(qt(why))};
  };
  const auto link = siteLinkOf(settings);
  if (!link) return failed(link.error().message);
  const auto done = downloadCases(*link, cases, downloadFolder().toStdString(),
                                  [isStopped](std::string_view, double) { return !*isStopped; });
  if (!done) return failed(done.error().message);
  QStringList sentences;
  for (const std::string& title : done->titles)
    sentences << SiteExchange::tr("Downloaded from the server: case '%1'.").arg(qt(title));
  for (const std::string& trouble : done->errors) sentences << qt(trouble);
  return {sentences.join(QLatin1Char(' ')), !done->titles.empty()};
}

}  // namespace

SiteExchange::Exchanged SiteExchange::exchange(const QString& database, const StoreServices& services) {
  const auto failed = [](const Error& error) {
    return Exchanged{.outcome = tr("The exchange with the server failed. Attempts are kept on this computer and sent "
                                   "later. %1")
                                    .arg(QString::fromStdString(error.message))};
  };
  QDir().mkpath(QFileInfo(database).absolutePath());
  const auto here = CurriculumStore::open(database.toStdString(), services);
  if (!here) return failed(here.error());
  const auto site = siteUploadOf(*here, readSiteSettings(database), services);
  if (!site) return failed(site.error());
  const auto report = site->exchange();
  if (!report) return failed(report.error());
  const auto cases = site->caseNames();
  return {sentencesOf(*report), cases ? std::optional(*cases) : std::nullopt};
}

SiteExchange::SiteExchange(Account& account, QObject* parent) : QObject(parent), account_(account) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &SiteExchange::exchangeNow);
  connect(&running_, &QFutureWatcherBase::finished, this, [this] {
    const Exchanged done = running_.result();
    outcome_ = done.outcome;
    Q_EMIT exchanged();
    if (done.cases) download(*done.cases);
    if (std::exchange(isRequested_, false)) exchangeNow();
  });
  connect(&account_, &Account::changed, this, [this] { timer_.start(kSoon); });
  timer_.start(kSoon);
}

SiteExchange::~SiteExchange() {
  *isStopped_ = true;
}

/// A thread of its own, since a download takes minutes, and the threads of the pool have other work. Without cases, the
/// list of downloaded cases is emptied.
void SiteExchange::download(std::vector<std::string> cases) {
  const SiteSettings settings = readSiteSettings(account_.address());
  std::erase_if(cases, [](const std::string& name) { return phantomVariant(name) != nullptr; });
  if (!settings.isHttp()) return;
  // The present download may have begun before a class of this computer changed.
  if (isDownloading_) {
    nextCases_ = std::move(cases);
    return;
  }
  isDownloading_ = true;
  runInBackground([self = QPointer<SiteExchange>(this), settings, cases, isStopped = isStopped_] {
    Downloaded done;
    try {
      done = downloadFrom(settings, cases, isStopped);
    } catch (const std::exception& error) {
      done.outcome = tr("Cases could not be downloaded from the server. %1").arg(QString::fromUtf8(error.what()));
    }
    if (*isStopped) return;
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [self, done] {
          if (self) self->takeDownload(done.outcome, done.isNew);
        },
        Qt::QueuedConnection);
  });
}

void SiteExchange::takeDownload(const QString& outcome, bool isNew) {
  isDownloading_ = false;
  if (isNew) Q_EMIT account_.casesDownloaded();
  if (!outcome.isEmpty()) {
    outcome_ += QLatin1Char(' ') + outcome;
    Q_EMIT exchanged();
  }
  if (auto next = std::exchange(nextCases_, std::nullopt)) download(std::move(*next));
}

QString SiteExchange::server() const {
  return readSiteSettings(account_.address()).address;
}

QString SiteExchange::authorityFile() const {
  return readSiteSettings(account_.address()).authorityFile;
}

Result<void> SiteExchange::setServer(const QString& address, const QString& token, const QString& authorityFile) {
  if (const QString refused = refusalOfStore(address.trimmed()); !refused.isEmpty()) return fail(refused.toStdString());
  // Others can read the field of the address, and no server needs a password in it.
  if (!QUrl(address.trimmed()).password().isEmpty())
    return fail(
        tr("Remove the password from the address. The server needs only the token of this computer.").toStdString());
  SiteSettings settings{
      .address = address.trimmed(), .token = token.trimmed().toStdString(), .authorityFile = authorityFile.trimmed()};
  // The token is not shown again; an empty field keeps it.
  const SiteSettings before = readSiteSettings(account_.address());
  if (settings.token.empty() && settings.address == before.address) settings.token = before.token;
  if (settings.isHttp())
    if (const auto link = httpLink({.url = settings.address.toStdString(), .token = settings.token}); !link)
      return tl::unexpected(link.error());
  if (auto written = writeSiteSettings(account_.address(), settings); !written) return written;
  outcome_.clear();
  Q_EMIT exchanged();
  exchangeNow();
  return {};
}

void SiteExchange::exchangeNow() {
  timer_.start(kOften);
  using State = Account::State;
  const bool open = account_.state() != State::Opening && account_.state() != State::Unreachable;
  if (server().isEmpty() || !open) return;
  // The present exchange may have begun before the change for which this one is requested.
  if (isRunning()) {
    isRequested_ = true;
    return;
  }
  running_.setFuture(QtConcurrent::run(&SiteExchange::exchange, account_.address(), account_.services()));
}

}  // namespace insonate::ui
