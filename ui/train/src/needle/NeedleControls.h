#pragma once

#include "../model/HandsControl.h"

#include <QWidget>
#include <array>

class QLabel;
class QPushButton;

namespace insonate::train {

class NumberField;
class DisclosureModel;
class HandsControl;
class NeedleMotion;
class ProbeMotion;
class StatusLine;

/// The panel's section about the needle: a button that takes it up or puts it away, its editable numbers, and its
/// contacts.
class NeedleControls final : public QWidget {
  Q_OBJECT

 public:
  NeedleControls(StatusLine& status, DisclosureModel& disclosure, HandsControl& hands, ProbeMotion& motion,
                 NeedleMotion& needle, QWidget* parent = nullptr);

 Q_SIGNALS:
  void devicesWanted();

 private:
  QWidget* buildNumbers();
  void refresh();
  QString wordsNow(const NeedleShown& needle) const;

  StatusLine& status_;
  DisclosureModel& disclosure_;
  HandsControl& hands_;
  ProbeMotion& motion_;
  NeedleMotion& needle_;
  QPushButton *along_ = nullptr, *across_ = nullptr;
  QWidget* numbers_ = nullptr;
  std::array<NumberField*, 4> fields_{};
  QLabel* words_ = nullptr;
};

}  // namespace insonate::train
