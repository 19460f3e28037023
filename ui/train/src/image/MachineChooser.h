#pragma once

#include <QComboBox>

namespace insonate::train {

class ImagingModel;

/// The class of machines whose settings the image has; choosing one takes them. Shows none once a setting that the
/// machine decides is another.
class MachineChooser : public QComboBox {
 public:
  explicit MachineChooser(ImagingModel& imaging, QWidget* parent = nullptr);

 private:
  void showCurrent();

  ImagingModel& imaging_;
};

}  // namespace insonate::train
