#pragma once

#include "../model/CasePlaces.h"

#include <QString>
#include <QWidget>
#include <functional>

class QComboBox;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace insonate::prepare {

struct PrepareModel;

/// Lists the targets, vessel names, landmarks and start poses of the case. The user can place them at the crosshair or
/// the probe, have missing ones proposed, show, rename, move and remove them. Training on the case begins at the first
/// start pose.
class PlacesBox : public QWidget {
 public:
  explicit PlacesBox(PrepareModel& shared, QWidget* parent = nullptr);
  /// Selects the kind to be marked next: the code of a landmark, or one of the kinds of PlacesEditor.h.
  void offer(const QString& kind);

 private:
  enum class Kind { Target, Vessel, Landmark, StartPose };
  struct Chosen {
    Kind kind;
    std::size_t index;
  };

  void arrange();
  void refresh();
  void refreshButtons();
  void add();
  void addTarget();
  void addLandmark(const std::string& code, const QString& name);
  void splitVesselHere();
  void show();
  void moveHere();
  void makeFirst();
  void remove();
  void rename(QTreeWidgetItem* item);
  void change(const QString& what, const std::function<void(CasePlaces&)>& how);
  bool chosen(Chosen& one) const;

  PrepareModel& shared_;
  QTreeWidget* list_;
  QComboBox* kind_;
  QPushButton *add_, *propose_, *show_, *put_, *first_, *split_, *remove_;
  bool showing_ = false;
};

}  // namespace insonate::prepare
