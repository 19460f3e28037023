#pragma once

#include <insonate/curriculum/StoreChanges.h>

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <set>
#include <string>

class QWidget;

namespace insonate::ui {
class Account;
}

namespace insonate::review {

/// Asks the store every few seconds whether its data have changed, on the account's thread, while a user is signed in
/// and the pages are visible. Changes that occur while the pages are hidden are reported when the pages are visible
/// again.
class StoreWatch final : public QObject {
  Q_OBJECT

 public:
  /// Watches for as long as `pages` exists, which becomes the parent.
  StoreWatch(ui::Account& account, QWidget& pages);

 Q_SIGNALS:
  /// Emitted when data of these people have changed (StoreChanges::readChanges()).
  void changed(const std::set<std::string>& people);

 private:
  void look();

  ui::Account& account_;
  QWidget& pages_;
  QTimer timer_;
  std::shared_ptr<std::optional<StoreChanges>> changes_;  ///< used on the account's thread only
  bool asking_ = false;
  int user_ = 0;           ///< number of the sign-in; an answer for a former user begins nothing
  bool hasBegun_ = false;  ///< true: changes since the sign-in are counted; begins even while the pages are hidden
};

}  // namespace insonate::review
