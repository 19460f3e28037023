#pragma once

#include "../model/HapticControl.h"

#include <QHash>
#include <QWidget>
#include <filesystem>

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

  HapticControl& hands_;
  QTableWidget* table_ = nullptr;
  QLabel* none_ = nullptr;  ///< text shown while the table is empty
  QComboBox* pedal_ = nullptr;
  QListWidget* events_ = nullptr;
  QPushButton* record_ = nullptr;
  int made_ = 0;  ///< number of simulated and replayed devices so far, used in their names
};

}  // namespace insonate::train
