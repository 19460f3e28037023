#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {

class Account;

/// Synchronizes this computer's store with its site's server while the window is open: some seconds after a user signs
/// in or out, and every five minutes. The exchange runs in the background. Without a server or a store, nothing is
/// done. Data that could not be sent wait for the next exchange. After an exchange, the published cases that the
/// classes of this computer need are downloaded in the background (downloadFolder()). May be used only on the window's
/// thread.
class SiteExchange : public QObject {
  Q_OBJECT

 public:
  explicit SiteExchange(Account& account, QObject* parent = nullptr);
  /// Stops a download of cases without waiting; a later exchange continues the download.
  ~SiteExchange() override;

  /// Returns the address of the server: https://HOST of insonate-server, or a database file; empty: no server.
  QString server() const;
  /// Returns the file with the certificate of the authority that signed the server's certificate; empty: the
  /// authorities that the system trusts are used.
  QString authorityFile() const;
  /// Joins a server and starts an exchange. `token`: this computer's token for insonate-server; if empty, the former
  /// token stays. Fails, with nothing changed, if the address or the token is invalid, if the address is that of a
  /// PostgreSQL database (refusalOfStore()) or contains a password, or if the token cannot be stored.
  Result<void> setServer(const QString& address, const QString& token = {}, const QString& authorityFile = {});

  /// Starts an exchange at once, or as soon as the present one has ended.
  void exchangeNow();
  bool isRunning() const { return running_.isRunning(); }
  /// Returns sentences about the outcome of the last exchange and the download after it; empty before the first
  /// exchange.
  QString outcome() const { return outcome_; }

 Q_SIGNALS:
  void exchanged();  ///< emitted when outcome() has changed

 private:
  struct Exchanged {
    QString outcome{};
    /// Names of the cases that the classes of this computer need; empty if the exchange failed or they are unknown.
    /// Then the downloaded cases stay as they are.
    std::optional<std::vector<std::string>> cases{};
  };
  static Exchanged exchange(const QString& database, const StoreServices& services);
  void download(std::vector<std::string> cases);
  void takeDownload(const QString& outcome, bool isNew);

  Account& account_;
  QTimer timer_;
  QFutureWatcher<Exchanged> running_;
  bool isRequested_ = false;  ///< true: another exchange follows the present one
  bool isDownloading_ = false;
  std::optional<std::vector<std::string>> nextCases_{};  ///< cases of the download that follows the present one
  std::shared_ptr<std::atomic<bool>> isStopped_ = std::make_shared<std::atomic<bool>>(false);
  QString outcome_;
};

}  // namespace insonate::ui
