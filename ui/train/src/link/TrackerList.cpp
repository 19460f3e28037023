#include "TrackerList.h"

#include "../model/HapticControl.h"

#include <QSettings>
#include <QVariantList>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

QVariantList numbersOf(const Transform& transform) {
  QVariantList numbers;
  for (const Vec3& v :
       {transform.linear.column[0], transform.linear.column[1], transform.linear.column[2], transform.offset})
    numbers << v.x << v.y << v.z;
  return numbers;
}

/// The identity where the numbers are not those of a rigid transform.
Transform transformOf(const QVariantList& numbers) {
  if (numbers.size() != 12) return {};
  const auto vector = [&](int at) {
    return Vec3{numbers[at].toDouble(), numbers[at + 1].toDouble(), numbers[at + 2].toDouble()};
  };
  const Transform made{{{vector(0), vector(3), vector(6)}}, vector(9)};
  const Mat3 square = transposed(made.linear) * made.linear;
  double off = 0;
  for (int axis = 0; axis < 3; ++axis) off += norm(square.column[axis] - Mat3{}.column[axis]);
  return off < 1e-3 && determinant(made.linear) > 0 && isFinite(made.offset) ? made : Transform{};
}

}  // namespace

TrackerList::TrackerList(HapticControl& hands, QObject* parent) : QObject(parent), hands_(hands) {}

bool TrackerList::add(const QString& host, int port, const QString& tool, const TrackerCalibration& calibration) {
  const auto isSame = [&](const Entry& entry) {
    return entry.host == host && entry.port == port && entry.tool == tool;
  };
  if (std::ranges::any_of(entries_, isSame)) return false;
  auto hand = std::make_unique<TrackerHand>(host.toStdString(), port, tool.toStdString(), calibration);
  // A device stays in the hub; one that was removed from the list must not be there twice.
  if (hands_.deviceOf(QString::fromStdString(hand->device()->info().id))) return false;
  hands_.session().devices().add(hand->device());
  entries_.push_back({host, port, tool, std::move(hand)});
  hands_.checkDevices();
  Q_EMIT hands_.handsChanged();
  return true;
}

void TrackerList::remove(int index) {
  entries_.erase(entries_.begin() + index);
  hands_.checkDevices();
}

void TrackerList::save(QSettings& settings) const {
  settings.beginWriteArray("trackers", int(entries_.size()));
  for (int i = 0; i < int(entries_.size()); ++i) {
    const Entry& entry = entries_[std::size_t(i)];
    const TrackerCalibration places = entry.hand->calibration();
    settings.setArrayIndex(i);
    settings.setValue("host", entry.host);
    settings.setValue("port", entry.port);
    settings.setValue("tool", entry.tool);
    settings.setValue("deviceFromTracker", numbersOf(places.deviceFromTracker));
    settings.setValue("markerFromStylus", numbersOf(places.markerFromStylus));
  }
  settings.endArray();
}

void TrackerList::restore(QSettings& settings) {
  const int count = settings.beginReadArray("trackers");
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    add(settings.value("host").toString(), settings.value("port").toInt(), settings.value("tool").toString(),
        {transformOf(settings.value("deviceFromTracker").toList()),
         transformOf(settings.value("markerFromStylus").toList())});
  }
  settings.endArray();
}

}  // namespace insonate::train
