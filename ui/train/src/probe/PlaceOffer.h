#pragma once

#include <QWidget>

namespace insonate::train {

class CaseModel;
class ProbeMotion;

/// Widget in place of the image while the case has no start pose. A button places the probe on the skin.
class PlaceOffer final : public QWidget {
 public:
  PlaceOffer(CaseModel& patientCase, ProbeMotion& motion, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseModel& patientCase_;
  ProbeMotion& motion_;
};

}  // namespace insonate::train
