#pragma once

#include <insonate/curriculum/SiteUpload.h>

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace insonate::ui {

class Account;

/// Synchronizes this computer's store with its site's server while the window is open: some seconds after a user signs
/// in or out, and every five minutes. Works in the background; no effect without a server or a store. Unsent facts wait
/// for the next exchange. For the window's thread.
class SiteExchange : public QObject {
  Q_OBJECT

 public:
  explicit SiteExchange(Account& account, QObject* parent = nullptr);

  /// Address of the server as in CurriculumStore, stored in the user's settings; empty: no server. The server's
  /// password is in ~/.pgpass or PGPASSWORD.
  QString server() const;
  void setServer(const QString& address);

  void now();
  bool isRunning() const { return running_.isRunning(); }
  /// Sentence about the outcome of the last exchange; empty before the first.
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
