#pragma once

#include "HandsControl.h"

#include <QWidget>
#include <array>

class QLabel;
class QPushButton;

namespace insonate::train {

class NumberField;
class TrainSession;

/// The panel's section about the needle: taking it up and putting it away, its editable numbers, and its contacts.
class NeedleControls final : public QWidget {
  Q_OBJECT

 public:
  explicit NeedleControls(TrainSession& session, QWidget* parent = nullptr);

 Q_SIGNALS:
  void devicesWanted();

 private:
  QWidget* buildNumbers();
  void refresh();
  QString wordsNow(const NeedleShown& needle) const;

  TrainSession& session_;
  QPushButton *along_ = nullptr, *across_ = nullptr;
  QWidget* numbers_ = nullptr;
  std::array<NumberField*, 4> fields_{};
  QLabel* words_ = nullptr;
};

}  // namespace insonate::train
