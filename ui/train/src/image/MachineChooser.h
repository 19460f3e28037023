#pragma once

#include <QComboBox>

namespace insonate::train {

class ImagingModel;

/// Combo box of machine classes. Selecting a class applies its settings. Shows no class if a setting that the class
/// defines was changed.
class MachineChooser : public QComboBox {
 public:
  explicit MachineChooser(ImagingModel& imaging, QWidget* parent = nullptr);

 private:
  void showCurrent();

  ImagingModel& imaging_;
};

}  // namespace insonate::train
