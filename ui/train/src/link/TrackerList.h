#pragma once

#include <insonate/igtlink/TrackerHand.h>

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

class QSettings;

namespace insonate::train {

class HapticControl;

/// The tools of tracking programs that the user has added. Each is a device that can move probe or needle. The list is
/// saved with the calibration of each tool.
class TrackerList : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    QString host;
    int port = 0;
    QString tool;  ///< empty: the first tool that the tracking program sends
    std::unique_ptr<TrackerHand> hand;
  };

  explicit TrackerList(HapticControl& hands, QObject* parent = nullptr);

  const std::vector<Entry>& entries() const { return entries_; }
  /// Adds a tool and begins to connect. Returns false if the list has the tool.
  bool add(const QString& host, int port, const QString& tool, const TrackerCalibration& calibration = {});
  /// Disconnects a tool and removes it from the list; its device is then absent.
  void remove(int index);

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  HapticControl& hands_;
  std::vector<Entry> entries_;
};

}  // namespace insonate::train
