#pragma once

#include "../model/HandsControl.h"

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
  explicit DeviceList(HandsControl& hands, QWidget* parent = nullptr);

  void refresh(const QHash<QString, double>& rates_Hz);
  /// Records the reports of devices on the bus, until it is called with an empty path. False if the file cannot be
  /// written.
  bool record(const std::filesystem::path& file);
  /// Adds a recording as a device; reports errors in it.
  void replay(const std::filesystem::path& file);

 private:
  QWidget* buildButtons();
  void addSimulated(int profile);
  void tell(const QString& sentence, bool trouble);
  void refreshPedals();

  HandsControl& hands_;
  QTableWidget* table_ = nullptr;
  QLabel* none_ = nullptr;  ///< in the table, while it is empty
  QComboBox* pedal_ = nullptr;
  QListWidget* events_ = nullptr;
  QPushButton* record_ = nullptr;
  int made_ = 0;  ///< simulated and replayed so far, for their names
};

}  // namespace insonate::train
