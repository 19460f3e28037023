#include "LabelFollowers.h"

#include <insonate/tissue/Labels.h>

#include <utility>

namespace insonate::prepare {
namespace {

constexpr int kSoon_ms = 400, kLater_ms = 2000;

}  // namespace

LabelFollowers::LabelFollowers(LabelSession& labels, LivePatient& live, CaseMeasuring& measuring, Wishes wishes,
                               QObject* parent)
    : QObject(parent), labels_(labels), live_(live), measuring_(measuring), wishes_(std::move(wishes)) {
  soon_.setSingleShot(true), soon_.setInterval(kSoon_ms);
  later_.setSingleShot(true), later_.setInterval(kLater_ms);
  connect(&soon_, &QTimer::timeout, this, [this] { followSoon(); });
  connect(&later_, &QTimer::timeout, this, [this] {
    measuring_.setLabels(labels_.snapshot());
    Q_EMIT restChanged();
  });
  connect(&labels_, &LabelSession::changed, this, [this](const LabelChange& change) {
    changed_ |= change.labels;
    // Its snapshot is needed for the next updates.
    measuring_.awaitLabels(change.labels);
    soon_.start();
    later_.start();
    Q_EMIT restChanged();
  });
  // Another case: pending updates belong to the former one.
  connect(&labels_, &LabelSession::caseSet, this, [this] {
    changed_.reset();
    soon_.stop();
    later_.stop();
    Q_EMIT restChanged();
  });
}

void LabelFollowers::followSoon() {
  const auto labels = labels_.snapshot();
  const bool outsideMoved = changed_.test(kBackground);
  std::vector<ui::SurfaceRequest> wishes = wishes_(std::exchange(changed_, {}));
  for (ui::SurfaceRequest& wish : wishes) wish.labels = labels;
  live_.setLabels(labels, std::move(wishes), outsideMoved);
}

}  // namespace insonate::prepare
