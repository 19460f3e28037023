#include "SiteSettings.h"

#include <insonate/site/HttpLink.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/SiteExchange.h>

#include <QDir>
#include <QFileInfo>
#include <QStringList>
#include <QtConcurrent/QtConcurrentRun>
#include <chrono>

namespace insonate::ui {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kSoon = 3s, kOften = 5min;

Result<UploadReport> sendReport(const QString& here, const StoreServices& services) {
  QDir().mkpath(QFileInfo(here).absolutePath());
  const auto mine = CurriculumStore::open(here.toStdString(), services);
  if (!mine) return tl::unexpected(mine.error());
  const auto site = siteUploadOf(*mine, readSiteSettings(here), services);
  return site ? site->exchange() : tl::unexpected(site.error());
}

/// Exchanges facts with the server; returns the outcome as a sentence.
QString exchange(const QString& here, const StoreServices& services) {
  const auto done = sendReport(here, services);
  if (!done)
    return SiteExchange::tr(
               "The exchange with the server failed. Attempts are kept on this computer and sent later. %1")
        .arg(QString::fromStdString(done.error().message));
  QStringList sentences{
      SiteExchange::tr("Sent to the server: %1 attempts, %2 completed forms.").arg(done->attempts).arg(done->forms)};
  for (const std::string& error : done->errors) sentences << QString::fromStdString(error);
  return sentences.join(QLatin1Char(' '));
}

}  // namespace

SiteExchange::SiteExchange(Account& account, QObject* parent) : QObject(parent), account_(account) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &SiteExchange::now);
  connect(&running_, &QFutureWatcherBase::finished, this, [this] {
    outcome_ = running_.result();
    Q_EMIT exchanged();
  });
  connect(&account_, &Account::changed, this, [this] { timer_.start(kSoon); });
  timer_.start(kSoon);
}

QString SiteExchange::server() const {
  return readSiteSettings(account_.address()).address;
}

QString SiteExchange::authorityFile() const {
  return readSiteSettings(account_.address()).authorityFile;
}

Result<void> SiteExchange::setServer(const QString& address, const QString& token, const QString& authorityFile) {
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
  now();
  return {};
}

void SiteExchange::now() {
  timer_.start(kOften);
  using State = Account::State;
  const bool open = account_.state() != State::Opening && account_.state() != State::Unreachable;
  if (isRunning() || server().isEmpty() || !open) return;
  running_.setFuture(QtConcurrent::run(exchange, account_.address(), account_.services()));
}

}  // namespace insonate::ui
