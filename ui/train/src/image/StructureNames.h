#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QElapsedTimer>
#include <QObject>

namespace insonate::train {

class CaseModel;
class DisclosureModel;
class HandsControl;
class LiveModel;

/// The names of the labeled structures over the image, while they are switched on and anatomy is disclosed. Vessels
/// have their own names, other structures that of their label; skin, fat and soft tissue have none. Names follow the
/// compression in the image's middle.
class StructureNames final : public QObject {
  Q_OBJECT

 public:
  StructureNames(DisclosureModel& disclosure, HandsControl& hands, CaseModel& patientCase, LiveModel& live,
                 views::UltrasoundView& image, QObject* parent);

  bool isOn() const { return isOn_; }
  void setOn(bool isOn);

 Q_SIGNALS:
  void switched(bool isOn);

 private:
  void show();
  std::vector<views::PictureName> names() const;

  DisclosureModel& disclosure_;
  HandsControl& hands_;
  CaseModel& case_;
  LiveModel& live_;
  views::UltrasoundView& image_;
  bool isOn_ = false;
  QElapsedTimer sinceShown_;
};

}  // namespace insonate::train
