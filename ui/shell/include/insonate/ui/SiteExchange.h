#pragma once

#include <insonate/curriculum/SiteUpload.h>

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace insonate::ui {

class Account;

/// Exchanges facts between this computer's store and its site's server while the window is open: some seconds after a
/// user signs in or out, and every five minutes. Off the window's thread; no effect without a server or a store.
/// Unsent facts wait. For the window's thread.
class SiteExchange : public QObject {
  Q_OBJECT

 public:
  explicit SiteExchange(Account& account, QObject* parent = nullptr);

  /// Address of the server as in CurriculumStore, stored in the user's settings; empty: none. Its password is in
  /// ~/.pgpass or PGPASSWORD.
  QString server() const;
  void setServer(const QString& address);

  void now();
  bool isRunning() const { return running_.isRunning(); }
  /// Outcome of the last exchange, a sentence; empty before the first.
  QString outcome() const { return outcome_; }

 Q_SIGNALS:
  void exchanged();  ///< outcome() is new

 private:
  Account& account_;
  QTimer timer_;
  QFutureWatcher<QString> running_;
  QString outcome_;
};

}  // namespace insonate::ui
