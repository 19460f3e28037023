#pragma once

#include <insonate/ui/AreaWords.h>

#include <QString>
#include <QTimer>
#include <QWidget>

class QLabel;
class QAction;
class QPushButton;

namespace insonate {
struct LiveDeformation;
}
namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class CaseModel;
class DisclosureModel;
class LiveModel;

/// The line under the image: the probe's force, the effect of the force on the vessels, and switches for overlays.
/// Empty without compression. The numbers change only a few times per second, so that they are readable.
class TissueStrip final : public QWidget {
  Q_OBJECT

 public:
  enum Show { kGrid, kPressure, kPlot, kShows };

  /// `commands`: commands that show or hide overlays, for the menu.
  TissueStrip(DisclosureModel& disclosure, CaseModel& patientCase, LiveModel& live, ui::Commands& commands,
              QWidget* parent = nullptr);

  bool shows(Show what) const { return isShown_[what]; }
  void setShown(Show what, bool on);

 Q_SIGNALS:
  void shownChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildMenu(ui::Commands& commands);
  void reserve();
  void follow();
  void refresh();
  void showVessel(QLabel& label, const LiveDeformation* press, int vessel, const QString& name) const;

  DisclosureModel& disclosure_;
  CaseModel& patientCase_;
  LiveModel& live_;
  QTimer soon_;
  QLabel *force_, *vein_, *artery_;
  QPushButton* menu_;
  QAction* actions_[kShows] = {};
  bool isShown_[kShows] = {};
  bool tight_ = false;  ///< true: the layout is narrow, and the button of the menu has a short text
  ui::AreaForm form_ = ui::AreaForm::Full;
};

}  // namespace insonate::train
