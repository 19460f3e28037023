#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QElapsedTimer>
#include <QObject>

namespace insonate::train {

class CaseModel;
class DisclosureModel;
class HapticControl;
class LiveModel;

/// Shows the names of labeled structures over the image, while names are switched on and anatomy is disclosed. A vessel
/// has its own name, any other structure the name of its label; skin, fat and soft tissue have no names. Names follow
/// the compression in the middle of the image.
class StructureNames final : public QObject {
  Q_OBJECT

 public:
  StructureNames(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase, LiveModel& live,
                 views::UltrasoundView& image, QObject* parent);

  bool isOn() const { return isOn_; }
  void setOn(bool isOn);

 Q_SIGNALS:
  void switched(bool isOn);

 private:
  void show();
  std::vector<views::NameOverlay> names() const;

  DisclosureModel& disclosure_;
  HapticControl& hands_;
  CaseModel& case_;
  LiveModel& live_;
  views::UltrasoundView& image_;
  bool isOn_ = false;
  QElapsedTimer sinceShown_;
};

}  // namespace insonate::train
