#pragma once

#include "../model/ProbeControl.h"

#include <QString>
#include <QWidget>
#include <array>
#include <functional>

namespace insonate::train {

class NumberField;

/// Fields for the probe's rotation, tilt, rock and pressure, and for its position on the skin.
class ProbeNumbers : public QWidget {
 public:
  explicit ProbeNumbers(QWidget* parent = nullptr);

  void show(const HandNumbers& numbers);
  /// Sets a listener for numbers that the user types or steps.
  void setTyped(std::function<void(HandAxis axis, double value)> listener) { typed_ = std::move(listener); }
  /// Sets a listener for a position that the user types, in the patient's frame (LPS).
  void setPlaced(std::function<void(Vec3 patient_mm)> listener) { placed_ = std::move(listener); }
  /// Sets a listener for sentences about rejected input.
  void setRefused(std::function<void(const QString& sentence)> listener) { refused_ = std::move(listener); }

 private:
  struct Field {
    HandAxis axis;
    NumberField* box;
  };
  void addAngles();
  void addPlace();

  std::array<Field, 4> fields_{};
  std::array<NumberField*, 3> place_{};
  Vec3 skin_mm_;
  std::function<void(HandAxis, double)> typed_;
  std::function<void(Vec3)> placed_;
  std::function<void(const QString&)> refused_;
};

}  // namespace insonate::train
