#pragma once

#include "../model/HapticControl.h"

#include <QWidget>
#include <array>

class QAction;
class QLabel;
class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class NumberField;
class DisclosureModel;
class HapticControl;
class NeedleMotion;
class ProbeMotion;
class StatusLine;

/// The panel's section about the needle: a button that takes the needle or puts it away, numbers that the user can
/// edit, and contacts with tissue.
class NeedleControls final : public QWidget {
  Q_OBJECT

 public:
  NeedleControls(StatusLine& status, DisclosureModel& disclosure, HapticControl& hands, ProbeMotion& motion,
                 NeedleMotion& needle, const ui::Commands& commands, QWidget* parent = nullptr);

  /// Sets the action of the button beside the heading.
  void setShowDevices(QAction& action);

 private:
  QWidget* buildNumbers(const ui::Commands& commands);
  void refresh();
  QString wordsNow(const NeedleShown& needle) const;

  StatusLine& status_;
  DisclosureModel& disclosure_;
  HapticControl& hands_;
  ProbeMotion& motion_;
  NeedleMotion& needle_;
  QPushButton* devices_;
  QWidget* numbers_ = nullptr;
  std::array<NumberField*, 4> fields_{};
  QLabel* words_ = nullptr;
};

}  // namespace insonate::train
