#include "StoreWatch.h"

#include <insonate/ui/Account.h>

#include <QWidget>
#include <chrono>

namespace insonate::review {
namespace {

using namespace std::chrono_literals;
using People = std::set<std::string>;

constexpr auto kPause = 3s;

}  // namespace

StoreWatch::StoreWatch(ui::Account& account, QWidget& pages)
    : QObject(&pages), account_(account), pages_(pages), changes_(std::make_shared<std::optional<StoreChanges>>()) {
  connect(&timer_, &QTimer::timeout, this, &StoreWatch::look);
  // The new user's pages are read when the user signs in.
  connect(&account, &ui::Account::changed, this, [this] {
    changes_ = std::make_shared<std::optional<StoreChanges>>();
    hasBegun_ = false, ++user_;
    look();
  });
  timer_.start(kPause);
  look();
}

void StoreWatch::look() {
  if (asking_ || !account_.isSignedIn() || account_.mustChangePassword()) return;
  if (hasBegun_ && !pages_.isVisible()) return;
  asking_ = true;
  account_.query<People>(
      this,
      [changes = changes_](const SignedIn& by) {
        if (!*changes) changes->emplace(by);
        return (*changes)->readChanges();
      },
      // A server that cannot be reached is the account's concern.
      [this, user = user_](const Result<People>& people) {
        asking_ = false;
        hasBegun_ |= people.has_value() && user == user_;
        if (people && !people->empty()) Q_EMIT changed(*people);
      });
}

}  // namespace insonate::review
