#pragma once

#include "../model/TissueChoice.h"

#include <QWidget>
#include <functional>

class QCheckBox;
class QComboBox;

namespace insonate::ui {
class ValueSlider;
}

namespace insonate::train {

class NumberField;
class ImagingModel;
class StatusLine;

/// The panel's section about the tissue under the probe: its mechanical model, and the patient's blood pressure and
/// posture.
class TissueControls final : public QWidget {
 public:
  TissueControls(StatusLine& status, ImagingModel& imaging, QWidget* parent = nullptr);

 private:
  QWidget* labeled(const QString& name, QWidget* widget);
  QComboBox* choice(const char* object, const QString& says);
  QWidget* buildPressures();
  QWidget* buildSwitches();
  void change(const std::function<void(TissueChoice&)>& edit);
  void refresh();

  StatusLine& status_;
  ImagingModel& imaging_;
  QComboBox *model_ = nullptr, *posture_ = nullptr;
  ui::ValueSlider* venous_ = nullptr;
  NumberField *systolic_ = nullptr, *diastolic_ = nullptr;
  QCheckBox *pulse_ = nullptr, *breathing_ = nullptr, *pneumothorax_ = nullptr;
  bool refreshing_ = false;
};

}  // namespace insonate::train
