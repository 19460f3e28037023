#pragma once

#include "CasePlaces.h"

#include <QString>
#include <QWidget>
#include <functional>

class QComboBox;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace insonate::prepare {

struct PrepareModel;

/// Kinds that PlacesBox marks beside landmarks, whose kinds are their codes.
inline const QString kTargetKind = QStringLiteral("target"), kStartPoseKind = QStringLiteral("start pose"),
                     kVesselKind = QStringLiteral("vessel");

/// Targets, names of vessels, landmarks and start poses of the case, to be placed where the crosshair or the probe is,
/// shown, renamed, moved and removed. A case begins at its first start pose.
class PlacesBox : public QWidget {
  Q_OBJECT

 public:
  explicit PlacesBox(PrepareModel& shared, QWidget* parent = nullptr);
  /// This kind is to be marked next.
  void offer(const QString& kind);

 Q_SIGNALS:
  /// It is chosen what to mark: the next click says where.
  void markingBegun();

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
  void split();
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
  QPushButton *add_, *show_, *put_, *first_, *split_, *remove_;
  bool showing_ = false;
};

}  // namespace insonate::prepare
