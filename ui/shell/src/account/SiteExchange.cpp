#include <insonate/ui/Account.h>
#include <insonate/ui/SiteExchange.h>

#include <QSettings>
#include <QStringList>
#include <QtConcurrent/QtConcurrentRun>
#include <chrono>

namespace insonate::ui {
namespace {

using namespace std::chrono_literals;

const QString kServer = QStringLiteral("account/server");
constexpr std::chrono::milliseconds kSoon = 3s, kOften = 5min;

Result<UploadReport> sendReport(const QString& here, const QString& server, const StoreServices& services) {
  const auto mine = CurriculumStore::open(here.toStdString(), services);
  if (!mine) return tl::unexpected(mine.error());
  const auto theirs = CurriculumStore::open(server.toStdString(), services);
  if (!theirs) return tl::unexpected(theirs.error());
  return SiteUpload(*mine, *theirs).exchange();
}

/// Exchanges facts with the server; returns the outcome as a sentence.
QString exchange(const QString& here, const QString& server, const StoreServices& services) {
  const auto done = sendReport(here, server, services);
  if (!done)
    return SiteExchange::tr("The server was not reached; attempts wait here. %1")
        .arg(QString::fromStdString(done.error().message));
  QStringList sentences{
      SiteExchange::tr("Sent to the server: %1 attempts, %2 completed forms.").arg(done->attempts).arg(done->forms)};
  for (const std::string& trouble : done->troubles) sentences << QString::fromStdString(trouble);
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
  return QSettings().value(kServer).toString();
}

void SiteExchange::setServer(const QString& address) {
  QSettings().setValue(kServer, address.trimmed());
  outcome_.clear();
  now();
}

void SiteExchange::now() {
  timer_.start(kOften);
  using State = Account::State;
  const bool open = account_.state() == State::Guest || account_.isSignedIn();
  if (isRunning() || server().isEmpty() || !open) return;
  running_.setFuture(QtConcurrent::run(exchange, account_.address(), server(), account_.services()));
}

}  // namespace insonate::ui
