#pragma once

#include <QWidget>

namespace insonate::train {

class CaseModel;
class ProbeMotion;

/// Button in place of the image that places the probe on the skin; visible if the case has no start pose.
class PlaceOffer final : public QWidget {
 public:
  PlaceOffer(CaseModel& patientCase, ProbeMotion& motion, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseModel& patientCase_;
  ProbeMotion& motion_;
};

}  // namespace insonate::train
