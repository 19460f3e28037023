#pragma once

#include <insonate/procedure/NeedleWords.h>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QPaintEvent;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class AttemptControl;
class CaseModel;
class DisclosureModel;
class HapticControl;

/// Shows the content of the syringe during aspiration: dark red non-pulsatile blood from a vein, bright red pulsatile
/// blood from an artery, air from lung and airway, and nothing from other tissue. The content stays until the user
/// takes another needle.
class SyringeView final : public QWidget {
  Q_OBJECT

 public:
  using Content = SyringeContent;

  SyringeView(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase, AttemptControl& attempt,
              const ui::Commands& commands, QWidget* parent = nullptr);

  Content content() const { return content_; }
  double level() const { return level_; }  ///< fill level, 0 to 1
  /// Describes the content: "dark red blood, non-pulsatile".
  QString words() const;
  QSize sizeHint() const override;

 Q_SIGNALS:
  void changed();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void draw();
  void empty();
  void tell();

  DisclosureModel& disclosure_;
  HapticControl& hands_;
  CaseModel& patientCase_;
  AttemptControl& attempt_;
  const ui::Commands& commands_;
  Content content_ = Content::Nothing;
  double level_ = 0, beat_ = 0;
  bool isOff_ = false;  ///< the syringe is not on the needle
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace insonate::train
