#pragma once

#include <insonate/curriculum/SiteUpload.h>

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace insonate::ui {

class Account;

/// Synchronizes this computer's store with its site's server while the window is open: some seconds after a user signs
/// in or out, and every five minutes. The exchange runs in the background. Without a server or a store, nothing is
/// done. Data that could not be sent wait for the next exchange. For the window's thread only.
class SiteExchange : public QObject {
  Q_OBJECT

 public:
  explicit SiteExchange(Account& account, QObject* parent = nullptr);

  /// Returns the address of the server, in the form that CurriculumStore::open() takes, from the user's settings;
  /// empty: no server. The password of the server is in ~/.pgpass or PGPASSWORD.
  QString server() const;
  void setServer(const QString& address);

  /// Starts an exchange at once.
  void now();
  bool isRunning() const { return running_.isRunning(); }
  /// Returns a sentence about the outcome of the last exchange; empty before the first one.
  QString outcome() const { return outcome_; }

 Q_SIGNALS:
  void exchanged();  ///< emitted when outcome() has changed

 private:
  Account& account_;
  QTimer timer_;
  QFutureWatcher<QString> running_;
  QString outcome_;
};

}  // namespace insonate::ui
