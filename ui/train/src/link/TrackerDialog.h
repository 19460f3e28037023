#pragma once

#include <QDialog>
#include <QTimer>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace insonate::train {

class TrackerList;

/// Window in which the user adds the tools of tracking programs and calibrates them.
class TrackerDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit TrackerDialog(TrackerList& trackers, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildFields();
  QWidget* buildButtons();
  void add();
  void calibrateTip();
  void setDesk();
  void refresh();
  void enableButtons();
  int selected() const;

  TrackerList& trackers_;
  QLineEdit *host_ = nullptr, *tool_ = nullptr;
  QSpinBox* port_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton *tip_ = nullptr, *desk_ = nullptr, *remove_ = nullptr;
  QLabel* said_ = nullptr;
  QTimer timer_;
};

}  // namespace insonate::train
