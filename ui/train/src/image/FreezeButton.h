#pragma once

#include <QPushButton>

namespace insonate::train {

class CaseModel;
class LiveModel;

/// Button that freezes the image and makes it live again.
class FreezeButton final : public QPushButton {
 public:
  FreezeButton(CaseModel& patientCase, LiveModel& live, const QString& toolTip, QWidget* parent = nullptr);

 private:
  void refresh();

  LiveModel& live_;
};

}  // namespace insonate::train
