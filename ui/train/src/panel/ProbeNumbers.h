#pragma once

#include "../hand/ProbeControl.h"

#include <QWidget>
#include <array>
#include <functional>

class QDoubleSpinBox;
class QLabel;

namespace insonate::train {

/// Where the probe is, in numbers that can be typed over: rotation, tilt, rock, pressure; and the place on the skin.
class ProbeNumbers : public QWidget {
 public:
  explicit ProbeNumbers(QWidget* parent = nullptr);

  void show(const HandNumbers& numbers);
  /// Called for numbers that a user types or steps.
  void setTyped(std::function<void(HandAxis axis, double value)> listener) { typed_ = std::move(listener); }

 private:
  struct Field {
    HandAxis axis;
    QDoubleSpinBox* box;
  };
  std::array<Field, 4> fields_{};
  QLabel* place_;
  std::function<void(HandAxis, double)> typed_;
};

}  // namespace insonate::train
