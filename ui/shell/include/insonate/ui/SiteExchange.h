#pragma once

#include <insonate/curriculum/SiteUpload.h>

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace insonate::ui {

class Account;

/// Brings this computer's store and its site's server together while the window is open: some seconds after somebody
/// signs in or out, and every five minutes. Off the window's thread; without a server, or without a store here, it does
/// nothing. What could not be sent waits. For the window's thread.
class SiteExchange : public QObject {
  Q_OBJECT

 public:
  explicit SiteExchange(Account& account, QObject* parent = nullptr);

  /// As in CurriculumStore, kept in the user's settings; empty: none. Its password stands in ~/.pgpass or PGPASSWORD.
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
