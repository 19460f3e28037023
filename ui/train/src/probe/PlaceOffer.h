#pragma once

#include <QWidget>

namespace insonate::train {

class CaseModel;
class ProbeMotion;

/// The offer to place the probe, where the image will be; visible while the case has no start pose.
class PlaceOffer final : public QWidget {
 public:
  PlaceOffer(CaseModel& patientCase, ProbeMotion& motion, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseModel& patientCase_;
  ProbeMotion& motion_;
};

}  // namespace insonate::train
