#pragma once

#include "../model/HapticControl.h"

#include <QElapsedTimer>
#include <QHash>
#include <QWidget>
#include <filesystem>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace insonate::train {

/// Lists real and simulated devices with their state, the pedal, and recent events.
class DeviceList final : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceList(HapticControl& hands, QWidget* parent = nullptr);

  void refresh(const QHash<QString, double>& rates_Hz);
  /// Adds a row with these buttons.
  void addButtons(const std::vector<QWidget*>& buttons);
  /// Begins to record all devices' reports to a file; an empty path ends the recording. Returns false if the file
  /// cannot be written.
  bool record(const std::filesystem::path& file);
  /// Adds a recording as a device; shows errors in the file.
  void replay(const std::filesystem::path& file);

 private:
  QWidget* buildButtons();
  void addSimulated(int profile);
  void tell(const QString& sentence, bool error);
  void refreshPedals();
  /// Contents of one row: a device, or mouse and keys.
  struct Row {
    QString id;  ///< DeviceInfo::id; empty: mouse and keys
    QStringList cells;
    QString tip;
    bool hasProblem = false;
  };
  Row mouseRow(const QHash<QString, double>& rates_Hz) const;
  Row rowOf(const HapticDevice& device, double rate_Hz) const;
  QString toolsOf(const QString& id) const;
  void show(int at, const Row& row);
  void beginTest(const QString& id);
  void goOnTesting();
  quint64 reportsOf(const QString& id) const;

  HapticControl& hands_;
  QTableWidget* table_ = nullptr;
  QLabel* none_ = nullptr;  ///< text shown while the table is empty
  QComboBox* pedal_ = nullptr;
  QListWidget* events_ = nullptr;
  QPushButton* record_ = nullptr;
  /// A test in progress: the user moves the hand for some seconds.
  struct Test {
    QString id, name;
    quint64 reports = 0;  ///< number of states at the beginning
    QElapsedTimer since;
    std::optional<Vec3> least_mm, most_mm;  ///< bounds of the tool's path; empty: no pose
  };
  std::optional<Test> test_;
  int made_ = 0;  ///< number of simulated and replayed devices so far, used in their names
};

}  // namespace insonate::train
